"""Derivatives of the FMU: of inputs and outputs by time, of outputs by inputs."""

import subprocess

import numpy as np
import pytest
from conftest import scene as feeder
from fmpy.fmi1 import FMICallException
from fmu import Slave
from test_fmi3 import Unit

RADIUS, DENSITY, G, MU = 0.1, 2500.0, 9.81, 0.2
MASS = DENSITY * 4.0 / 3.0 * np.pi * RADIUS**3
STEP = 1e-3


def scene(floor, extra="", height=RADIUS, lock="", tolerance=1e-9):
    """One sphere above a floor with the keys `floor`."""
    return f"""
title = "one sphere"
[simulation]
duration = 1.0
step = {STEP}
fixed_step = true
strict = true
[simulation.tolerance]
gap = {tolerance}
slip = {tolerance}
force = {tolerance}
opening = 0
[[material]]
name = "glass"
density = {DENSITY}
friction = {MU}
[[spheres]]
name = "ball"
material = "glass"
radius = {RADIUS}
positions = [[0.0, 0.0, {height}]]
{lock}
[[boundary]]
name = "floor"
material = "glass"
faces = [{{ plane = {{ point = [0.0, 0.0, 0.0], normal = [0.0, 0.0, 1.0] }} }}]
{floor}
[[probe]]
name = "ball"
sphere = "ball"
{extra}
"""


PISTON = """
[[boundary]]
name = "piston"
material = "glass"
faces = [{ plane = { point = [0.0, 0.0, 9.0], normal = [0.0, 0.0, -1.0] } }]
body = { mass = 2.0, gravity = false, joint = { slide = [1.0, 0.0, 0.0] } }
input = "load"
"""


@pytest.fixture(scope="module")
def export(command, tmp_path_factory):
    """Exports a scene's text once for each version asked for."""
    folder, made = tmp_path_factory.mktemp("derivatives"), {}

    def exported(text, version=2):
        if (text, version) not in made:
            source, target = folder / f"{len(made)}.toml", folder / f"{len(made)}.fmu"
            source.write_text(text)
            subprocess.run([command, "export", source, "--fmi", str(version), "-o", target], check=True)
            made[text, version] = target
        return made[text, version]

    return exported


def give(slave, name, value, *rates):
    """Sets an input and its derivatives."""
    reference = slave.reference[name]
    slave.set(name, value)
    orders = list(range(1, len(rates) + 1))
    slave.fmi.setRealInputDerivatives([reference] * len(rates), orders, list(rates))


def rate(slave, *names):
    return slave.fmi.getRealOutputDerivatives([slave.reference[n] for n in names], [1] * len(names))


def test_a_pose_with_derivatives_has_no_lag(export):
    """Taylor polynomial of order 2 of a sine: the error at the end of a step is of order 3 in the step."""
    omega, size = 2 * np.pi * 3.0, 0.02
    worst = []
    for h in (8e-3, 4e-3):
        with Slave(export(scene('input = "pose"', height=0.5))) as slave:
            errors = []
            for k in range(int(0.2 / h)):
                t = k * h
                sine, cosine = np.sin(omega * t), np.cos(omega * t)
                rates = (size * omega * cosine, -size * omega**2 * sine)
                give(slave, "boundary.floor.translation[1]", size * sine, *rates)
                slave.step(t, h)
                errors.append(slave.get("boundary.floor.position[1]")[0] - size * np.sin(omega * (t + h)))
            worst.append(np.abs(errors).max())
    assert worst[0] < size * (omega * 8e-3) ** 3 / 6 * 1.01
    assert 7.0 < worst[0] / worst[1] < 9.0, worst


