"""The hopper that starts full: 2000 spheres settled at export, in equilibrium at t = 0, let out by the gate."""

import subprocess

import numpy as np
import pytest
from conftest import ROOT
from fmu import Slave

GRAVITY = 9.81
STEP = 0.005
# Of the gaps, as the scene asks for it.
TOLERANCE = 1e-4


@pytest.fixture(scope="module")
def hopper(command, tmp_path_factory):
    """The FMU with the settled spheres."""
    path = tmp_path_factory.mktemp("hopper") / "hopper.fmu"
    scene = ROOT / "examples" / "hopper" / "hopper.toml"
    subprocess.run([command, "export", scene, "--settle", "4", "--until-rest", "-o", path], check=True)
    return path


def test_a_settled_hopper_starts_in_equilibrium_and_empties_by_its_gate(hopper):
    with Slave(hopper) as slave:
        forces = [f"boundary.{of}.force[{k}]" for of in ("bin", "gate") for k in (1, 2, 3)]
        mass, *force = slave.get("mass", *forces)
        weight = mass * GRAVITY
        total = np.sum(np.reshape(force, (2, 3)), axis=0)
        assert np.linalg.norm(total - [0, 0, -weight]) <= 1e-6 * weight, (total, weight)
        assert slave.get("maxOverlap")[0] <= TOLERANCE

        stock = slave.get("sensor.stock.mass")[0]
        assert stock == mass
        passed = 0.0
        for k in range(80):
            # A turn of 1.2 rad downwards within 0.1 s.
            slave.set("boundary.gate.angle", min(12.0 * (k + 1) * STEP, 1.2))
            slave.step(k * STEP, STEP)
            rate, left, kept = slave.get("sensor.outflow.rate", "sensor.outflow.mass", "sensor.stock.mass")
            passed += rate * STEP
            assert abs(passed - left) <= 1e-12 * mass
            assert abs(stock - kept - left) <= 1e-12 * mass
            assert slave.get("maxOverlap")[0] <= TOLERANCE
        assert left > 0.01 * mass
