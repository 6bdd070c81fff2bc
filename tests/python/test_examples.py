"""Every example runs, and does what its README says."""

import json
import re
import subprocess
import sys

import meshio
import numpy as np
import pytest
from conftest import EXAMPLES, ROOT, scene

# Simulated seconds [s]: long enough for contacts, short enough for a quick suite.
STOP = {
    "funnel": 1.0,
    "slopes": 5.0,
    "feeder": 0.1,
    "conveyor": 0.5,
    "landslide": 1.5,
    "bed": 0.1,
    "shear": 0.1,
    "triaxial": 0.2,
    "chute": 0.8,
    "press": 0.45,
    "wet_heap": 0.4,
    "clump_drum": 0.2,
    "clump_repose": 0.1,
    "dumper": 0.5,
}


def python(script, *arguments):
    done = subprocess.run([sys.executable, ROOT / script, *map(str, arguments)], capture_output=True, text=True, timeout=600)
    assert done.returncode == 0, done.stderr
    return done.stdout


@pytest.fixture(scope="module")
def results(command, tmp_path_factory):
    """Name -> result directory of a run of each example."""
    folders = {}
    for name in EXAMPLES:
        folders[name] = tmp_path_factory.mktemp("runs") / name
        subprocess.run([command, "run", scene(name), "-o", folders[name], "--stop", str(STOP[name])], check=True, timeout=600)
    return folders


@pytest.mark.parametrize("name", EXAMPLES)
def test_run(results, name):
    table = np.genfromtxt(results[name] / "history.csv", delimiter=",", names=True)
    assert np.isclose(table["time_s"][-1], STOP[name])
    overlap = [column for column in table.dtype.names if "maxOverlap" in column]
    allowed = json.loads((results[name] / "run.json").read_text())["settings"]["tolerance"]["gap"]
    assert overlap and all(table[column].max() <= allowed for column in overlap)
    frames = sorted(results[name].glob("spheres_*.vtu"))
    first, last = meshio.read(frames[0]), meshio.read(frames[-1])
    assert np.linalg.norm(last.points - first.points, axis=1).max() > 1e-3, "nothing moves"


def test_check(command):
    for name in EXAMPLES:
        subprocess.run([command, "check", scene(name)], check=True, capture_output=True)


def test_every_frame_opens_in_meshio_and_vtk(results):
    from test_vtk import check_frame, listed

    for name, folder in results.items():
        collections = sorted(folder.glob("*.pvd"))
        meshes = ["clumps"] if name == "dumper" else []
        assert [c.stem for c in collections] == ["boundaries", *meshes, "contacts", "spheres"]
        for pvd in collections:
            for time, path in listed(pvd):
                check_frame(pvd.stem, time, path)


def test_landslide_valley_is_the_formula(tmp_path):
    """The committed grid is what its script writes."""
    script = tmp_path / "valley.py"
    script.write_text((ROOT / "examples/landslide/valley.py").read_text())
    subprocess.run([sys.executable, script], check=True)
    assert (tmp_path / "valley.asc").read_text() == (ROOT / "examples/landslide/valley.asc").read_text()


def test_conveyor_driver(fmus, tmp_path):
    """The force of the drive is the mass flow times the belt's speed."""
    told = python("examples/conveyor/drive.py", "--fmu", fmus["conveyor"], "--output", tmp_path / "conveyor.png")
    assert (tmp_path / "conveyor.png").stat().st_size > 10_000
    found = re.findall(r"flow (\S+) kg/s, force (\S+) N, Q v (\S+) N", told)
    assert len(found) == 2
    for flow, force, law in np.array(found, dtype=float):
        # A stream of some hundred grains in the time of the mean.
        assert flow == pytest.approx(1.2, rel=0.1)
        assert force == pytest.approx(law, rel=0.1)


def test_chute_liner_is_what_its_script_writes(tmp_path):
    script = tmp_path / "mesh.py"
    script.write_text((ROOT / "examples/chute/mesh.py").read_text())
    subprocess.run([sys.executable, script], check=True)
    assert (tmp_path / "chute.stl").read_bytes() == (ROOT / "examples/chute/chute.stl").read_bytes()


def test_chute_driver(units, tmp_path):
    """Arrays of the FMU add up to its totals, and the liner wears deepest where the stream falls on it."""
    told = python("examples/chute/wear.py", "--fmu", units["chute"], "--stop", 2, "--output", tmp_path / "chute.png")
    assert (tmp_path / "chute.png").stat().st_size > 10_000
    energies = np.array(re.findall(r"Energy: (\S+) J on the triangles, (\S+) J", told), dtype=float)
    assert energies.shape == (2, 2) and (energies > 1).all()
    assert energies[:, 0] == pytest.approx(energies[:, 1], rel=1e-6)
    worn = np.array(re.findall(r"worn: (\S+) mm\^3 by the triangles, (\S+) mm", told), dtype=float)
    assert worn[0, 0] == pytest.approx(worn[0, 1], rel=1e-4)
    deepest, missed = re.search(r"x = (\S+) m, tractions miss the force by at most (\S+) of it", told).groups()
    assert 0.1 < float(deepest) < 0.3
    assert float(missed) < 1e-12


