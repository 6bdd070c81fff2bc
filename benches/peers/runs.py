"""A run of one code on one scene: what is asked for and what came of it."""

import json
from collections.abc import Callable
from dataclasses import asdict, dataclass, field
from typing import Any, Literal

from measures import Course, End
from scenes import DURATION

Code = Literal["sphere-dda", "sphere-dda-fmi", "rapier", "liggghts", "mujoco", "newton"]

INTERVAL = 0.004  # between two output times [s]
MEAN = 0.04  # before the end over which the force on the floor is averaged [s]


@dataclass(frozen=True)
class Case:
    """A code, a scene and settings.

    Positions at every output time are judged if `watch`; what each communication step cost is kept if `trace`.
    """

    code: Code
    scene: str
    n: int
    settings: dict[str, float | bool | str]
    seed: int = 1
    threads: int = 1
    duration: float = DURATION
    watch: bool = True
    trace: bool = False

    @property
    def key(self) -> str:
        """Equal for equal cases."""
        return json.dumps(asdict(self), sort_keys=True)

    @property
    def label(self) -> str:
        """The settings in words, for tables and legends."""
        return _LABELS[self.code](self.settings)


def tidy(x: float) -> str:
    """Three digits; powers of ten without padding, from 1e5 on and below 1e-3."""
    if x == 0 or 1e-3 <= abs(x) < 1e5:
        return f"{x:.0f}" if abs(x) >= 1e3 else f"{x:.3g}"
    mantissa, _, exponent = f"{x:.2e}".partition("e")
    return f"{mantissa.rstrip('0').rstrip('.')}e{int(exponent)}"


def _ours(s: dict[str, float | bool | str]) -> str:
    words = {
        "tolerance": tidy,
        "step": lambda x: f"{x * 1e3:g} ms",
        "fixed_step": lambda _: "fixed",
        "accuracy": str,
        "registers": lambda x: f"{x} registers",
    }
    return ", ".join(words.get(name, lambda x, name=name: f"{name.replace('_', ' ')} {tidy(x)}")(value) for name, value in s.items())


def _rapier(s: dict[str, float]) -> str:
    label = f"{s['step'] * 1e3:g} ms, {s['substeps']:g} substeps, {s['softness']:g} Hz"
    return f"{label}, prediction {s['prediction']:g} d" if "prediction" in s else label


def _liggghts(s: dict[str, float]) -> str:
    return f"E = {tidy(s['young'])} Pa"


def _mujoco(s: dict[str, float]) -> str:
    return f"{s['step'] * 1e3:g} ms, {s['iterations']:g} iterations, contact time {s['time'] * 1e3:g} ms"


def _newton(s: dict[str, Any]) -> str:
    words = [str(s["solver"]), f"{s['step'] * 1e3:g} ms"]
    return ", ".join([*words, f"{s['iterations']:g} iterations"] if "iterations" in s else words)


_LABELS: dict[str, Callable[[dict[str, Any]], str]] = {
    "sphere-dda": _ours,
    "sphere-dda-fmi": _ours,
    "rapier": _rapier,
    "liggghts": _liggghts,
    "mujoco": _mujoco,
    "newton": _newton,
}


@dataclass(frozen=True)
class Outcome:
    """What a run cost and reached; `None` where a code does not tell."""

    version: str
    cpu_s: float  # of all threads or processes [s]
    wall_s: float  # [s]
    spheres: int
    steps: int
    end: End
    watched: Course | None = None  # of the positions at all output times
    worst: float | None = None  # the same at every internal step [-]
    floor: float | None = None  # mean force on the floor over the weight [-]
    memory: float | None = None  # per sphere [B]
    peak: float | None = None  # largest resident memory of the process that computed, with its libraries [B]
    opening: float | None = None  # largest gap of a loaded contact over radius at every internal step [-]
    force: list[float] = field(default_factory=list)  # the scene's load over the intervals of its window [N, N m]
    sweeps: int | None = None
    factorizations: int | None = None
    force_residual: float | None = None  # worst of any step [-]
    contacts: float | None = None  # loaded ones, mean over output times
    course: dict[str, list[float]] = field(default_factory=dict)  # per communication step

    @property
    def largest(self) -> float | None:
        """The largest overlap over radius that is known of [-]."""
        known = [] if self.worst is None else [self.worst]
        return max([*known, self.watched.worst] if self.watched else known, default=None)

    @property
    def widest(self) -> float | None:
        """The widest opening of a loaded contact over radius: of every internal step if told, else of the output times [-]."""
        if self.opening is not None:
            return self.opening
        return self.watched.opening if self.watched else None

    @staticmethod
    def from_dict(data: dict[str, Any]) -> "Outcome":
        """The outcome of what `asdict` gave."""
        watched = data["watched"] and Course(**data["watched"])
        return Outcome(**{**data, "end": End(**data["end"]), "watched": watched})


@dataclass(frozen=True)
class Row:
    """A case and its outcome. Rows of one `group` were timed in turn."""

    case: Case
    group: str
    outcome: Outcome


@dataclass(frozen=True)
class Failed:
    """A case that has no outcome, and why."""

    case: Case
    group: str
    error: str


def from_dict(data: dict[str, Any]) -> Row | Failed:
    """The row of what `asdict` gave."""
    case, group = Case(**data["case"]), data["group"]
    if "error" in data:
        return Failed(case, group, data["error"])
    return Row(case, group, Outcome.from_dict(data["outcome"]))
