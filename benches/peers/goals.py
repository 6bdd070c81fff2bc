"""What this project has to reach beside its peers, and whether a record shows it."""

from collections.abc import Iterator
from dataclasses import dataclass
from statistics import median

import measures
import plan
from record import Record, cpu, merged
from runs import Case, Outcome, Row, tidy

# Ratio to the CPU time of Rapier's fastest row that a tolerance on the bed may take; contacts open ten times as far.
BED = {"1e-4": 0.12, "1e-5": 0.2, "1e-6": 0.5}
OPENING = 10.0
LARGE = 0.15  # the same for 10 000 spheres
AVX2 = 1.3  # times that without wider registers
FORCE = 0.1  # worst force residual [-]
FLOOR = (0.99, 1.01)  # force over weight [-]
HEIGHT = (0.0499, 0.0512)  # [m]
ENERGY = 1e-5  # at rest [J/kg]
SLOPE = (7.22, 7.24)  # [J/kg]
DISCHARGED = (6.3, 7.1)  # [kg]
MEMORY = 1000.0  # per sphere [B]
MEASURED = (10_000, 100_000)  # spheres at which memory is judged
THREADED = {2000: 1.5, 100_000: 1.8}  # times as fast on two threads, by spheres
STEADY = 0.01  # root mean square of the floor's force about the converged mean, over that [-]
ROLLING = 1.6  # CPU time over that of the same bed without
SIZES = 1.5  # CPU time per contact of radii 1 to 10 over that of the bed
REAL_TIME = 1.0  # CPU time over simulated time
SWEEPS = 1.5  # growth from 1000 to 100 000 spheres
SETTLED = 0.05  # cost of what has settled beside a blade over what it was while it moved
MOVING_PART, SETTLED_PART = (0.05, 0.3), (1.2, 1.5)  # when it moves, when it has settled [s]
FLAT = 1.5
REST = 50.0


@dataclass(frozen=True)
class Goal:
    """A line of the table; `met` is `None` where nothing was measured."""

    what: str
    wanted: str
    found: str
    met: bool | None

    @staticmethod
    def most(what: str, limit: float, found: float | None, unit: str = "") -> "Goal":
        """At most `limit`."""
        if found is None:
            return Goal(what, f"≤ {tidy(limit)}{unit}", "not measured", None)
        return Goal(what, f"≤ {tidy(limit)}{unit}", f"{tidy(found)}{unit}", found <= limit)

    @staticmethod
    def least(what: str, limit: float, found: float | None, unit: str = "") -> "Goal":
        """At least `limit`."""
        if found is None:
            return Goal(what, f"≥ {tidy(limit)}{unit}", "not measured", None)
        return Goal(what, f"≥ {tidy(limit)}{unit}", f"{tidy(found)}{unit}", found >= limit)

    @staticmethod
    def within(what: str, limits: tuple[float, float], found: float | None, unit: str = "") -> "Goal":
        """Between two limits."""
        wanted = f"{limits[0]:g} to {limits[1]:g}{unit}"
        if found is None:
            return Goal(what, wanted, "not measured", None)
        return Goal(what, wanted, f"{found:.4g}{unit}", limits[0] <= found <= limits[1])


def table(record: Record) -> list[Goal]:
    """All goals in the order of the page."""
    parts = (_bed, _physics, _bounded, _large, _registers, _steady, _others, _machines, _size, _rest, _heap)
    return [goal for part in parts for goal in part(record)]


def worst(rows: list[Row]) -> float | None:
    """Worst overlap over radius of any run at every internal step."""
    found = [row.outcome.worst for row in rows if row.outcome.worst is not None]
    return max(found, default=None)


def widest(rows: list[Row]) -> float | None:
    """Widest opening of a loaded contact over radius: of every internal step if told, else of the output times."""
    found = [row.outcome.widest for row in rows]
    return max((x for x in found if x is not None), default=None)


def residual(rows: list[Row]) -> float | None:
    """Worst force residual of any run."""
    found = [row.outcome.force_residual for row in rows if row.outcome.force_residual is not None]
    return max(found, default=None)


def _own(record: Record, group: str, settings: dict[str, float]) -> list[Row]:
    return [r for r in record.of(group) if r.case.code == "sphere-dda" and r.case.settings == settings]


