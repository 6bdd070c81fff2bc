"""The wheel and what is released, made of the release command, and a machine that has only those."""

import hashlib
import importlib
import os
import subprocess
import sys

import pytest
from conftest import ROOT

# Directories of a machine without Rust and without this repository.
SYSTEM = os.pathsep.join(("/usr/bin", "/bin"))


@pytest.fixture(scope="session")
def released(command, tmp_path_factory):
    """The folder of `release/build --here`."""
    folder = tmp_path_factory.mktemp("release")
    environment = {**os.environ, "CARGO_TARGET_DIR": str(command.parents[1])}
    environment["PATH"] = os.pathsep.join((os.path.dirname(sys.executable), environment["PATH"]))
    done = subprocess.run(
        [ROOT / "release" / "build", "--here", folder], env=environment, capture_output=True, text=True, timeout=300
    )
    assert done.returncode == 0, done.stderr
    return folder


@pytest.fixture(scope="session")
def wheel(released):
    """The wheel."""
    (path,) = released.glob("*.whl")
    return path


@pytest.fixture(scope="session")
def sphere_dda(wheel, tmp_path_factory):
    """The package, imported from the wheel as pip unpacks it."""
    folder = tmp_path_factory.mktemp("site")
    pip(sys.executable, "--no-deps", "--target", folder, wheel)
    sys.path.insert(0, str(folder))
    try:
        package = importlib.import_module("sphere_dda")
        assert package.__file__.startswith(str(folder)), "another installation is in the way"
        yield package
    finally:
        sys.path.remove(str(folder))


class Machine:
    """A machine with Python and a clean virtual environment, and nothing of the project."""

    def __init__(self, folder):
        self.folder = folder
        subprocess.run([sys.executable, "-m", "venv", folder], check=True)
        self.python = folder / "bin" / "python"
        path = os.pathsep.join((str(folder / "bin"), SYSTEM))
        self.environment = {"PATH": path, "HOME": str(folder), "LANG": "C.UTF-8"}

    def install(self, *arguments):
        pip(self.python, *arguments)

    def run(self, *call, cwd=None, timeout=120):
        """Runs a program there; what it prints."""
        done = subprocess.run(
            [str(part) for part in call], cwd=cwd or self.folder, env=self.environment, capture_output=True, text=True, timeout=timeout,
        )
        assert done.returncode == 0, done.stdout + done.stderr
        return done.stdout


def pip(python, *arguments):
    call = [python, "-m", "pip", "install", "--quiet", "--disable-pip-version-check", *arguments]
    done = subprocess.run([str(part) for part in call], capture_output=True, text=True, timeout=300)
    assert done.returncode == 0, done.stderr


def digest(path):
    return hashlib.sha256(path.read_bytes()).hexdigest()
