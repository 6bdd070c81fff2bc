"""Plots of the page, SVG, the same from the same record."""

from pathlib import Path
from statistics import median
from typing import Any

import matplotlib
import matplotlib.pyplot as plt
from matplotlib.axis import Axis
from matplotlib.figure import Figure
from matplotlib.ticker import LogLocator, NullFormatter

from goals import scaled
from record import Record, cpu, merged
from runs import INTERVAL, Case, Row

matplotlib.use("svg")
matplotlib.rcParams.update({"svg.hashsalt": "peers", "svg.fonttype": "none", "font.size": 9, "axes.grid": True, "grid.alpha": 0.3})

NAMES = {
    "sphere-dda": "this project",
    "sphere-dda-fmi": "this project by FMI",
    "rapier": "Rapier",
    "liggghts": "LIGGGHTS",
    "mujoco": "MuJoCo",
    "newton": "Newton",
}
STYLES = {"sphere-dda": ("C0", "o"), "rapier": ("C1", "s"), "liggghts": ("C2", "^"), "mujoco": ("C3", "D"), "newton": ("C4", "v")}


def _save(figure: Figure, path: Path) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    figure.savefig(path, metadata={"Date": None})
    plt.close(figure)


def _plain(axis: Axis) -> None:
    """Ticks at 1, 2 and 5 with plain numbers, for logarithmic axes of few decades."""
    axis.set_major_locator(LogLocator(subs=(1, 2, 5)))
    axis.set_major_formatter("{x:g}")
    axis.set_minor_formatter(NullFormatter())


def pareto(rows: list[Row], title: str, path: Path) -> None:
    """CPU time against worst overlap and against overlap at the end, one line a code."""
    figure, axes = plt.subplots(1, 2, figsize=(9, 4), sharey=True, layout="constrained")
    heads = ("worst over all output times (this project: every step)", "at the end")
    for axis, head, of in zip(axes, heads, (lambda row: row.outcome.largest or 0.0, lambda row: row.outcome.end.overlap), strict=True):
        drawn = False
        small: dict[str, Any] = {"textcoords": "offset points", "fontsize": 7}
        for code, ahead in (*((code, False) for code in STYLES), ("rapier", True)):
            colour, marker = STYLES[code]
            cases = [case for case in merged(rows) if _series(case[0].case) == (code, ahead)]
            if not cases:
                continue
            name = f"{NAMES[code]}, contacts predicted" if ahead else NAMES[code]
            style: dict[str, Any] = {"marker": marker, "color": colour, "label": name, "fillstyle": "none" if ahead else "full"}
            points = [(cpu(case), median(of(row) for row in case), case[0].case.label) for case in cases]
            points = sorted(p for p in points if p[1] > 0)
            drawn = drawn or bool(points)
            axis.plot([p[0] for p in points], [p[1] for p in points], "--" if ahead else "-", **style)
            for x, y, label in points:
                axis.annotate(label.split(",")[0].removeprefix("E = "), (x, y), xytext=(4, -9 if ahead else 4), color=colour, **small)
        # Where no code has any overlap there is nothing to draw on a logarithmic axis.
        axis.set(xscale="log" if drawn else "linear", yscale="log" if drawn else "linear", xlabel="CPU time [s]", title=head)
        axis.title.set_fontsize(9)
        axis.margins(x=0.15)
        if drawn:
            _plain(axis.xaxis)
    axes[0].set_ylabel("largest overlap / radius")
    axes[1].legend()
    figure.suptitle(title)
    _save(figure, path)


def _series(case: Case) -> tuple[str, bool]:
    """Cases of one line of a plot are equal in this."""
    return case.code, "prediction" in case.settings


def scaling(record: Record, path: Path) -> None:
    """Cost per sphere and simulated second, cost per loaded contact and sweep, memory per sphere, against size."""
    rows = [case[0] for case in merged(record.of("scaling"))]
    figure, axes = plt.subplots(1, 3, figsize=(11, 3.6), layout="constrained")
    for code, (colour, marker) in STYLES.items():
        own = [row for row in rows if row.case.code == code]
        if not own:
            continue
        style: dict[str, Any] = {"marker": marker, "color": colour, "label": NAMES[code]}
        sizes = [row.case.n for row in own]
        axes[0].plot(sizes, [1e3 * row.outcome.cpu_s / row.case.n / row.case.duration for row in own], **style)
        memory = [(row.case.n, row.outcome.memory / 1e3) for row in own if row.outcome.memory is not None]
        axes[2].plot([n for n, _ in memory], [kilobytes for _, kilobytes in memory], **style)
        if code == "sphere-dda":
            until = min(row.case.duration for row in own)
            axes[1].plot(sizes, [1e9 * scaled(row.outcome, until)[1] for row in own], **style)
    labels = ("CPU time per sphere and simulated second [ms]", "CPU time per loaded contact and sweep [ns]", "memory per sphere [kB]")
    for axis, label in zip(axes, labels, strict=True):
        axis.set(xscale="log", yscale="log", xlabel="spheres", ylabel=label)
        _plain(axis.yaxis)
    axes[0].legend()
    _save(figure, path)


def rest(row: Row, path: Path) -> None:
    """Cost of every output interval of a run."""
    course = row.outcome.course
    figure, axis = plt.subplots(figsize=(6, 3), layout="constrained")
    axis.plot(course["time"], [1e3 * clock for clock in course["wall_s"]], color="C0", linewidth=1)
    axis.set(yscale="log", xlabel="simulated time [s]", ylabel=f"time per {1e3 * INTERVAL:g} ms [ms]")
    _save(figure, path)
