"""One run in a process of its own: a case as JSON on standard input, its outcome as JSON on standard output."""

import json
import sys
import tempfile
from dataclasses import asdict
from pathlib import Path

import scenes
from codes import module
from runs import Case


def main() -> None:
    """Runs the case."""
    case = Case(**json.load(sys.stdin))
    code = module(case.code)
    scene = scenes.build(case.scene, case.n, case.seed)
    with tempfile.TemporaryDirectory(prefix="peers-") as folder:
        try:
            outcome = code.run(case, scene, Path(folder))
        except RuntimeError as error:
            sys.exit(str(error))
    json.dump(asdict(outcome), sys.stdout)


if __name__ == "__main__":
    main()
