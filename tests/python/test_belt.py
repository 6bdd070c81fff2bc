"""A belt as FMU input: what it carries, the force it needs, and its speed in a saved state."""

import subprocess

import numpy as np
import pytest
from fmu import Slave

SPEED, FRICTION, G = 1.4, 0.3, 9.81
STEP = 1e-3
SCENE = f"""
title = "A sled on a belt"

[simulation]
duration = 1.0
step = {STEP}
fixed_step = true
strict = true
tolerance = {{ gap = 1e-6, slip = 1e-6, force = 1e-6, opening = 0 }}

[[material]]
name = "glass"
density = 2500.0
friction = {FRICTION}

[[spheres]]
name = "sled"
material = "glass"
radius = 0.1
positions = [[0.0, 0.0, 0.1]]
lock = ["rotations"]

[[boundary]]
name = "belt"
material = "glass"
faces = [{{ plane = {{ point = [0.0, 0.0, 0.0], normal = [0.0, 0.0, 1.0] }} }}]
surface_velocity = [{SPEED}, 0.0, 0.0]
surface_input = true

[[probe]]
name = "sled"
sphere = "sled"
"""


@pytest.fixture(scope="module")
def fmu(command, tmp_path_factory):
    folder = tmp_path_factory.mktemp("belt")
    (folder / "belt.toml").write_text(SCENE)
    subprocess.run([command, "export", folder / "belt.toml", "-o", folder / "belt.fmu"], check=True)
    return folder / "belt.fmu"


def advance(slave, start, count):
    """Forces on the belt (averaged), its power, and velocities of the sled over `count` steps from step `start`."""
    rows = []
    for k in range(start, start + count):
        slave.step(k * STEP, STEP)
        force = slave.vector("boundary.belt.averageForce")
        rows.append([*force, *slave.get("boundary.belt.power"), *slave.vector("probe.sled.velocity")])
    return np.array(rows)


def test_the_belt_needs_mu_m_g_while_it_slips_and_nothing_after(fmu):
    with Slave(fmu) as slave:
        variable = {v.name: v for v in slave.description.modelVariables}["boundary.belt.surfaceVelocity[1]"]
        assert (variable.causality, float(variable.start), variable.unit) == ("input", SPEED, "m/s")
        weight = slave.get("mass")[0] * G
        sliding = int(SPEED / (FRICTION * G) / STEP)
        rows = advance(slave, 0, sliding - 1)
        assert np.allclose(rows[:, 0], -FRICTION * weight, rtol=1e-6)
        assert np.allclose(rows[:, 2], -weight, rtol=1e-6)
        assert np.allclose(rows[:, 3], -FRICTION * weight * SPEED, rtol=1e-6)
        time = STEP * np.arange(1, sliding)
        assert np.allclose(rows[:, 4], FRICTION * G * time, rtol=1e-6)
        carried = advance(slave, sliding - 1, 100)[5:]
        assert np.allclose(carried[:, 4], SPEED, rtol=1e-6)
        assert np.abs(carried[:, 0]).max() < 1e-5 * weight


def test_a_commanded_belt_brakes_and_its_command_is_saved(fmu):
    with Slave(fmu) as slave:
        advance(slave, 0, 600)
        slave.set("boundary.belt.surfaceVelocity[1]", 0.0)
        slave.set("boundary.belt.surfaceVelocity[2]", 0.2)
        blob = slave.save()
        first = advance(slave, 600, 600)
        assert np.allclose(first[-1, 4:], [0.0, 0.2, 0.0], atol=1e-6)
        # While it slips, friction points along the slip of the belt against the sled.
        slip = np.array([0.0 - SPEED, 0.2 - 0.0]) / np.hypot(SPEED, 0.2)
        weight = slave.get("mass")[0] * G
        assert np.allclose(first[100, :2], -FRICTION * weight * slip, rtol=1e-4)
        slave.set("boundary.belt.surfaceVelocity[1]", 9.0)
        slave.restore(blob)
        assert advance(slave, 600, 600).tobytes() == first.tobytes()
