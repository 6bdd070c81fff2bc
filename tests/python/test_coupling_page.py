"""The recipes of docs/coupling.md run and agree."""

import re
import shlex
import subprocess
import sys

import numpy as np
import pytest
from conftest import ROOT
from pages import environment, texts

PAGE = "docs/coupling.md"


@pytest.fixture
def folder(fmus, tmp_path):
    for name in ("shaker", "bed"):
        (tmp_path / f"{name}.fmu").symlink_to(fmus[name].resolve())
    (tmp_path / "examples").symlink_to(ROOT / "examples")
    return tmp_path


def python(block, folder):
    done = subprocess.run([sys.executable, "-c", block], cwd=folder, capture_output=True, text=True, timeout=300)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


def shell(block, command, folder):
    done = subprocess.run(
        ["bash", "-euc", block], cwd=folder, env=environment(command), capture_output=True, text=True, timeout=300
    )
    assert done.returncode == 0, done.stderr
    return done.stderr


def last(path):
    return np.genfromtxt(path, delimiter=",", names=True, deletechars="")[-1]


def test_all_masters_agree(command, folder):
    making, ours, package = texts(PAGE, "sh")
    assert shlex.split(making)[:2] == ["sphere-dda", "export"]
    said = shell(ours, command, folder)
    assert 1.0 < float(re.search(r"([\d.]+) iterations per step", said)[1]) < 8.0
    shell(package, command, folder)
    strong = last(folder / "coupled.csv")
    assert (folder / "coupled.csv").read_bytes() == (folder / "from-ssp.csv").read_bytes()

    by_states, by_cosim = texts(PAGE, "python")
    told = python(by_states, folder)
    position, iterations = (float(re.search(pattern, told)[1]) for pattern in (r"position (\S+) m", r"([\d.]+) iterations per step"))
    # Grains in motion magnify what is left of the tolerance.
    assert abs(position - strong["shaker.position"]) < 1e-3 * abs(position)
    assert 1.0 < iterations < 8.0

    loose = ours.replace("iterated --coupling-tolerance 1e-6", "jacobi").replace("-o coupled.csv", "-o loose.csv")
    shell(loose, command, folder)
    position = float(re.search(r"position (\S+) m", python(by_cosim, folder))[1])
    assert abs(position - last(folder / "loose.csv")["shaker.position"]) < 1e-6 * abs(position)
