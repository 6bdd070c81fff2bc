"""Result folders: history, frames, pages."""

from __future__ import annotations

import csv
import json
import os
import re
import xml.etree.ElementTree as xml
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np

from . import vtu
from .errors import SphereDdaError
from .page import Page


@dataclass(frozen=True)
class Frame:
    """A frame. Arrays and units are those of docs/results.md#frames."""

    #: Time [s].
    time: float
    #: `position` [m] `[n, 3]`, `radius` [m] `[n]`, `velocity` [m/s], `angular_velocity` [rad/s], `force` [N], `torque` [N m]
    #: `[n, 3]`, `orientation` `[n, 4]` (w, x, y, z), `id`, `material` `[n]`.
    spheres: dict[str, np.ndarray]
    #: `ends` [m] `[n, 2, 3]`: the line from centre 1 to centre 2 or to the boundary; `normal_force` [N], `overlap` [m],
    #: `slip` [m/s] `[n]`, `force` on 1 [N] `[n, 3]`, `id1`, `id2`, `kind` `[n]` (0 between spheres, 1 on a boundary).
    contacts: dict[str, np.ndarray]
    #: `triangles` [m] `[n, 3, 3]`, `velocity` [m/s] of their corners `[n, 3, 3]`, `force` on the whole boundary [N] `[n, 3]`,
    #: `boundary` `[n]`: row in `Run.boundaries`; with `wall_fields` also what each triangle feels: `area` [m2], `pressure` [Pa],
    #: `shear`, `traction` [Pa] `[n, 3]`, `friction_energy`, `impact_energy` [J], `wear_depth` [m] `[n]`.
    boundaries: dict[str, np.ndarray]


class Frames(Sequence[Frame]):
    """The frames of a run, read when they are asked for."""

    def __init__(self, folder: Path):
        self._folder = folder
        lists = {series: _listed(folder / f"{series}.pvd") for series in ("spheres", "contacts", "boundaries")}
        self._files = {series: files for series, (_, files) in lists.items() if files}
        times = [times for times, files in lists.values() if files]
        # A run that still writes may have one series ahead of another.
        self._times = min(times, key=len) if times else []

    @property
    def times(self) -> np.ndarray:
        """Times of the frames [s], `[n]`."""
        return np.array(self._times)

    def __len__(self) -> int:
        return len(self._times)

    def __getitem__(self, k: Any) -> Any:
        if isinstance(k, slice):
            return [self[one] for one in range(*k.indices(len(self)))]
        if not -len(self) <= k < len(self):
            raise IndexError(f"frame {k}: the run has {len(self)} frames")
        k %= len(self)
        grids = {series: vtu.read(self._folder / files[k]) for series, files in self._files.items()}
        return Frame(
            self._times[k],
            _spheres(grids["spheres"]) if "spheres" in grids else {},
            _contacts(grids["contacts"]) if "contacts" in grids else {},
            _boundaries(grids["boundaries"]) if "boundaries" in grids else {},
        )

    def __iter__(self) -> Iterator[Frame]:
        return (self[k] for k in range(len(self)))

    def near(self, time: float) -> Frame:
        """The frame next to a time [s]."""
        if not self._times:
            raise SphereDdaError(f"`{self._folder}` has no frames: set `vtu_interval` in the scene's [output]")
        return self[int(np.abs(self.times - time).argmin())]


class Run:
    """A result folder of `sphere-dda run`, of `Scene.run` or of `Simulation.record`."""

    def __init__(self, folder: Path):
        #: The folder.
        self.folder = folder
        if not folder.is_dir() or not (folder / "run.json").is_file():
            raise SphereDdaError(f"`{folder}` is no result folder: found no `run.json`, expected the folder of a run")
        #: What `run.json` says: version, title and hash of the scene, settings.
        self.about: dict[str, Any] = json.loads((folder / "run.json").read_text(encoding="utf-8"))
        #: Names of the boundaries, in the order of the frames' `boundary`.
        self.boundaries: list[str] = self.about["boundaries"]

    @cached_property
    def _table(self) -> tuple[dict[str, np.ndarray], dict[str, str]]:
        path = self.folder / "history.csv"
        if not path.is_file():
            return {}, {}
        with path.open(newline="", encoding="utf-8") as file:
            header = next(csv.reader(file))
            # The last line of a run that still writes may be cut.
            rows = [line.split(",") for line in file if line.endswith("\n")]
        columns = np.array(rows, dtype=float).reshape(-1, len(header)).T
        names = [re.fullmatch(r"(.*) \[(.*)\]", title) for title in header]
        arrays = {found[1]: np.ascontiguousarray(column) for found, column in zip(names, columns) if found}
        return arrays, {found[1]: found[2] for found in names if found}

    @property
    def history(self) -> dict[str, np.ndarray]:
        """The columns of history.csv by name, each `[n]`; `time` [s] is the first. Units: `units`."""
        return self._table[0]

    @property
    def units(self) -> dict[str, str]:
        """Unit of each column of the history, `-` where there is none."""
        return self._table[1]

    def pandas(self):
        """The history as a DataFrame; needs pandas (`pip install sphere-dda[study]`)."""
        import pandas

        return pandas.DataFrame(self.history)

    @property
    def frames(self) -> Frames:
        """The frames that are there now."""
        return Frames(self.folder)

    def pyvista(self, k: int = -1, series: str = "spheres"):
        """Frame `k` of a series as a pyvista grid; needs pyvista (`pip install sphere-dda[view]`)."""
        import pyvista

        return pyvista.read(self.folder / self.frames._files[series][k])

    def view(self, output: str | os.PathLike[str] | None = None, **options: object) -> Page:
        """Writes the page of the run (HTML, offline), `view.html` in the folder if `output` is absent; notebooks show it.

        Args:
            options: as of `sphere-dda view`, `max_size="10MB"`.
        """
        return Page.of(self.folder, output or self.folder / "view.html", **options)

    def __repr__(self) -> str:
        return f"Run({str(self.folder)!r}): {len(self.frames)} frames"


def open(folder: str | os.PathLike[str]) -> Run:
    """Opens a result folder, also while a run still writes it.

    Raises:
        SphereDdaError: a folder that no run wrote.
    """
    return Run(Path(folder))


def _listed(path: Path) -> tuple[list[float], list[str]]:
    """Times [s] and files of a collection."""
    if not path.is_file():
        return [], []
    sets = list(xml.parse(path).getroot().iter("DataSet"))
    return [float(one.get("timestep", "nan")) for one in sets], [one.get("file", "") for one in sets]


def _spheres(grid: vtu.Grid) -> dict[str, np.ndarray]:
    # A frame without spheres holds a placeholder.
    there = grid.arrays["id"] >= 0
    return {name: array[there] for name, array in {"position": grid.points, **grid.arrays}.items()}


def _contacts(grid: vtu.Grid) -> dict[str, np.ndarray]:
    there = grid.arrays["kind"] >= 0
    corners = grid.points[grid.corners]
    ends = corners.reshape(-1, 2, 3) if there.any() else np.empty((0, 2, 3), corners.dtype)
    return {"ends": ends, **{name: array[there] for name, array in grid.arrays.items()}}


def _boundaries(grid: vtu.Grid) -> dict[str, np.ndarray]:
    corners = grid.corners.reshape(-1, 3)
    arrays = dict(grid.arrays)
    return {"triangles": grid.points[corners], **arrays, "velocity": arrays["velocity"][corners]}
