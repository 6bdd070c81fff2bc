"""A driven body through its FMU: a piston on a slide that the importer pushes."""

import subprocess
from itertools import pairwise

import numpy as np
import pytest
from fmu import Slave

MASS, RADIUS, G, STEP = 2.0, 0.1, 9.81, 1e-3
AREA = 0.3
SPHERE = 2500.0 * 4.0 / 3.0 * np.pi * RADIUS**3
SCENE = f"""
title = "piston"
[simulation]
duration = 1.0
step = {STEP}
fixed_step = true
strict = true
[simulation.tolerance]
force = 1e-8
gap = 1e-6
slip = 1e-6
opening = 0
[[material]]
name = "glass"
density = 2500.0
[[spheres]]
name = "grains"
material = "glass"
radius = [{RADIUS}, {RADIUS}]
positions = [[0.0, 0.0, {RADIUS}], [0.0, 0.0, {3 * RADIUS}]]
[[boundary]]
name = "floor"
material = "glass"
faces = [{{ plane = {{ point = [0.0, 0.0, 0.0], normal = [0.0, 0.0, 1.0] }} }}]
[[boundary]]
name = "piston"
material = "glass"
faces = [{{ plane = {{ point = [0.0, 0.0, {4 * RADIUS}], normal = [0.0, 0.0, -1.0] }} }}]
body = {{ mass = {MASS}, joint = {{ slide = [0.0, 0.0, -1.0] }} }}
input = "load"
"""


@pytest.fixture(scope="module")
def piston(command, tmp_path_factory):
    folder = tmp_path_factory.mktemp("piston")
    (folder / "piston.toml").write_text(SCENE)
    subprocess.run([command, "export", folder / "piston.toml", "-o", folder / "piston.fmu"], check=True)
    return folder / "piston.fmu"


@pytest.fixture(scope="module")
def servo(command, tmp_path_factory):
    folder = tmp_path_factory.mktemp("servo")
    wall = f"servo = {{ pressure = 400.0, area = {AREA}, input = true }} }}"
    text = SCENE.replace("[0.0, 0.0, -1.0] } }\ninput = \"load\"", f"[0.0, 0.0, -1.0] }}, limits = {{ lower = -0.02 }}, {wall}")
    assert "servo" in text
    (folder / "servo.toml").write_text(text)
    subprocess.run([command, "export", folder / "servo.toml", "-o", folder / "servo.fmu"], check=True)
    return folder / "servo.fmu"


def test_the_floor_carries_the_pressure_that_the_importer_asks_for(servo):
    with Slave(servo) as slave:
        assert slave.get("boundary.piston.pressure") == [400.0]
        for k in range(40):
            pressure = 400.0 if k < 10 else 400.0 + 50.0 * k
            if k >= 10:
                slave.set("boundary.piston.pressure", pressure)
            slave.step(k * STEP, STEP)
            pressed = pressure * AREA + MASS * G
            assert slave.vector("boundary.piston.averageForce")[2] == pytest.approx(pressed, rel=1e-6)
            floor = -slave.vector("boundary.floor.averageForce")[2]
            assert floor == pytest.approx(pressed + 2 * SPHERE * G, rel=1e-6)
            assert slave.get("boundary.piston.jointForce") == [0.0]


def test_a_piston_that_is_sucked_up_hangs_on_its_stop(servo):
    """Travel is counted along the slide, which points down: the lower stop lies above."""
    with Slave(servo) as slave:
        for k in range(200):
            slave.set("boundary.piston.pressure", -400.0)
            slave.step(k * STEP, STEP)
        assert slave.get("boundary.piston.jointTravel") == pytest.approx([-0.02], abs=1e-6 * RADIUS)
        assert slave.get("boundary.piston.jointForce") == pytest.approx([400.0 * AREA - MASS * G], rel=1e-6)


def load(time):
    return 50.0 + 400.0 * time


def advance(slave, start, end):
    """Steps with a growing load; all real outputs after each step, as bytes."""
    outputs = slave.measured()
    seen = []
    for k in range(start, end):
        slave.set("boundary.piston.appliedForce", load(k * STEP))
        slave.step(k * STEP, STEP)
        seen.append(np.array(slave.get(*outputs)).tobytes())
    return seen


def test_the_floor_carries_load_and_weights(piston):
    with Slave(piston) as slave:
        for k in range(40):
            slave.set("boundary.piston.appliedForce", load(k * STEP))
            slave.step(k * STEP, STEP)
            pressed = load(k * STEP) + MASS * G
            # Along +z the spheres push the piston; the load is held over the step.
            assert slave.vector("boundary.piston.averageForce")[2] == pytest.approx(pressed, rel=1e-6)
            floor = -slave.vector("boundary.floor.averageForce")[2]
            assert floor == pytest.approx(pressed + 2 * SPHERE * G, rel=1e-6)
            assert slave.vector("boundary.piston.position")[2] == pytest.approx(0.0, abs=1e-6 * RADIUS)
            assert np.linalg.norm(slave.vector("boundary.piston.velocity")) < 1e-6


def test_a_pulled_piston_leaves_as_newton_has_it(piston):
    up = 3.0 * MASS * G
    with Slave(piston) as slave:
        speeds = []
        for k in range(20):
            slave.set("boundary.piston.appliedForce", -up)
            slave.step(k * STEP, STEP)
            speeds.append(slave.vector("boundary.piston.velocity")[2])
        for before, after in pairwise(speeds):
            assert (after - before) / STEP == pytest.approx(2.0 * G, rel=1e-9)


def test_a_restored_piston_repeats_the_same_bytes(piston):
    with Slave(piston) as slave:
        advance(slave, 0, 10)
        blob = slave.save()
        first = advance(slave, 10, 30)
        slave.restore(blob)
        assert advance(slave, 10, 30) == first
