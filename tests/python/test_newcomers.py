"""The scenes that newcomers write, without any key of the solver, run to their end and step as FMUs."""

import json
import subprocess
import sys

import numpy as np
import pytest
from conftest import ROOT
from fmu import Slave

sys.path.insert(0, str(ROOT / "benches" / "newcomers"))
sys.path.insert(0, str(ROOT / "tests" / "newcomers"))
import make
import measure
from cases import CASES, FOLDER, OVERLAP, TIME, UNCONVERGED, Case

STEPS = 50
# Simulated time of a run [s]: grains have fallen onto the floor and onto each other.
SHORT, LARGE = 0.2, {"box5000": 0.05}
LIMIT = 120.0


def test_every_scene_is_run_and_sets_no_key_of_the_solver():
    scenes = {path.stem: path.read_text() for path in FOLDER.glob("*.toml")}
    assert {*scenes} == {*CASES}
    allowed = {"duration", "communication_step", "gravity"}
    for name, text in scenes.items():
        section = text.split("[simulation]\n")[1].split("\n[")[0]
        keys = {line.split("=")[0].strip() for line in section.splitlines() if "=" in line}
        assert keys <= allowed, (name, keys - allowed)


def test_meshes_and_terrain_are_those_of_the_program(tmp_path):
    make.main(tmp_path)
    written = {path.name: path.read_text() for path in tmp_path.iterdir()}
    assert written == {path.name: path.read_text() for suffix in ("stl", "asc") for path in FOLDER.glob(f"*.{suffix}")}


@pytest.mark.parametrize("name", CASES)
def test_a_scene_runs_within_the_tolerance_of_the_default_accuracy(command, tmp_path, name):
    stop = LARGE.get(name, SHORT)
    words = [command, "run", FOLDER / f"{name}.toml", "-o", tmp_path, "--stop", str(stop)]
    done = subprocess.run(words, capture_output=True, text=True, timeout=LIMIT, check=False)
    assert done.returncode == 0, done.stderr
    history = measure.read(tmp_path / "history.csv")
    assert history[TIME][-1] == pytest.approx(stop)
    gap = json.loads((tmp_path / "run.json").read_text())["settings"]["tolerance"]["gap"]
    assert history[OVERLAP].max() <= gap
    assert history[UNCONVERGED].sum() == 0, done.stderr
    assert CASES[name].column in history


@pytest.mark.parametrize("name", CASES)
def test_an_fmu_of_a_scene_takes_its_first_steps(command, tmp_path, name):
    case, fmu = CASES[name], tmp_path / f"{name}.fmu"
    words = [command, "export", FOLDER / f"{name}.toml", "-o", fmu]
    done = subprocess.run([*words, "--until-rest"] if case.rests else words, capture_output=True, text=True, timeout=LIMIT, check=False)
    assert done.returncode == 0, done.stderr
    with Slave(fmu) as slave:
        found = measure.advance(case, slave, STEPS)
    assert (found["steps"], found["discards"]) == (STEPS, 0)


def test_the_error_of_a_steady_force_is_that_of_its_mean_at_the_end():
    times = np.linspace(0.01, 3.0, 300)
    late = times > 2.0

    def run(force):
        return measure.Run(1.0, 3.0, {TIME: times, "force": force})

    reference = run(np.where(late, 10.0, 0.0))
    found = run(np.where(late, 11.0 + np.sin(20 * np.pi * times), 77.0))
    assert measure.error(Case("force"), found, reference) == pytest.approx(0.1, abs=1e-3)
    assert measure.error(Case("force", steady=False), reference, reference) == 0.0
    # Twice the force is an error of one, and what is faster than the window is none.
    twice = run(2.0 * reference.history["force"])
    assert measure.error(Case("force", steady=False), twice, reference) == pytest.approx(1.0)
    trembling = run(reference.history["force"] + np.tile([1.0, -1.0, 0.0], 100))
    assert measure.error(Case("force", steady=False), trembling, reference) < 0.02
