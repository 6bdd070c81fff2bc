"""A simulation: the life cycle of an FMU instance, with names and arrays."""

from __future__ import annotations

import math
import os
import re
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np

from . import command
from .contacts import Contacts
from .description import Description, Variable
from .errors import SimulationError
from .fmi3 import ENDED, Instance
from .results import Run
from .results import open as open_run
from .scene import Scene

_INSTANTIATED, _INITIALIZATION, _STEPPING, _ENDED = range(4)


class Simulation:
    """A scene that runs, step by step. A context manager; `close` ends it.

    Args:
        scene: a `Scene`, or what a `Scene` is made of.
        settle: let the spheres settle before t = 0: for at most this time [s], or `"rest"`: until they are at rest.
        parameters: values of parameters by name; names with dots as `**{"solver.tolerance.gap": 1e-6}`.

    Values are read and set by name: `sim["boundary.gate.angle"] = 0.3`, `sim["sensor.load.force"]`; `[k]` behind a name is
    element k of an array, from 1, as in history.csv. `variables` has all names with units. Inputs take effect in the next
    step: docs/fmu.md says how.

    Raises:
        SceneError: all problems of the scene.
        SimulationError: a parameter that there is not, or whose value is not allowed.
    """

    def __init__(
        self, scene: Scene | str | os.PathLike[str] | Mapping[str, Any], *, settle: float | str | None = None, **parameters: Any,
    ):
        #: The scene.
        self.scene = scene if isinstance(scene, Scene) else Scene(scene)
        self._folder = self.scene.prepare(settle)
        self._description = Description.read(self._folder / "modelDescription.xml")
        self._instance = self._instantiate("simulation")
        self._stage, self._time = _INSTANTIATED, 0.0
        self._arrays: dict[str, np.ndarray] = {}
        try:
            for name, value in parameters.items():
                self._description.find(_split(name)[0], "parameter")
                self[name] = value
        except BaseException:
            self.close()
            raise

    @property
    def variables(self) -> dict[str, Variable]:
        """All variables by name, with type, shape, unit, range and meaning."""
        return self._description.variables

    @property
    def time(self) -> float:
        """Simulated time [s]."""
        return self._time

    @property
    def calls(self) -> dict[str, int]:
        """Calls of FMI functions so far, by name: what a loop costs beside the steps themselves."""
        return {name: count for name, count in self._instance.calls.items() if count}

    @property
    def positions(self) -> np.ndarray:
        """Centres of all spheres [m], `[N, 3]`."""
        return self._whole("spheres.position")

    @property
    def radii(self) -> np.ndarray:
        """Radii [m], `[N]`."""
        return self._whole("spheres.radius")

    @property
    def velocities(self) -> np.ndarray:
        """Velocities of the centres [m/s], `[N, 3]`."""
        return self._whole("spheres.velocity")

    @property
    def angular_velocities(self) -> np.ndarray:
        """Angular velocities [rad/s], world axes, `[N, 3]`."""
        return self._whole("spheres.angularVelocity")

    @property
    def orientations(self) -> np.ndarray:
        """Orientations, unit quaternions w, x, y, z, `[N, 4]`."""
        return self._whole("spheres.orientation")

    @property
    def present(self) -> np.ndarray:
        """Which spheres are in the scene, `[N]`; others wait in a source or have left through a sink."""
        return self._whole("spheres.present")

    @property
    def contacts(self) -> Contacts:
        """The contacts that carry a force or overlap, as arrays: read anew each time, in no fixed number."""
        return Contacts.read(self["contacts.document"])

    def __getitem__(self, name: str) -> Any:
        whole, index = _split(name)
        variable = self._description.find(whole)
        self._check_index(variable, index)
        if self._stage == _INSTANTIATED and variable.causality not in ("parameter", "input", "independent"):
            self._initialize()
        value = self._instance.get(variable)
        return value if index is None else value.flat[index].item()

    def __setitem__(self, name: str, value: Any) -> None:
        whole, index = _split(name)
        variable = self._description.find(whole)
        self._check_index(variable, index)
        if index is not None:
            value, element = self._instance.get(variable), value
            value.flat[index] = element
        self._instance.set(variable, value)

    def __contains__(self, name: str) -> bool:
        return name in self.variables

    def step(self, h: float | None = None) -> None:
        """Takes a communication step of length `h` [s], the scene's if absent.

        Raises:
            SimulationError: with `status` `discard`, nothing has changed and a shorter step may do.
        """
        if self._stage != _STEPPING:
            self._start()
        self._time = self._instance.step(self._time, self._description.step if h is None else h)

    def run(self, until: float | None = None, h: float | None = None) -> None:
        """Takes steps of length `h` [s], the scene's if absent, up to the time `until` [s], the scene's duration if absent.

        Communication points are multiples of `h`, so the results are those of `sphere-dda run`.
        """
        until, h = self._description.stop if until is None else until, self._description.step if h is None else h
        if not (h > 0.0 and math.isfinite(until)):
            raise SimulationError(f"found h = {h} s, until = {until} s; expected h > 0 and a finite time")
        k = round(self._time / h)
        while until - self._time > 1e-9 * h:
            k += 1
            if k * h > self._time:
                self.step(min(k * h, until) - self._time)

    def save(self) -> bytes:
        """The state: all that decides the future. Works in other simulations of the scene, also in other processes."""
        if self._stage != _STEPPING:
            self._start()
        return self._instance.save()

    def restore(self, state: bytes) -> None:
        """Goes back to a state that `save` returned; the continuation is the same bit for bit.

        Raises:
            SimulationError: bytes that are no state of this scene; nothing has changed.
        """
        self._instance.restore(state)
        self._stage = _STEPPING
        self._time = self["time"]

    @contextmanager
    def record(
        self, folder: str | os.PathLike[str], *, interval: float | None = None, overwrite: bool = False,
    ) -> Iterator[Run]:
        """Writes frames and history to `folder`, as `sphere-dda run` does. The simulation ends with the block.

        Args:
            folder: the result folder.
            interval: time between frames [s]; the scene's if absent.
            overwrite: whether an earlier run in the folder may be replaced.

        Raises:
            SimulationError: after the first step, and where the folder cannot be used.
        """
        if self._stage >= _STEPPING:
            raise SimulationError("record: the simulation has begun; expected a call before the first step")
        path = Path(folder).absolute()
        if re.search(r'[\x00-\x1f\\:*?"<>|]|[. ]$', path.name):
            raise SimulationError(f"record: found the name `{path.name}`, which is no folder's on every system")
        self._rename(path.name)
        self["output.directory"] = path.parent
        self["output.overwrite"] = overwrite
        if interval is not None:
            self["output.interval"] = interval
        self._start()
        try:
            yield open_run(folder)
        finally:
            self._end()

    def close(self) -> None:
        """Completes what is recorded and frees the simulation. Arrays that were read stay valid."""
        try:
            self._end()
        finally:
            self._instance.free()

    def __enter__(self) -> Simulation:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def __del__(self) -> None:
        if hasattr(self, "_instance"):
            self._instance.free()

    def __repr__(self) -> str:
        return f"Simulation({self.scene!r}) at {self._time:g} s"

    def _instantiate(self, name: str) -> Instance:
        return Instance(command.library(), self._description.token, self._folder / "resources", name)

    def _rename(self, name: str) -> None:
        """Results go to the folder `<output.directory>/<name of the instance>`: an instance of this name, with the same values."""
        settable = [v for v in self.variables.values() if v.causality in ("parameter", "input")]
        values = [self._instance.get(variable) for variable in settable]
        self._instance.free()
        self._instance, self._stage = self._instantiate(name), _INSTANTIATED
        for variable, value in zip(settable, values):
            if not np.array_equal(self._instance.get(variable), value):
                self._instance.set(variable, value)

    def _initialize(self) -> None:
        """Places the boundaries with inputs: outputs have values from here on."""
        self._instance.call("EnterInitializationMode", False, 0.0, 0.0, False, 0.0)
        self._stage = _INITIALIZATION

    def _start(self) -> None:
        """Ends the initialization."""
        if self._stage == _ENDED:
            raise SimulationError(ENDED)
        if self._stage == _INSTANTIATED:
            self._initialize()
        self._instance.call("ExitInitializationMode")
        self._stage = _STEPPING

    def _end(self) -> None:
        if self._stage == _STEPPING:
            self._stage = _ENDED
            self._instance.call("Terminate")

    def _whole(self, name: str) -> np.ndarray:
        """An array over all spheres: each read writes to the same memory."""
        variable = self._description.find(name)
        if self._stage == _INSTANTIATED:
            self._initialize()
        if name not in self._arrays:
            self._arrays[name] = self._instance.get(variable)
            return self._arrays[name]
        return self._instance.get(variable, self._arrays[name])

    @staticmethod
    def _check_index(variable: Variable, index: int | None) -> None:
        if index is not None and not 0 <= index < math.prod(variable.shape or (0,)):
            raise SimulationError(f"{variable.name}[{index + 1}]: found no such element, its shape is {variable.shape}")


def _split(name: str) -> tuple[str, int | None]:
    """`x[3]` -> `x` and the index 2; a name without brackets -> itself and None."""
    found = re.fullmatch(r"(.+)\[(\d+)\]", name)
    return (found[1], int(found[2]) - 1) if found else (name, None)
