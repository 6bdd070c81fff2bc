"""What goes wrong, as exceptions that say where, what was found and how to mend it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass


class SphereDdaError(Exception):
    """Any error of this package."""


class CommandError(SphereDdaError):
    """The command refused its arguments or failed; the text is its message."""

    def __init__(self, message: str, code: int):
        super().__init__(message)
        #: Exit code: 1 a run failed, 2 invalid file or argument, 130 interrupted.
        self.code = code

    def __reduce__(self):
        return type(self), (self.args[0], self.code)


@dataclass(frozen=True)
class Problem:
    """A finding about a scene."""

    #: `error`: the scene is refused; `warning`: it runs, but probably not as meant; `advice`: it could be simpler.
    severity: str
    #: Key path, counted from 0: `boundary[1].faces[0].plane.normal`.
    path: str
    #: Line in the scene file, from 1; of a scene from a dict, in `Scene.text`.
    line: int
    #: What was found and what is expected, with units.
    message: str
    #: How to mend it.
    help: str | None = None

    def __str__(self) -> str:
        mend = f"\n  help: {self.help}" if self.help else ""
        return f"{self.path}: {self.message}{mend}"


class SceneError(SphereDdaError):
    """A scene that was refused, with all its problems in the order of the file."""

    def __init__(self, name: str, problems: Sequence[Problem]):
        super().__init__("\n".join(f"{name}:{problem.line}: {problem}" for problem in problems))
        self.name = name
        self.problems = list(problems)

    def __reduce__(self):
        return type(self), (self.name, self.problems)


class SimulationError(SphereDdaError):
    """A call that the FMU refused or could not do; the text is what its log says."""

    def __init__(self, message: str, status: str = "error"):
        super().__init__(message)
        #: `discard`: the step failed and nothing has changed, a shorter one may do. `error`: see the text.
        self.status = status

    def __reduce__(self):
        return type(self), (self.args[0], self.status)


class SimulationWarning(UserWarning):
    """Warnings of the FMU: steps that missed the tolerances, files that could not be written."""
