"""An FMU instance with names instead of value references, on fmpy's low-level calls."""

import shutil

import fmpy
from fmpy.fmi2 import FMU2Slave


class Slave:
    """A co-simulation instance with parameters, ready to step. A context manager: frees the instance and its files."""

    def __init__(self, fmu, stop=10.0, folder=None, reals=None, integers=None):
        self.description = fmpy.read_model_description(str(fmu))
        self.reference = {v.name: v.valueReference for v in self.description.modelVariables}
        self.own = folder is None
        self.folder = folder or fmpy.extract(str(fmu))
        self.fmi = FMU2Slave(
            guid=self.description.guid,
            unzipDirectory=self.folder,
            modelIdentifier=self.description.coSimulation.modelIdentifier,
            instanceName="test",
        )
        self.fmi.instantiate()
        for values, call in ((reals, self.fmi.setReal), (integers, self.fmi.setInteger)):
            for name, value in (values or {}).items():
                call([self.reference[name]], [value])
        self.fmi.setupExperiment(startTime=0.0, stopTime=stop)
        self.fmi.enterInitializationMode()
        self.fmi.exitInitializationMode()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.fmi.freeInstance()
        if self.own:
            shutil.rmtree(self.folder, ignore_errors=True)

    def get(self, *names):
        """Values of real variables."""
        return self.fmi.getReal([self.reference[name] for name in names])

    def vector(self, name):
        return self.get(*(f"{name}[{axis}]" for axis in (1, 2, 3)))

    def set(self, name, value):
        self.fmi.setReal([self.reference[name]], [value])

    def step(self, start, h):
        self.fmi.doStep(currentCommunicationPoint=start, communicationStepSize=h)

    def save(self):
        """The serialized state."""
        state = self.fmi.getFMUstate()
        try:
            return self.fmi.serializeFMUstate(state)
        finally:
            self.fmi.freeFMUstate(state)

    def restore(self, blob):
        state = self.fmi.deSerializeFMUstate(blob)
        try:
            self.fmi.setFMUstate(state)
        finally:
            self.fmi.freeFMUstate(state)

    def measured(self):
        """Names of the real variables that are measured, outputs or not."""
        kinds = ("output", "local")
        return [v.name for v in self.description.modelVariables if v.causality in kinds and v.type == "Real"]
