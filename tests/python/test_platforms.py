"""FMUs for several platforms: where the libraries lie, what they need, and that they are of the program that packs them.

Libraries built apart (`fmu/platforms/build`) are judged where they are; what needs none is tested always.
"""

import os
import re
import shutil
import subprocess
import zipfile

import fmpy
import numpy as np
import pytest
from conftest import ROOT, scene

FILES = {
    "linux64": "libsphere_dda_fmu.so",
    "aarch64-linux": "libsphere_dda_fmu.so",
    "win64": "sphere_dda_fmu.dll",
}
# Those of one FMU for both systems.
BOTH = ("linux64", "win64")
PLACES = {
    2: {"linux64": "binaries/linux64/feeder.so", "win64": "binaries/win64/feeder.dll"},
    3: {"linux64": "binaries/x86_64-linux/feeder.so", "win64": "binaries/x86_64-windows/feeder.dll"},
}


def built(command, platform):
    """The library of a platform that was built apart, or a skipped test."""
    path = command.parent / "platforms" / platform / FILES[platform]
    if not path.exists():
        pytest.skip(f"{path} is not there: fmu/platforms/build {platform}")
    return path


def export(command, path, platforms, version=2):
    call = [command, "export", scene("feeder"), "-o", path, "--fmi", str(version)]
    return subprocess.run([*call, "--platform", platforms], capture_output=True, text=True)


def dump(*arguments):
    return subprocess.run(["objdump", *arguments], capture_output=True, text=True, check=True).stdout


@pytest.mark.parametrize("platform", ("linux64", "aarch64-linux"))
def test_linux_libraries_run_with_glibc_2_17(command, platform):
    # Versions are named in the text of the library, whichever tools are here.
    versions = set(re.findall(rb"GLIBC_([0-9.]+)\0", built(command, platform).read_bytes()))
    versions = {version.decode() for version in versions}
    assert versions, "no version is needed at all: nothing was read"
    assert max(tuple(map(int, v.split("."))) for v in versions) <= (2, 17)


def test_win64_needs_windows_only_and_has_every_function(command):
    told = dump("-p", built(command, "win64"))
    needed = {name.lower() for name in re.findall(r"DLL Name: (\S+)", told)}
    own = r"(kernel32|ntdll|bcryptprimitives|ws2_32|userenv|advapi32|api-ms-win-(core|crt)-.*)\.dll"
    assert needed and all(re.fullmatch(own, name) for name in needed), needed
    exported = set(re.findall(r"\b(fmi[23]\w+)\b", told))
    assert len([n for n in exported if n.startswith("fmi2")]) == 34
    assert len([n for n in exported if n.startswith("fmi3")]) == 75


@pytest.mark.parametrize("version", [2, 3])
def test_one_fmu_for_both_with_the_guid_of_any(command, fmus, units, tmp_path, version):
    libraries = {platform: built(command, platform) for platform in BOTH}
    path = tmp_path / "feeder.fmu"
    done = export(command, path, "linux64,win64,linux64", version)
    assert done.returncode == 0, done.stderr
    with zipfile.ZipFile(path) as archive:
        binaries = [n for n in archive.namelist() if n.startswith("binaries/")]
        assert binaries == list(PLACES[version].values())
        for platform, library in libraries.items():
            assert archive.read(PLACES[version][platform]) == library.read_bytes()
    own = (fmus if version == 2 else units)["feeder"]
    assert fmpy.read_model_description(str(path)).guid == fmpy.read_model_description(str(own)).guid
    assert "win64" in fmpy.supported_platforms(str(path)) or version == 3
    # The library for old Linux gives the same bits.
    results = [fmpy.simulate_fmu(str(p), stop_time=0.1, output_interval=2e-3) for p in (path, own)]
    for name in results[0].dtype.names:
        assert np.array_equal(results[0][name], results[1][name], equal_nan=True), name


def test_a_library_that_is_missing_or_old_is_refused(command, tmp_path):
    # A program in a folder of its own, with no libraries around.
    program = tmp_path / "bin" / "sphere-dda"
    program.parent.mkdir()
    shutil.copy2(command, program)
    path = tmp_path / "feeder.fmu"
    done = export(program, path, "win64")
    assert done.returncode == 2 and "fmu/platforms/build win64" in done.stderr, done.stderr
    place = program.parent / "platforms" / "win64"
    place.mkdir(parents=True)
    (place / FILES["win64"]).write_bytes(b"MZ" + bytes(1000))
    done = export(program, path, "win64")
    assert done.returncode == 2 and "older or newer than this program" in done.stderr, done.stderr
    done = export(program, path, "linux32")
    assert done.returncode == 2 and "linux32" in done.stderr and "win64" in done.stderr
    assert not path.exists()


def machine(library):
    """What a library of ELF is for, and whether it is for Linux or any system."""
    assert library[:6] == b"\x7fELF\x02\x01"
    return int.from_bytes(library[18:20], "little")


