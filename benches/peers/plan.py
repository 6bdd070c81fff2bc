"""What is run, in which order."""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import product

from codes import module
from runs import Case

# Own rows: gap tolerance [-], and the range [s] in which each step is chosen for least time.
OURS = {
    "1e-4": {"tolerance": 1e-4, "step": 4e-3, "smallest_step": 1e-4},
    "1e-5": {"tolerance": 1e-5, "step": 2e-3, "smallest_step": 2e-5},
    "1e-6": {"tolerance": 1e-6, "step": 1e-3, "smallest_step": 1e-5},
}
# What users get: no other key of the solver.
USERS = {name: {"accuracy": name} for name in ("fast", "standard", "reference")}
# The same for beds of all sizes: within the reach of longer steps more pairs are, which takes more memory.
SIZED = {"tolerance": 1e-4, "step": 2e-3, "smallest_step": 1e-4}
# The same for the funnel with steps of one length [s].
FIXED = {
    "1e-4": {"tolerance": 1e-4, "step": 1e-3, "fixed_step": True},
    "1e-5": {"tolerance": 1e-5, "step": 5e-4, "fixed_step": True},
    "1e-6": {"tolerance": 1e-6, "step": 5e-4, "fixed_step": True},
}
# Step [s], substeps [-] and contact softness [Hz] from fast to accurate. Contacts are looked for 0.02 mean diameters ahead; with
# `prediction` [diameters], the way of the fastest spheres in a step, impacts are met earlier: rows of more time and less overlap.
RAPIER = {
    "4 ms": {"step": 0.004, "substeps": 16, "softness": 2000},
    "2 ms": {"step": 0.002, "substeps": 16, "softness": 2000},
    "1 ms": {"step": 0.001, "substeps": 16, "softness": 4000},
    "0.5 ms": {"step": 0.0005, "substeps": 16, "softness": 8000},
    "4 ms ahead": {"step": 0.004, "substeps": 16, "softness": 2000, "prediction": 0.2},
    "2 ms ahead": {"step": 0.002, "substeps": 16, "softness": 2000, "prediction": 0.25},
    "1 ms ahead": {"step": 0.001, "substeps": 16, "softness": 4000, "prediction": 0.12},
    "0.5 ms ahead": {"step": 0.0005, "substeps": 16, "softness": 8000, "prediction": 0.06},
}
AHEAD = ("4 ms ahead", "2 ms ahead", "1 ms ahead", "0.5 ms ahead")
# Young's modulus [Pa] from the softest in use to that of rock.
LIGGGHTS = {"soft": {"young": 1e7}, "1e8": {"young": 1e8}, "1e9": {"young": 1e9}, "rock": {"young": 1.3e10}}
# Step [s], most iterations [-] and time constant of a contact [s], from fast to accurate.
MUJOCO = {
    "fast": {"step": 0.002, "iterations": 20, "time": 0.004},
    "accurate": {"step": 0.0005, "iterations": 50, "time": 0.001},
}
# Step [s], iterations [-] and contact stiffness [N/m], from fast to accurate.
NEWTON: dict[str, dict[str, float | bool | str]] = {
    "fast": {"solver": "VBD", "step": 0.004, "iterations": 10, "stiffness": 1e5},
    "accurate": {"solver": "VBD", "step": 0.001, "iterations": 20, "stiffness": 1e6},
}
# The converged run once more with steps at most about half as long on average [s].
HALVED = {"accuracy": "reference", "step": 2e-4}
SEEDS = (2, 3, 4, 5)  # besides 1, which the other groups run
HEAPS = (3000, 9000)  # spheres beside the blade: it moves about a thousand, and the longer trough has more that settle
SIZES = (100, 1000, 10_000, 100_000, 1_000_000)
PEER_LIMIT = 100_000  # spheres, above which peers are not run
REST = 3.0  # of the bed that comes to rest [s]
REST_SPEED = 1e-2  # below which it does [m/s]
# A real-time mode: every step has so many sweeps and is as good as it is then.
BOUNDED = {"tolerance": 1e-4, "step": 4e-3, "fixed_step": True, "sweeps": 20}


