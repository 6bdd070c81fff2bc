"""Closed forms met through the FMU, driven by fmpy: rows 4, 7, 9, 11, 13 and 14 of tests/verification, same errors."""

import subprocess

import numpy as np
import pytest
from conftest import ROOT
from fmu import Slave

G = 9.81


@pytest.fixture(scope="module")
def case(command, tmp_path_factory):
    """Exports a scene of tests/verification/scenes and opens it."""
    folder = tmp_path_factory.mktemp("cases")

    def opened(name):
        path = folder / f"{name}.fmu"
        subprocess.run([command, "export", ROOT / f"tests/verification/scenes/{name}.toml", "-o", path], check=True)
        return Slave(path)

    return opened


class Run:
    """Steps an instance; the overlap and the balance of momentum are checked in every step."""

    def __init__(self, slave, h, gravity=G):
        self.slave, self.h, self.k = slave, h, 0
        marker = ".averageForce[1]"
        self.boundaries = [n.removesuffix(marker) for n in slave.measured() if n.endswith(marker)]
        self.weight = slave.get("mass")[0] * np.array([0.0, 0.0, -gravity])
        self.momentum = np.array(slave.vector("momentum"))

    def step(self):
        self.slave.step(self.k * self.h, self.h)
        self.k += 1
        assert self.slave.get("maxOverlap")[0] <= 1e-6
        forces = [-np.array(self.slave.vector(f"{b}.averageForce")) for b in self.boundaries]
        after = np.array(self.slave.vector("momentum"))
        residue = after - self.momentum - self.h * (sum(forces) + self.weight)
        scale = self.h * (sum(np.linalg.norm(f) for f in forces) + np.linalg.norm(self.weight))
        assert np.linalg.norm(residue) <= 1e-9 * (scale + np.linalg.norm(self.momentum))
        self.momentum = after

    @property
    def time(self):
        return self.k * self.h

    def vector(self, name):
        return np.array(self.slave.vector(name))


def test_row_4_rolls_down_an_incline(case):
    with case("incline") as slave:
        run, mass = Run(slave, 1e-3), slave.get("mass")[0]
        down = np.array([np.sqrt(3) / 2, 0.0, -0.5])
        for _ in range(1000):
            run.step()
            speed = 5 / 7 * G * 0.5 * run.time
            assert np.isclose(run.vector("probe.ball.velocity") @ down, speed, rtol=1e-6)
            assert np.isclose(run.vector("probe.ball.angularVelocity")[1] * 0.1, speed, rtol=1e-6)
            friction = run.vector("boundary.incline.force") @ down
            assert np.isclose(friction, 2 / 7 * mass * G * 0.5, rtol=1e-6)


def test_row_7_presses_on_both_sides_of_a_groove(case):
    with case("groove") as slave:
        run, weight = Run(slave, 1e-3), slave.get("mass")[0] * G
        for _ in range(50):
            run.step()
        for wall, share in (("left", np.sin(np.pi / 4)), ("right", np.sin(np.pi / 6))):
            force = np.linalg.norm(run.vector(f"boundary.{wall}.force"))
            assert np.isclose(force, weight * share / np.sin(np.radians(75)), rtol=1e-6)


def test_row_9_sticks_or_slips_at_a_wall(case):
    mu, e, speed = 0.2, 0.5, 4.0
    with case("impact") as slave:
        run = Run(slave, 1e-3, gravity=0.0)
        for _ in range(40):
            run.step()
        for name, angle in (("steep", np.radians(20)), ("flat", np.radians(60))):
            normal, tangential = speed * np.cos(angle), speed * np.sin(angle)
            push = min(mu * (1 + e) * normal, 2 / 7 * tangential)
            v, w = run.vector(f"probe.{name}.velocity"), run.vector(f"probe.{name}.angularVelocity")
            assert np.allclose(v, [tangential - push, 0.0, e * normal], atol=1e-9 * speed)
            assert np.allclose(w * 0.1, [0.0, 2.5 * push, 0.0], atol=1e-9 * speed)


def test_row_11_slides_until_it_rolls(case):
    mu, v0 = 0.2, 2.0
    with case("slide") as slave:
        run, mass = Run(slave, 1e-4), slave.get("mass")[0]
        slip = v0
        while slip > 1e-6:
            run.step()
            slip = run.vector("probe.ball.velocity")[0] - 0.1 * run.vector("probe.ball.angularVelocity")[1]
        assert np.isclose(run.time, 2 * v0 / (7 * mu * G), rtol=1e-3)
        assert np.isclose(run.vector("probe.ball.position")[0], 12 * v0**2 / (49 * mu * G), rtol=1e-3)
        for _ in range(300):
            run.step()
        assert np.isclose(run.vector("probe.ball.velocity")[0], 5 / 7 * v0, rtol=1e-6)
        friction, impact, residue = slave.get("frictionEnergy", "impactEnergy", "residualEnergy")
        assert np.isclose(friction, mass * v0**2 / 7, rtol=1e-3)
        assert impact == 0.0 and abs(residue) < 1e-5 * friction


def test_row_13_swings_in_a_trough(case):
    with case("trough") as slave:
        run, crossings = Run(slave, 1e-3), []
        before = run.vector("probe.ball.position")[0]
        while len(crossings) < 3:
            run.step()
            now = run.vector("probe.ball.position")[0]
            if before * now <= 0:
                crossings.append(run.time - run.h * now / (now - before))
            before = now
        period = 2 * np.pi * np.sqrt(7 * 0.9 / (5 * G))
        assert np.isclose(crossings[2] - crossings[0], period, rtol=1e-3)


def test_row_14_leaves_an_edge(case):
    with case("edge") as slave:
        run, loaded = Run(slave, 1e-4), []
        while True:
            x = run.vector("probe.ball.position")
            angle = np.arctan2(x[0], x[2])
            run.step()
            force = -run.vector("boundary.step.force") @ np.array([np.sin(angle), 0.0, np.cos(angle)])
            if force == 0.0:
                break
            loaded.append((angle, force))
        (a, f), (b, g) = loaded[-2:]
        # mu = 100: it slips in the last hundredth of a degree only.
        assert np.isclose(np.degrees(b + (b - a) * g / (f - g)), 53.962, rtol=2e-4)
