"""The hopper of 1500 grains from CAD as an FMU, its gate opening, with the sweeps of an internal step bounded.

One FMU, settled at `standard`; its parameters set the tolerances of each accuracy and the bound. Prints, and writes
into docs/newcomers/realtime.md, the CPU time over the simulated time, the longest communication step over its length,
and the error of the gate's force against `reference`.
"""

import argparse
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from cases import CASES, REFERENCE, ROOT
from measure import Slave, apart, at_accuracy, export

SCENE = "hopper"
GATE = "boundary.gate.averageForce[3]"
OVERLAP = "maxOverlap"
FORCE = "solver.forceResidual"
STEP = 0.005  # communication step [s]
AGAIN = "reference, half the gap"
BOUNDS = (5, 10, 20, 40, 80, 0)  # 0: as many as it takes
TOLERANCES = {"fast": (5e-4, 0.1), "standard": (1e-4, 0.1), REFERENCE: (1e-6, 1e-2), AGAIN: (5e-7, 1e-2)}  # gap, force
HEAD = """\
<!-- Written by `benches/newcomers/run realtime`. -->

# Real time

1500 grains in a hopper from CAD whose gate opens between 0.1 and 0.6 s, as one FMU, settled at `standard`, on one
core. Its parameters `solver.tolerance.*` are those of the accuracy, `solver.maxSweeps` bounds the sweeps of an
internal step. *of real time*: CPU time over simulated time. *longest*: longest `fmi2DoStep` over the communication
step of 5 ms. *gate force*: root mean square of the difference of running means (window: 5 % of the run) from
`reference`, over that of the reference. *outflow*: difference of the mass that has left. *force residual*: the median
over the steps of the worst contact's. A flow of grains is chaotic: the last row, whose gaps are held to half as much,
shows how far two exact runs part.

| accuracy | sweeps | of real time | longest | gate force | outflow | worst overlap | force residual |
|---|---|---|---|---|---|---|---|"""


@dataclass(frozen=True)
class Run:
    """Gate force [N], overlap [-], force residual [-] and CPU time [s] of every communication step; mass out [kg]."""

    gate: np.ndarray
    overlap: np.ndarray
    residual: np.ndarray
    cpu: np.ndarray
    mass: float


def main() -> None:
    """The command."""
    parser = argparse.ArgumentParser(prog="benches/newcomers/run realtime", description=__doc__)
    parser.add_argument("--accuracies", type=lambda text: text.split(","), default=["fast", "standard"], metavar="A,B")
    parser.add_argument("--duration", type=float, default=2.0, metavar="S", help="simulated time (2)")
    parser.add_argument("--limit", type=float, default=600.0, metavar="S", help="clock time of an export")
    parser.add_argument("--out", type=Path, default=ROOT / "docs" / "newcomers", help="folder of the page (docs/newcomers)")
    arguments = parser.parse_args()
    lines = HEAD.splitlines()
    with tempfile.TemporaryDirectory(prefix="newcomers-") as folder:
        fmu = Path(folder) / f"{SCENE}.fmu"
        export(at_accuracy(SCENE, "standard", Path(folder)), fmu, True, arguments.limit)
        reference = ran(fmu, REFERENCE, 0, arguments.duration)
        for accuracy, bound in [(accuracy, bound) for accuracy in arguments.accuracies for bound in BOUNDS]:
            lines.append(_line(accuracy, bound, ran(fmu, accuracy, bound, arguments.duration), reference))
            print(lines[-1], flush=True)
        for accuracy, run in ((REFERENCE, reference), (AGAIN, ran(fmu, AGAIN, 0, arguments.duration))):
            lines.append(_line(accuracy, 0, run, reference))
            print(lines[-1], flush=True)
    arguments.out.mkdir(parents=True, exist_ok=True)
    (arguments.out / "realtime.md").write_text("\n".join(lines) + "\n")


def ran(fmu: Path, accuracy: str, bound: int, duration: float) -> Run:
    """Drives the FMU with the tolerances of an accuracy and `bound` sweeps a step, 0 for any number."""
    gap, force = TOLERANCES[accuracy]
    reals = {"solver.tolerance.gap": gap, "solver.tolerance.slip": 3.5 * gap, "solver.tolerance.force": force}
    rows = []
    with Slave(fmu, stop=1e6, reals=reals, integers={"solver.maxSweeps": bound}) as slave:
        for k in range(round(duration / STEP)):
            for name, value in CASES[SCENE].inputs((k + 1) * STEP).items():
                slave.set(name, value)
            begun = time.process_time()
            slave.step(k * STEP, STEP)
            cpu = time.process_time() - begun
            rows.append([*slave.get(GATE, OVERLAP, FORCE), cpu])
        (mass,) = slave.get("sensor.outflow.mass")
    table = np.array(rows)
    return Run(*table.T, mass)


def _line(accuracy: str, bound: int, run: Run, reference: Run) -> str:
    error = apart(run.gate, reference.gate)
    flow = abs(run.mass / reference.mass - 1.0)
    real, longest = run.cpu.mean() / STEP, run.cpu.max() / STEP
    cells = [accuracy, bound or "-", f"{real:.2g}", f"{longest:.2g}", f"{error:.1%}", f"{flow:.1%}"]
    return "| " + " | ".join(map(str, [*cells, f"{run.overlap.max():.1e}", f"{np.median(run.residual):.1e}"])) + " |"


if __name__ == "__main__":
    main()
