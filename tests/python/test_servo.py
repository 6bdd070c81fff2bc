"""Samples between servo walls: the examples `shear` and `triaxial`, up to the first strain."""

import subprocess

import numpy as np
import pytest
from conftest import scene

PRESSURE = 1e4
# Simulated seconds [s]: the walls have pressed, the sample has yielded.
STOP = 0.2


@pytest.fixture(scope="module")
def history(command, tmp_path_factory):
    """Name -> columns of the history, by their names without unit."""
    tables = {}
    for name in ("shear", "triaxial"):
        folder = tmp_path_factory.mktemp("runs") / name
        subprocess.run([command, "run", scene(name), "-o", folder, "--stop", str(STOP)], check=True, timeout=600)
        table = np.genfromtxt(folder / "history.csv", delimiter=",", names=True, deletechars="")
        tables[name] = {column.split("_[")[0]: table[column] for column in table.dtype.names}
    return tables


@pytest.mark.parametrize("name", ["shear", "triaxial"])
def test_overlaps_are_a_thousandth_of_a_radius_at_every_step(history, name):
    assert 0 < history[name]["maxOverlap"].max() <= 1e-3


def test_the_lid_holds_its_load_and_both_halves_push_alike(history):
    shear = history["shear"]
    moving = shear["time"] > 0.12
    lid, upper, lower = (shear[f"boundary.{of}.averageForce[{k}]"][moving] for of, k in (("lid", 3), ("upper", 1), ("lower", 1)))
    load = PRESSURE * 0.12 * 0.06
    assert np.mean(lid) == pytest.approx(load, rel=0.01)
    # Without friction on the other walls the forces along x are in balance.
    assert np.mean(upper + lower) == pytest.approx(0, abs=0.01 * load)
    ratio = np.mean(-upper / lid)
    assert 0.35 < ratio < 0.65, ratio


def test_servo_walls_hold_the_confining_pressure_while_the_deviator_rises(history):
    test = history["triaxial"]
    force = {b: test[f"boundary.{b}.averageForce[{k}]"] for b, k in (("west", 1), ("east", 1), ("south", 2), ("north", 2), ("top", 3), ("bottom", 3))}
    at = {b: test[f"boundary.{b}.position[{k}]"] for b, k in (("west", 1), ("east", 1), ("south", 2), ("north", 2), ("top", 3), ("bottom", 3))}
    length, width, height = (at[b] - at[a] for a, b in (("west", "east"), ("south", "north"), ("bottom", "top")))
    late = test["time"] > 0.15
    for a, b, area in (("west", "east", width * height), ("south", "north", length * height)):
        for wall, sign in ((a, -1), (b, 1)):
            stress = np.mean((sign * force[wall] / area)[late])
            assert stress == pytest.approx(PRESSURE, rel=0.02), wall
    axial = force["top"] / (length * width)
    assert np.mean(axial[late]) == pytest.approx(np.mean((-force["bottom"] / (length * width))[late]), rel=0.01)
    ratio = np.mean(axial[late]) / PRESSURE
    # Its friction angle so far: 10 to 25 degrees.
    assert 1.42 < ratio < 2.46, ratio
