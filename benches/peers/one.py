"""One run in a process of its own: a case as JSON on standard input, its outcome as JSON on standard output."""

import importlib
import json
import sys
import tempfile
from dataclasses import asdict
from pathlib import Path

import scenes
from runs import Case

MODULES = {"sphere-dda": "sphere_dda", "rapier": "rapier", "liggghts": "liggghts"}


def main() -> None:
    """Runs the case."""
    case = Case(**json.load(sys.stdin))
    code = importlib.import_module(f"codes.{MODULES[case.code]}")
    scene = scenes.build(case.scene, case.n, case.seed)
    with tempfile.TemporaryDirectory(prefix="peers-") as folder:
        try:
            outcome = code.run(case, scene, Path(folder))
        except RuntimeError as error:
            sys.exit(str(error))
    json.dump(asdict(outcome), sys.stdout)


if __name__ == "__main__":
    main()