@pytest.mark.parametrize(
    "kind, name, power, order",
    [("pose", "translation[1]", 0, 2), ("twist", "velocity[1]", 1, 2), ("motion", "translation[1]", 0, 2),
     ("motion", "velocity[1]", 1, 1), ("pose", "rotation[3]", 0, 2), ("twist", "angularVelocity[3]", 1, 2)],
)
def test_the_boundary_follows_the_polynomial(export, kind, name, power, order):
    h = 5 * STEP
    u, first, second = (0.02, 0.3, 4.0) if power == 0 else (0.3, 4.0, 50.0)
    second = second if order == 2 else 0.0
    with Slave(export(scene(f'input = "{kind}"', height=0.5))) as slave:
        turns = "rotation" in name or "angular" in name
        start = 0.02 if kind == "motion" and power else 0.0
        if start:
            slave.set("boundary.floor.translation[1]", start)
        give(slave, f"boundary.floor.{name}", u, *(first, second)[:order])
        slave.step(0.0, h)
        if turns:
            w, *q = slave.get(*(f"boundary.floor.orientation[{k}]" for k in (1, 2, 3, 4)))
            found = 2 * np.arctan2(q[2], w)
        else:
            found = slave.get("boundary.floor.position[1]")[0]
        if power == 0:
            expected = u + first * h + second * h**2 / 2
        else:
            expected = start + u * h + first * h**2 / 2 + second * h**3 / 6
        assert found == pytest.approx(expected, abs=1e-13)
        # They hold for one step: a pose goes back to what is set, a speed to what it was.
        before = found
        slave.step(h, h)
        found = slave.get("boundary.floor.position[1]")[0]
        if kind == "pose" and not turns:
            assert found == pytest.approx(u, abs=1e-13)
        elif kind == "twist" and not turns:
            assert found == pytest.approx(before + u * h, abs=1e-13)


def test_setting_an_input_takes_its_derivatives_back_and_states_keep_them(export):
    h, name = 2 * STEP, "boundary.floor.velocity[1]"
    with Slave(export(scene('input = "twist"', height=0.5))) as slave:
        give(slave, name, 0.1, 5.0)
        blob = slave.save()
        slave.step(0.0, h)
        curved = slave.get("boundary.floor.position[1]")[0]
        assert curved == pytest.approx(0.1 * h + 5.0 * h**2 / 2, abs=1e-14)
        slave.restore(blob)
        slave.step(0.0, h)
        assert slave.get("boundary.floor.position[1]")[0] == curved
        slave.restore(blob)
        slave.set(name, 0.1)
        slave.step(0.0, h)
        assert slave.get("boundary.floor.position[1]")[0] == pytest.approx(0.1 * h, abs=1e-15)


def test_a_load_that_grows_is_integrated_to_second_order(export):
    """x''= (f + f' t)/m from rest."""
    force, growth, h, errors = 3.0, 80.0, 0.04, []
    exact = force / 2.0 * h**2 / 2 + growth / 2.0 * h**3 / 6
    for step in (4e-3, 2e-3):
        text = scene("", PISTON, height=0.5).replace(f"step = {STEP}", f"step = {step}")
        with Slave(export(text)) as slave:
            give(slave, "boundary.piston.appliedForce", force, growth)
            slave.step(0.0, h)
            errors.append(slave.get("boundary.piston.position[1]")[0] - exact)
    # The first half step knows the load at rest, which is none: of the constant part, first order in the step.
    assert abs(errors[1]) < 0.1 * exact
    assert 1.8 < errors[0] / errors[1] < 4.2, errors


def test_refused_derivatives_say_why_and_change_nothing(export):
    with Slave(export(scene('input = "twist"'))) as slave:
        speed, force = slave.reference["boundary.floor.velocity[1]"], slave.reference["boundary.floor.force[1]"]
        for references, orders, values in [
            ([speed], [3], [1.0]), ([speed], [0], [1.0]), ([force], [1], [1.0]), ([speed] * 2, [1, 1], [1.0, np.nan]),
        ]:
            with pytest.raises(FMICallException):
                slave.fmi.setRealInputDerivatives(references, orders, values)
        slave.step(0.0, STEP)
        assert slave.get("boundary.floor.position[1]")[0] == 0.0
        for references, orders in [([speed], [1]), ([force], [2]), ([10**6], [1])]:
            with pytest.raises(FMICallException):
                slave.fmi.getRealOutputDerivatives(references, orders)