def test_dumper_stone_is_what_its_script_says():
    """The committed facets, in whatever order the hull has them."""
    sys.path.insert(0, str(ROOT / "examples/dumper"))
    import mesh

    record = np.frombuffer((ROOT / "examples/dumper/stone.stl").read_bytes()[84:], dtype=[("n", "<f4", 3), ("c", "<f4", (3, 3)), ("e", "<u2")])

    def corners(facets):
        return sorted(tuple(sorted(map(tuple, np.round(facet.astype(float), 3)))) for facet in facets)

    assert len(record) == 64 and corners(record["c"]) == corners(mesh.facets())


def test_dumper_driver(fmus, tmp_path):
    """The suspension carries the weight in the end, and twice as much when the stones fall."""
    told = python("examples/dumper/load.py", "--fmu", fmus["dumper"], "--output", tmp_path / "dumper.png")
    assert (tmp_path / "dumper.png").stat().st_size > 10_000
    share, most = re.search(r"(\S+) of the weight on the suspension at the end\nat most (\S+) of it", told).groups()
    assert float(share) == pytest.approx(1, abs=0.02) and 1.8 < float(most) < 2.3


def test_press_driver(fmus, tmp_path):
    """Beads between boundaries that close on them have an answer, whose error stays within the tolerance."""
    told = python("examples/press/press.py", "--fmu", fmus["press"], "--output", tmp_path / "press.png")
    assert (tmp_path / "press.png").stat().st_size > 10_000
    force, compressed, off = re.search(r"(\S+) kN, beads compressed by (\S+) R, off by (\S+) R", told).groups()
    assert float(force) > 1 and 1e-3 < float(compressed) < 0.1
    assert float(off) <= 1e-6


def test_beads_in_a_fluid(units, tmp_path):
    """Drag computed in Python brings each bead to Stokes' speed; work of drag and buoyancy is what weight and motion lack."""
    sys.path.insert(0, str(ROOT / "examples/viscous"))
    from settle import BEADS, STEP, VISCOSITY, G, settle, terminal

    times, heights, velocities, radius, work = settle(units["viscous"], 0.4)
    mass = BEADS * 4 / 3 * np.pi * radius**3
    for size in np.unique(radius):
        # What the speed lacks, by the scheme of Adams and Bashforth, whose first step is Euler's.
        q = STEP * 6 * np.pi * VISCOSITY * size / (BEADS * 4 / 3 * np.pi * size**3)
        lack = [terminal(size), (1 - q) * terminal(size)]
        while len(lack) < len(times):
            lack.append((1 - 1.5 * q) * lack[-1] + 0.5 * q * lack[-2])
        expected = np.array(lack) - terminal(size)
        assert np.abs(velocities[:, radius == size] - expected[:, None]).max() < 1e-10 * terminal(size)
    fallen = mass * G @ (heights[0] - heights[-1])
    assert work == pytest.approx(0.5 * mass @ velocities[-1] ** 2 - fallen, rel=1e-3)
    told = python("examples/viscous/settle.py", "--fmu", units["viscous"], "--stop", 1, "--output", tmp_path / "viscous.png")
    assert (tmp_path / "viscous.png").stat().st_size > 10_000
    off = re.findall(r"off by (\S+) at", told)
    assert len(off) == 2 and all(float(one) < 1e-9 for one in off)


def test_wet_heap_driver(units, tmp_path):
    """Wet grains heap up steeper the more they hold together; without cohesion both heaps are alike."""
    told = python("examples/wet_heap/heap.py", "--fmu", units["wet_heap"], "--bond", 0, 10, "--output", tmp_path / "heap.png")
    assert (tmp_path / "heap.png").stat().st_size > 10_000
    runs = re.findall(r"wet (\S+) deg, dry (\S+) deg, overlap (\S+) R", told)
    (none, dry), (wet, beside) = [[float(angle) for angle in run[:2]] for run in runs]
    assert abs(none - dry) < 6 and abs(beside - dry) < 6
    assert wet > dry + 20
    assert all(float(run[2]) <= 1e-4 for run in runs)


def test_clump_drum_ribs_are_what_their_script_writes(tmp_path):
    script = tmp_path / "mesh.py"
    script.write_text((ROOT / "examples/clump_drum/mesh.py").read_text())
    subprocess.run([sys.executable, script], check=True)
    assert (tmp_path / "ribs.stl").read_bytes() == (ROOT / "examples/clump_drum/ribs.stl").read_bytes()


