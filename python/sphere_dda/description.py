"""The variables of an FMU of FMI 3.0, from its model description."""

from __future__ import annotations

import difflib
import xml.etree.ElementTree as xml
from dataclasses import dataclass
from pathlib import Path

from .errors import SimulationError

_TYPES = ("Float64", "Int32", "Int64", "Boolean", "String", "Enumeration", "Binary")


@dataclass(frozen=True)
class Variable:
    """A variable of a simulation."""

    #: Name: `boundary.gate.angle`.
    name: str
    #: Value reference.
    reference: int
    #: `Float64`, `Int32`, `Int64`, `Boolean`, `String`, `Enumeration` or `Binary`.
    type: str
    #: `parameter`, `calculatedParameter`, `input`, `output`, `local` or `independent`.
    causality: str
    #: `fixed` parameters are set before the first step, `tunable` ones also between steps.
    variability: str
    #: Dimensions; `()` for a scalar.
    shape: tuple[int, ...]
    #: SI unit, `None` where there is none.
    unit: str | None
    #: Least and largest value, `None` where there is none.
    min: float | None
    max: float | None
    #: What it is.
    description: str
    #: Choices of an enumeration: name -> value.
    choices: dict[str, int]


@dataclass(frozen=True)
class Description:
    """What the model description says."""

    token: str
    #: Length of a communication step [s] and duration [s], as the scene has them.
    step: float
    stop: float
    variables: dict[str, Variable]

    @classmethod
    def read(cls, path: Path) -> Description:
        """Reads `modelDescription.xml`."""
        root = xml.parse(path).getroot()
        choices = {
            kind.get("name"): {item.get("name", ""): int(item.get("value", "0")) for item in kind.iter("Item")}
            for kind in root.iter("EnumerationType")
        }
        variables = {}
        for one in root.find("ModelVariables") or ():
            if one.tag in _TYPES:
                least, most = one.get("min"), one.get("max")
                variables[one.get("name", "")] = Variable(
                    name=one.get("name", ""),
                    reference=int(one.get("valueReference", "")),
                    type=one.tag,
                    causality=one.get("causality", "local"),
                    variability=one.get("variability", "continuous"),
                    shape=tuple(int(size.get("start", "")) for size in one.iter("Dimension")),
                    unit=one.get("unit"),
                    min=None if least is None else float(least),
                    max=None if most is None else float(most),
                    description=one.get("description", ""),
                    choices=choices.get(one.get("declaredType"), {}),
                )
        experiment = root.find("DefaultExperiment")
        step, stop = (float("nan") if experiment is None else float(experiment.get(k, "nan")) for k in ("stepSize", "stopTime"))
        return cls(root.get("instantiationToken", ""), step, stop, variables)

    def find(self, name: str, causality: str | None = None) -> Variable:
        """A variable by name, of this causality if one is given.

        Raises:
            SimulationError: with names that are alike.
        """
        found = self.variables.get(name)
        if found is not None and causality in (None, found.causality):
            return found
        names = [one.name for one in self.variables.values() if causality in (None, one.causality)]
        alike = difflib.get_close_matches(name, names, 3, 0.5)
        others = f"there are {', '.join(names)}" if causality else "see `variables` for all names"
        hint = f"did you mean {' or '.join(f'`{one}`' for one in alike)}?" if alike else others
        raise SimulationError(f"found no {causality or 'variable'} `{name}`; {hint}")
