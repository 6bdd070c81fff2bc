"""The page docs/benchmarks.md and its plots, from a record."""

from collections.abc import Callable, Iterator
from pathlib import Path
from statistics import median
from typing import Any

import goals
import measures
import plan
import plots
from codes import MODULES, missing
from record import FILE, Record, cpu, merged
from runs import INTERVAL, MEAN, Outcome, Row
from scenes import BUILDERS

PLOTS = "benchmarks"
INTRODUCTION = f"""\
This project, [Rapier](https://rapier.rs), [LIGGGHTS](https://www.cfdem.com), [MuJoCo](https://mujoco.org) and
[NVIDIA Newton](https://github.com/newton-physics/newton) (on the processor) on the same scenes, run one after the other by one
command; this page and its plots are its output:

```sh
benches/peers/run            # about an hour; --quick: minutes, --only bed,slope, --up-to 1e5
```

It takes Rapier, MuJoCo and Newton from PyPI into an environment of its own and needs LIGGGHTS (`apt-get install liggghts`).
Positions, radii, walls and materials are those of [scenes](../benches/peers/scenes) in every code, overlaps, openings, heights and energies
are computed from positions and velocities by [measures.py](../benches/peers/measures.py) for every code. *worst, output times* is the largest
overlap of any two spheres or of a sphere and a wall, over the smaller radius, at any of the times {INTERVAL * 1e3:g} ms apart; *worst, every step* is
what this project reports of all its internal steps, which peers do not tell. CPU time is that of all threads or processes, without
reading scenes and writing positions. Force on the floor: mean of the last {MEAN * 1e3:g} ms. Height: mean
of the highest twentieth of the centres. Force residual: worst of any step, over the contact's force scale, of which a sphere's weight
is a part ([theory.md](theory.md)). Peers run with several settings, from fast to accurate; with their defaults Rapier keeps 0.2 r at
rest. *fast*, *standard*, *reference*: this project with `accuracy` alone, as users run it ([accuracy.md](accuracy.md)). *prediction*: how far ahead, in mean diameters, Rapier looks for contacts; 0.02 where nothing is said.

*opening*: widest gap of a contact that carries a force, over the smaller radius, at output times (Rapier: every tenth) or *every
step*; contacts of LIGGGHTS have a force where spheres overlap and no other, Newton does not tell forces of rigid bodies. *load*: the
force of the spheres on the boundary that the section names, by output interval, against the mean of this project's run at *reference*
(*vs own*: against that of the code's own row of most steps): error of its mean, and root mean square of its course about that mean;
what flows has an RMS of its own, which the row *reference* shows. Rapier's loads with friction follow from the change of momentum.
*peak*: largest resident memory of the process, libraries and, of codes in Python, the interpreter included.

Kamino, Newton's other solver of rigid contact, was tried with 4 ms steps and its defaults (Newton 1.8.0, Warp 1.19.0, Python 3.11): a
bed of 30 spheres takes 0.27 s of CPU time a step, one of 100 spheres 3 s. It has no rows.
"""
SECTIONS = (
    (
        "bed",
        "Bed of 1000 spheres",
        "Dropped from a loose lattice into a box, settled for 1.0 s. *ratio*: CPU time over the mean of Rapier's 4 ms rows just before and "
        "after, median. Rows that ran several times show medians, of overlaps and residuals the worst.",
    ),
    (
        "slope",
        "Slope",
        "180 spheres roll and slide down five planes of 50 to 10 degrees for 1.0 s. *ratio*: to Rapier at 2 ms. Rapier and this "
        "project have half-spaces, LIGGGHTS triangles.",
    ),
    (
        "funnel",
        "Funnel",
        "1000 spheres of two sizes run out of a funnel of triangles for 1.0 s. *ratio*: to Rapier at 2 ms. *half out*: when half of the mass "
        "was below the outlet. This project with steps of one length and with chosen ones (*smallest step*).",
    ),
    (
        "rolling",
        "Bed with rolling friction",
        "The bed of 1000 spheres with a coefficient of rolling resistance of 0.05. *ratio*: to this project's plain bed at *standard*, just before and "
        "after. Load: the floor.",
    ),
    (
        "polydisperse",
        "Bed of radii 1 to 10 mm",
        "1000 spheres, as many in every ratio of radii. *ratio*: to this project's bed at *standard*. Load: the floor.",
    ),
    (
        "hopper",
        "Hopper of 10 000 triangles",
        "1500 spheres run out of a cone for 1.0 s. *ratio*: to Rapier at 2 ms. Load: the walls, downwards, in the last 0.5 s.",
    ),
    (
        "drum",
        "Rotating drum",
        "1000 spheres in a drum of 24 flat sides at 2 rad/s, 1.5 s. *ratio*: to Rapier at 4 ms. Load: the couple about the axis in the last 0.5 s.",
    ),
    (
        "blade",
        "Settled bed with a moving blade",
        "1000 spheres settle for 0.5 s, then a plate moves into them at 0.1 m/s. *ratio*: to Rapier at 4 ms. Load: the plate, along its way, in the "
        "last 0.2 s.",
    ),
    (
        "feeder",
        "Feeder by FMI",
        "150 grains on a trough that vibrates at 20 Hz, 1.0 s: as an FMU whose displacement is an input every output interval, "
        "beside the same motion in a scene without FMI. *ratio*: to the latter. Load: the trough, downwards, in the last 0.5 s; between "
        "communication points the FMU's trough moves evenly, not along a sine.",
    ),
    (
        "large",
        "Bed of 10 000 spheres",
        "As above, twice as deep. *ratio*: to Rapier at 4 ms. MuJoCo and Newton have no rows of this size in the plan.",
    ),
)
Column = tuple[str, Callable[[list[Row]], str]]


