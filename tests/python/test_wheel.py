"""The wheel and the released files on a machine that has Python and nothing of this project."""

import re
import shutil
import subprocess
import time
import zipfile

import fmpy
import pytest
from conftest import ROOT
from pages import texts
from wheel import SYSTEM, Machine, digest


@pytest.fixture(scope="module")
def machine(wheel, tmp_path_factory):
    """A machine after `pip install sphere-dda[fmpy]`."""
    machine = Machine(tmp_path_factory.mktemp("machine"))
    machine.install(f"{wheel}[fmpy]")
    return machine


def test_no_rust_and_no_tree(machine):
    assert not any(shutil.which(name, path=SYSTEM) for name in ("cargo", "rustc", "sphere-dda"))
    told = machine.run("python", "-c", "import sphere_dda; print(sphere_dda.__file__)")
    assert told.startswith(str(machine.folder))


def test_the_readmes_five_lines(machine, tmp_path):
    """Scene -> run -> HTML -> FMU -> fmpy, under 60 s."""
    (tmp_path / "scene.toml").write_text(texts("README.md", "toml")[0])
    (lines,) = (block for block in texts("README.md", "python") if "sphere_dda.Scene" in block)
    start = time.monotonic()
    told = machine.run("python", "-c", lines, cwd=tmp_path)
    assert time.monotonic() - start < 60.0
    assert (tmp_path / "results" / "view.html").stat().st_size > 1e5
    assert (tmp_path / "scene.fmu").is_file()
    assert float(told.split()[-2]) > 0.0, "nothing flows out"


def test_the_pages_example(machine, tmp_path):
    """What docs/python.md shows, from its first line to its last."""
    (tmp_path / "scene.toml").write_text(texts("README.md", "toml")[0])
    machine.run("python", "-c", "\n".join(texts("docs/python.md", "python")), cwd=tmp_path)
    assert (tmp_path / "results" / "view.html").is_file() and (tmp_path / "recorded" / "history.csv").is_file()


def test_the_command_is_on_the_path(machine, tmp_path):
    version = machine.run("sphere-dda", "--version")
    assert version == machine.run("python", "-m", "sphere_dda", "--version") and version.startswith("sphere-dda ")
    (tmp_path / "bad.toml").write_text("[simulaton]\n")
    call = [machine.folder / "bin" / "sphere-dda", "check", "bad.toml"]
    done = subprocess.run(call, cwd=tmp_path, env=machine.environment, capture_output=True, text=True)
    assert done.returncode == 2 and "simulaton" in done.stderr
    (tmp_path / "scene.toml").write_text(texts("README.md", "toml")[0])
    machine.run("sphere-dda", "export", "scene.toml", "--platform", "linux64", cwd=tmp_path)


def test_the_wheel_is_for_this_platform_and_has_what_it_needs(wheel):
    assert re.fullmatch(r"sphere_dda-[\d.]+-py3-none-manylinux_2_\d+_x86_64\.whl", wheel.name)
    with zipfile.ZipFile(wheel) as archive:
        names = archive.namelist()
        program = archive.getinfo("sphere_dda/bin/sphere-dda")
        assert program.external_attr >> 16 & 0o111, "not executable"
        glibc = set(re.findall(rb"GLIBC_2\.(\d+)", archive.read(program)))
        assert max(17, *map(int, glibc)) <= int(wheel.name.split("manylinux_2_")[1].split("_")[0])
        metadata = archive.read(next(n for n in names if n.endswith("/METADATA"))).decode()
        licences = archive.read("sphere_dda/bin/licences/third-party.txt").decode()
    assert {"sphere_dda/py.typed", "sphere_dda/bin/platforms/linux64/libsphere_dda_fmu.so"} <= set(names)
    assert "\n- clap " in licences and "\n- nalgebra " in licences
    assert re.findall(r"^Requires-Dist: (?!.*extra)(.*)$", metadata, re.M) == ["numpy>=1.26"]
    version = re.search(r'\[workspace\.package\]\nversion = "(.*)"', (ROOT / "Cargo.toml").read_text())[1]
    assert f"\nVersion: {version}\n" in metadata


def test_live_pages_are_made_by_the_wheel_alone(command, machine, tmp_path):
    """As the wheel has the module for WebAssembly where that is built."""
    (tmp_path / "scene.toml").write_text(texts("README.md", "toml")[0])
    module = command.parent / "platforms" / "wasm" / "sphere_dda_fmu.wasm"
    if not module.exists():
        pytest.skip("the module is not there: fmu/platforms/build wasm")
    machine.run("sphere-dda", "view", "scene.toml", "--live", "-o", "live.html", cwd=tmp_path)
    assert (tmp_path / "live.html").stat().st_size > 1e6
    machine.run("sphere-dda", "export", "scene.toml", "--fmi", "3", "--platform", "linux64,wasm", cwd=tmp_path)
    with zipfile.ZipFile(tmp_path / "scene.fmu") as archive:
        assert any(name.endswith(".wasm") for name in archive.namelist())


def test_the_released_folder_alone_is_enough(released, tmp_path):
    """Checksums are right; wheel, command and FMUs work without an index and without anything else of the project."""
    lines = (released / "SHA256SUMS").read_text().splitlines()
    sums = {name: value for value, name in (line.split(maxsplit=1) for line in lines)}
    files = {str(p.relative_to(released)) for p in released.rglob("*") if p.is_file()} - {"SHA256SUMS"}
    assert set(sums) == files and len(files) == 10
    assert all(digest(released / name) == value for name, value in sums.items())
    copy = tmp_path / "release"
    shutil.copytree(released, copy)
    machine = Machine(tmp_path / "machine")
    machine.install("numpy")
    machine.install("--no-index", "--find-links", copy, "sphere-dda")
    machine.run("python", "-c", "import sphere_dda")
    for fmu in (copy / "fmus").iterdir():
        assert fmpy.simulate_fmu(str(fmu), stop_time=0.01)[-1][0] == pytest.approx(0.01), fmu.name
    (archive,) = copy.glob("*.tar.gz")
    shutil.unpack_archive(archive, tmp_path / "command", filter="data")
    (program,) = (tmp_path / "command").glob("*/sphere-dda")
    (tmp_path / "scene.toml").write_text(texts("README.md", "toml")[0])
    machine.run(program, "export", "scene.toml", "-o", "alone.fmu", cwd=tmp_path)
    machine.run("sphere-dda", "simulate", "alone.fmu", "--stop", "0.02", "-o", "out.csv", cwd=tmp_path)
    assert (tmp_path / "out.csv").stat().st_size > 100
