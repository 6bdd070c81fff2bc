"""FMI 3.0: static checks, arrays, states across versions, early return and intermediate update, the life cycle."""

import ctypes
import struct
import subprocess
import zipfile
from ctypes import byref, c_bool, c_double, c_int, c_size_t, c_void_p

import fmpy
import numpy as np
import pytest
from conftest import SCENES
from fmpy.fmi3 import FMU3Slave
from fmpy.validation import validate_fmu
from fmu import Slave
from lxml import etree

H = 2e-3
DRIVE = "boundary.trough.displacement"


class Unit:
    """An FMI 3.0 instance with names instead of value references."""

    def __init__(self, path, initialize=True, **options):
        self.description = fmpy.read_model_description(str(path))
        self.variables = {v.name: v for v in self.description.modelVariables}
        self.lines = []
        self.fmi = FMU3Slave(
            guid=self.description.guid,
            unzipDirectory=fmpy.extract(str(path)),
            modelIdentifier=self.description.coSimulation.modelIdentifier,
            instanceName="test",
        )
        self.fmi.instantiate(logMessage=lambda _, status, category, text: self.lines.append(text.decode()), **options)
        if initialize:
            self.fmi.enterInitializationMode(startTime=0.0, stopTime=10.0)
            self.fmi.exitInitializationMode()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.fmi.freeInstance()

    def reference(self, name):
        return self.variables[name].valueReference

    def shape(self, name):
        return tuple(int(d.start) for d in self.variables[name].dimensions)

    def get(self, name):
        kind, shape = self.variables[name].type, self.shape(name)
        count = int(np.prod(shape)) if shape else 1
        values = getattr(self.fmi, f"get{kind}")([self.reference(name)], nValues=count)
        return np.array(values).reshape(shape) if shape else values[0]

    def set(self, name, *values):
        self.fmi.setFloat64([self.reference(name)], list(values))

    def step(self, start, h=H):
        return self.fmi.doStep(start, h)

    def save(self):
        state = self.fmi.getFMUState()
        blob = self.fmi.serializeFMUState(state)
        self.fmi.freeFMUState(state)
        return blob

    def restore(self, blob):
        state = self.fmi.deserializeFMUState(blob)
        self.fmi.setFMUState(state)
        self.fmi.freeFMUState(state)


def displacement(time):
    return 1.5e-3 * np.sin(2 * np.pi * 18 * time)


@pytest.mark.parametrize("name", SCENES)
def test_fmpy_finds_nothing_to_complain_about(units, name):
    assert validate_fmu(str(units[name])) == []


@pytest.mark.parametrize("name", SCENES)
def test_simulate_fmu_gives_what_version_2_gives(units, fmus, name):
    step = float(fmpy.read_model_description(str(units[name])).defaultExperiment.stepSize)
    names = ["kineticEnergy", "momentum"]
    three = fmpy.simulate_fmu(str(units[name]), stop_time=5 * step, output_interval=step, output=names)
    names = ["kineticEnergy", "momentum[1]", "momentum[2]", "momentum[3]"]
    two = fmpy.simulate_fmu(str(fmus[name]), stop_time=5 * step, output_interval=step, output=names)
    assert len(two) == len(three) == 6
    assert np.array_equal(two["kineticEnergy"], three["kineticEnergy"])
    for axis in range(3):
        assert np.array_equal(two[f"momentum[{axis + 1}]"], three["momentum"][:, axis])


def test_both_versions_give_the_same_bytes_and_share_states(units, fmus):
    with Slave(fmus["feeder"]) as two, Unit(units["feeder"]) as three:
        assert two.description.guid == three.description.guid
        for k in range(10):
            for unit in (two, three):
                unit.set(DRIVE, displacement((k + 1) * H))
                unit.step(k * H, H)
        blob = two.save()
        assert blob == three.save()
        scalars = [n for n in two.measured()]
        for name in scalars:
            stem, _, index = name.partition("[")
            value = three.get(stem)
            assert two.get(name)[0] == (value[int(index[:-1]) - 1] if index else value), name
        # Version 3 goes on from a state of version 2.
        with Unit(units["feeder"], initialize=False) as other:
            other.restore(blob)
            for unit in (other, two):
                unit.step(10 * H, H)
            assert other.save() == two.save()
        for bad in (b"", b"garbage" * 9, blob[:-1], blob[:60] + b"\xff" + blob[61:]):
            with pytest.raises(fmpy.fmi1.FMICallException):
                three.restore(bad)
        assert three.save() == blob