def write(record: Record, folder: Path) -> None:
    """Writes the page and its plots into `folder`."""
    text = "\n".join(_page(record, folder))
    (folder / "benchmarks.md").write_text(text.rstrip() + "\n")


def _page(record: Record, folder: Path) -> Iterator[str]:
    m = record.machine
    versions = {row.case.code: row.outcome.version for row in record.rows if isinstance(row, Row)}
    yield "<!-- Written by benches/peers/run. -->\n\n# Benchmarks\n"
    yield INTRODUCTION
    yield f"{m['date']}, `{m['command']}`, commit {m['commit']}, {m['rustc']}; " + ", ".join(
        f"{plots.NAMES[code]} {version}" for code, version in sorted(versions.items())
    )
    yield f"on {m['processor']}, {m['speed']}, cache {m['cache']}, {m['cores']} cores, {m['memory']}, {m['system']}."
    yield f"Cores busy with other work at the start: {m['busy']}."
    yield f"All numbers: [record.jsonl]({FILE}).\n\n## Goals\n"
    yield from _goals(record)
    for group, title, words in SECTIONS:
        rows = record.of(group, f"{group}-peers")
        if group == "bed":
            rows += [row for row in record.of("real-time") if row.case.code == "sphere-dda"]
        rows = [row for row in rows if row.case.scene == group or group not in BUILDERS]
        if rows:
            yield f"\n## {title}\n\n{words}\n"
            plots.pareto(rows, title, folder / PLOTS / f"{group}.svg")
            yield f"![CPU time against overlap]({PLOTS}/{group}.svg)\n"
            yield from _rows(rows, record.ratios(group) | record.ratios("real-time"), group, record)
            if group in BUILDERS:
                yield from _absent(group, rows)
    yield from _seeds(record)
    yield from _rest(record, folder)
    yield from _heap(record)
    yield from _registers(record)
    yield from _threads(record)
    yield from _scaling(record, folder)
    yield from _failed(record)


def _table(head: list[str], rows: list[list[str]]) -> Iterator[str]:
    """A table without the columns that are empty."""
    kept = [k for k in range(len(head)) if any(row[k] not in ("", "-") for row in rows)]
    for line in (head, ["---"] * len(head), *rows):
        yield "| " + " | ".join(line[k] for k in kept) + " |"


def _goals(record: Record) -> Iterator[str]:
    words = {True: "yes", False: "**no**", None: ""}
    rows = [[g.what, g.wanted, g.found, words[g.met]] for g in goals.table(record)]
    yield from _table(["goal", "wanted", "measured", "reached"], rows)


def _number(x: float | None, form: str = ".2g") -> str:
    return "" if x is None else f"{x:{form}}"


def _of(name: str, form: str, pick: Callable[[list[float]], float] = median) -> Callable[[list[Row]], str]:
    """A column of `Outcome.name`, or of `Outcome.end.name`."""

    def cell(rows: list[Row]) -> str:
        found = [_attribute(row.outcome, name) for row in rows]
        known = [x for x in found if x is not None]
        return _number(pick(known), form) if known else ""

    return cell


def _attribute(outcome: Outcome, name: str) -> Any:
    part: Any = outcome
    for word in name.split("."):
        part = None if part is None else getattr(part, word)
    return part


def _absent(scene: str, rows: list[Row]) -> Iterator[str]:
    """Which codes have no row, and why."""
    run = {row.case.code for row in rows}
    for code, why in missing(scene).items():
        if not (code == "sphere-dda-fmi" and scene != "feeder"):
            yield f"\n{plots.NAMES[code]}: not run, {why}."
    for code in MODULES:
        if code not in run and code not in missing(scene):
            yield f"\n{plots.NAMES[code]}: runs this scene, but has no row in this record."