def _ratio(record: Record, group: str, rows: list[Row]) -> float | None:
    ratios = record.ratios(group)
    found = [ratio for key in {row.case.key for row in rows} for ratio in ratios.get(key, [])]
    return median(found) if found else None


def _bed(record: Record) -> Iterator[Goal]:
    for name, limit in BED.items():
        rows = _own(record, "bed", plan.OURS[name])
        yield Goal.most(f"bed, tolerance {name}: worst overlap at every step", float(name), worst(rows), " r")
        yield Goal.most(f"bed, tolerance {name}: widest opening of a loaded contact", OPENING * float(name), widest(rows), " r")
        yield Goal.most(f"bed, tolerance {name}: CPU time over Rapier's at 4 ms", limit, _ratio(record, "bed", rows))
        yield Goal.most(f"bed, tolerance {name}: worst force residual", FORCE, residual(rows))
    finest = _own(record, "bed", plan.OURS["1e-6"])
    yield Goal.most("beyond that, 1e-6: CPU time over Rapier's at 4 ms", 1.0, _ratio(record, "bed", finest))
    middle = _own(record, "bed", plan.OURS["1e-5"])
    soft = [r for r in record.of("bed-peers") if r.case.settings == plan.LIGGGHTS["soft"]]
    ratio = cpu(middle) / cpu(soft) if middle and soft else None
    yield Goal.most("beyond that, 1e-5: CPU time over that of the softest LIGGGHTS", 1.0, ratio)


def _bounded(record: Record) -> Iterator[Goal]:
    rows = _own(record, "real-time", plan.BOUNDED)
    overlap = max((r.outcome.end.overlap for r in rows), default=None)
    name = f"bed, at most {plan.BOUNDED['sweeps']} sweeps a step"
    yield Goal.most(f"{name}: overlap at the end", 1.2e-4, overlap, " r")
    yield Goal.most(f"{name}: CPU time over Rapier's at 4 ms", 1 / 3, _ratio(record, "real-time", rows))


def seeds(record: Record) -> list[list[Row]]:
    """Rows of beds of 1000 spheres by code and settings, one per seed."""
    rows = [r for r in record.of("bed", "bed-peers", "seeds") if r.case.duration == 1.0]
    found: dict[str, dict[int, Row]] = {}
    for row in rows:
        found.setdefault(f"{row.case.code} {row.case.label}", {})[row.case.seed] = row
    return [list(by_seed.values()) for by_seed in found.values() if len(by_seed) > 1]


def middle(rows: list[Row]) -> tuple[float, float, float]:
    """Medians of force on the floor over weight [-], height [m] and kinetic energy [J/kg]."""
    outcomes = [row.outcome for row in rows]
    return (
        median(o.floor for o in outcomes if o.floor is not None),
        median(o.end.height for o in outcomes if o.end.height is not None),
        median(o.end.energy for o in outcomes),
    )


def _physics(record: Record) -> Iterator[Goal]:
    found = {rows[0].case.label: rows for rows in seeds(record) if rows[0].case.code == "sphere-dda"}
    for gap, settings in plan.OURS.items():
        rows = found.get(Case("sphere-dda", "bed", 1000, settings).label, [])
        floor, height, energy = middle(rows) if rows else (None, None, None)
        name = f"bed, tolerance {gap}, median of {len(rows) or 1 + len(plan.SEEDS)} seeds"
        yield Goal.within(f"{name}: floor force over weight", FLOOR, floor)
        yield Goal.within(f"{name}: height", HEIGHT, height, " m")
        yield Goal.most(f"{name}: kinetic energy", ENERGY, energy, " J/kg")


def _large(record: Record) -> Iterator[Goal]:
    rows = _own(record, "large", plan.OURS["1e-4"])
    yield Goal.most("bed of 10 000: worst overlap at every step", 1e-4, worst(rows), " r")
    yield Goal.most("bed of 10 000: CPU time over Rapier's at 4 ms", LARGE, _ratio(record, "large", rows))


