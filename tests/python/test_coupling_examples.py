"""The examples of coupling against what mechanics says of them: shaker, bucket, drum; and the shaker through libcosim."""

import subprocess
import sys

import fmpy
import numpy as np
import pytest
from conftest import EXAMPLES, ROOT, scene
from libcosimpy.CosimExecution import CosimExecution
from libcosimpy.CosimLogging import CosimLogLevel, log_output_level
from libcosimpy.CosimObserver import CosimObserver
from libcosimpy.CosimSlave import CosimLocalSlave

sys.path[:0] = [str(ROOT / "examples" / name) for name in ("two_fmus", "bucket", "drum")]
from compare import compare  # noqa: E402
from couple import WIRES  # noqa: E402
from hang import hang  # noqa: E402
from turn import IDLE, STALL, balance, steady, turn  # noqa: E402


def exported(command, folder, name, *more):
    path = folder / f"{name}.fmu"
    subprocess.run([command, "export", scene(name), "-o", path, *more], check=True)
    return path


def test_strong_coupling_comes_to_the_solution_of_one_solver(command, fmus, tmp_path):
    rows, own = compare(command, fmus["shaker"], tmp_path, steps=[2e-3, 1e-2], reference_step=1e-5)
    assert own < 1e-3
    wrong = {(scheme, step): error for scheme, step, inner, error, *_ in rows if step == inner}
    order = {s: np.log(wrong[s, 1e-2] / wrong[s, 2e-3]) / np.log(5) for s, _ in wrong}
    assert all(0.3 < order[s] < 1.3 for s in ("jacobi", "gauss-seidel", "jacobi, extrapolated", "iterated")), order
    # The reference itself is off by 9e-4, which is in the way at the shorter step.
    assert 1.5 < order["iterated, speed"] < 2.5, order
    assert wrong["iterated", 2e-3] < 0.3 * wrong["jacobi", 2e-3]
    assert wrong["iterated, speed", 2e-3] < 0.02 * wrong["jacobi", 2e-3]
    # How often the solver steps inside does not matter here: the error is that of the coupling.
    for scheme, step, inner, error, tries, _ in rows:
        assert abs(error - wrong[scheme, step]) < 0.2 * error, (scheme, step, inner)
        assert tries < 4 if scheme.startswith("iterated") else tries == 1


def test_a_hanging_bucket_comes_to_rest_where_statics_says(command, tmp_path):
    table, statics = hang(exported(command, tmp_path, "bucket", "--fmi", "3"))
    last = table[-1]
    assert abs(last["place[3]"] / statics["sag"] - 1) < 1e-3
    turn_ = np.array([last[f"turn[{axis}]"] for axis in (1, 2, 3)])
    assert np.linalg.norm(statics["turn"]) > 5e-3, "the grains do not lie at one side"
    assert np.linalg.norm(turn_ - statics["turn"]) < 1e-2 * np.linalg.norm(statics["turn"])
    assert statics["lost"] < 1e-12


def test_a_drum_turns_where_motor_and_grains_agree(command, tmp_path):
    table = turn(exported(command, tmp_path, "drum"))
    speed, motor, grains = steady(table)
    assert 0.5 * IDLE < speed < 0.95 * IDLE
    # What is left is J (w - w_0) / 10 s: the speed sways by less than 0.7 rad/s between two instants.
    assert abs(motor + grains) < 0.01 * motor
    assert abs(motor - STALL * (1 - speed / IDLE)) < 1e-3 * motor
    missing, half = balance(table)
    assert missing < 1.001 * half


def reals(path):
    return {v.name: v.valueReference for v in fmpy.read_model_description(str(path)).modelVariables}


class Cosim:
    """FMUs in libcosim, which steps all of them by the same length and exchanges values after each step."""

    def __init__(self, fmus, step):
        log_output_level(CosimLogLevel.ERROR)
        self.execution = CosimExecution.from_step_size(step_size=round(step * 1e9))
        self.references = {name: reals(path) for name, path in fmus.items()}
        self.index = {
            name: self.execution.add_local_slave(CosimLocalSlave(fmu_path=str(path), instance_name=name))
            for name, path in fmus.items()
        }
        self.observer = CosimObserver.create_last_value()
        assert self.execution.add_observer(self.observer)

    def place(self, name):
        component, variable = name.split(".", 1)
        return self.index[component], self.references[component][variable]

    def connect(self, source, target):
        # A status of C: 0 is success.
        assert self.execution.connect_real_variables(*self.place(source), *self.place(target)) == 0

    def set(self, name, value):
        assert self.execution.real_initial_value(*self.place(name), value)

    def get(self, name):
        component, reference = self.place(name)
        return self.observer.last_real_values(component, [reference])[0]


def test_libcosim_couples_as_the_built_in_master_does(command, fmus, tmp_path):
    cosim = Cosim({name: fmus[name] for name in ("shaker", "bed")}, 1e-3)
    for source, target in WIRES:
        cosim.connect(source, target)
    cosim.set("shaker.amplitude", 2e-3)
    for _ in range(300):
        assert cosim.execution.step()
    out = tmp_path / "out.csv"
    connect = [f"--connect={source}={target}" for source, target in WIRES]
    names = ["shaker.position", "shaker.velocity", "bed.momentum[3]"]
    record = [f"--record={name}" for name in names]
    options = ["--set", "shaker.amplitude=0.002", "--step", "1e-3", "--stop", "0.3", "-o", out]
    subprocess.run([command, "simulate", fmus["shaker"], fmus["bed"], *connect, *record, *options], check=True)
    ours = np.genfromtxt(out, delimiter=",", names=True, deletechars="")[-1]
    for name in names:
        # Its steps are not exactly 1 ms: it counts nanoseconds and converts them.
        assert abs(cosim.get(name) - ours[name]) < 1e-8 * abs(ours[name]), name
    assert abs(ours["shaker.position"]) > 1e-3, "nothing moves"


@pytest.mark.parametrize("name", EXAMPLES)
def test_libcosim_runs_every_example(fmus, name):
    step = float(fmpy.read_model_description(str(fmus[name])).defaultExperiment.stepSize)
    cosim = Cosim({name: fmus[name]}, step)
    for _ in range(20):
        assert cosim.execution.step()
    mine = fmpy.simulate_fmu(str(fmus[name]), stop_time=20 * step, step_size=step, output=["momentum[3]", "mass"])
    given = mine["mass"][-1] * 9.81 * 20 * step
    assert abs(cosim.get(f"{name}.momentum[3]") - mine["momentum[3]"][-1]) < 1e-6 * given
    assert abs(cosim.get(f"{name}.mass") / mine["mass"][-1] - 1) < 1e-12