@dataclass(frozen=True)
class Group:
    """Cases that belong together; a `reference` runs before and after each, so that ratios are of the same minute."""

    name: str
    cases: tuple[Case, ...]
    reference: Case | None = None
    repeat: int = 1

    def sequence(self) -> Iterator[Case]:
        """The runs in order."""
        for _ in range(self.repeat):
            for case in self.cases:
                if self.reference:
                    yield self.reference
                yield case
            if self.reference:
                yield self.reference


def _peers(name: str, n: int, rapier: tuple[str, ...], liggghts: tuple[str, ...]) -> tuple[Case, ...]:
    return (
        *(Case("rapier", name, n, RAPIER[key]) for key in rapier),
        *(Case("liggghts", name, n, LIGGGHTS[key]) for key in liggghts),
    )


def _duration(n: int, quick: bool) -> float:
    """Simulated time [s]: all of it where that is a matter of minutes."""
    if n <= 10_000:
        return 1.0
    return 0.1 if quick or n > 100_000 else 0.5


def _machines(quick: bool) -> list[Group]:
    """Beds of other grains, and what has moving parts or a mesh."""
    repeat = 1 if quick else 3
    users = {name: dict(settings) for name, settings in USERS.items()}

    def ours(name: str, n: int, duration: float, *settings: dict[str, float | bool | str]) -> tuple[Case, ...]:
        return tuple(Case("sphere-dda", name, n, s, duration=duration) for s in settings)

    def peers(name: str, n: int, duration: float, rapier: tuple[str, ...]) -> tuple[Case, ...]:
        young = ("soft",) if quick else ("soft", "1e8")
        pace = ("fast",) if quick and name in ("drum", "blade") else tuple(MUJOCO)
        wanted = [
            *(Case("rapier", name, n, RAPIER[key], duration=duration) for key in rapier),
            *(Case("liggghts", name, n, LIGGGHTS[key], duration=duration) for key in young),
            *(Case("mujoco", name, n, MUJOCO[key], duration=duration) for key in pace),
            *(Case("newton", name, n, NEWTON[key], duration=duration) for key in NEWTON),
        ]
        return tuple(case for case in wanted if name not in module(case.code).CANNOT)

    standard = Case("sphere-dda", "bed", 1000, users["standard"])
    found = []
    for name in ("rolling", "polydisperse"):
        # Beside the same project's plain bed.
        found.append(Group(name, ours(name, 1000, 1.0, users["standard"]), standard, repeat))
        others = ours(name, 1000, 1.0, users["fast"], users["reference"], *([HALVED] if name == "rolling" else []))
        found.append(Group(f"{name}-peers", (*others, *peers(name, 1000, 1.0, ("4 ms", "1 ms")))))
    for name, n, duration, pace in (("hopper", 1500, 1.0, "2 ms"), ("drum", 1000, 1.5, "4 ms"), ("blade", 1000, 1.0, "4 ms")):
        reference = Case("rapier", name, n, RAPIER[pace], duration=duration)
        settings = (*users.values(), *([HALVED] if name == "blade" else []))
        found.append(Group(name, ours(name, n, duration, *settings), reference, repeat))
        found.append(Group(f"{name}-peers", peers(name, n, duration, ("1 ms",))))
    fmi = Case("sphere-dda-fmi", "feeder", 150, users["standard"], watch=False)
    found.append(Group("feeder", (fmi,), replace(fmi, code="sphere-dda"), max(3, repeat)))
    resting = {"accuracy": "standard", "rest_speed": REST_SPEED}
    heaps = tuple(Case("sphere-dda", "blade", n, resting, duration=1.5, watch=False, trace=True) for n in HEAPS)
    found.append(Group("heap", heaps))
    for settings, n in (*((s, 1000) for s in OURS.values()), (OURS["1e-4"], 10_000)):
        wide = Case("sphere-dda", "bed", n, settings, watch=False)
        found.append(Group("registers", (replace(wide, settings={**settings, "registers": "avx2"}),), wide, repeat))
    return found


