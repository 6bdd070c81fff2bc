"""Puts the command and the libraries of FMUs into the wheel, and gives it the tag of their platform.

They lie in the folder that SPHERE_DDA_BUILT names: see release/wheel.
"""

import os
import re
from pathlib import Path

from hatchling.builders.hooks.plugin.interface import BuildHookInterface

# Older ones install nowhere that a Python of today runs.
OLDEST_GLIBC = (2, 17)


def tag(programs):
    """The platform of programs and libraries: Windows, or Linux with the glibc that all of them run with."""
    if any(path.suffix == ".exe" for path in programs):
        return "win_amd64"
    needed = [OLDEST_GLIBC]
    for path in programs:
        if path.suffix != ".dll":
            found = re.findall(rb"GLIBC_(\d+)\.(\d+)", path.read_bytes())
            needed += [(int(major), int(minor)) for major, minor in found]
    return "manylinux_{}_{}_x86_64".format(*max(needed))


class PlatformWheel(BuildHookInterface):
    """The hook."""

    def initialize(self, version, build_data):
        built = os.environ.get("SPHERE_DDA_BUILT")
        if not built:
            raise SystemExit("SPHERE_DDA_BUILT is not set: make wheels with release/wheel")
        files = [path for path in Path(built).rglob("*") if path.is_file()]
        programs = [path for path in files if path.suffix in ("", ".exe", ".so", ".dll")]
        build_data["pure_python"] = False
        build_data["tag"] = f"py3-none-{tag(programs)}"
        for path in files:
            build_data["force_include"][str(path)] = f"sphere_dda/bin/{path.relative_to(built).as_posix()}"
