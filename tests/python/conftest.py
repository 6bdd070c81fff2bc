"""The command and the exported FMUs that the tests drive.

`tests/run` names the release command in SPHERE_DDA; without it, that of target/release. It exports the
examples once per session; each worker of pytest-xdist has a session of its own.
"""

import os
import subprocess
from pathlib import Path

import pytest

# Fixtures of the wheel, made once for all tests.
pytest_plugins = ("wheel",)

ROOT = Path(__file__).resolve().parents[2]
EXAMPLES = ("funnel", "slopes", "feeder", "conveyor", "landslide", "bed", "shear", "triaxial", "chute", "press", "wet_heap",
            "clump_drum", "clump_repose", "dumper")
# All scenes of the examples, also those that other tests run: what lies in the archive is judged for each.
SCENES = (*EXAMPLES, "plate", "bucket", "drum", "dropped", "hopper", "gate", "tray", "viscous",
          "live_hopper", "live_drum", "live_box")


def scene(name):
    """The scene of this name in the folder of some example."""
    (path,) = ROOT.glob(f"examples/*/{name}.toml")
    return path


@pytest.fixture(scope="session")
def command():
    """Path of the `sphere-dda` command."""
    target = Path(os.environ.get("CARGO_TARGET_DIR", ROOT / "target"))
    path = Path(os.environ.get("SPHERE_DDA", target / "release" / "sphere-dda"))
    assert path.exists(), f"{path} is missing: run `cargo build --release`, or name the command in SPHERE_DDA"
    return path


@pytest.fixture(scope="session")
def fmus(command, tmp_path_factory):
    """Name -> path of the FMU of every scene of the examples, and of the shaker."""
    folder = tmp_path_factory.mktemp("fmus")
    paths = {name: folder / f"{name}.fmu" for name in (*SCENES, "shaker")}
    for name, path in paths.items():
        if name == "shaker":
            subprocess.run([command.parent / "export-shaker", path], check=True)
        else:
            subprocess.run([command, "export", scene(name), "-o", path], check=True)
    return paths


@pytest.fixture(scope="session")
def units(command, tmp_path_factory):
    """Name -> path of the FMI 3.0 FMU of every scene of the examples."""
    folder = tmp_path_factory.mktemp("fmi3")
    paths = {name: folder / f"{name}.fmu" for name in SCENES}
    for name, path in paths.items():
        subprocess.run([command, "export", scene(name), "--fmi", "3", "-o", path], check=True)
    return paths