def _rows(rows: list[Row], ratios: dict[str, list[float]], group: str, record: Record) -> Iterator[str]:
    known = goals.converged(record, group)

    def load(against: Callable[[list[Row]], list[float]], part: str) -> Callable[[list[Row]], str]:
        def cell(case: list[Row]) -> str:
            errors = [measures.force_error(row.outcome.force, against(case)) for row in case]
            found = [getattr(error, part) for error in errors if error is not None]
            return f"{100 * median(found):.2g} %" if found else ""

        return cell

    def own(case: list[Row]) -> list[float]:
        """The load of the code's row with the most steps."""
        same = [row for row in rows if row.case.code == case[0].case.code and row.outcome.force]
        return max(same, key=lambda row: row.outcome.steps).outcome.force if len(merged(same)) > 1 else []

    def ratio(case: list[Row]) -> str:
        known = ratios.get(case[0].case.key)
        return f"{median(known):.2f}" if known else ""

    def lost(case: list[Row]) -> str:
        most = max(row.outcome.end.lost for row in case)
        return str(most) if most else ""

    columns: list[Column] = [
        ("code", lambda case: plots.NAMES[case[0].case.code]),
        ("setting", lambda case: case[0].case.label),
        ("runs", lambda case: str(len(case)) if len(case) > 1 else ""),
        ("CPU s", lambda case: f"{cpu(case):.3g}"),
        ("ratio", ratio),
        ("worst, output times", _of("watched.worst", ".1e", max)),
        ("worst, every step", _of("worst", ".1e", max)),
        ("at the end", _of("end.overlap", ".1e", max)),
        ("opening", lambda case: _of("watched.opening", ".1e", max)(case) or "-"),
        ("opening, every step", lambda case: _of("opening", ".1e", max)(case) or "-"),
        ("load, mean", load(lambda _: known, "mean")),
        ("load, RMS", load(lambda _: known, "rms")),
        ("vs own, mean", load(own, "mean")),
        ("vs own, RMS", load(own, "rms")),
        ("floor/weight", _of("floor", ".4f")),
        ("height m", _of("end.height", ".5f")),
        ("J/kg", _of("end.energy", ".1e" if rows[0].case.scene == "bed" else ".4g")),
        ("half out s", _of("watched.half_out", ".3f")),
        ("discharged kg", _of("end.discharged", ".2f")),
        ("steps", _of("steps", ".0f")),
        ("sweeps", _of("sweeps", ".0f")),
        ("factorizations", _of("factorizations", ".0f")),
        ("force residual", _of("force_residual", ".1e", max)),
        ("peak MB", lambda case: _number(max(row.outcome.peak or 0.0 for row in case) / 1e6 or None, ".0f")),
        ("lost", lost),
    ]
    codes = list(plots.NAMES)
    cases = sorted(merged(rows), key=lambda case: (codes.index(case[0].case.code), "prediction" in case[0].case.settings, cpu(case)))
    yield from _table([name for name, _ in columns], [[cell(case) for _, cell in columns] for case in cases])


def _seeds(record: Record) -> Iterator[str]:
    groups = goals.seeds(record)
    if not groups:
        return
    yield "\n## Bed of 1000 spheres, other seeds\n\nMedians over beds that differ by the seed of positions and radii.\n"
    rows = []
    for group in groups:
        floor, height, energy = goals.middle(group)
        case = group[0].case
        rows.append([plots.NAMES[case.code], case.label, str(len(group)), f"{floor:.4f}", f"{height:.5f}", f"{energy:.1e}"])
    yield from _table(["code", "setting", "seeds", "floor/weight", "height m", "J/kg"], rows)


def _rest(record: Record, folder: Path) -> Iterator[str]:
    for row in record.of("rest")[:1]:
        moving, settled = goals.resting(row.outcome)
        plots.rest(row, folder / PLOTS / "rest.svg")
        yield f"\n## Bed that comes to rest\n\n1000 spheres, {row.case.label}, {row.case.duration:g} s: {INTERVAL * 1e3:g} ms cost {moving * 1e3:.2g} ms in"
        yield f"the most expensive tenth of the run and {settled * 1e3:.2g} ms in the last tenth.\n"
        yield f"![Time per output interval]({PLOTS}/rest.svg)"


def _heap(record: Record) -> Iterator[str]:
    found = goals.beside_blade(record)
    if found:
        few, many = plan.HEAPS
        setting = record.of("heap")[0].case.label
        yield f"\n## What has settled beside a moving blade\n\nThe trough of the blade with {few} and, longer, with {many} spheres, {setting}: the"
        yield f"{many - few} more cost {found[0] * 1e3:.2g} ms per {INTERVAL * 1e3:g} ms while they settle and {found[1] * 1e3:.2g} ms at the end, while the blade moves."


