"""Clumps through their FMU: a dumbbell in free flight, a saved state, and the arrays of its members."""

import subprocess

import numpy as np
import pytest
from fmu import Slave

G, STEP = 9.81, 1e-3
SCENE = f"""
title = "Clumps"

[simulation]
duration = 1.0
step = {STEP}
fixed_step = true
strict = true

[[material]]
name = "glass"
density = 2500.0
friction = 0.4
restitution = 0.3

[[clump]]
name = "rod"
members = [
  {{ position = [-0.05, 0.0, 0.0], radius = 0.06 }},
  {{ position = [0.05, 0.0, 0.0], radius = 0.06 }},
]

[[spheres]]
name = "rods"
material = "glass"
clump = "rod"
positions = [[0.0, 0.0, 0.5], [0.02, 0.01, 0.8]]
rotations = [[0.0, 0.0, 0.0]]
spin = [0.0, 0.0, 3.0]

[[boundary]]
name = "floor"
material = "glass"
faces = [{{ plane = {{ point = [0.0, 0.0, 0.0], normal = [0.0, 0.0, 1.0] }} }}]

[[probe]]
name = "one"
sphere = "rods[0]"

[[probe]]
name = "two"
sphere = "rods[1]"
"""
NAMES = [f"probe.{p}.{q}[{k}]" for p in ("one", "two") for q in ("position", "velocity") for k in (1, 2, 3)]


@pytest.fixture(scope="module")
def fmu(command, tmp_path_factory):
    folder = tmp_path_factory.mktemp("clumps")
    (folder / "clumps.toml").write_text(SCENE)
    subprocess.run([command, "export", folder / "clumps.toml", "-o", folder / "clumps.fmu"], check=True)
    return folder / "clumps.fmu"


def advance(slave, start, count):
    """Rows of positions and velocities of both members over `count` steps from step `start`."""
    rows = []
    for k in range(start, start + count):
        slave.step(k * STEP, STEP)
        rows.append(slave.get(*NAMES))
    return np.array(rows)


def test_members_fly_with_their_clump(fmu):
    with Slave(fmu) as slave:
        rows = advance(slave, 0, 200)
        time = STEP * np.arange(1, 201)
        one, two = rows[:, 0:3], rows[:, 6:9]
        middle = 0.5 * (one + two)
        np.testing.assert_allclose(middle[:, 2], 0.5 - 0.5 * G * time**2, atol=1e-12)
        arm = 0.05 * np.stack([np.cos(3 * time), np.sin(3 * time), 0 * time], axis=1)
        np.testing.assert_allclose(two - middle, arm, atol=1e-12)
        turning = 0.15 * np.stack([-np.sin(3 * time), np.cos(3 * time), 0 * time], axis=1)
        np.testing.assert_allclose(0.5 * (rows[:, 9:12] - rows[:, 3:6]), turning, atol=1e-12)


def test_a_saved_state_goes_on_with_the_same_bits(fmu):
    with Slave(fmu) as slave:
        advance(slave, 0, 300)
        state = slave.fmi.getFMUstate()
        first = advance(slave, 300, 300)
        slave.fmi.setFMUstate(state)
        assert np.array_equal(advance(slave, 300, 300), first)
        # Both have met the floor and each other.
        assert np.ptp(first[:, 2]) > 0
        assert slave.get("maxOverlap")[0] <= 1e-4
        distance = np.linalg.norm(first[:, 0:3] - first[:, 6:9], axis=1)
        np.testing.assert_allclose(distance, 0.1, rtol=1e-13)