def _others(record: Record) -> Iterator[Goal]:
    rows = [r for r in record.of("slope") if r.case.settings.get("tolerance") == 1e-6]
    yield Goal.most("slope: worst overlap at every step", 1e-6, worst(rows), " r")
    energy = median(r.outcome.end.energy for r in rows) if rows else None
    yield Goal.within("slope: kinetic energy", SLOPE, energy, " J/kg")
    yield Goal.most("slope: CPU time over Rapier's at 2 ms", 0.5, _ratio(record, "slope", rows))
    for name, settings in (("funnel", plan.FIXED["1e-4"]), ("funnel, chosen steps", plan.OURS["1e-4"])):
        rows = _own(record, "funnel", settings)
        yield Goal.most(f"{name}: worst overlap at every step", 1e-4, worst(rows), " r")
        found = [r.outcome.end.discharged for r in rows if r.outcome.end.discharged is not None]
        yield Goal.within(f"{name}: discharged", DISCHARGED, median(found) if found else None, " kg")
        yield Goal.most(f"{name}: CPU time over Rapier's at 2 ms", 1.0, _ratio(record, "funnel", rows))


def _size(record: Record) -> Iterator[Goal]:
    own = [rows[0] for rows in merged(record.of("scaling")) if rows[0].case.code == "sphere-dda"]
    big = [row for row in own if row.case.n >= 1000]
    flat, per_update = None, None
    if len(big) > 1:
        until = min(row.case.duration for row in big)
        costs = [scaled(row.outcome, until) for row in big]
        flat, per_update = (max(c) / min(c) for c in zip(*costs, strict=True))
    sizes = f"{big[0].case.n:,} to {big[-1].case.n:,}".replace(",", " ") if big else "1000 on"
    yield Goal.most(f"beds of {sizes}: cost per sphere and step, largest over smallest", FLAT, flat)
    yield Goal.most(f"beds of {sizes}: cost per loaded contact and sweep, largest over smallest", FLAT, per_update)
    until = min((row.case.duration for row in big), default=0.0)
    swept = {row.case.n: _until(row.outcome, "sweeps", until) for row in big if row.outcome.course}
    growth = swept[100_000] / swept[1000] if {1000, 100_000} <= set(swept) else None
    yield Goal.most("beds of 1 000 and 100 000: sweeps of the same time, growth", SWEEPS, growth)
    for n in MEASURED:
        memory = [r.outcome.memory for r in own if r.case.n == n and r.outcome.memory is not None]
        yield Goal.most(f"memory per sphere, contacts included, bed of {_grouped(n)}", MEMORY, max(memory, default=None), " B")
    for n, times in THREADED.items():
        clock = {row.case.threads: row.outcome.wall_s for row in record.of("threads") if row.case.n == n}
        faster = clock[1] / clock[2] if {1, 2} <= set(clock) else None
        yield Goal.least(f"2 threads at {_grouped(n)} spheres: times as fast", times, faster)


def scaled(outcome: Outcome, until: float) -> tuple[float, float]:
    """CPU time per sphere and step, and per loaded contact and sweep [s], up to time `until` [s] of a run."""
    course = outcome.course
    part = [k for k, time in enumerate(course["time"]) if time <= until * (1 + 1e-9)]
    cpu_s, steps = (sum(course[name][k] for k in part) for name in ("cpu_s", "steps"))
    updates = sum(course["sweeps"][k] * course["contacts"][k] for k in part)
    return cpu_s / (outcome.spheres * steps), cpu_s / max(updates, 1)


def _grouped(n: int) -> str:
    return f"{n:,}".replace(",", " ")


def _until(outcome: Outcome, name: str, until: float) -> float:
    """Sum of a part of the course up to a time [s]."""
    return sum(x for x, time in zip(outcome.course[name], outcome.course["time"], strict=True) if time <= until * (1 + 1e-9))


def converged(record: Record, group: str) -> list[float]:
    """The load of this project's run of a group at its accuracy `reference`."""
    rows = [row for row in record.of(group, f"{group}-peers") if row.case.code == "sphere-dda" and row.case.settings == plan.USERS["reference"]]
    return rows[0].outcome.force if rows else []


