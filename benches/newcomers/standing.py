"""Packings at rest stay at rest: five are exported with --until-rest and stand for 10 s.

Writes into docs/newcomers/standing.md, at every accuracy, the largest deviation of the force on each boundary from its
mean, over the mean, the kinetic energy in the first and in the last second, and the CPU time; plots force and energy
over time into docs/newcomers/standing-ACCURACY.svg.
"""

import argparse
import re
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path

import matplotlib

matplotlib.use("svg")
import matplotlib.pyplot as plt
import numpy as np

from cases import ACCURACIES, FOLDER, ROOT
from measure import Failed, Slave, export, written

HEAD = """\
<!-- Written by `benches/newcomers/run standing`. -->

# Packings at rest

Packings that settled before their export stand for 10 s as FMUs: the largest deviation of the force on
each boundary from its mean over that mean, the kinetic energy, and the CPU time of the 10 s.

| packing | accuracy | boundary | mean force N | largest deviation | kinetic energy J, first s | last s | CPU s |
|---|---|---|---|---|---|---|---|"""
EXAMPLES = ROOT / "examples"
STEP = 0.01  # communication step [s]
THIN = 10  # of the communication steps, one is plotted


@dataclass(frozen=True)
class Packing:
    """A scene, the boundaries whose force is watched, the text that is left out."""

    source: Path
    boundaries: tuple[str, ...]
    without: tuple[str, ...] = ()


# Keys that choose step and tolerances in the examples; here `accuracy` does.
NUMERICS = (r"^step = .*\n", r"^communication_step = .*\n", r"^tolerance = .*\n", r"^fixed_step = .*\n", r"^strict = .*\n")
MOTION = (r"^motion = .*\n",)
PACKINGS = {
    "hopper": Packing(EXAMPLES / "hopper" / "hopper.toml", ("bin", "gate"), (NUMERICS[1],)),
    "bed": Packing(FOLDER / "box.toml", ("box",)),
    "heap": Packing(FOLDER / "terrain.toml", ("ground",), (NUMERICS[1],)),
    "drum": Packing(FOLDER / "drum.toml", ("drum",), (NUMERICS[1], *MOTION)),
    "triaxial": Packing(EXAMPLES / "triaxial" / "triaxial.toml", ("bottom", "top", "west", "east", "south", "north"), (*NUMERICS, *MOTION)),
}


def main() -> None:
    """The command."""
    parser = argparse.ArgumentParser(prog="benches/newcomers/run standing", description=__doc__)
    parser.add_argument("--packings", type=lambda text: text.split(","), default=[*PACKINGS], metavar="A,B")
    parser.add_argument("--accuracies", type=lambda text: text.split(","), default=[*ACCURACIES], metavar="A,B")
    parser.add_argument("--duration", type=float, default=10.0, metavar="S", help="time that the packings stand (10)")
    parser.add_argument("--limit", type=float, default=1800.0, metavar="S", help="clock time of an export")
    parser.add_argument("--out", type=Path, default=ROOT / "docs" / "newcomers", help="folder of the plots (docs/newcomers)")
    arguments = parser.parse_args()
    lines = HEAD.splitlines()
    for accuracy in arguments.accuracies:
        stands = {}
        for name in arguments.packings:
            try:
                stands[name] = stood(PACKINGS[name], accuracy, arguments.duration, arguments.limit)
            except Failed as error:
                lines.append(f"| {name} | {accuracy} | failed: {error} | | | | | |")
                continue
            lines += _lines(name, accuracy, stands[name])
            print(lines[-1], flush=True)
        if stands:
            _plot(stands, arguments.out / f"standing-{accuracy}.svg")
    plots = [f"![At {accuracy}](standing-{accuracy}.svg)" for accuracy in arguments.accuracies]
    (arguments.out / "standing.md").write_text("\n\n".join(["\n".join(lines), *plots]) + "\n")


@dataclass(frozen=True)
class Stand:
    """Boundary -> force [N] after every communication step, (steps, 3); kinetic energy [J]; CPU time of the steps [s]."""

    forces: dict[str, np.ndarray]
    energy: np.ndarray
    cpu: float


def stood(packing: Packing, accuracy: str, duration: float, limit: float) -> Stand:
    """Lets a packing stand for a `duration` [s] as an FMU."""
    text = packing.source.read_text()
    for pattern in packing.without:
        text, count = re.subn(pattern, "", text, flags=re.MULTILINE)
        if count != 1:
            raise ValueError(f"{packing.source}: {pattern!r} is there {count} times")
    with tempfile.TemporaryDirectory(prefix="newcomers-") as name:
        folder = Path(name)
        scene = written(text, packing.source, folder, f'accuracy = "{accuracy}"\ncommunication_step = {STEP}')
        fmu = folder / "standing.fmu"
        export(scene, fmu, True, limit)
        rows = []
        with Slave(fmu, stop=1e6) as slave:
            wanted = [f"boundary.{boundary}.averageForce[{k}]" for boundary in packing.boundaries for k in (1, 2, 3)]
            begun = time.process_time()
            for k in range(round(duration / STEP)):
                slave.step(k * STEP, STEP)
                rows.append(slave.get("kineticEnergy", *wanted))
            cpu = time.process_time() - begun
    table = np.array(rows)
    forces = table[:, 1:].reshape(len(table), -1, 3)
    return Stand({boundary: forces[:, k] for k, boundary in enumerate(packing.boundaries)}, table[:, 0], cpu)


def _lines(name: str, accuracy: str, stand: Stand) -> list[str]:
    second = round(1.0 / STEP)
    first, last = stand.energy[:second].max(), stand.energy[-second:].max()
    lines = []
    for boundary, force in stand.forces.items():
        mean = np.linalg.norm(force.mean(axis=0))
        deviation = np.linalg.norm(force - force.mean(axis=0), axis=1).max() / mean
        lines.append(f"| {name} | {accuracy} | {boundary} | {mean:.4g} | {deviation:.2%} | {first:.1e} | {last:.1e} | {stand.cpu:.2g} |")
    return lines


def _plot(stands: dict[str, Stand], path: Path) -> None:
    figure, axes = plt.subplots(len(stands), 2, figsize=(9, 2.2 * len(stands)), squeeze=False, sharex=True, layout="constrained")
    for row, (name, stand) in zip(axes, stands.items(), strict=True):
        energy = stand.energy[::THIN]
        times = STEP * np.arange(1, len(stand.energy) + 1, THIN)
        for boundary, force in stand.forces.items():
            row[0].plot(times, np.linalg.norm(force[::THIN], axis=1), linewidth=1, label=boundary)
        row[0].set(title=name, ylabel="force [N]")
        row[0].legend(fontsize=7)
        row[1].plot(times, np.maximum(energy, 1e-30), linewidth=1, color="C3")
        row[1].set(title=name, ylabel="kinetic energy [J]", yscale="log")
    for axis in axes[-1]:
        axis.set_xlabel("time [s]")
    for axis in axes[:, 0]:
        axis.set_ylim(bottom=0.0)
    path.parent.mkdir(parents=True, exist_ok=True)
    figure.savefig(path, metadata={"Date": None})
    plt.close(figure)


if __name__ == "__main__":
    main()