def groups(quick: bool) -> list[Group]:
    """All groups; `quick` keeps what the goals need, once each."""
    repeat = 1 if quick else 3
    ours = {key: Case("sphere-dda", "bed", 1000, settings) for key, settings in OURS.items()}
    rapier = Case("rapier", "bed", 1000, RAPIER["4 ms"])
    soft = Case("liggghts", "bed", 1000, LIGGGHTS["soft"])
    hard = ("soft", "1e8") if quick else tuple(LIGGGHTS)
    seeded = tuple(ours.values()) if quick else (*ours.values(), rapier, soft)
    seeds = tuple(replace(case, seed=seed, watch=False) for case, seed in product(seeded, SEEDS))

    big = Case("sphere-dda", "bed", 10_000, OURS["1e-4"])
    big_rapier, big_soft = replace(rapier, n=10_000), replace(soft, n=10_000)
    huge = replace(ours["1e-4"], n=100_000, duration=max(0.2, _duration(100_000, quick)), watch=False)
    few = replace(ours["1e-4"], n=2000, watch=False)
    threads: tuple[Case, ...] = tuple(replace(case, threads=t) for case in (few, huge) for t in (1, 2))
    if not quick:
        bigs = (big, big_rapier, big_soft)
        threads = (*threads, *(replace(c, threads=t, watch=False) for c in bigs for t in (1, 2)))

    sized = replace(ours["1e-4"], settings=SIZED)
    coded = (sized,) if quick else (sized, rapier, soft)
    scaling = tuple(
        replace(case, n=n, duration=_duration(n, quick), watch=False, trace=True)
        for n in (SIZES[:-1] if quick else SIZES)
        for case in coded
        if case.code == "sphere-dda" or n <= PEER_LIMIT
    )
    gaps = (1e-6,) if quick else (1e-4, 1e-5, 1e-6)
    slope = tuple(Case("sphere-dda", "slope", 180, {"tolerance": gap, "step": 2e-3, "fixed_step": True}) for gap in gaps)
    slope_rapier = Case("rapier", "slope", 180, RAPIER["2 ms"])
    names = ("1e-4",) if quick else tuple(OURS)
    funnel = tuple(Case("sphere-dda", "funnel", 1000, steps[gap]) for gap in names for steps in (FIXED, OURS))
    funnel_rapier = Case("rapier", "funnel", 1000, RAPIER["2 ms"])

    convex = (
        *(Case("mujoco", "bed", 1000, s) for s in MUJOCO.values()),
        *(Case("newton", "bed", 1000, s) for s in NEWTON.values()),
    )

    def users(name: str, n: int) -> tuple[Case, ...]:
        return tuple(Case("sphere-dda", name, n, settings) for settings in USERS.values())

    return [
        Group("bed", (*ours.values(), *users("bed", 1000)), rapier, repeat),
        Group("bed-peers", (*_peers("bed", 1000, ("2 ms", "1 ms", "0.5 ms", *AHEAD), hard), *convex, replace(ours["1e-4"], settings=HALVED))),
        Group("seeds", seeds),
        Group("slope", (*slope, *users("slope", 180)), slope_rapier, repeat),
        Group("slope-peers", (*_peers("slope", 180, ("4 ms", "1 ms", "0.5 ms"), hard), *(replace(case, scene="slope", n=180) for case in convex))),
        Group("funnel", (*funnel, *users("funnel", 1000)), funnel_rapier, repeat),
        Group("funnel-peers", _peers("funnel", 1000, ("4 ms", "1 ms", "0.5 ms", *AHEAD), hard[:2])),
        Group("real-time", (Case("sphere-dda", "bed", 1000, BOUNDED),), rapier, repeat),
        Group(
            "rest",
            (
                replace(
                    ours["1e-4"],
                    settings={"tolerance": 1e-4, "step": 5e-4, "fixed_step": True, "rest_speed": REST_SPEED},
                    duration=REST,
                    watch=False,
                    trace=True,
                ),
            ),
        ),
        Group("large", (big,), big_rapier),
        Group("large-peers", (big_soft,)),
        Group("threads", threads),
        Group("scaling", scaling),
        *_machines(quick),
    ]


def chosen(quick: bool, only: list[str], up_to: float, peers: bool = True) -> list[Group]:
    """The groups whose name, or its first word, is in `only` (all if that is empty), without beds above `up_to` spheres.

    Without `peers` those whose times are of no pairs are left out.
    """
    found = []
    for group in groups(quick):
        if not peers and group.name.endswith("-peers"):
            continue
        if only and not {group.name, group.name.split("-")[0]} & set(only):
            continue
        cases = tuple(case for case in group.cases if case.n <= up_to)
        if cases:
            found.append(replace(group, cases=cases))
    return found
