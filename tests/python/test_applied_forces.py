"""Forces from outside on all spheres: the input `spheres.appliedForce` of FMI 3.0, and of the package."""

import os
import subprocess
import sys

import fmpy
import numpy as np
import pytest
from conftest import ROOT
from fmpy.fmi1 import FMICallException
from test_fmi3 import Unit

NAME, STEP = "spheres.appliedForce", 1e-3


@pytest.fixture(scope="module")
def fmu(units):
    """64 beads of two sizes, without a fluid."""
    return units["viscous"]


def test_it_is_there_where_the_scene_asks_for_it(fmu, units, fmus):
    (variable,) = [v for v in fmpy.read_model_description(str(fmu)).modelVariables if v.name == NAME]
    assert (variable.causality, variable.variability, variable.unit) == ("input", "continuous", "N")
    assert [int(d.start) for d in variable.dimensions] == [64, 3]
    assert set(map(float, variable.start.split())) == {0.0}
    for other in (units["feeder"], fmus["viscous"]):
        assert NAME not in {v.name for v in fmpy.read_model_description(str(other)).modelVariables}


def test_a_force_from_the_start_makes_a_parabola_and_states_hold_it(fmu):
    """`v = (F/m - g) t` from t = 0 on, whatever was restored in between."""
    rng = np.random.default_rng(1)
    with Unit(fmu, initialize=False) as unit:
        unit.fmi.enterInitializationMode(startTime=0.0, stopTime=10.0)
        mass = 2500 * 4 / 3 * np.pi * unit.get("spheres.radius") ** 3
        # Upwards, and apart by less than their distances.
        force = mass[:, None] * rng.uniform(-0.5, 0.5, (64, 3))
        force[:, 2] += mass * 9.81
        unit.set(NAME, *force.ravel())
        assert np.array_equal(unit.get(NAME), force)
        unit.fmi.exitInitializationMode()
        for k in range(5):
            unit.step(k * STEP, STEP)
        saved, expected = unit.save(), (force / mass[:, None] - [0, 0, 9.81]) * 5 * STEP
        assert unit.get("spheres.velocity") == pytest.approx(expected, abs=1e-12)
        body = unit.get("averageBodyForce")
        assert body == pytest.approx(force.sum(0) - [0, 0, 9.81 * mass.sum()], abs=1e-12)
        unit.set(NAME, *np.zeros(192))
        unit.step(5 * STEP, STEP)
        after = unit.get("spheres.velocity")
        unit.restore(saved)
        assert np.array_equal(unit.get(NAME), force)
        unit.step(5 * STEP, STEP)
        assert unit.get("spheres.velocity") == pytest.approx(expected * 6 / 5, abs=1e-12)
        assert np.abs(unit.get("spheres.velocity") - after).max() > 1e-3


def test_zeros_change_no_bit(fmu):
    def run(set_it):
        with Unit(fmu) as unit:
            for k in range(60):
                if set_it:
                    unit.set(NAME, *np.zeros(192))
                unit.step(k * STEP, STEP)
            return unit.save()

    assert run(True) == run(False)


def test_what_cannot_be_is_refused(fmu):
    with Unit(fmu) as unit:
        for values, told in ((np.full(192, np.nan), "appliedForce[1]"), (np.zeros(191), "191, for 192 elements"), (np.full(192, 1e31), "1e30")):
            with pytest.raises(FMICallException):
                unit.set(NAME, *values)
            assert told in unit.lines[-1], unit.lines
        assert not unit.get(NAME).any()
        unit.step(0.0, STEP)
        with pytest.raises(FMICallException):
            unit.fmi.getDirectionalDerivative([unit.reference("kineticEnergy")], [unit.reference(NAME)], [1.0] * 192)
        assert "an input of a boundary as known" in unit.lines[-1]


def test_the_package_sets_it(command, tmp_path):
    script = (
        "import numpy as np, sphere_dda\n"
        f"sim = sphere_dda.Simulation({str(tmp_path / 'scene.toml')!r})\n"
        f"sim['{NAME}'] = np.tile([0.0, 0.0, 1.0], (2, 1))\n"
        "sim.step(0.001)\n"
        "print(*sim.velocities[:, 2])\n"
    )
    (tmp_path / "scene.toml").write_text(
        "[simulation]\nduration = 1.0\ngravity = [0, 0, 0]\n[fmu]\napplied_forces = true\n[[material]]\nname = 'a'\ndensity = 2500.0\n"
        "[[spheres]]\nname = 's'\nmaterial = 'a'\nradius = [0.1, 0.2]\npositions = [[0, 0, 0], [1, 0, 0]]\n"
    )
    environment = os.environ | {"SPHERE_DDA": str(command), "PYTHONPATH": str(ROOT / "python")}
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, env=environment)
    assert done.returncode == 0, done.stderr
    mass = 2500 * 4 / 3 * np.pi * np.array([0.1, 0.2]) ** 3
    assert np.array(done.stdout.split(), dtype=float) == pytest.approx(1e-3 / mass, rel=1e-9)
