"""The command and the library of the FMUs that this package brings along."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

from .errors import CommandError, SphereDdaError

_WINDOWS = sys.platform == "win32"
_PLATFORM, _LIBRARY = ("win64", "sphere_dda_fmu.dll") if _WINDOWS else ("linux64", "libsphere_dda_fmu.so")


def program() -> Path:
    """The command: that of the package, unless the environment variable SPHERE_DDA names another."""
    bundled = Path(__file__).parent / "bin" / ("sphere-dda.exe" if _WINDOWS else "sphere-dda")
    path = Path(os.environ.get("SPHERE_DDA", bundled))
    if not path.is_file():
        raise SphereDdaError(
            f"the command is not at `{path}`: install a wheel for this platform, or name the command in SPHERE_DDA"
        )
    return path


def library() -> Path:
    """The library that the command packs into FMUs of this platform."""
    folder = program().parent
    places = [folder / _LIBRARY, folder / "platforms" / _PLATFORM / _LIBRARY]
    for place in places:
        if place.is_file():
            return place
    raise SphereDdaError(f"the library of the FMUs is at none of {', '.join(map(str, places))}")


def run(*arguments: str | os.PathLike[str]) -> str:
    """Runs the command and returns what it prints.

    Raises:
        CommandError: with the command's message.
    """
    done = subprocess.run([program(), *arguments], capture_output=True, text=True, encoding="utf-8")
    if done.returncode != 0:
        raise CommandError((done.stderr or done.stdout).strip(), done.returncode)
    return done.stdout
