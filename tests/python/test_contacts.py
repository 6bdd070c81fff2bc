"""All contacts of a simulation: arrays and binary of FMI 3.0, and `contacts` of the package. Their sums are what bodies feel."""

import csv
import shutil
import struct
import subprocess

import numpy as np
import pytest
from test_fmi3 import Unit

H = 5e-3
# 36 balls of two sizes fall on a tilting floor between two walls; sideways the box is periodic. Contacts resist rolling.
SCENE = """
title = "Tray"
[simulation]
duration = 1.0
communication_step = 5e-3
[[material]]
name = "stone"
density = 2500.0
[pair_default]
friction = 0.4
rolling_friction = 0.05
restitution = 0.3
[cell]
y = [-0.06, 0.06]
[[spheres]]
name = "large"
material = "stone"
radius = 0.016
lattice = { origin = [-0.05, -0.04, 0.02], count = [3, 3, 2], spacing = 0.04, jitter = 0.1 }
[[spheres]]
name = "small"
material = "stone"
radius = 0.010
lattice = { origin = [-0.05, -0.04, 0.1], count = [3, 3, 2], spacing = 0.04, jitter = 0.1 }
[[boundary]]
name = "walls"
material = "stone"
faces = [
    { plane = { point = [-0.07, 0, 0], normal = [1, 0, 0] } },
    { plane = { point = [0.07, 0, 0], normal = [-1, 0, 0] } },
]
[[boundary]]
name = "floor"
material = "stone"
input = { hinge = [0.0, 1.0, 0.0] }
faces = [{ plane = { point = [0, 0, 0], normal = [0, 0, 1] } }]
[[probe]]
name = "low"
sphere = "large[5]"
[[probe]]
name = "high"
sphere = "small[14]"
"""
ARRAYS = ("bodies", "position", "normal", "force", "torque", "gap")
WALLS, FLOOR = -1, -2


def angle(time):
    return 0.2 * np.sin(6.0 * time)


@pytest.fixture(scope="module")
def fmus(command, tmp_path_factory):
    """The FMU with so many rows of contacts, by number."""
    folder = tmp_path_factory.mktemp("contacts")

    def make(rows):
        scene, fmu = folder / f"rows{rows}.toml", folder / f"rows{rows}.fmu"
        if not fmu.exists():
            scene.write_text(f"{SCENE}[fmu]\ncontacts = {rows}\n" if rows else SCENE)
            subprocess.run([command, "export", scene, "-o", fmu, "--fmi", "3"], check=True, capture_output=True)
        return fmu

    yield make
    shutil.rmtree(folder, ignore_errors=True)


def document(blob):
    magic, version, count, time = struct.unpack_from("<8sIQd", blob)
    assert (magic, version) == (b"SDDACON\0", 1) and len(blob) == 28 + 120 * count
    columns = [("bodies", "<i8", 2), *((name, "<f8", 3) for name in ARRAYS[1:5]), ("gap", "<f8")]
    return time, np.frombuffer(blob, columns, count, 28)


def agree(contacts, get):
    """Contacts are where spheres and boundaries are, and sum up to what these feel."""
    a, b = contacts["bodies"].T
    force, normal, couple = contacts["force"], contacts["normal"], contacts["torque"]
    place, radius = get("spheres.position"), get("spheres.radius")
    between = b >= 0
    scale = 1e-9 + np.abs(force).max(initial=0.0)
    for probe, sphere in (("low", 5), ("high", 18 + 14)):
        own, other = a == sphere, b == sphere
        total = force[own].sum(axis=0) - force[other].sum(axis=0)
        assert np.allclose(total, get(f"probe.{probe}.contactForce"), rtol=0, atol=1e-12 * scale)
        arm = -radius[sphere] * normal
        torque = (np.cross(arm, force) + couple)[own].sum(axis=0) + (np.cross(arm, force) - couple)[other].sum(axis=0)
        assert np.allclose(torque, get(f"probe.{probe}.contactTorque"), rtol=0, atol=1e-12 * scale * 0.016)
        assert own.sum() + other.sum() == get(f"probe.{probe}.contactCount")
    for name, row in (("walls", WALLS), ("floor", FLOOR)):
        on = b == row
        assert np.allclose(-force[on].sum(axis=0), get(f"boundary.{name}.force"), rtol=0, atol=1e-12 * scale)
        assert on.sum() == get(f"boundary.{name}.contactCount")
    gap, point = contacts["gap"], contacts["position"]
    assert np.allclose(np.linalg.norm(place[a] - point, axis=1), radius[a] + gap, atol=1e-12), "beside the sphere"
    # The copy of the other sphere that touches.
    way = point[between] - place[b[between]]
    way[:, 1] -= 0.12 * np.round(way[:, 1] / 0.12)
    assert np.allclose(np.linalg.norm(way, axis=1), radius[b[between]], atol=1e-12)
    assert np.allclose(np.linalg.norm(normal, axis=1), 1.0)
    assert len(contacts) == get("contactCount")
    return len(contacts)