def _registers(record: Record) -> Iterator[Goal]:
    for name, n, limit in (*((key, 1000, limit) for key, limit in BED.items()), ("1e-4", 10_000, LARGE)):
        settings = {**plan.OURS[name], "registers": "avx2"}
        rows = [row for row in _own(record, "registers", settings) if row.case.n == n]
        slower = _ratio(record, "registers", rows)
        group = "bed" if n == 1000 else "large"
        wide = _ratio(record, group, _own(record, group, plan.OURS[name]))
        both = slower * wide if slower is not None and wide is not None else None
        spheres = f"bed of {_grouped(n)}, tolerance {name}, AVX2 alone: "
        yield Goal.most(f"{spheres}CPU time over that with the widest registers", AVX2, slower)
        yield Goal.most(f"{spheres}CPU time over Rapier's at 4 ms", AVX2 * limit, both)


def _steady(record: Record) -> Iterator[Goal]:
    known = converged(record, "bed")
    for name, settings in (*plan.OURS.items(), *((key, plan.USERS[key]) for key in ("fast", "standard"))):
        rows = _own(record, "bed", settings)
        errors = [measures.force_error(row.outcome.force, known) for row in rows]
        found = [error.rms for error in errors if error is not None]
        yield Goal.most(f"bed at rest, {name}: floor force about the converged one, root mean square", STEADY, max(found, default=None))


def _machines(record: Record) -> Iterator[Goal]:
    standard = plan.USERS["standard"]
    rolling = _own(record, "rolling", standard)
    rolling = [row for row in rolling if row.case.scene == "rolling"]
    yield Goal.most("rolling friction: CPU time over the same bed without", ROLLING, _ratio(record, "rolling", rolling))
    rows = _own(record, "polydisperse", standard)
    sizes, plain = ([row.outcome for row in rows if row.case.scene == name] for name in ("polydisperse", "bed"))
    for what, cost in (("contact and simulated second", _per_contact), ("contact and sweep", _per_sweep)):
        ratio = median(map(cost, sizes)) / median(map(cost, plain)) if sizes and plain else None
        yield Goal.most(f"radii 1 to 10: CPU time per loaded {what} over that of the bed", SIZES, ratio)
    for name in ("fast", "standard"):
        times = [row.outcome.cpu_s / row.case.duration for row in _own(record, "hopper", plan.USERS[name])]
        yield Goal.most(
            f"hopper of 10 000 triangles and 1500 spheres, {name}: CPU time over simulated time", REAL_TIME, median(times) if times else None
        )


def _per_contact(outcome: Outcome) -> float:
    return outcome.cpu_s / (outcome.contacts or 1)


def _per_sweep(outcome: Outcome) -> float:
    return _per_contact(outcome) / (outcome.sweeps or 1)


def beside_blade(record: Record) -> tuple[float, float] | None:
    """Clock time per output interval [s] that the longer trough costs more than the shorter: while it settles, then at rest."""
    rows = {row.case.n: row.outcome.course for row in record.of("heap")}
    if not set(plan.HEAPS) <= set(rows):
        return None
    short, long = (rows[n] for n in plan.HEAPS)
    more = [b - a for a, b in zip(short["wall_s"], long["wall_s"], strict=True)]

    def mean(part: tuple[float, float]) -> float:
        chosen = [x for x, time in zip(more, short["time"], strict=True) if part[0] < time <= part[1] * (1 + 1e-9)]
        return sum(chosen) / len(chosen)

    return mean(MOVING_PART), mean(SETTLED_PART)


def _heap(record: Record) -> Iterator[Goal]:
    found = beside_blade(record)
    yield Goal.most("settled beside a moving blade: cost over that while it moved", SETTLED, found[1] / found[0] if found else None)


def resting(outcome: Outcome) -> tuple[float, float]:
    """Time on the clock per output interval [s]: mean of the most expensive tenth of them, and of the last tenth of the run."""
    each = outcome.course["wall_s"]
    tenth = max(1, len(each) // 10)
    return sum(sorted(each)[-tenth:]) / tenth, sum(each[-tenth:]) / tenth


def _rest(record: Record) -> Iterator[Goal]:
    rows = record.of("rest")
    ratio = None
    if rows:
        moving, settled = resting(rows[0].outcome)
        ratio = moving / settled
    yield Goal.least("a settled bed: times cheaper than while moving", REST, ratio)