def test_clump_drum_driver(units, tmp_path):
    """Clumps stand at least 5 degrees steeper than spheres, and the drums carry the weight of the beds at its lever."""
    picture = tmp_path / "drums.png"
    told = python("examples/clump_drum/turn.py", "--fmu", units["clump_drum"], "--stop", 4, "--since", 1.2, "--output", picture)
    assert picture.stat().st_size > 10_000
    beds = re.findall(r"surface (\S+) deg, .* torque (\S+) N m, of the weight (\S+) N m", told)
    assert len(beds) == 2
    for angle, torque, weight in np.array(beds, dtype=float):
        assert 20 < angle < 60
        assert torque == pytest.approx(weight, rel=0.03)
    more = re.search(r"clumps stand (\S+) deg steeper, their centre of mass (\S+) deg; overlap (\S+) R", told)
    surface, centre, overlap = map(float, more.groups())
    assert surface > 5 and centre > 5
    assert overlap <= 1e-4


def test_clump_repose_driver(units, tmp_path):
    """The slope that stays is at least 5 degrees steeper of clumps than of spheres: means of packings, single ones differ by 4 degrees."""
    arguments = ("--fmu", units["clump_repose"], "--packings", 3, "--output", tmp_path / "repose.png")
    told = python("examples/clump_drum/repose.py", *arguments)
    assert (tmp_path / "repose.png").stat().st_size > 10_000
    spheres, clumps = [float(re.search(rf"^{kind}: (\S+) \+-", told, re.MULTILINE)[1]) for kind in ("spheres", "clumps")]
    assert clumps > spheres + 5
    packings = re.findall(r"fastest (\S+) m/s, overlap (\S+) R", told)
    assert len(packings) == 3
    for speed, overlap in packings:
        assert float(speed) < 1e-3
        assert float(overlap) <= 1e-4


def test_feeder_driver(fmus, tmp_path):
    """Material is conveyed, and the reaction carries its weight on average."""
    python("examples/feeder/drive.py", "--fmu", fmus["feeder"], "--stop", 1.6, "--output", tmp_path)
    assert (tmp_path / "feeder.png").stat().st_size > 10_000
    table = np.genfromtxt(tmp_path / "feeder.csv", delimiter=",", names=True, deletechars="")
    assert table["sensor.flow.mass"][-1] > 0.05
    assert np.abs(table["displacement"]).max() == pytest.approx(1.5e-3, rel=0.05)
    up = -(table["boundary.trough.averageForce[3]"] + table["boundary.bin.averageForce[3]"])[1:]
    # Momentum: what the reaction lacks of the weight is in the motion of the grains.
    moved = table["momentum[3]"][-1] - table["momentum[3]"][1]
    weight = table["mass"][0] * 9.81
    assert np.mean(up[1:]) == pytest.approx(weight + moved / (table["time"][-1] - table["time"][1]), rel=1e-6)
    assert np.mean(up) == pytest.approx(weight, rel=0.1)


def test_a_million_spheres_are_read(command):
    done = subprocess.run([command, "check", scene("million")], check=True, capture_output=True, text=True)
    assert re.search(r"spheres +1000000,", done.stdout)


def test_what_settling_costs_is_told(command, tmp_path):
    """The table of settle.py has every step, every second and the end of the run; nothing is run twice."""
    text = scene("million").read_text()
    for large, small in (("500, 500, 4", "5, 5, 4"), ("6.2375", "0.05"), ("6.25", "0.0625")):
        assert large in text
        text = text.replace(large, small)
    (tmp_path / "few.toml").write_text(text.replace("duration = 1.0", "duration = 0.25"))
    arguments = ("--command", command, "--scene", tmp_path / "few.toml", "--output", tmp_path / "few")
    told = python("examples/million/settle.py", *arguments)
    history = np.genfromtxt(tmp_path / "few" / "history.csv", delimiter=",", names=True)
    costs = np.genfromtxt(tmp_path / "few" / "costs.csv", delimiter=",", names=True)
    assert np.array_equal(costs["time_s"], history["time_s"]) and len(costs) == 26
    rows = [[float(cell) for cell in line.split("|")[1:-1]] for line in told.splitlines() if re.match(r"\| [0-9]", line)]
    assert [row[0] for row in rows] == [0.1, 0.2, 0.25]
    assert [row[1] for row in rows] == [history["solverinternalSteps_"][first:last].sum() for first, last in ((1, 11), (11, 21), (21, 26))]
    assert rows[-1][5] == history["contactCount_"][-1] > 0
    assert rows[-1][7] == pytest.approx(history["kineticEnergy_J"][-1] / history["mass_kg"][-1], rel=0.06)
    assert all(row[8] == pytest.approx(peak / 1e9, abs=0.006) for row, peak in zip(rows, costs["peak_memory_B"][[10, 20, 25]], strict=True))
    assert costs["peak_memory_B"].min() > 1e6
    again = python("examples/million/settle.py", *arguments)
    assert again[again.index("|") :] == told[told.index("|") :]