def test_arrays_and_document_are_one(units):
    with Unit(units["funnel"]) as unit:
        for k in range(60):
            unit.step(k * 0.01, 0.01)
        place, n = unit.get("spheres.position"), unit.shape("spheres.radius")[0]
        assert place.shape == (n, 3) and n > 10
        assert np.array_equal(unit.get("spheres.id"), np.arange(n))
        blob = unit.get("spheres.document")
        magic, version, count, time = struct.unpack_from("<8sIQd", blob)
        assert (magic, version, count) == (b"SDDASPH\0", 1, n) and np.isclose(time, 0.6)
        rows = np.frombuffer(blob, "<f8", offset=28).reshape(n, 15)
        assert np.array_equal(rows[:, 0], unit.get("spheres.present"))
        assert np.array_equal(rows[:, 1], unit.get("spheres.radius"))
        assert np.array_equal(rows[:, 2:5], place)
        assert np.array_equal(rows[:, 5:9], unit.get("spheres.orientation"))
        assert np.array_equal(rows[:, 9:12], unit.get("spheres.velocity"))
        assert np.array_equal(rows[:, 12:15], unit.get("spheres.angularVelocity"))
        assert unit.get("sphereCount") == unit.get("spheres.present").sum()
        assert np.allclose(np.linalg.norm(rows[:, 5:9], axis=1), 1)
        force = unit.get("boundaries.averageForce")
        own = [v.name for v in unit.description.modelVariables if v.name.endswith(".averageForce")]
        own.remove("boundaries.averageForce")
        assert np.array_equal(force, [unit.get(name) for name in own])
        assert np.abs(force).max() > 0
        with pytest.raises(fmpy.fmi1.FMICallException):
            unit.fmi.getFloat64([unit.reference("spheres.position")], nValues=3 * n - 1)


def test_a_step_returns_early_when_it_is_asked_to(units):
    calls = []

    def update(_, time, may_set, may_get, done, may_return, wanted, at):
        calls.append((time, may_set, may_get, done, may_return))
        if len(calls) == 2:
            wanted[0] = True
            at[0] = time

    with Unit(units["feeder"], earlyReturnAllowed=True, intermediateUpdate=update) as unit, Unit(
        units["feeder"]
    ) as plain:
        inside = 5 * H
        _, terminate, early, last = unit.step(0.0, inside)
        assert early and not terminate and last == calls[1][0] and 0 < last < inside
        assert all(may_set and may_get and done and may_return for _, may_set, may_get, done, may_return in calls)
        assert unit.get("time") == last
        # It goes on from there.
        _, _, early, end = unit.step(last, inside - last)
        assert not early and np.isclose(end, inside)
        assert not calls[-1][4], "nothing is left to return from at the end"
        # A step to the same place gives the same up to rounding.
        plain.step(0.0, last)
        plain.step(last, inside - last)
        assert unit.save() == plain.save()


@pytest.mark.parametrize("wishes, expected", [([3], 3), ([4, 2], 2), ([2, 4], 2), ([2.5], 3)])
def test_an_early_return_at_a_later_time_is_kept(units, wishes, expected):
    """One wish in each of the first callbacks, in internal steps from now; the earliest counts and is not forgotten."""
    times = []

    def update(_, time, may_set, may_get, done, may_return, wanted, at):
        times.append(time)
        if len(times) <= len(wishes):
            wanted[0] = True
            at[0] = wishes[len(times) - 1] * times[0]

    with Unit(units["feeder"], earlyReturnAllowed=True, intermediateUpdate=update) as unit:
        _, terminate, early, last = unit.step(0.0, 10 * H)
        assert early and not terminate
        assert len(times) == expected and last == times[-1] and np.isclose(last, expected * times[0])


