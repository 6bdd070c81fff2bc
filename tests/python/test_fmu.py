"""The FMUs of the examples in the hands of a foreign importer: fmpy, and the checks of the FMU manipulation toolbox.

SPHERE_DDA names the command; without it: the one of the release build. It exports with the library beside it, so what
is tested is what ships.
"""

import math
import os
import subprocess
import sys
from pathlib import Path

import fmpy
import numpy as np
import pytest
from fmpy.fmi2 import FMU2Slave
from fmpy.validation import validate_fmu

ROOT = Path(__file__).resolve().parents[2]
TARGET = Path(os.environ.get("CARGO_TARGET_DIR", ROOT / "target"))
COMMAND = Path(os.environ.get("SPHERE_DDA", TARGET / "release" / "sphere-dda"))
EXAMPLES = ["feeder", "funnel", "slopes"]
GRAVITY = 9.81


@pytest.fixture(scope="session")
def fmus(tmp_path_factory):
    """Path of the FMU of each example."""
    folder = tmp_path_factory.mktemp("fmus")
    paths = {name: folder / f"{name}.fmu" for name in EXAMPLES}
    for name, path in paths.items():
        scene = ROOT / "examples" / name / f"{name}.toml"
        subprocess.run([COMMAND, "export", scene, "-o", path], check=True, capture_output=True, text=True)
    return paths


class Slave:
    """A low-level instance, initialized, with its variables by name."""

    def __init__(self, path, folder, name="one"):
        description = fmpy.read_model_description(path)
        self.references = {v.name: v.valueReference for v in description.modelVariables}
        self.lines = []
        self.fmu = FMU2Slave(
            guid=description.guid,
            unzipDirectory=fmpy.extract(path, folder),
            modelIdentifier=description.coSimulation.modelIdentifier,
            instanceName=name,
        )
        self.fmu.instantiate()
        self.fmu.setupExperiment(startTime=0.0)
        self.fmu.enterInitializationMode()
        self.fmu.exitInitializationMode()

    def get(self, *names):
        return self.fmu.getReal([self.references[name] for name in names])

    def set(self, name, value):
        self.fmu.setReal([self.references[name]], [value])

    def bytes(self):
        state = self.fmu.getFMUstate()
        data = self.fmu.serializeFMUstate(state)
        self.fmu.freeFMUstate(state)
        return bytes(data)

    def vector(self, name):
        return np.array(self.get(*(f"{name}[{k}]" for k in (1, 2, 3))))

    def close(self):
        self.fmu.terminate()
        self.fmu.freeInstance()


@pytest.fixture
def feeder(fmus, tmp_path):
    slave = Slave(fmus["feeder"], tmp_path)
    yield slave
    slave.close()


@pytest.mark.parametrize("name", EXAMPLES)
def test_fmpy_finds_nothing(fmus, name):
    assert validate_fmu(str(fmus[name])) == []


@pytest.mark.parametrize("name", EXAMPLES)
def test_fmutool_finds_nothing(fmus, name):
    tool = Path(sys.executable).with_name("fmutool")
    run = subprocess.run([tool, "-input", fmus[name], "-check"], check=True, capture_output=True, text=True)
    text = run.stdout + run.stderr
    assert "compliant with FMI-2.0" in text and "No semantic error" in text, text
    assert "ERROR" not in text and "WARNING" not in text, text


@pytest.mark.parametrize(("name", "stop", "step"), [("funnel", 0.5, 0.05), ("slopes", 2.0, 0.5), ("feeder", 0.05, 0.002)])
def test_fmpy_simulates(fmus, name, stop, step):
    result = fmpy.simulate_fmu(fmus[name], stop_time=stop, output_interval=step, validate=True)
    assert len(result) == round(stop / step) + 1
    assert result["time"][-1] == pytest.approx(stop, rel=1e-12)
    for column in result.dtype.names:
        assert np.all(np.isfinite(result[column])), column
    assert max(result["maxOverlap"]) <= 1e-6


