"""`python -m sphere_dda`, and the script `sphere-dda`: the command."""

import os
import subprocess
import sys

from .command import program


def main() -> int:
    """Becomes the command, with the arguments of this process; returns its exit code where a process cannot become another."""
    call = [str(program()), *sys.argv[1:]]
    if os.name != "nt":
        os.execv(call[0], call)
    # Ctrl-C reaches the command too, which ends the run and completes its files.
    process = subprocess.Popen(call)
    while True:
        try:
            return process.wait()
        except KeyboardInterrupt:
            continue


if __name__ == "__main__":
    sys.exit(main())
