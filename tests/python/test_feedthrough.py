"""Feedback loops: what the model descriptions say of dependencies, as a master with handling of algebraic loops reads it, and whether
it is true of the running FMUs."""

import sys

import fmpy
import numpy as np
import pytest
from conftest import ROOT
from fmpy.fmi2 import FMU2Slave
from fmpy.fmi3 import FMU3Slave

sys.path.insert(0, str(ROOT / "examples" / "two_fmus"))
from couple import WIRES  # noqa: E402

H = 1e-3


class Watched:
    """An FMU whose real inputs and outputs are read and set as in any master, and looked at in between."""

    def __init__(self, name, fmu):
        self.name, self.description = name, fmpy.read_model_description(str(fmu))
        self.three = self.description.fmiVersion.startswith("3")
        make, reals = (FMU3Slave, "Float64") if self.three else (FMU2Slave, "Real")
        own = [v for v in self.description.modelVariables if v.type == reals]
        self.size = {v.name: int(np.prod([int(d.start) for d in v.dimensions])) if v.dimensions else 1 for v in own}
        self.reference = {v.name: v.valueReference for v in own}
        self.inputs = [v.name for v in own if v.causality == "input"]
        self.outputs = [v.name for v in own if v.causality == "output"]
        listed = {u.variable.name: u.dependencies for u in self.description.outputs}
        # No list means all.
        self.feeds = {
            name: self.inputs if listed[name] is None else [v.name for v in listed[name] if v.name in self.inputs]
            for name in self.outputs
        }
        self.fmi = make(
            guid=self.description.guid,
            unzipDirectory=fmpy.extract(str(fmu)),
            modelIdentifier=self.description.coSimulation.modelIdentifier,
            instanceName=name,
        )
        self.fmi.instantiate()

    def get(self, name):
        reference = [self.reference[name]]
        if self.three:
            return np.array(self.fmi.getFloat64(reference, nValues=self.size[name]))
        return np.array(self.fmi.getReal(reference))

    def set(self, name, values):
        (self.fmi.setFloat64 if self.three else self.fmi.setReal)([self.reference[name]], list(values))

    def start(self):
        if not self.three:
            self.fmi.setupExperiment(startTime=0.0)
        self.fmi.enterInitializationMode()
        self.fmi.exitInitializationMode()

    def step(self, k):
        self.fmi.doStep(currentCommunicationPoint=k * H, communicationStepSize=H)

    def moved(self, name):
        """Outputs that change when this input is set, without a step; the input is put back."""
        held, before = self.get(name), {other: self.get(other).tobytes() for other in self.outputs}
        self.set(name, held + 0.37 * (1 + np.abs(held)))
        found = {other for other in self.outputs if self.get(other).tobytes() != before[other]}
        self.set(name, held)
        assert all(self.get(other).tobytes() == before[other] for other in self.outputs)
        return found


def place(name):
    component, variable = name.split(".", 1)
    if component == "bed3" and variable.endswith("averageForce[3]"):
        return component, variable.removesuffix("[3]")
    return component, variable


def loops(fmus, wires, feeds=None):
    """Connectors on a circle of connections and direct feedthrough, as masters look for algebraic loops."""
    edges = {}
    for source, to in wires:
        edges.setdefault(place(source), set()).add(place(to))
    for fmu in fmus:
        for output, inputs in (feeds or {}).get(fmu.name, fmu.feeds).items():
            for own in inputs:
                edges.setdefault((fmu.name, own), set()).add((fmu.name, output))

    def reached(start):
        seen, waiting = set(), [start]
        while waiting:
            for other in edges.get(waiting.pop(), ()):
                if other not in seen:
                    seen.add(other)
                    waiting.append(other)
        return seen

    return {start for start in edges if start in reached(start)}


@pytest.mark.parametrize("version", (2, 3))
def test_a_bed_on_a_shaker_is_no_algebraic_loop(fmus, units, version):
    bed = Watched("bed" if version == 2 else "bed3", (fmus if version == 2 else units)["bed"])
    shaker = Watched("shaker", fmus["shaker"])
    both = [shaker, bed]
    wires = [tuple(end.replace("bed.", f"{bed.name}.") for end in wire) for wire in WIRES]
    assert not loops(both, wires)
    assert shaker.feeds["acceleration"] == ["force"] and not shaker.feeds["position"]
    # The reader sees a loop where nothing is said, and one that is there: a tray driven by the acceleration.
    everything = {fmu.name: {output: fmu.inputs for output in fmu.outputs} for fmu in both}
    assert len(loops(both, wires, everything)) >= 4
    (force, _), (_, to) = wires[1], wires[0]
    direct = [("shaker.acceleration", to), (force, "shaker.force")]
    assert not loops(both, direct), "the bed is still between them"
    assert loops(both, direct, {bed.name: everything[bed.name]})

    # Is it true? The loop runs, and at each communication point every input is moved and put back.
    for fmu in both:
        fmu.start()
    ends = [(place(source), place(to)) for source, to in wires]
    by_name = {fmu.name: fmu for fmu in both}
    seen = {fmu.name: set() for fmu in both}
    forces = []
    for k in range(60):
        for (source, output), (target, own) in ends:
            value = by_name[source].get(output)
            by_name[target].set(own, value[-1:] if own == "force" else value)
        for fmu in both:
            fmu.step(k)
        forces.append(shaker.get("force")[0])
        for fmu in both:
            for name in fmu.inputs:
                moved = fmu.moved(name)
                unlisted = {other for other in moved if name not in fmu.feeds[other]}
                assert not unlisted, (k, fmu.name, name, unlisted)
                seen[fmu.name] |= {(name, other) for other in moved}
    assert len(set(forces)) > 30, "the grains give no force"
    # What is listed is there as well.
    listed = {fmu.name: {(own, name) for name, inputs in fmu.feeds.items() for own in inputs} for fmu in both}
    assert seen == listed
    for fmu in both:
        fmu.fmi.terminate()
        fmu.fmi.freeInstance()