def _registers(record: Record) -> Iterator[str]:
    rows = record.of("registers")
    if not rows:
        return
    yield "\n## Vector registers\n\nBeds with AVX2 alone beside the same with the widest registers of the processor, in turns; both take the same steps.\n"
    ratios = record.ratios("registers")
    lines = []
    for case in merged([row for row in rows if "registers" in row.case.settings]):
        first = case[0]
        plain = {name: value for name, value in first.case.settings.items() if name != "registers"}
        wide = [row for row in rows if row.case.settings == plain and row.case.n == first.case.n]
        ratio = ratios.get(first.case.key)
        steps, sweeps = ({getattr(row.outcome, name) for row in (*case, *wide)} for name in ("steps", "sweeps"))
        counts = [str(found.pop()) if len(found) == 1 else "differ" for found in (steps, sweeps)]
        lines.append([str(first.case.n), first.case.label, *counts, f"{cpu(wide):.3g}", f"{cpu(case):.3g}", f"{median(ratio):.2f}" if ratio else ""])
    yield from _table(["spheres", "setting", "steps", "sweeps", "CPU s, widest", "CPU s, AVX2", "ratio"], lines)


def _threads(record: Record) -> Iterator[str]:
    rows = record.of("threads")
    if not rows:
        return
    yield "\n## Threads\n\nLIGGGHTS runs one process a thread.\n"
    single = {(r.case.code, r.case.n): r.outcome.wall_s for r in rows if r.case.threads == 1}
    lines = []
    for row in rows:
        case, outcome = row.case, row.outcome
        alone = single.get((case.code, case.n))
        lines.append(
            [
                plots.NAMES[case.code],
                case.label,
                str(case.n),
                f"{case.duration:g}",
                str(case.threads),
                f"{outcome.wall_s:.3g}",
                f"{outcome.cpu_s:.3g}",
                f"{alone / outcome.wall_s:.2f}" if alone else "",
            ]
        )
    yield from _table(["code", "setting", "spheres", "simulated s", "threads", "clock s", "CPU s", "times as fast"], lines)


def _scaling(record: Record, folder: Path) -> Iterator[str]:
    rows = record.of("scaling")
    if not rows:
        return
    plots.scaling(record, folder / PLOTS / "scaling.svg")
    own = [row for row in rows if row.case.code == "sphere-dda"]
    until = min((row.case.duration for row in own), default=0.0)
    yield "\n## Size\n\nBeds of the same lattice, ever wider and deeper. Large ones are run for their first part only; costs per step of this"
    yield f"project are those of the first {until:g} s of every size. *per contact and sweep*: CPU time of everything over loaded contacts times"
    yield "sweeps. Memory: peak of the process less what it held before the scene (LIGGGHTS: its own account).\n"
    yield f"![Cost and memory against size]({PLOTS}/scaling.svg)\n"
    lines = []
    for row in rows:
        case, outcome = row.case, row.outcome
        costs = goals.scaled(outcome, until) if outcome.course else None
        per_step = None if outcome.sweeps is None else outcome.sweeps / outcome.steps
        lines.append(
            [
                plots.NAMES[case.code],
                str(case.n),
                f"{case.duration:g}",
                f"{outcome.cpu_s:.3g}",
                f"{outcome.cpu_s / case.n / case.duration * 1e3:.3g}",
                str(outcome.steps),
                _number(per_step, ".1f"),
                _number(outcome.contacts and outcome.contacts / case.n, ".2f"),
                f"{costs[0] * 1e6:.3g}" if costs else "",
                f"{costs[1] * 1e9:.3g}" if costs else "",
                _number(outcome.worst, ".1e"),
                _number(outcome.memory and outcome.memory / 1e3, ".3g"),
            ]
        )
    head = ["code", "spheres", "simulated s", "CPU s", "CPU ms per sphere and simulated s", "steps", "sweeps a step", "contacts a sphere"]
    head += ["µs per sphere and step", "ns per contact and sweep", "worst overlap", "kB per sphere"]
    yield from _table(head, lines)


def _failed(record: Record) -> Iterator[str]:
    rows = record.failed()
    if rows:
        yield "\n## Rows that failed\n"
        head = ["code", "scene", "spheres", "setting", "threads", "why"]
        lines = [[plots.NAMES[r.case.code], r.case.scene, str(r.case.n), r.case.label, str(r.case.threads), r.error] for r in rows]
        yield from _table(head, lines)
