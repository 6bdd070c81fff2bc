"""Parameters of every type as fmpy sets them, in both versions: texts, truth values, enumerations, tunable numbers."""

import fmpy
import numpy as np
import pytest

H = 2e-3
WORK, MOMENTUM = ("solver.sweeps", "solver.factorizations"), "momentum"


@pytest.fixture(params=[2, 3], ids=["fmi2", "fmi3"])
def feeder(request, fmus, units):
    return str((fmus if request.param == 2 else units)["feeder"])


def variables(path):
    return {v.name: v for v in fmpy.read_model_description(path).modelVariables}


def gravity(path, value):
    """Start values of all components of gravity."""
    if "gravity" in variables(path):
        return {"gravity": value}
    return {f"gravity[{k + 1}]": value[k] for k in range(3)}


def simulate(path, start_values, stop=20 * H):
    names = [n for n in variables(path) if n.startswith(MOMENTUM) or n in WORK]
    result = fmpy.simulate_fmu(path, stop_time=stop, output_interval=H, start_values=start_values, output=names)
    momentum = np.column_stack([result[n] for n in names if n.startswith(MOMENTUM)])
    return momentum, [int(result[n].sum()) for n in WORK]


def test_there_is_one_of_every_type(feeder):
    found = variables(feeder)
    assert {v.type for v in found.values() if v.causality == "parameter"} in (
        {"Real", "Integer", "Boolean", "String", "Enumeration"},
        {"Float64", "Int32", "Boolean", "String", "Enumeration"},
    )
    solver = found["solver.kind"]
    assert [(i.name, int(i.value)) for i in solver.declaredType.items] == [
        ("Auto", 1), ("Direct", 2), ("GaussSeidel", 3),
    ]
    assert all(i.description for i in solver.declaredType.items)
    assert solver.start == "1" and solver.variability == "fixed"
    assert found["output.directory"].start == ""
    tunable = {n.partition("[")[0] for n, v in found.items() if v.variability == "tunable"}
    assert tunable == {"gravity"}


def test_the_solver_is_chosen_by_name_or_number(feeder):
    # Steps below those that are chosen are all of one length, whatever they cost.
    same = {f"solver.tolerance.{kind}": 1e-6 for kind in ("gap", "slip", "force")} | {"solver.step": 5e-4}
    own, of_own = simulate(feeder, same)
    runs = {number: simulate(feeder, same | {"solver.kind": number}) for number in (1, 2, 3)}
    # All solve the same problems, within the tolerance of 1e-6.
    for momentum, _ in runs.values():
        assert np.allclose(momentum, own, atol=1e-5 * np.abs(own).max())
    # What they count tells which it was.
    work = [done for _, done in runs.values()]
    assert work[0] == of_own and of_own[0] > 0
    assert work[1][0] == 0 and work[1][1] > 0, "the direct solver factorizes and does not sweep"
    assert work[2][0] > 0 and work[2][1] == 0, "Gauss-Seidel sweeps and does not factorize"


@pytest.mark.parametrize("value", [0, 4, -1, 2**31 - 1])
def test_a_solver_that_does_not_exist_is_refused(feeder, value, capsys):
    # A logger of its own would stay behind in fmpy and be called, dead, by the next FMU.
    with pytest.raises(fmpy.fmi1.FMICallException):
        fmpy.simulate_fmu(feeder, stop_time=H, start_values={"solver.kind": value})
    told = capsys.readouterr().out
    assert f"`solver.kind` = {value}, expected one of 1 (Auto), 2 (Direct), 3 (GaussSeidel)" in told


def test_a_number_wider_than_any_item_is_refused(units):
    with pytest.raises(fmpy.fmi1.FMICallException):
        fmpy.simulate_fmu(str(units["feeder"]), stop_time=H, start_values={"solver.kind": 2**32 + 1})


def test_gravity_may_be_tuned(feeder):
    description = fmpy.read_model_description(feeder)
    fall, _ = simulate(feeder, gravity(feeder, [0.0, 0.0, 0.0]))
    assert np.array_equal(fall, np.zeros_like(fall)), "without weight nothing moves"
    name, values = ("gravity", [9.0, 0.0, 0.0]) if description.fmiVersion == "3.0" else ("gravity[1]", [9.0])

    def push(time, recorder):
        if np.isclose(time, 10 * H):
            variable = variables(feeder)[name]
            fmu = recorder.fmu
            (fmu.setFloat64 if len(values) == 3 else fmu.setReal)([variable.valueReference], values)
        return True

    axes = [f"{MOMENTUM}[{k}]" for k in (1, 2, 3)] if len(values) == 1 else [MOMENTUM]
    result = fmpy.simulate_fmu(
        feeder, stop_time=20 * H, output_interval=H, start_values=gravity(feeder, [0.0, 0.0, 0.0]),
        output=[*axes, "mass"], step_finished=push,
    )
    x = result[MOMENTUM][:, 0] if len(axes) == 1 else result[axes[0]]
    time = result["time"]
    assert np.all(x[time <= 10 * H + 1e-9] == 0)
    # The trough of the scene holds the grains by their weight only.
    after = time > 12 * H
    slope = np.polyfit(time[after], x[after], 1)[0]
    assert np.isclose(slope, 9.0 * result["mass"][0], rtol=1e-9)


def test_texts_and_truth_values_steer_the_results(feeder, tmp_path):
    once = {"output.directory": str(tmp_path), "output.interval": 2 * H}
    simulate(feeder, once)
    (run,) = tmp_path.iterdir()
    frames = sorted(run.glob("spheres_*.vtu"))
    assert len(frames) == 11
    # An earlier run stands unless told otherwise.
    with pytest.raises(fmpy.fmi1.FMICallException):
        simulate(feeder, once)
    simulate(feeder, once | {"output.overwrite": True}, stop=4 * H)
    assert len(list(run.glob("spheres_*.vtu"))) == 3