def test_a_sinusoid_drives_the_feeder(fmus):
    frequency, amplitude, step = 20.0, 1.5e-3, 2e-3
    time = np.arange(0.0, 0.3, step / 4)
    drive = np.array(
        list(zip(time, amplitude * np.sin(2 * math.pi * frequency * time))),
        dtype=[("time", float), ("boundary.trough.displacement", float)],
    )
    result = fmpy.simulate_fmu(
        fmus["feeder"],
        stop_time=0.3,
        output_interval=step,
        input=drive,
        output=["boundary.trough.position[3]", "boundary.trough.averageForce[3]", "sensor.flow.mass", "momentum[1]"],
    )
    height = result["boundary.trough.position[3]"]
    # 30 degrees above the horizontal: half of the displacement is vertical.
    assert np.ptp(height) == pytest.approx(amplitude, rel=0.05)
    # The trough carries the grains: on the mean its load pushes it down.
    assert np.mean(result["boundary.trough.averageForce[3]"]) < 0.0


def test_impulses_change_the_momentum(feeder):
    h = 2e-3
    mass = feeder.get("mass")[0]
    feeder.fmu.doStep(0.0, h)
    momentum = feeder.vector("momentum")
    for k in range(1, 30):
        t = k * h
        feeder.set("boundary.trough.displacement", 1e-3 * math.sin(120.0 * t))
        feeder.fmu.doStep(t, h)
        reaction = feeder.vector("boundary.trough.averageForce") + feeder.vector("boundary.bin.averageForce")
        impulse = h * (np.array([0.0, 0.0, -GRAVITY * mass]) - reaction)
        after = feeder.vector("momentum")
        assert np.max(np.abs(after - momentum - impulse)) <= 1e-9 * mass * GRAVITY * h
        momentum = after


def test_rollback_is_bitwise(feeder):
    def drive(start, stop):
        for k in range(start, stop):
            feeder.set("boundary.trough.displacement", 1e-3 * math.sin(0.24 * k))
            feeder.fmu.doStep(k * 2e-3, 2e-3)

    drive(0, 10)
    state = feeder.fmu.getFMUstate()
    drive(10, 20)
    once = feeder.bytes()
    feeder.fmu.setFMUstate(state)
    drive(10, 20)
    assert feeder.bytes() == once
    feeder.fmu.freeFMUstate(state)


def test_another_instance_continues(feeder, fmus, tmp_path):
    for k in range(10):
        feeder.fmu.doStep(k * 2e-3, 2e-3)
    other = Slave(fmus["feeder"], tmp_path / "other", name="other")
    state = other.fmu.deSerializeFMUstate(feeder.bytes())
    other.fmu.setFMUstate(state)
    other.fmu.freeFMUstate(state)
    for slave in (feeder, other):
        slave.fmu.doStep(0.02, 2e-3)
    assert feeder.bytes() == other.bytes()
    other.close()


def test_results_are_written_on_request(fmus, tmp_path):
    fmpy.simulate_fmu(
        fmus["feeder"],
        stop_time=0.04,
        output_interval=2e-3,
        start_values={"output.directory": str(tmp_path), "output.interval": 0.01},
    )
    (run,) = tmp_path.iterdir()
    assert {"spheres.pvd", "contacts.pvd", "boundaries.pvd", "history.csv", "run.json", "view.py"} <= {
        path.name for path in run.iterdir()
    }
    assert len(list(run.glob("spheres_*.vtu"))) == 5


def test_same_scene_same_bytes(fmus, tmp_path):
    again = tmp_path / "feeder.fmu"
    scene = ROOT / "examples" / "feeder" / "feeder.toml"
    subprocess.run([COMMAND, "export", scene, "-o", again], check=True, capture_output=True)
    assert again.read_bytes() == fmus["feeder"].read_bytes()
