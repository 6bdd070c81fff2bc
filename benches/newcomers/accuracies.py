"""Runs the scenes of newcomers at every accuracy, by the command and as FMUs, and writes docs/newcomers.md."""

import argparse
import json
import os
import platform
import shlex
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path

from cases import ACCURACIES, CASES, REFERENCE, ROOT
from measure import SHARE, WINDOW, Failed, Record, at_accuracy, compared, driven, export, run

RECORD = "newcomers.json"
PAGE = "newcomers.md"
INTRODUCTION = f"""\
Scenes as newcomers write them ([tests/newcomers](../tests/newcomers)): no key of the solver is
set. This page is the output of one command, which runs each scene at every `accuracy`:

```sh
benches/newcomers/run        # --scenes box,silo --accuracies fast,standard --skip-fmu: a part of it
```

*x real time*: simulated time over CPU time. *overlap*: worst of any internal step, over the
smaller radius. *unconverged*: internal steps that missed the tolerances and went on. *force error*
is that of the resultant in the last table against the run at `{REFERENCE}`. Of scenes that are
steady at the end it is the difference of the means over the last {"third" if SHARE == 1 / 3 else SHARE} of the run over the
reference's mean. Of the others it is the root mean square of the difference of the running means
(window: {WINDOW:.0%} of the run) over that of the reference; scenes of many impacts are chaotic, so
that a part of it is no error of the solver. *commit*: of the project, when the row was measured.
"""
FMU = """\
Communication steps of the FMU, its inputs driven by fmpy. *export*: CPU time, with settling
where the scene was exported with `--until-rest`. *discards*: steps the FMU refused; each was taken
again in ten parts.
"""


def main() -> int:
    """The command; 1 if a run failed, 2 if there is no such scene."""
    arguments = _arguments()
    unknown = sorted({*arguments.scenes} - {*CASES}) + sorted({*arguments.accuracies} - {*ACCURACIES})
    if unknown:
        print(f"no such scene or accuracy: {', '.join(unknown)}", file=sys.stderr)
        return 2
    path = arguments.out / RECORD
    record = json.loads(path.read_text()) if path.exists() else {"scenes": {}}
    record["machine"] = _machine()
    failed = 0
    for name in arguments.scenes:
        with tempfile.TemporaryDirectory(prefix="newcomers-") as folder:
            rows = _measured(name, arguments, Path(folder))
        for accuracy, row in rows.items():
            for part in row.values():
                part["commit"] = record["machine"]["commit"]
            record["scenes"].setdefault(name, {}).setdefault(accuracy, {}).update(row)
            failed += sum("failed" in part for part in row.values())
            print(f"{name:15} {accuracy:10} {_told(row)}", flush=True)
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(json.dumps(record, indent=1, sort_keys=True) + "\n")
        (arguments.out / PAGE).write_text("\n".join(_page(record)) + "\n")
    print(f"{arguments.out / PAGE} is written; {failed} runs failed")
    return 1 if failed else 0


def _arguments() -> argparse.Namespace:
    def names(text: str) -> list[str]:
        return text.split(",")

    parser = argparse.ArgumentParser(prog="benches/newcomers/run", description=__doc__)
    parser.add_argument("--scenes", type=names, default=[*CASES], metavar="A,B", help="these scenes only; the other rows stay")
    parser.add_argument("--accuracies", type=names, default=[*ACCURACIES], metavar="A,B", help="these accuracies only")
    parser.add_argument("--skip-fmu", action="store_true", help="no export, no steps of FMUs")
    parser.add_argument("--skip-runs", action="store_true", help="FMUs only")
    parser.add_argument("--fmu-steps", type=int, default=1000, metavar="N", help="communication steps of each FMU (1000)")
    parser.add_argument("--limit", type=float, default=1800.0, metavar="S", help="clock time after which a run counts as failed")
    parser.add_argument("--out", type=Path, default=ROOT / "docs", help="folder of the page (docs)")
    return parser.parse_args()