def drive(unit, steps, first=0):
    for k in range(first, first + steps):
        unit.set("boundary.floor.angle", angle((k + 1) * H))
        unit.step(k * H, H)
        yield k


def test_contacts_sum_up_to_what_bodies_feel(fmus):
    with Unit(fmus(200)) as unit:
        counts, across, rolling = [], 0, 0.0
        for _ in drive(unit, 120):
            time, contacts = document(unit.get("contacts.document"))
            assert time == unit.get("time")
            counts.append(agree(contacts, unit.get))
            count = counts[-1]
            for name in ARRAYS:
                array = unit.get(f"contacts.{name}")
                assert array.shape[0] == 200 and np.array_equal(array[:count], contacts[name])
                assert (array[count:] == (-1 if name == "bodies" else 0)).all()
            y = unit.get("spheres.position")[:, 1]
            pairs = contacts["bodies"][contacts["bodies"][:, 1] >= 0]
            across += (np.abs(y[pairs[:, 0]] - y[pairs[:, 1]]) > 0.06).sum()
            rolling = max(rolling, np.abs(contacts["torque"]).max(initial=0.0))
        assert min(counts) == 0 and max(counts) > 60 and across > 50 and rolling > 0.0
        assert unit.variables["contacts.force"].causality == "output"
        assert not any("room for" in line for line in unit.lines)


def test_contacts_are_those_of_a_restored_state(fmus):
    def look(unit):
        return [unit.get("contacts.document"), *(unit.get(f"contacts.{name}").tobytes() for name in ARRAYS)]

    with Unit(fmus(200)) as unit:
        *_, last = drive(unit, 60)
        state, here = unit.save(), look(unit)
        list(drive(unit, 20, last + 1))
        there = look(unit)
        assert there != here
        unit.restore(state)
        assert look(unit) == here
        list(drive(unit, 20, last + 1))
        assert look(unit) == there


def test_too_few_rows_are_told_once_and_none_are_the_default(fmus):
    with Unit(fmus(7)) as unit:
        list(drive(unit, 100))
        count = unit.get("contactCount")
        _, whole = document(unit.get("contacts.document"))
        assert len(whole) == count > 7 and not any("room for" in line for line in unit.lines)
        assert np.array_equal(unit.get("contacts.force"), whole["force"][:7])
        assert unit.get("contacts.gap").shape == (7,) and len(unit.get("contacts.document")) == 28 + 120 * count
        (told,) = [line for line in unit.lines if "room for" in line]
        assert f"found {count} loaded ones" in told and "room for 7" in told
    with Unit(fmus(0)) as unit:
        assert [name for name in unit.variables if name.startswith("contacts.")] == ["contacts.document"]
        assert len(document(unit.get("contacts.document"))[1]) == 0, "at the start, in free fall"


def test_the_package_has_contacts_without_being_asked(sphere_dda, tmp_path):
    (tmp_path / "tray.toml").write_text(SCENE)
    scene = sphere_dda.Scene(tmp_path / "tray.toml")
    with sphere_dda.Simulation(scene) as sim:
        none = sim.contacts
        assert len(none) == 0 and none.force.shape == (0, 3) and none.time == 0.0
        kept = []
        for k in range(100):
            sim["boundary.floor.angle"] = angle((k + 1) * H)
            sim.step(H)
            assert agree(sim.contacts.table, sim.__getitem__) == len(sim.contacts)
            kept.append(sim.contacts)
        contacts = kept[-1]
        for name in ARRAYS:
            assert np.array_equal(getattr(contacts, name), contacts.table[name]), name
            assert np.shares_memory(getattr(contacts, name), contacts.table), "a view"
        state, force = sim.save(), contacts.force.copy()
        sim.step(H)
        assert not np.array_equal(sim.contacts.force, force) and np.array_equal(contacts.force, force), "it stays as it was"
        sim.restore(state)
        assert sim.contacts.table.tobytes() == contacts.table.tobytes() and sim.contacts.time == contacts.time
    with pytest.raises(sphere_dda.SimulationError, match="contacts.document"):
        sphere_dda.Contacts.read(b"SDDASPH\0" + bytes(20))
    with pytest.raises(sphere_dda.SimulationError, match="29 bytes for 0 contacts"):
        sphere_dda.Contacts.read(struct.pack("<8sIQd", b"SDDACON\0", 1, 0, 0.0) + b"x")


def test_other_masters_record_them(command, fmus, tmp_path):
    done = subprocess.run(
        [command, "simulate", fmus(40), "--stop", "0.2", "--record", "contacts.bodies", "--record", "contacts.force", "--record",
         "contactCount", "-o", tmp_path / "out.csv"], capture_output=True, text=True, check=True,
    )
    with (tmp_path / "out.csv").open(newline="") as file:
        *_, last = csv.DictReader(file)
    assert int(last["contactCount"]) > 0 and int(last["contacts.bodies[1,1]"]) >= 0 and "room for" not in done.stderr
