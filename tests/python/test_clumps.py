"""Clumps through their FMU: a dumbbell in free flight, a saved state, and the arrays of its members."""

import subprocess

import fmpy
import meshio
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


MESH = """
title = "Clumps from a mesh"

[simulation]
duration = 1.0
communication_step = 0.01

[[material]]
name = "glass"
density = 2500.0
friction = 0.4

[[clump]]
name = "brick"
stl = "meshes/brick.stl"
unit = "mm"
spheres = 9

[[spheres]]
name = "bricks"
material = "glass"
clump = "brick"
seed = 2
lattice = { origin = [0.0, 0.0, 0.1], count = [2, 2, 1], spacing = 0.12 }

[[boundary]]
name = "floor"
material = "glass"
faces = [{ plane = { point = [0.0, 0.0, 0.0], normal = [0.0, 0.0, 1.0] } }]
"""
SIDES = np.array([80.0, 60.0, 40.0])


def write_box(path, sides):
    """A closed binary STL of a box about the origin."""
    corners = 0.5 * sides * np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)])
    quads = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    facets = [t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))]
    record = np.zeros(len(facets), dtype=[("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("extra", "<u2")])
    record["corners"] = corners[np.array(facets)]
    path.parent.mkdir()
    path.write_bytes(b"box".ljust(80) + np.uint32(len(facets)).tobytes() + record.tobytes())


@pytest.mark.parametrize("version", ["2", "3"])
def test_an_fmu_carries_the_mesh_of_its_clumps(command, tmp_path, version):
    """The FMU runs without the file, with the mass of the mesh, as the command runs the scene."""
    write_box(tmp_path / "meshes" / "brick.stl", SIDES)
    (tmp_path / "bricks.toml").write_text(MESH)
    told = subprocess.run([command, "check", tmp_path / "bricks.toml"], check=True, capture_output=True, text=True).stdout
    assert "9 spheres for `meshes/brick.stl`" in told and "1.9200e-4 m^3" in told
    subprocess.run([command, "run", tmp_path / "bricks.toml", "-o", tmp_path / "run", "--stop", "0.4"], check=True)
    table = np.genfromtxt(tmp_path / "run" / "history.csv", delimiter=",", names=True)
    unit = tmp_path / "bricks.fmu"
    subprocess.run([command, "export", tmp_path / "bricks.toml", "--fmi", version, "-o", unit], check=True)
    (tmp_path / "meshes" / "brick.stl").unlink()
    result = fmpy.simulate_fmu(str(unit), stop_time=0.4, output_interval=0.01, output=["mass", "maxOverlap", "kineticEnergy"])
    assert result["mass"] == pytest.approx(4 * 2500 * SIDES.prod() * 1e-9, rel=1e-6)
    assert result["maxOverlap"].max() <= 1e-4
    assert np.array_equal(result["kineticEnergy"], table["kineticEnergy_J"])
    # They have met the floor.
    assert table["kineticEnergy_J"].max() > 1.5 * table["kineticEnergy_J"][-1] > 0


def test_frames_show_the_meshes_of_clumps(command, tmp_path):
    """Each clump's mesh is the box of its file, turned and moving as its members, which lie within it."""
    write_box(tmp_path / "meshes" / "brick.stl", SIDES)
    ball = '[[spheres]]\nname = "ball"\nmaterial = "glass"\nradius = 0.02\npositions = [[0.3, 0.0, 0.02]]\n'
    (tmp_path / "bricks.toml").write_text(MESH.replace("spheres = 9", "spheres = 9\nsurface = true") + ball)
    subprocess.run([command, "run", tmp_path / "bricks.toml", "-o", tmp_path / "run", "--stop", "0.3"], check=True)
    last = sorted((tmp_path / "run").glob("clumps_*.vtu"))[-1]
    clumps, spheres = meshio.read(last), meshio.read(str(last).replace("clumps", "spheres"))
    triangles, owner = clumps.cells_dict["triangle"], clumps.cell_data_dict["clump"]["triangle"]
    of = spheres.point_data["clump"]
    assert np.array_equal(np.unique(owner), np.arange(4))
    assert np.array_equal(spheres.point_data["meshed"], of >= 0) and (of < 0).sum() == 1
    for k in range(4):
        members, corners = np.flatnonzero(of == k), np.unique(triangles[owner == k])
        w, x, y, z = spheres.point_data["orientation"][members[0]].astype(float)
        own = np.array(
            [
                [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
            ]
        )
        points, half = clumps.points[corners].astype(float), 0.5e-3 * SIDES
        centre = points.mean(axis=0)
        assert len(corners) == 8
        np.testing.assert_allclose(np.abs((points - centre) @ own), np.tile(half, (8, 1)), atol=1e-6)
        assert (np.abs((spheres.points[members] - centre) @ own) < half).all()
        first, spin = members[0], spheres.point_data["angular_velocity"][members[0]]
        turning = np.cross(spin, points - spheres.points[first])
        np.testing.assert_allclose(clumps.point_data["velocity"][corners], spheres.point_data["velocity"][first] + turning, atol=1e-5)
    assert np.linalg.norm(clumps.point_data["velocity"], axis=1).max() > 1e-3