def test_output_derivatives_are_velocities_and_backward_differences(export):
    """A ball on a floor that is lifted with a growing acceleration, v = j t^2/2: force m (g + j t)."""
    jerk, h = 30.0, 5 * STEP
    text = scene('input = "twist"')
    with Slave(export(text)) as slave, Unit(export(text, 3)) as unit:
        assert rate(slave, "boundary.floor.force[3]", "probe.ball.velocity[3]") == [0.0, 0.0]
        for k in range(6):
            t = k * h
            give(slave, "boundary.floor.velocity[3]", jerk * t**2 / 2, jerk * t, jerk)
            give(slave, "boundary.floor.velocity[1]", 0.05, 0.4)
            slave.step(t, h)
            averages = [] if k == 0 else before
            before = slave.get("boundary.floor.averageForce[3]")
        names = ["position[1]", "position[3]"]
        speeds = rate(slave, *(f"probe.ball.{n}" for n in names))
        assert speeds == pytest.approx(slave.get("probe.ball.velocity[1]", "probe.ball.velocity[3]"), abs=1e-10)
        # Of the floor: its velocity over the last internal step, that of the step's middle.
        middle = t + h - STEP / 2
        floor = rate(slave, "boundary.floor.position[3]", "boundary.floor.position[1]")
        assert floor == pytest.approx([jerk * middle**2 / 2 + jerk * STEP**2 / 24, 0.05 + 0.4 * (h - STEP / 2)], abs=1e-9)
        # Of the ball: the acceleration in the last internal step, and the force that grows with the jerk.
        assert rate(slave, "probe.ball.velocity[3]")[0] == pytest.approx(jerk * (t + h - STEP), rel=1e-6)
        growth = rate(slave, "boundary.floor.force[3]", "probe.ball.contactForce[3]", "boundary.floor.averageForce[3]")
        assert growth[:2] == pytest.approx([-MASS * jerk, MASS * jerk], rel=1e-5)
        assert growth[2] == pytest.approx((before[0] - averages[0]) / h, rel=1e-9)
        assert growth[2] == pytest.approx(-MASS * jerk, rel=1e-5)
        # The other version, from the same state: the same numbers.
        unit.restore(slave.save())
        arrays = [unit.reference(n) for n in ("probe.ball.position", "spheres.position", "boundary.floor.force")]
        values = (len(arrays) + 6) * [0.0]
        got = derivatives3(unit, arrays, len(values))
        assert got[:3] == got[3:6] == rate(slave, *(f"probe.ball.position[{k}]" for k in (1, 2, 3)))
        assert got[6:] == rate(slave, *(f"boundary.floor.force[{k}]" for k in (1, 2, 3)))


def derivatives3(unit, references, count):
    """`fmi3GetOutputDerivatives` of arrays, which fmpy's own wrapper does not know."""
    import ctypes

    n = len(references)
    values = (ctypes.c_double * count)()
    unit.fmi.fmi3GetOutputDerivatives(
        unit.fmi.component, (ctypes.c_uint32 * n)(*references), n, (ctypes.c_int32 * n)(*[1] * n), values, count,
    )
    return list(values)


def test_after_an_impact_the_wrench_has_no_derivative(export):
    fall = np.sqrt(2 * 0.01 / G)
    with Slave(export(scene("", height=RADIUS + 0.01))) as slave:
        h, hit = 10 * STEP, []
        for k in range(12):
            slave.step(k * h, h)
            force = slave.get("boundary.floor.averageForce[3]")[0]
            hit.append((force, *rate(slave, "boundary.floor.averageForce[3]", "boundary.floor.force[3]")))
    struck = int(fall / h)
    assert hit[struck][0] < -MASS * G and hit[struck][1:] == (0.0, 0.0)
    # Later it is that of rest: from one step's average to the next nothing changes.
    assert abs(hit[-1][1]) < 1e-5 * MASS * G / h


def jacobian(slave, outputs, inputs):
    """`fmi2GetDirectionalDerivative`, one input at a time."""
    unknowns = [slave.reference[n] for n in outputs]
    columns = [slave.fmi.getDirectionalDerivative(unknowns, [slave.reference[n]], [1.0]) for n in inputs]
    return np.array(columns).T