@pytest.mark.parametrize("version", [2, 3])
def test_arm_libraries_lie_where_both_standards_want_them(command, tmp_path, version):
    library = built(command, "aarch64-linux").read_bytes()
    assert machine(library) == 183, "EM_AARCH64"
    path = tmp_path / "feeder.fmu"
    done = export(command, path, "aarch64-linux,linux64", version)
    assert done.returncode == 0, done.stderr
    with zipfile.ZipFile(path) as archive:
        assert archive.read("binaries/aarch64-linux/feeder.so") == library
        assert machine(archive.read(PLACES[version]["linux64"])) == 62, "EM_X86_64"


def test_arm_steps_and_rolls_back_under_qemu(command, tmp_path):
    """The bits of x86 with AVX2: both round sums of products once."""
    qemu, zig = os.environ.get("SPHERE_DDA_QEMU") or shutil.which("qemu-aarch64-static"), shutil.which("python-zig")
    system = os.environ.get("SPHERE_DDA_ARM_ROOT", "/usr/aarch64-linux-gnu")
    if not (qemu and zig and os.path.exists(f"{system}/lib/ld-linux-aarch64.so.1")):
        pytest.skip("needs qemu-aarch64-static, libc6-arm64-cross and zig")
    built(command, "aarch64-linux")
    fmu, host = tmp_path / "feeder.fmu", tmp_path / "host"
    assert export(command, fmu, "linux64,aarch64-linux").returncode == 0
    source = ROOT / "tests" / "platforms" / "host.c"
    subprocess.run([zig, "cc", "-target", "aarch64-linux-gnu.2.17", "-O1", "-o", host, source, "-ldl"], check=True)
    there = steps([qemu, "-L", system, host], fmu, "aarch64-linux", tmp_path)
    linux = fmpy.simulate_fmu(str(fmu), stop_time=COUNT * STEP, output_interval=STEP, output=NAMES)
    here = np.column_stack([linux[name][1:] for name in NAMES])
    print("largest differences:", dict(zip(NAMES, np.abs(there - here).max(axis=0), strict=True)))
    assert len(np.unique(here[:, 3])) > 30, "nothing happens"
    assert np.array_equal(there, here)


NAMES = ["momentum[1]", "momentum[3]", "kineticEnergy", "boundary.trough.averageForce[3]", "maxOverlap"]
STEP, COUNT = 2e-3, 60


def steps(host, fmu, platform, folder, place="{}", address="file://{}"):
    """Runs the host on the library of a platform; the values of NAMES after each step."""
    description = fmpy.read_model_description(str(fmu))
    references = {v.name: str(v.valueReference) for v in description.modelVariables}
    inner = fmpy.extract(str(fmu), unzipdir=folder / platform)
    library = place.format(f"{inner}/binaries/{platform}/feeder{'.dll' if platform == 'win64' else '.so'}")
    arguments = [library, description.guid, address.format(f"{inner}/resources"), str(STEP), str(COUNT)]
    done = subprocess.run(
        [*host, *arguments, *(references[n] for n in NAMES)], capture_output=True, text=True, timeout=600
    )
    assert done.returncode == 0, done.stderr
    *there, again = [[float(x) for x in line.split()] for line in done.stdout.splitlines()]
    assert len(there) == COUNT and again == there[-1], "the way from the saved state is the same"
    return np.array(there)


def compiler():
    """A C compiler for Windows, as arguments; zig comes with fmu/platforms/requirements.txt."""
    gcc, zig = shutil.which("x86_64-w64-mingw32-gcc"), shutil.which("python-zig")
    if gcc:
        return [gcc]
    return [zig, "cc", "-target", "x86_64-windows-gnu"] if zig else None


def test_win64_steps_and_rolls_back_under_wine(command, tmp_path):
    wine, cc = os.environ.get("SPHERE_DDA_WINE") or shutil.which("wine64") or shutil.which("wine"), compiler()
    if not (wine and cc):
        pytest.skip("needs wine and a compiler for Windows")
    built(command, "win64")
    fmu, host = tmp_path / "feeder.fmu", tmp_path / "host.exe"
    assert export(command, fmu, "linux64,win64").returncode == 0
    sources, shim = ROOT / "tests" / "platforms", tmp_path / "bcryptprimitives.dll"
    subprocess.run([*cc, "-O1", "-o", host, sources / "host.c"], check=True)
    subprocess.run([*cc, "-shared", "-O1", "-o", shim, sources / "bcryptprimitives.c", "-ladvapi32"], check=True)
    there = steps([wine, host], fmu, "win64", tmp_path, place="Z:{}", address="file:///Z:{}")
    linux = fmpy.simulate_fmu(str(fmu), stop_time=COUNT * STEP, output_interval=STEP, output=NAMES)
    for k, name in enumerate(NAMES):
        ours, theirs = linux[name][1:], there[:, k]
        # Sines and exponentials are each system's own.
        assert np.allclose(ours, theirs, rtol=1e-6, atol=1e-6 * np.abs(ours).max()), name
