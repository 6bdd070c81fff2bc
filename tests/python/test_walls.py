"""What triangles of boundaries feel: frames as others read them, CSV, arrays of FMI 3.0 and their rollback, the page."""

import csv
import io
import subprocess

import browser
import fmpy
import meshio
import numpy as np
import pytest
import pyvista
from conftest import scene
from fmu import Slave
from test_fmi3 import Unit

H = 5e-3
# Balls in a pan that tilts about a turning pipe, one period away in a periodic cell, fed from above. They rub and roll on steel alone.
SCENE = """
title = "Pan"
[simulation]
duration = 1.0
communication_step = 5e-3
[output]
vtu_interval = 0.1
float64 = true
[[material]]
name = "stone"
density = 2500.0
[[material]]
name = "steel"
[[pair]]
materials = ["stone", "steel"]
friction = 0.4
rolling_friction = 0.05
restitution = 0.3
wear = 1e-11
[cell]
y = [-0.5, 0.5]
[[spheres]]
name = "balls"
material = "stone"
radius = 0.012
lattice = { origin = [-0.045, -0.61, 0.05], count = [4, 3, 3], spacing = 0.03, jitter = 0.1 }
[[source]]
name = "feed"
material = "stone"
radius = 0.01
region = { box = { min = [-0.05, 0.37, 0.2], max = [0.05, 0.47, 0.3] } }
capacity = 20
rate = 40.0
seed = 1
[[boundary]]
name = "pan"
material = "steel"
wall_fields = true
input = { hinge = [0.0, 1.0, 0.0] }
faces = [
    { rectangle = { corner = [-0.07, 0.36, 0], u = [0.14, 0, 0], v = [0, 0.12, 0] } },
    { rectangle = { corner = [-0.07, 0.36, 0], u = [0, 0, 0.4], v = [0, 0.12, 0] } },
    { rectangle = { corner = [0.07, 0.36, 0], u = [0, 0, 0.4], v = [0, 0.12, 0] } },
    { rectangle = { corner = [-0.07, 0.36, 0], u = [0.14, 0, 0], v = [0, 0, 0.4] } },
    { rectangle = { corner = [-0.07, 0.48, 0], u = [0.14, 0, 0], v = [0, 0, 0.4] } },
]
[[boundary]]
name = "pipe"
material = "steel"
motion = { constant = { angular_velocity = [0.0, 2.0, 0.0] } }
point_of_action = [0.0, 0.42, 0.02]
faces = [{ cylinder = { base = [0.0, 0.36, 0.02], axis = [0, 1, 0], radius = 0.006, height = 0.12 } }]
"""
PAN = 10


@pytest.fixture(scope="module")
def folder(command, tmp_path_factory):
    folder = tmp_path_factory.mktemp("walls")
    (folder / "pan.toml").write_text(SCENE)
    for version in ("2", "3"):
        subprocess.run([command, "export", folder / "pan.toml", "--fmi", version, "-o", folder / f"pan{version}.fmu"], check=True)
    subprocess.run([command, "run", folder / "pan.toml", "-o", folder / "run", "--view"], check=True)
    return folder


def fields(unit):
    names = ("pressure", "shear", "traction", "frictionEnergy", "impactEnergy", "wearDepth")
    return {name: unit.get(f"wall.pan.{name}") for name in names}


def advance(unit, first, count):
    for k in range(first, first + count):
        unit.set("boundary.pan.angle", 0.3 * np.sin(8 * k * H))
        unit.step(k * H, H)
        felt, area = fields(unit), unit.get("wall.pan.area")
        force = unit.get("boundary.pan.averageForce")
        scale = area @ np.linalg.norm(felt["traction"], axis=1)
        assert np.linalg.norm(area @ felt["traction"] - force) <= 1e-12 * scale
        for name in ("frictionEnergy", "impactEnergy"):
            assert felt[name].sum() == pytest.approx(unit.get(f"boundary.pan.{name}"), rel=1e-12, abs=1e-15)
        assert area @ felt["wearDepth"] == pytest.approx(unit.get("boundary.pan.wearVolume"), rel=1e-12, abs=1e-25)
    return fields(unit)


def test_arrays_add_up_and_roll_back(folder):
    assert fmpy.validation.validate_fmu(str(folder / "pan3.fmu")) == []
    with Unit(folder / "pan3.fmu") as unit:
        assert unit.shape("wall.pan.traction") == (PAN, 3) and unit.shape("wall.pan.corners") == (PAN, 3, 3)
        assert "wall.pipe.pressure" not in unit.variables
        corners = unit.get("wall.pan.corners")
        sides = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        assert np.linalg.norm(sides, axis=1) / 2 == pytest.approx(unit.get("wall.pan.area"), rel=1e-14)
        advance(unit, 0, 40)
        saved = unit.save()
        first = advance(unit, 40, 30)
        unit.restore(saved)
        again = advance(unit, 40, 30)
        assert first["wearDepth"].max() > 0 and first["impactEnergy"].max() > 0
        for name, values in first.items():
            assert np.array_equal(values, again[name]), name
        with Unit(folder / "pan3.fmu") as other:
            other.restore(saved)
            elsewhere = advance(other, 40, 30)
        assert all(np.array_equal(values, elsewhere[name]) for name, values in first.items())