def differences(slave, blob, outputs, inputs, base, step, change):
    """Central differences of the FMU itself: put back, set, step, read."""
    columns = []
    for name in inputs:
        ends = []
        for sign in (-1, 1):
            slave.restore(blob)
            for other, value in base.items():
                slave.set(other, value + sign * change * (other == name))
            slave.step(*step)
            ends.append(np.array(slave.get(*outputs)))
        columns.append((ends[1] - ends[0]) / (2 * change))
    return np.array(columns).T


def components(*names):
    return [f"{name}[{k}]" for name in names for k in (1, 2, 3)]


MEASURED = components(
    "boundary.floor.averageForce", "boundary.floor.averageTorque", "boundary.floor.force", "boundary.floor.position",
    "probe.ball.position", "probe.ball.velocity", "probe.ball.angularVelocity", "momentum",
)


def by_vector(table):
    """Largest entry of each vector of three outputs, for each of its rows."""
    return np.repeat(np.abs(table).reshape(-1, 3, table.shape[1]).max(axis=1), 3, axis=0)


@pytest.mark.parametrize("steps", (1, 5))
def test_directional_derivatives_are_central_differences_of_the_fmu(export, steps):
    """A ball that slips on a floor with its own motion: 1e-5, and sixteen times less error for a quarter of the change."""
    inputs = components("boundary.floor.velocity", "boundary.floor.angularVelocity")
    base = dict(zip(inputs, (0.7, 0.3, 0.02, 0.03, 0.02, 0.9)))
    h = steps * STEP
    with Slave(export(scene('input = "twist"', tolerance=1e-12))) as slave:
        for k in range(4):
            blob = slave.save()
            for name, value in base.items():
                slave.set(name, value)
            slave.step(k * h, h)
        assert slave.get("solver.activeSetMargin")[0] > 0.1
        found = jacobian(slave, MEASURED, inputs)
        errors = []
        for change in (4e-3, 1e-3):
            expected = differences(slave, blob, MEASURED, inputs, base, (3 * h, h), change)
            scale = by_vector(expected)
            # Not 1e-3: the momentum of a step of 1e-3 s would be at the edge.
            told = scale > 5e-4 * scale.max()
            errors.append((np.abs(found - expected) / np.where(told, scale, 1.0))[told].max())
            assert told.sum() >= 30
    assert errors[1] < 1e-5, errors
    assert errors[0] > 8 * errors[1] or errors[0] < 2e-7, errors


def test_derivatives_survive_a_restore_and_add_up(export):
    inputs = components("boundary.floor.velocity")
    with Slave(export(scene('input = "twist"'))) as slave, Unit(export(scene('input = "twist"'), 3)) as unit:
        for k in range(3):
            slave.set(inputs[0], 0.5)
            slave.step(k * 2 * STEP, 2 * STEP)
        found = jacobian(slave, MEASURED, inputs)
        blob = slave.save()
        slave.step(6 * STEP, 2 * STEP)
        assert not np.array_equal(jacobian(slave, MEASURED, inputs), found)
        slave.restore(blob)
        assert np.array_equal(jacobian(slave, MEASURED, inputs), found)
        # A direction is the sum of its parts.
        unknowns, knowns = [[slave.reference[n] for n in names] for names in (MEASURED, inputs)]
        seed = [0.3, -2.0, 0.7]
        assert np.allclose(slave.fmi.getDirectionalDerivative(unknowns, knowns, seed), found @ seed, rtol=1e-12)
        # The other version has the same numbers, of whole arrays, and their transpose.
        unit.restore(blob)
        names = list(dict.fromkeys(n[:-3] for n in MEASURED))
        unknowns = [unit.reference(n) for n in names]
        known = [unit.reference("boundary.floor.velocity")]
        forward = unit.fmi.getDirectionalDerivative(unknowns, known, seed, nSensitivity=len(MEASURED))
        assert np.allclose(forward, found @ seed, rtol=1e-12)
        weights = np.cos(np.arange(len(MEASURED)))
        adjoint = unit.fmi.getAdjointDerivative(unknowns, known, list(weights), nSensitivity=3)
        assert np.allclose(adjoint, found.T @ weights, rtol=1e-12)
        spheres = unit.fmi.getDirectionalDerivative([unit.reference("spheres.position")], known, seed, nSensitivity=3)
        rows = [MEASURED.index(n) for n in components("probe.ball.position")]
        assert np.allclose(spheres, (found @ seed)[rows], rtol=1e-12)


