"""The exported FMUs as importers meet them: static checks, a driven run, momentum, rollback, processes, threads."""

import subprocess
import sys
import threading
from pathlib import Path

import fmpy
import numpy as np
import pytest
from conftest import EXAMPLES, SCENES
from fmpy.validation import validate_fmu
from fmu import Slave

FREQUENCY = 18.0
AMPLITUDE = 1.5e-3
INPUT = "boundary.trough.displacement"
STEP = 2e-3


def displacement(time):
    return AMPLITUDE * np.sin(2 * np.pi * FREQUENCY * time)


def advance(slave, start, end):
    """Drives the feeder from communication step `start` to `end`; all real outputs after each step, as bytes."""
    outputs = slave.measured()
    seen = []
    for k in range(start, end):
        slave.set(INPUT, displacement((k + 1) * STEP))
        slave.step(k * STEP, STEP)
        seen.append(np.array(slave.get(*outputs)).tobytes())
    return seen


@pytest.mark.parametrize("name", (*SCENES, "shaker"))
def test_fmpy_finds_nothing_to_complain_about(fmus, name):
    assert validate_fmu(str(fmus[name])) == []


@pytest.mark.parametrize("version", (2, 3))
@pytest.mark.parametrize("name", (*SCENES, "shaker"))
def test_fmutool_finds_nothing_to_complain_about(fmus, units, name, version):
    if (name, version) == ("shaker", 3):
        pytest.skip("the shaker is of FMI 2.0 only")
    path = (fmus if version == 2 else units)[name]
    tool = Path(sys.executable).parent / "fmutool"
    done = subprocess.run([tool, "-input", path, "-check"], capture_output=True, text=True, timeout=120)
    told = done.stdout + done.stderr
    assert done.returncode == 0, told
    assert f"compliant with FMI-{version}.0" in told and "No semantic error" in told, told
    assert "ERROR" not in told and "WARNING" not in told, told


@pytest.mark.parametrize("name", EXAMPLES)
def test_simulate_fmu_runs_the_default_experiment(fmus, name):
    step = float(fmpy.read_model_description(str(fmus[name])).defaultExperiment.stepSize)
    result = fmpy.simulate_fmu(str(fmus[name]), stop_time=20 * step, output_interval=step)
    assert np.isclose(result["time"][-1], 20 * step)
    assert all(np.isfinite(result[column]).all() for column in result.dtype.names)


def test_simulate_fmu_drives_the_feeder_with_a_sinusoid(fmus):
    stop = 0.3
    time = np.arange(0, stop + STEP, STEP)
    signal = np.array(list(zip(time, displacement(time))), dtype=[("time", float), (INPUT, float)])
    outputs = ["boundary.trough.position[1]", "boundary.trough.averageForce[3]", "mass", "maxOverlap"]
    result = fmpy.simulate_fmu(
        str(fmus["feeder"]), stop_time=stop, output_interval=STEP, input=signal, output=outputs,
    )
    # fmpy sets the input of the start of a step, and the trough reaches it at the step's end: one step late.
    x = result["boundary.trough.position[1]"]
    slide = np.cos(np.radians(30))
    assert np.allclose(x[1:] - x[0], slide * displacement(time[: len(x) - 1]), atol=1e-9)
    assert result["maxOverlap"].max() <= 1e-6
    # The trough carries the grains: on the mean of whole periods, their weight.
    down = -result["boundary.trough.averageForce[3]"][result["time"] > 0.3 - 4 / FREQUENCY]
    assert np.isclose(down.mean(), result["mass"][0] * 9.81, rtol=0.15)


@pytest.mark.parametrize("name", ("funnel", "slopes", "feeder", "landslide", "bed"))
def test_averaged_wrench_and_weight_are_the_change_of_momentum(fmus, name):
    with Slave(fmus[name]) as slave:
        h = float(slave.description.defaultExperiment.stepSize)
        marker = ".averageForce[1]"
        boundaries = [n.removesuffix(marker) for n in slave.measured() if n.endswith(marker)]
        assert boundaries
        gravity = np.array([0.0, 0.0, -9.81])
        weight = slave.get("mass")[0] * gravity
        before = np.array(slave.vector("momentum"))
        loaded = 0
        for k in range(100):
            if name == "feeder":
                slave.set(INPUT, displacement((k + 1) * h))
            slave.step(k * h, h)
            after = np.array(slave.vector("momentum"))
            # The outputs are the spheres' action on the boundary: the reaction has the other sign.
            forces = [-np.array(slave.vector(f"{b}.averageForce")) for b in boundaries]
            scale = h * (sum(np.linalg.norm(f) for f in forces) + np.linalg.norm(weight))
            residue = after - before - h * (sum(forces) + weight)

            assert np.abs(residue).max() <= 1e-9 * scale, f"step {k}: {residue / scale}"
            loaded += any(np.linalg.norm(f) > 0 for f in forces)
            before = after
        assert loaded > 20, "a balance without contact shows nothing"


