"""Runs a scene for a limited time and tells what that cost: time a step, memory, frames.

    python examples/million/settle.py --command target/release/sphere-dda --output million-results --minutes 20

The scene is the million spheres beside this script, or another one (--scene). After that time the run is interrupted as by Ctrl-C; the
same command goes on with it. When each row of the history came is kept in costs.csv in the output folder; the table, of all sessions so
far, is printed in Markdown. Needs Linux.
"""

import argparse
import csv
import resource
import signal
import subprocess
import sys
import time
from itertools import pairwise
from pathlib import Path

HERE = Path(__file__).resolve().parent
LOOK = 0.1  # between two looks at the history [s]
INTERVAL = 0.1  # simulated time of a line of the table [s]
HEAD = ("time [s]", "clock [s]", "peak memory [B]")


def table(path):
    """The complete rows of a CSV file by the names of its columns; none where there is no file yet."""
    text = path.read_text() if path.exists() else ""
    lines = text[: text.rfind("\n") + 1].splitlines()
    return [{name: float(value) for name, value in row.items()} for row in csv.DictReader(lines)]


def peak(process):
    """Largest memory of a process that runs [B]."""
    try:
        lines = Path(f"/proc/{process.pid}/status").read_text().splitlines()
    except OSError:
        return 0
    return 1024 * next((int(line.split()[1]) for line in lines if line.startswith("VmHWM")), 0)


def watch(process, folder, limit):
    """What each new row of the history has cost, until the run ends; after `limit` [s] it is asked to.

    The clock is the time since the row before, in the first row since the process began.
    """
    begun = last = time.monotonic()
    known = {row["time [s]"] for row in table(folder / "history.csv")}
    costs, largest, size, asked = [], 0, None, False
    over = False
    while not over:
        time.sleep(LOOK)
        over = process.poll() is not None
        # One that ended between two looks is told of by its parent alone.
        largest = max(largest, 1024 * resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss if over else peak(process))
        now = time.monotonic()
        if not asked and now - begun > limit:
            process.send_signal(signal.SIGINT)
            asked = True
        path = folder / "history.csv"
        if not path.exists() or path.stat().st_size == size:
            continue
        size = path.stat().st_size
        new = [row["time [s]"] for row in table(path) if row["time [s]"] not in known]
        known.update(new)
        # Rows that came between two looks share the time.
        costs += [dict(zip(HEAD, (t, (now - last) / len(new), largest), strict=True)) for t in new]
        last = now if new else last
    return costs


def markdown(folder):
    """A line per interval of simulated time: costs are those of its steps, energies and contacts those at its end."""
    costs = {row["time [s]"]: row for row in table(folder / "costs.csv")}
    rows = [row for row in table(folder / "history.csv") if row["time [s]"] in costs]
    yield "| simulated s | steps | clock s | s a step | sweeps a step | loaded contacts | worst overlap / R | kinetic energy J/kg | peak memory GB |"
    yield "|---|---|---|---|---|---|---|---|---|"
    ends = [k for k, row in enumerate(rows) if k and round(row["time [s]"] / INTERVAL, 6).is_integer()]
    ends += [len(rows) - 1] if rows and ends[-1:] != [len(rows) - 1] else []
    for first, last in pairwise([0, *ends]):
        part, end = rows[first + 1 : last + 1], rows[last]
        clock = sum(costs[row["time [s]"]]["clock [s]"] for row in part)
        steps, sweeps = (sum(row[f"solver.{name} [-]"] for row in part) for name in ("internalSteps", "sweeps"))
        overlap = max(row["maxOverlap [-]"] for row in part)
        energy = end["kineticEnergy [J]"] / end["mass [kg]"]
        memory = max(costs[row["time [s]"]]["peak memory [B]"] for row in part)
        yield (
            f"| {end['time [s]']:.2f} | {steps:.0f} | {clock:.0f} | {clock / steps:.2f} | {sweeps / steps:.0f} | {end['contactCount [-]']:.0f} "
            f"| {overlap:.1e} | {energy:.1e} | {memory / 1e9:.2f} |"
        )


def files(folder):
    """What the frames and the last checkpoint take on the disk."""
    for name in ("spheres_*.vtu", "contacts_*.vtu", "checkpoint_*.state"):
        sizes = [path.stat().st_size for path in sorted(folder.glob(name))]
        if sizes:
            yield f"{name}: {len(sizes)} files, the last one {sizes[-1] / 1e6:.1f} MB, the largest {max(sizes) / 1e6:.1f} MB"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--scene", type=Path, default=HERE / "million.toml", help="the scene")
    parser.add_argument("--command", type=Path, default=Path("sphere-dda"), help="the sphere-dda command")
    parser.add_argument("--output", type=Path, required=True, help="folder of the run")
    parser.add_argument("--minutes", type=float, default=20.0, help="time after which the run is interrupted")
    arguments = parser.parse_args()
    folder = arguments.output
    process = subprocess.Popen([arguments.command, "run", arguments.scene, "-o", folder, "--resume"])
    try:
        costs = watch(process, folder, 60.0 * arguments.minutes)
    except KeyboardInterrupt:
        process.wait()
        raise
    path = folder / "costs.csv"
    new = not path.exists()
    with path.open("a", newline="") as file:
        writer = csv.DictWriter(file, HEAD)
        if new:
            writer.writeheader()
        writer.writerows(costs)
    print("\n".join([*markdown(folder), "", *files(folder)]))
    # 130: interrupted, as asked.
    return 0 if process.returncode in (0, 130) else process.returncode


if __name__ == "__main__":
    sys.exit(main())
