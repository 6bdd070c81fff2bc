"""Scenes: a file or a dict, checked, shown, exported."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import tempfile
import zipfile
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from . import command, toml
from .errors import CommandError, Problem, SceneError
from .page import Page
from .results import Run
from .results import open as open_run

#: Keys of a scene whose value is a file beside it.
_FILES = ("file", "csv", "vtu", "checkpoint")


@dataclass(frozen=True, repr=False)
class Check:
    """What `Scene.check` found."""

    #: Counts, mass, extent, suggested step and cost, as text.
    summary: str
    #: What runs, but probably not as meant.
    warnings: list[Problem]

    def __str__(self) -> str:
        return "\n".join([*(f"{warning.severity}: {warning}" for warning in self.warnings), self.summary])

    __repr__ = __str__


class Scene:
    """A scene: the path of a scene file (TOML), or a dict with the same keys.

    Args:
        source: path, or dict. Keys and units are those of docs/scene.md; numpy arrays and numbers are welcome.
        folder: of a dict: where the files lie that it refers to (meshes, tables); the current folder if absent.
        name: of a dict: its name, which FMUs and pages get.

    A scene is prepared once for all its simulations: make a new `Scene` after its file has changed.
    """

    def __init__(
        self, source: str | os.PathLike[str] | Mapping[str, Any], *,
        folder: str | os.PathLike[str] = ".", name: str = "scene",
    ):
        self._source, self._folder, self._name = source, Path(folder).absolute(), name
        self._scratch: tempfile.TemporaryDirectory[str] | None = None
        self._prepared: dict[tuple[str, ...], Path] = {}
        if isinstance(source, Mapping):
            #: The scene file; of a dict a temporary one.
            self.path = Path(self._own_folder(), "scene", f"{name}.toml")
            self.path.parent.mkdir()
            self.path.write_text(toml.document(source), encoding="utf-8")
            self._copy_files(source)
        else:
            self.path = Path(source).absolute()

    def __reduce__(self):
        # Temporary files stay with the process that made them.
        source = self._source if isinstance(self._source, Mapping) else self.path
        return _rebuilt, (source, self._folder, self._name)

    def __repr__(self) -> str:
        return f"Scene({self._name!r} from a dict)" if isinstance(self._source, Mapping) else f"Scene({str(self.path)!r})"

    @property
    def text(self) -> str:
        """The text of the scene file."""
        return self.path.read_text(encoding="utf-8")

    def check(self) -> Check:
        """Checks the scene.

        Raises:
            SceneError: with all its problems at once.
        """
        call = [os.fspath(command.program()), "check", "--json", os.fspath(self.path)]
        done = subprocess.run(call, capture_output=True, text=True, encoding="utf-8")
        try:
            told = json.loads(done.stdout)
        except ValueError:
            raise CommandError(done.stderr.strip(), done.returncode) from None
        problems = [Problem(**problem) for problem in told["problems"]]
        if told["summary"] is None:
            raise SceneError(self.path.name, problems)
        return Check(told["summary"], problems)

    def view(self, output: str | os.PathLike[str] | None = None, **options: object) -> Page:
        """Writes the page of the scene at t = 0 (HTML, offline); notebooks show it inline.

        Args:
            output: the page; a temporary file if absent.
            options: as of `sphere-dda view`, `max_size="10MB"`.
        """
        output = output or Path(self._own_folder(), f"{self.path.stem}.html")
        with _named(self):
            return Page.of(self.path, output, keep=self._scratch, **options)

    def run(self, output: str | os.PathLike[str], *, overwrite: bool = False, **options: object) -> Run:
        """Runs the scene by the command, to the end of its duration or to `stop=` [s], and returns the `Run`.

        Args:
            output: the result folder.
            overwrite: whether an earlier run in it may be replaced.
            options: as of `sphere-dda run`: `stop=1.5`, `until_rest=True`, `settle=2.0`.
        """
        self._command("run", "-o", Path(output), *["--overwrite"] * overwrite, *_flags(options))
        return open_run(output)

    def export(
        self, path: str | os.PathLike[str], *, fmi: int = 2, settle: float | str | None = None,
        platforms: Sequence[str] = (), overwrite: bool = False,
    ) -> Path:
        """Packs the scene into an FMU and returns its path.

        Args:
            path: the FMU; its name ends with `.fmu`.
            fmi: 2 or 3; arrays of all spheres in 3 only.
            settle: let the spheres settle before t = 0: for at most this time [s], or `"rest"`: until they are at rest.
            platforms: of the FMU: `linux64`, `win64`; this one if empty.
            overwrite: whether the file may be replaced.

        Raises:
            SceneError: all problems of the scene. CommandError: what else stops the export.
        """
        each = ["--platform", ",".join(platforms)] if platforms else []
        more = [*each, *["--overwrite"] * overwrite, *_settling(settle)]
        self._command("export", "-o", Path(path), "--fmi", str(fmi), *more)
        return Path(path)

    def prepare(self, settle: float | str | None = None) -> Path:
        """The unpacked FMU of FMI 3.0 without library, made once for each `settle`: what a `Simulation` starts from."""
        key = _settling(settle)
        if key not in self._prepared:
            folder = Path(tempfile.mkdtemp(dir=self._own_folder()))
            fmu = self.export(folder / "scene.fmu", fmi=3, settle=settle)
            with zipfile.ZipFile(fmu) as archive:
                wanted = [n for n in archive.namelist() if n == "modelDescription.xml" or n.startswith("resources/")]
                archive.extractall(folder, wanted)
            fmu.unlink()
            self._prepared[key] = folder
        return self._prepared[key]

    def _own_folder(self) -> str:
        if self._scratch is None:
            self._scratch = tempfile.TemporaryDirectory(prefix="sphere-dda-", ignore_cleanup_errors=True)
        return self._scratch.name

    def _copy_files(self, value: Any) -> None:
        """Files lie beside or below the scene file: copies those that the dict names. The command tells of missing ones."""
        if isinstance(value, Mapping):
            for key, one in value.items():
                if key in _FILES and isinstance(one, (str, os.PathLike)):
                    found, place = self._folder / one, self.path.parent / one
                    if found.is_file() and place.resolve().is_relative_to(self.path.parent.resolve()):
                        place.parent.mkdir(parents=True, exist_ok=True)
                        shutil.copyfile(found, place)
                else:
                    self._copy_files(one)
        elif isinstance(value, (list, tuple)):
            for one in value:
                self._copy_files(one)

    def _command(self, verb: str, *arguments: str | os.PathLike[str]) -> None:
        with _named(self):
            command.run(verb, self.path, *arguments)


class _named:
    """Turns the failure of a command into the problems of the scene, if it has any."""

    def __init__(self, scene: Scene):
        self.scene = scene

    def __enter__(self) -> None:
        pass

    def __exit__(self, kind, error, trace) -> None:
        if isinstance(error, CommandError) and error.code == 2:
            self.scene.check()


def _rebuilt(source: Any, folder: Path, name: str) -> Scene:
    return Scene(source, folder=folder, name=name)


def _settling(settle: float | str | None) -> tuple[str, ...]:
    if settle is None:
        return ()
    return ("--until-rest",) if settle == "rest" else ("--settle", str(settle))


def _flags(options: Mapping[str, object]) -> list[str]:
    """Keyword arguments as options of the command."""
    flags = []
    for key, value in options.items():
        if value is not False and value is not None:
            flags.append(f"--{key.replace('_', '-')}")
            flags += [] if value is True else [str(value)]
    return flags