def test_a_restored_state_repeats_the_same_bytes(fmus):
    with Slave(fmus["feeder"]) as slave:
        advance(slave, 0, 30)
        blob = slave.save()
        first = advance(slave, 30, 60)
        slave.restore(blob)
        assert slave.save() == blob
        # Another way out must leave no trace.
        slave.set(INPUT, -AMPLITUDE / 2)
        slave.step(30 * STEP, STEP / 2)
        slave.restore(blob)
        assert advance(slave, 30, 60) == first
        assert len(set(first)) == len(first), "the outputs move"


OTHER_PROCESS = """
import sys
from pathlib import Path
sys.path.insert(0, sys.argv[1])
from fmu import Slave
from test_fmu import advance
with Slave(sys.argv[2]) as slave:
    slave.restore(Path(sys.argv[3]).read_bytes())
    Path(sys.argv[4]).write_bytes(b"".join(advance(slave, 30, 60)))
"""


def test_a_state_continues_in_another_process_with_the_same_bytes(fmus, tmp_path):
    blob, seen = tmp_path / "state", tmp_path / "seen"
    with Slave(fmus["feeder"]) as slave:
        advance(slave, 0, 30)
        blob.write_bytes(slave.save())
        here = b"".join(advance(slave, 30, 60))
    folder = Path(__file__).parent
    subprocess.run([sys.executable, "-c", OTHER_PROCESS, folder, fmus["feeder"], blob, seen], check=True, timeout=300)
    assert seen.read_bytes() == here


def test_damaged_states_are_refused_and_change_nothing(fmus):
    with Slave(fmus["feeder"]) as slave:
        advance(slave, 0, 3)
        blob = slave.save()
        damaged = [b"\0", b"garbage" * 99, blob[: len(blob) // 2], blob[:-1], blob[:99] + b"\xff" * 9 + blob[108:]]
        for bad in damaged:
            with pytest.raises(fmpy.fmi1.FMICallException):
                slave.restore(bad)
    with Slave(fmus["feeder"]) as slave, Slave(fmus["funnel"]) as other:
        with pytest.raises(fmpy.fmi1.FMICallException):
            slave.restore(other.save())


def test_two_instances_in_two_threads_give_the_bytes_of_one(fmus):
    with Slave(fmus["feeder"]) as slave:
        alone = advance(slave, 0, 40)
        folder = slave.folder
        seen = {}

        def work(who):
            with Slave(fmus["feeder"], folder=folder) as own:
                seen[who] = advance(own, 0, 40)

        threads = [threading.Thread(target=work, args=(who,)) for who in range(2)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join(timeout=300)
        assert seen == {0: alone, 1: alone}


@pytest.mark.parametrize(
    ("what", "call"),
    [
        ("h = 0", lambda s: s.step(0.0, 0.0)),
        ("h < 0", lambda s: s.step(0.0, -STEP)),
        ("wrong communication point", lambda s: s.step(1.0, STEP)),
        ("NaN input", lambda s: (s.set(INPUT, float("nan")), s.step(0.0, STEP))),
        ("unknown reference", lambda s: s.fmi.getReal([10**6])),
    ],
)
def test_bad_calls_are_refused(fmus, what, call):
    with Slave(fmus["feeder"]) as slave:
        with pytest.raises(fmpy.fmi1.FMICallException):
            call(slave)


def test_the_fmu_writes_its_own_results(fmus, tmp_path):
    fmpy.simulate_fmu(
        str(fmus["funnel"]), stop_time=0.3, output_interval=0.01, start_values={"output.directory": str(tmp_path)},
    )
    runs = list(tmp_path.iterdir())
    assert len(runs) == 1
    assert (runs[0] / "spheres.pvd").exists() and len(list(runs[0].glob("spheres_*.vtu"))) == 4


def test_a_wrench_sensor_is_its_boundarys_average(fmus):
    names = [f"{of}[{k}]" for of in ("sensor.reaction.force", "boundary.trough.averageForce") for k in (1, 2, 3)]
    result = fmpy.simulate_fmu(str(fmus["feeder"]), stop_time=0.02, output_interval=2e-3, output=names)
    values = result.view(np.float64).reshape(len(result), -1)
    assert np.any(values[:, 1:4] != 0)
    assert np.array_equal(values[:, 1:4], values[:, 4:7])
