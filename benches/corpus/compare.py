"""Solves Siconos' test problems by this project and by Siconos on one thread and writes docs/corpus.md; `run` starts it."""

import argparse
import csv
import json
import os
import platform
import signal
import subprocess
import sys
import tempfile
from dataclasses import asdict, dataclass, field
from pathlib import Path

import convert
import numpy as np
import page
import peer
import siconos.numerics as sn

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent
TOLERANCE = 1e-8
STUCK = 1800  # wall time after which a run of Siconos is given up [s]
PEERS = ("NSGS", "ADMM", "NSN_AC")
QUIET = 0.2  # cores busy with other work, above which times are worth little


@dataclass
class Solve:
    """What one solver made of one problem; `error` is Siconos' measure, taken by Siconos."""

    error: float
    iterations: str
    seconds: float
    failed: str = ""

    @property
    def solved(self) -> bool:
        """Whether the tolerance is reached."""
        return not self.failed and self.error <= TOLERANCE


@dataclass
class Problem:
    """A problem and all its solves by solver, `NSGS2D` being their solver of two dimensions on the file as it is."""

    name: str
    contacts: int
    ours: dict[str, Solve] = field(default_factory=dict)
    theirs: dict[str, Solve] = field(default_factory=dict)


def main() -> int:
    """The command; 1 if a file cannot be compared."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("data", type=Path, help="folder of problems: .dat and .hdf5")
    parser.add_argument("--out", type=Path, default=ROOT / "docs")
    parser.add_argument("--only", default="", help="part of the names")
    parser.add_argument("--page", action="store_true", help="write the page from the last record")
    arguments = parser.parse_args()
    record = arguments.out / "corpus" / "record.json"
    if arguments.page:
        kept = json.loads(record.read_text())
        page.write(arguments.out / "corpus.md", kept["machine"], [_read(one) for one in kept["problems"]], kept["refused"])
        return 0
    busy = os.getloadavg()[0]
    if busy > QUIET:
        print(f"warning: other work keeps {busy:.1f} cores busy: times are worth little", file=sys.stderr)
    with tempfile.TemporaryDirectory() as folder:
        problems, refused = compared(arguments.data, Path(folder), arguments.only)
    record.parent.mkdir(parents=True, exist_ok=True)
    machine = {"processor": _processor(), "busy": f"{busy:.1f}", "siconos": _version(), "limit": f"{peer.LONGEST} s of CPU time"}
    kept = {"machine": machine, "refused": refused, "problems": [asdict(one) for one in problems]}
    record.write_text(json.dumps(kept, indent=1) + "\n")
    page.write(arguments.out / "corpus.md", machine, problems, refused)
    return 0


def compared(data: Path, folder: Path, only: str) -> tuple[list[Problem], list[str]]:
    """All problems of a folder with all solves, and why some files are none."""
    texts = folder / "texts"
    texts.mkdir()
    for path in sorted(data.glob("*.dat")):
        (texts / path.name).symlink_to(path.resolve())
    for path in sorted(data.glob("*.hdf5")):
        (texts / f"{path.stem}.dat").write_text(convert.converted(path))
    for path in list(texts.iterdir()):
        if only not in path.name:
            path.unlink()
    target = Path(os.environ.get("CARGO_TARGET_DIR", ROOT / "target")) / "release" / "sphere-dda"
    out = folder / "solved"
    command = [target, "corpus", texts, "--solver", "all", "--tolerance", str(TOLERANCE), "-o", out]
    run = subprocess.run(command, capture_output=True, text=True, check=False)
    if run.returncode not in (0, 1):
        raise SystemExit(run.stderr)
    refused = [line.split("texts/")[-1] for line in run.stderr.splitlines() if line.startswith("not read")]
    rows: dict[str, list[dict[str, str]]] = {}
    with (out / "corpus.csv").open() as file:
        for row in csv.DictReader(file):
            rows.setdefault(row["problem"], []).append(row)
    problems = []
    for name, own in rows.items():
        problem = Problem(name, int(own[0]["contacts"]))
        local = out / f"{name}.dat"
        for row in own:
            problem.ours[row["solver"]] = _judged(local, out / f"{name}.{row['solver']}.txt", row)
        for solver in PEERS:
            problem.theirs[solver] = solved(local, solver)
        original = texts / f"{name}.dat"
        if original.read_text()[:1] == "2" and not name.startswith("gfc"):
            problem.theirs["NSGS2D"] = solved(original, "NSGS")
        problems.append(problem)
        print(page.told(problem), flush=True)
    return problems, refused


def _judged(local: Path, impulses: Path, row: dict[str, str]) -> Solve:
    """Our impulses by their measure."""
    text = impulses.read_text().split()
    error = 0.0
    if text:
        error = peer.measure(sn.frictionContact_new_from_filename(str(local)), np.array(text, float))
    iterations = f"{row['sweeps']}+{row['factorizations']}"
    return Solve(error, iterations, 1e-3 * float(row["time (ms)"]))


def solved(path: Path, solver: str) -> Solve:
    """One of their solvers in a process of its own."""
    command = [sys.executable, HERE / "peer.py", path, solver, str(TOLERANCE)]
    late = Solve(1.0, "-", float(peer.LONGEST), f"more than {peer.LONGEST} s")
    try:
        run = subprocess.run(command, capture_output=True, text=True, timeout=STUCK, check=False)
    except subprocess.TimeoutExpired:
        return late
    if run.returncode == -signal.SIGXCPU:
        return late
    lines = [line for line in run.stdout.splitlines() if line.startswith('{"error"')]
    if run.returncode or not lines:
        return Solve(1.0, "-", 0.0, "crash" if run.returncode < 0 else "refused")
    found = json.loads(lines[-1])
    error = found["error"] if np.isfinite(found["error"]) else 1.0
    return Solve(error, str(found["iterations"]), found["cpu_s"])


def _read(one: dict) -> Problem:
    solves = {side: {name: Solve(**solve) for name, solve in one[side].items()} for side in ("ours", "theirs")}
    return Problem(one["name"], one["contacts"], **solves)


def _processor() -> str:
    for line in Path("/proc/cpuinfo").read_text().splitlines():
        if line.startswith("model name"):
            return line.split(":", 1)[1].strip()
    return platform.processor()


def _version() -> str:
    run = subprocess.run(["dpkg-query", "-W", "-f", "${Version}", "python3-siconos"], capture_output=True, text=True, check=False)
    return run.stdout or "unknown"


if __name__ == "__main__":
    sys.exit(main())