def test_in_initialization_mode_they_are_of_the_forces_at_rest(export):
    text = scene('input = "twist"', height=0.5) + PLATE
    outputs, inputs = components("boundary.floor.force"), components("boundary.plate.appliedForce")
    with Unit(export(text, 3), initialize=False) as unit:
        unit.fmi.enterInitializationMode(startTime=0.0)
        unknown, known = [unit.reference("boundary.floor.force")], [unit.reference("boundary.plate.appliedForce")]
        push = unit.fmi.getDirectionalDerivative(unknown, known, [0.0, 0.0, -1.0], nSensitivity=3)
        unit.set("boundary.plate.appliedForce", 0.0, 0.0, -10.0)
        loaded = unit.get("boundary.floor.force")
        unit.fmi.exitInitializationMode()
    # Three balls carry the plate: what presses on it presses on the floor.
    assert np.allclose(push, [0, 0, -1], atol=1e-6) and len(outputs) == len(inputs) == 3
    assert loaded[2] < -10.0


PLATE = """
[[spheres]]
name = "balls"
material = "glass"
radius = [0.1, 0.1, 0.1]
positions = [[1.3, 0.0, 0.1], [0.7, 0.25, 0.1], [0.7, -0.25, 0.1]]
[[boundary]]
name = "plate"
material = "glass"
faces = [{ box = { min = [0.4, -0.6, 0.2], max = [1.6, 0.6, 0.25] } }]
body = { mass = 30.0, centre = [1.0, 0.0, 0.225], inertia = [4.0, 5.0, 8.0] }
input = "load"
"""


def test_refused_directional_derivatives_say_why(export):
    with Slave(export(scene('input = "twist"'))) as slave:
        force, speed = slave.reference["boundary.floor.force[1]"], slave.reference["boundary.floor.velocity[1]"]
        count, gravity = slave.reference["contactCount"], slave.reference["gravity[1]"]
        for unknown, known, seed in [(count, speed, 1.0), (speed, speed, 1.0), (force, gravity, 1.0), (force, speed, np.nan)]:
            with pytest.raises(FMICallException):
                slave.fmi.getDirectionalDerivative([unknown], [known], [seed])


def test_the_feeder_has_derivatives_where_its_contacts_last(export):
    """150 grains, thrown and caught: the wrench on the trough by its displacement, to 1e-5 where contacts keep their states."""
    name, h = "boundary.trough.displacement", 2e-3
    outputs = components("boundary.trough.averageForce", "boundary.trough.averageTorque", "momentum")
    text = feeder("feeder").read_text()
    tight = "[simulation]\nstep = 5e-4\nfixed_step = true\nstrict = true\ntolerance = { gap = 1e-11, slip = 1e-11, force = 1e-10, opening = 0 }"
    errors = []
    with Slave(export(text.replace("[simulation]", tight))) as slave:
        for k in range(50):
            blob = slave.save() if k >= 20 else None
            position = 1.5e-3 * np.sin(2 * np.pi * 18 * (k + 1) * h)
            slave.set(name, position)
            slave.step(k * h, h)
            if blob is None:
                continue
            end = slave.save()
            margin = slave.get("solver.activeSetMargin")[0]
            found = jacobian(slave, outputs, [name])
            expected = differences(slave, blob, outputs, [name], {name: position}, (k * h, h), 1e-8)
            scale = by_vector(expected)
            slave.restore(end)
            if scale.max() > 0:
                errors.append(((np.abs(found - expected)[scale > 0] / scale[scale > 0]).max(), margin))
    kept = [error for error, margin in errors if margin > 1e-4]
    assert len(kept) >= 10 and max(kept) < 1e-5, errors