def test_only_what_can_be_had_within_a_step_is_taken_as_required(units):
    with zipfile.ZipFile(units["feeder"]) as archive:
        variables = etree.fromstring(archive.read("modelDescription.xml")).find("ModelVariables")
    references = {v.get("name"): (int(v.get("valueReference")), v.get("intermediateUpdate") == "true") for v in variables}
    for name in (DRIVE, "boundary.trough.force", "mass", "spheres.id", "spheres.radius", "gravity", "solver.step"):
        reference, may = references[name]
        options = {"requiredIntermediateVariables": [reference], "intermediateUpdate": lambda *_: None}
        if may:
            with Unit(units["feeder"], **options) as unit:
                unit.step(0.0)
        else:
            assert name not in (DRIVE, "boundary.trough.force", "mass")
            with pytest.raises(Exception, match="instantiate"):
                Unit(units["feeder"], **options)


def test_without_permission_a_step_does_not_return_early(units):
    def update(_, time, may_set, may_get, done, may_return, wanted, at):
        assert not may_return
        wanted[0] = True

    with Unit(units["feeder"], intermediateUpdate=update) as unit, Unit(units["feeder"]) as plain:
        _, _, early, last = unit.step(0.0)
        assert not early and last == H
        plain.step(0.0)
        # Being watched changes nothing.
        assert unit.save() == plain.save()


def test_inputs_set_within_a_step_act_in_the_next_internal_step(units):
    seen, told = [], []

    def update(_, time, *rest):
        seen.append((time, unit.get("boundary.trough.position")[0], unit.get("boundary.trough.force")[2]))
        if len(seen) == 1:
            unit.set(DRIVE, 1e-4)
            with pytest.raises(fmpy.fmi1.FMICallException):
                unit.set("gravity", 0.0, 0.0, 0.0)
            with pytest.raises(fmpy.fmi1.FMICallException):
                unit.step(time)
            with pytest.raises(fmpy.fmi1.FMICallException):
                unit.save()
            told.extend(unit.lines)

    unit = Unit(units["feeder"], intermediateUpdate=update)
    with unit:
        start = unit.get("boundary.trough.position")[0]
        unit.step(0.0, 4 * H)
        times, places, _ = np.array(seen).T
        assert len(times) >= 3 and np.isclose(times[-1], 4 * H)
        assert places[0] == start, "the first internal step knew nothing of the input"
        # From there linearly to the commanded place at the end of the step.
        slide = np.cos(np.radians(30)) * 1e-4
        expected = start + slide * (times - times[0]) / (times[-1] - times[0])
        assert np.allclose(places, expected, atol=1e-12)
        assert sum("intermediate update mode" in line for line in told) == 3, told


def test_dependencies_say_what_decides(units):
    """No list means all: through contacts every output may depend on every input. Rows and radii of spheres depend on none."""
    description = fmpy.read_model_description(str(units["feeder"]))
    structure = {u.variable.name: u.dependencies for u in (*description.outputs, *description.initialUnknowns)}
    fixed = {"spheres.id", "spheres.radius"}
    assert fixed <= set(structure) and "boundary.trough.averageForce" in structure
    assert all(structure[name] == [] if name in fixed else structure[name] is None for name in structure)


def test_other_interfaces_are_refused_with_a_reason(units):
    with Unit(units["feeder"], initialize=False) as unit:
        lines = []
        log = fmpy.fmi3.fmi3LogMessageCallback(lambda _, status, category, text: lines.append(text))
        library, token = unit.fmi.dll, unit.description.guid.encode()
        for name, nulls in (("fmi3InstantiateModelExchange", 0), ("fmi3InstantiateScheduledExecution", 3)):
            make = getattr(library, name)
            make.restype = c_void_p
            make.argtypes = None
            made = make(b"x", token, b"", c_bool(False), c_bool(False), c_void_p(), log, *[c_void_p()] * nulls)
            assert made is None
        assert b"model exchange is not offered" in lines[0] and b"scheduled execution" in lines[1], lines