def _measured(name: str, arguments: argparse.Namespace, folder: Path) -> dict[str, dict[str, Record]]:
    """Accuracy -> "run" and "fmu" -> what was found."""
    case, runs = CASES[name], {}
    rows: dict[str, dict[str, Record]] = {accuracy: {} for accuracy in arguments.accuracies}
    for accuracy in arguments.accuracies:
        scene = at_accuracy(name, accuracy, folder / accuracy)
        if not arguments.skip_runs:
            try:
                runs[accuracy] = run(scene, folder / accuracy / "results", arguments.limit)
            except Failed as error:
                rows[accuracy]["run"] = {"failed": str(error)}
        if not arguments.skip_fmu:
            fmu = folder / accuracy / f"{name}.fmu"
            try:
                cost = export(scene, fmu, case.rests, arguments.limit)
                rows[accuracy]["fmu"] = {"export": cost, **driven(name, fmu, arguments.fmu_steps, arguments.limit)}
            except Failed as error:
                rows[accuracy]["fmu"] = {"failed": str(error)}
    for accuracy, found in compared(runs, case).items():
        rows[accuracy]["run"] = found
    return rows


def _told(row: dict[str, Record]) -> str:
    def part(found: Record) -> str:
        return ", ".join(f"{key} {value:.3g}" if isinstance(value, float) else f"{key} {value}" for key, value in found.items())

    return "; ".join(f"{what}: {part(found)}" for what, found in row.items())


def _machine() -> dict[str, str]:
    """What a reader needs to judge the times by."""
    models = [line.split(":")[1].strip() for line in Path("/proc/cpuinfo").read_text().splitlines() if line.startswith("model name")]
    commit = ["git", "-C", str(ROOT), "describe", "--always", "--dirty"]
    return {
        "date": time.strftime("%Y-%m-%d"),
        "command": shlex.join(["benches/newcomers/run", *sys.argv[1:]]),
        "processor": models[0] if models else platform.processor(),
        "cores": str(os.cpu_count()),
        "commit": subprocess.run(commit, capture_output=True, text=True, check=False).stdout.strip() or "unknown",
    }


def _page(record: dict[str, dict]) -> Iterator[str]:
    m = record["machine"]
    rows = [
        (name, accuracy, record["scenes"][name][accuracy]) for name in CASES for accuracy in ACCURACIES if accuracy in record["scenes"].get(name, {})
    ]
    yield f"<!-- Written by benches/newcomers/run. -->\n\n# Scenes of newcomers\n\n{INTRODUCTION}"
    yield f"Last: {m['date']}, commit {m['commit']}, {m['processor']}, {m['cores']} cores,\n`{m['command']}`."
    yield "\n## Runs\n"
    head = ["scene", "accuracy", "CPU s", "x real time", "overlap", "unconverged", "force error", "commit"]
    yield from _table(head, [[name, accuracy, *_run(row["run"])] for name, accuracy, row in rows if "run" in row])
    yield f"\n## As FMUs\n\n{FMU}"
    head = ["scene", "accuracy", "export CPU s", "steps", "CPU s", "x real time", "discards", "commit"]
    yield from _table(head, [[name, accuracy, *_fmu(row["fmu"])] for name, accuracy, row in rows if "fmu" in row])
    reasons = [(name, accuracy, what, part["failed"]) for name, accuracy, row in rows for what, part in row.items() if "failed" in part]
    if reasons:
        yield "\n## Failed\n"
        yield from (f"- {name}, {accuracy}, {what}: {why}" for name, accuracy, what, why in reasons)
    yield "\n## Resultants\n"
    kinds = {True: "means at the end", False: "running means"}
    head = ["scene", "column of history.csv", "compared by"]
    yield from _table(head, [[name, f"`{case.column}`", kinds[case.steady]] for name, case in CASES.items()])


def _table(head: list[str], rows: list[list[str]]) -> Iterator[str]:
    for line in (head, ["---"] * len(head), *rows):
        yield "| " + " | ".join(line) + " |"


def _pace(part: Record) -> str:
    return f"{part['simulated'] / part['cpu']:.2g}"


def _run(part: Record) -> list[str]:
    if "failed" in part:
        return ["failed", "", "", "", "", part["commit"]]
    error = "" if part["error"] is None else f"{part['error']:.1%}"
    return [f"{part['cpu']:.3g}", _pace(part), f"{part['overlap']:.1e}", str(part["unconverged"]), error, part["commit"]]


def _fmu(part: Record) -> list[str]:
    if "failed" in part:
        return ["failed", "", "", "", "", part["commit"]]
    return [f"{part['export']:.3g}", str(part["steps"]), f"{part['cpu']:.3g}", _pace(part), str(part["discards"]), part["commit"]]


if __name__ == "__main__":
    sys.exit(main())
