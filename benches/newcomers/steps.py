"""Cost of the box of 500 grains against its bound `step`, at every accuracy: printed, and docs/newcomers/steps.md.

A larger bound must not cost more: a row that takes over 10 % more CPU time than the bound before is marked. The cost is
the mean over several packings: where grains collide, the sweeps of a single one scatter by a fifth.
"""

import argparse
import tempfile
from pathlib import Path
from statistics import fmean

from cases import ACCURACIES, FOLDER, ROOT
from measure import Failed, Run, run, written

SCENE = "box"
BOUNDS = (1e-5, 3e-5, 1e-4, 3e-4, 1e-3, 3e-3, 1e-2)
SHORT = {1e-5: 0.05}  # simulated time [s] where that of the scene takes too long
RISE = 1.1
HEAD = """\
<!-- Written by `benches/newcomers/run steps`. -->

# Cost over the bound of the step

The box of 500 grains ([scene](../../tests/newcomers/box.toml)) with `step` as given, at every accuracy; means over
packings of other seeds. *of the bound before*: CPU time over that of the row above. It must not rise by more than a tenth.

| accuracy | step s | simulated s | CPU s | of the bound before | steps | sweeps | unconverged | status |
|---|---|---|---|---|---|---|---|---|"""


def main() -> None:
    """The command."""
    parser = argparse.ArgumentParser(prog="benches/newcomers/run steps", description=__doc__)
    parser.add_argument("--accuracies", type=lambda text: text.split(","), default=[*ACCURACIES], metavar="A,B")
    parser.add_argument("--bounds", type=lambda text: [float(word) for word in text.split(",")], default=[*BOUNDS], metavar="S,S")
    parser.add_argument("--packings", type=int, default=5, metavar="N", help="packings of each row (5)")
    parser.add_argument("--limit", type=float, default=600.0, metavar="S", help="clock time after which a run counts as failed")
    parser.add_argument("--out", type=Path, default=ROOT / "docs" / "newcomers", help="folder of the page (docs/newcomers)")
    arguments = parser.parse_args()
    lines = HEAD.splitlines()
    for accuracy in arguments.accuracies:
        before = None
        for bound in sorted(arguments.bounds):
            cells, cost = _row(accuracy, bound, arguments)
            ratio = "" if before is None or cost is None or bound in SHORT else f"{cost / before:.2f}"
            mark = " **rises**" if ratio and cost > RISE * before else ""
            lines.append(f"| {accuracy} | {bound:g} | {cells[0]} | {cells[1]} | {ratio}{mark} | " + " | ".join(cells[2:]) + " |")
            print(lines[-1], flush=True)
            before = None if bound in SHORT else cost
    (arguments.out / "steps.md").write_text("\n".join(lines) + "\n")


def _row(accuracy: str, bound: float, arguments: argparse.Namespace) -> tuple[list[str], float | None]:
    """Cells of a row, and the CPU time [s]."""
    with tempfile.TemporaryDirectory(prefix="newcomers-") as name:
        folder = Path(name)
        try:
            runs = [_run(accuracy, bound, seed, folder, arguments.limit) for seed in range(arguments.packings)]
        except Failed as error:
            return ["", "", "", "", "", str(error)], None
    cost = fmean(run.cpu for run in runs)
    steps, sweeps = (fmean(run.history[f"solver.{name} [-]"].sum() for run in runs) for name in ("internalSteps", "sweeps"))
    unconverged = sum(run.unconverged for run in runs)
    return [f"{runs[0].simulated:g}", f"{cost:.3g}", f"{steps:.0f}", f"{sweeps:.0f}", str(unconverged), "done"], cost


def _run(accuracy: str, bound: float, seed: int, folder: Path, limit: float) -> Run:
    """The scene with its packing of a seed."""
    source = FOLDER / f"{SCENE}.toml"
    text = source.read_text().replace("radius_jitter = 0.1\n", f"radius_jitter = 0.1\nseed = {seed}\n")
    scene = written(text, source, folder, f'accuracy = "{accuracy}"\nstep = {bound:g}')
    return run(scene, folder / "results", limit, SHORT.get(bound))


if __name__ == "__main__":
    main()