def test_fmi_2_has_totals_alone(folder):
    with Slave(folder / "pan2.fmu") as slave:
        assert not [name for name in slave.reference if name.startswith("wall.")]
        outputs = {v.name: v for v in slave.description.modelVariables if v.causality == "output"}
        assert outputs["boundary.pan.wearVolume"].unit == "m3"
        assert "boundary.pipe.wearVolume" not in slave.reference
        for k in range(60):
            slave.step(k * H, H)
        assert slave.get("boundary.pan.wearVolume")[0] > 0


def test_frames_are_read_by_others(folder):
    """Tractions of all frames add up to the impulse on the pan, energies to the history's."""
    history = np.genfromtxt(folder / "run/history.csv", delimiter=",", names=True, deletechars="")
    column = lambda name: history[name.replace(" ", "_")]
    before = 0.0
    for path in sorted((folder / "run").glob("boundaries_*.vtu")):
        grid, mesh = pyvista.read(path), meshio.read(path)
        time = grid.field_data["TimeValue"][0]
        data = grid.cell_data
        for name in ("pressure", "shear", "wear_depth"):
            assert np.array_equal(data[name], mesh.cell_data[name][0])
        own = data["boundary"] == 0
        assert (data["area"][own] > 0).all() and not data["area"][~own].any() and not data["pressure"][~own].any()
        assert grid.compute_cell_sizes()["Area"][own] == pytest.approx(data["area"][own], rel=1e-12)
        rows = (column("time [s]") > before + 1e-9) & (column("time [s]") <= time + 1e-9)
        for axis in range(3):
            force = column(f"boundary.pan.averageForce[{axis + 1}] [N]")
            given = (data["area"] @ data["traction"][:, axis]) * (time - before)
            taken = force[rows].sum() * H if before < time else force[0] * (time - before)
            assert given == pytest.approx(taken, rel=1e-9, abs=1e-9)
        last = np.isclose(column("time [s]"), time)
        assert data["friction_energy"].sum() == pytest.approx(column("boundary.pan.frictionEnergy [J]")[last][0], rel=1e-12)
        before = time
    assert data["wear_depth"].max() > 0


def test_csv_is_the_frame(command, folder):
    told = subprocess.run([command, "walls", folder / "run", "--time", "0.5"], capture_output=True, text=True, check=True).stdout
    rows = list(csv.DictReader(io.StringIO(told)))
    grid = pyvista.read(folder / "run/boundaries_000005.vtu")
    assert [row["boundary"] for row in rows] == ["pan"] * PAN
    assert [row["triangle [-]"] for row in rows] == [str(k) for k in range(PAN)]
    centres = grid.cell_centers().points[:PAN]
    for axis, name in enumerate("xyz"):
        assert [float(row[f"{name} [m]"]) for row in rows] == pytest.approx(centres[:, axis], abs=1e-9)
        assert [float(row[f"shear[{axis + 1}] [Pa]"]) for row in rows] == grid.cell_data["shear"][:PAN, axis].tolist()
    assert [float(row["wear_depth [m]"]) for row in rows] == grid.cell_data["wear_depth"][:PAN].tolist()
    wrong = subprocess.run([command, "walls", folder / "run", "--boundary", "pot"], capture_output=True, text=True)
    assert wrong.returncode == 2 and "found `pot`, expected one of pan, pipe" in wrong.stderr


def test_a_run_without_walls_says_so(command, tmp_path):
    subprocess.run([command, "run", scene("bed"), "-o", tmp_path / "bed", "--stop", "0.02"], check=True)
    done = subprocess.run([command, "walls", tmp_path / "bed"], capture_output=True, text=True)
    assert done.returncode == 2 and "expected `wall_fields = true` of a boundary of its scene" in done.stderr


@browser.needed
def test_the_page_colours_what_the_frames_hold(folder, tmp_path):
    with browser.started(tmp_path) as window:
        head = window.open(folder / "run/view.html")
        names = [field["name"] for field in head["walls"]]
        assert names == ["pressure", "shear", "traction", "friction_energy", "impact_energy", "wear_depth"]
        assert [body["felt"] for body in head["boundaries"]] == [True, False]
        grid = pyvista.read(folder / "run/boundaries_000007.vtu")
        for triangle in range(PAN):
            felt = window.run(f"await sphereDda.setTime({head['times'][7]!r}); return sphereDda.felt('pan', {triangle})")
            for name in names:
                value = np.linalg.norm(grid.cell_data[name][triangle])
                top = max(field["top"] for field in head["walls"] if field["name"] == name)
                assert felt[name] == pytest.approx(value, rel=6e-3, abs=1e-5 * top), name
        window.run("await sphereDda.set({wall: 'wear_depth'})")
        assert window.log() == []
