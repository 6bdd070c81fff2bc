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

FILES = {"linux64": "libsphere_dda_fmu.so", "win64": "sphere_dda_fmu.dll"}
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


def test_linux64_runs_with_glibc_2_17(command):
    versions = set(re.findall(r"GLIBC_([0-9.]+)", dump("-T", built(command, "linux64"))))
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
    libraries = {platform: built(command, platform) for platform in FILES}
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
    sources, shim = ROOT / "tests" / "windows", tmp_path / "bcryptprimitives.dll"
    subprocess.run([*cc, "-O1", "-o", host, sources / "host.c"], check=True)
    subprocess.run([*cc, "-shared", "-O1", "-o", shim, sources / "bcryptprimitives.c", "-ladvapi32"], check=True)
    description = fmpy.read_model_description(str(fmu))
    names = ["momentum[1]", "momentum[3]", "kineticEnergy", "boundary.trough.averageForce[3]", "maxOverlap"]
    references = {v.name: str(v.valueReference) for v in description.modelVariables}
    folder, step, count = fmpy.extract(str(fmu)), 2e-3, 60
    library, resources = f"Z:{folder}/binaries/win64/feeder.dll", f"file:///Z:{folder}/resources"
    call = [wine, host, library, description.guid, resources, str(step), str(count), *(references[n] for n in names)]
    done = subprocess.run(call, capture_output=True, text=True, timeout=300)
    assert done.returncode == 0, done.stderr
    *there, again = [[float(x) for x in line.split()] for line in done.stdout.splitlines()]
    assert len(there) == count and again == there[-1], "the way from the saved state is the same"
    linux = fmpy.simulate_fmu(str(fmu), stop_time=count * step, output_interval=step, output=names)
    for k, name in enumerate(names):
        ours, theirs = linux[name][1:], np.array(there)[:, k]
        # Sines and exponentials are each system's own.
        assert np.allclose(ours, theirs, rtol=1e-6, atol=1e-6 * np.abs(ours).max()), name
