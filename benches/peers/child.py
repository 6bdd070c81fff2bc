"""A program in a process of its own: what it said, its CPU time and its largest resident memory.

Linux counts the memory of the process that forks as the child's too: this file starts the program a second time removed, from a
small interpreter that imports nothing else.
"""

import json
import os
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path


@dataclass(frozen=True)
class Ended:
    """A program that ended; `cpu_s` [s] is that of all its processes, `peak` [B] that of the largest one."""

    status: int
    out: str
    error: str
    cpu_s: float
    peak: float


def run(command: list[str], folder: Path, environment: dict[str, str] | None = None) -> Ended:
    """Runs `command` in `folder`; the report is left there."""
    report = folder / "usage.json"
    report.unlink(missing_ok=True)
    starter = [sys.executable, "-I", "-S", str(Path(__file__).resolve()), str(report), *command]
    done = subprocess.run(starter, cwd=folder, env=environment, capture_output=True, text=True, errors="replace", check=False)
    if not report.exists():
        return Ended(done.returncode or 1, done.stdout, done.stderr, 0.0, 0.0)
    usage = json.loads(report.read_text())
    return Ended(done.returncode, done.stdout, done.stderr, usage["cpu_s"], usage["peak"])


def _start(report: str, command: list[str]) -> int:
    program = os.posix_spawnp(command[0], command, os.environ)
    _, status, usage = os.wait4(program, 0)
    # Kilobytes on Linux.
    Path(report).write_text(json.dumps({"cpu_s": usage.ru_utime + usage.ru_stime, "peak": usage.ru_maxrss * 1024.0}))
    return os.waitstatus_to_exitcode(status)


if __name__ == "__main__":
    sys.exit(_start(sys.argv[1], sys.argv[2:]))
