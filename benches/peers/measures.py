"""What is measured of every code alike, from positions, velocities, loaded contacts and forces on a boundary."""

import math
from collections.abc import Iterable
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from scenes import GRAVITY, Array, Plane, Scene

Pairs = NDArray[np.int64]
WALL = -1  # in place of the second sphere of a loaded contact


@dataclass(frozen=True)
class End:
    """The state at the end of a run; what a scene does not have is `None`."""

    overlap: float  # largest overlap of any pair or with a wall, over the smaller radius [-]
    energy: float  # kinetic energy per mass [J/kg]
    lost: int  # spheres outside of the walls
    height: float | None  # mean height of the highest twentieth's centres [m]
    discharged: float | None  # mass below the outlet [kg]
    total: float  # mass of all [kg]


def overlap(scene: Scene, x: Array, time: float = 0.0) -> float:
    """Largest overlap over the smaller radius [-], of spheres that are within the walls, at `time` [s] of what moves."""
    inside = _inside(scene, x)
    x, r = x[inside], scene.radius[inside]
    if len(x) == 0:
        return 0.0
    depth = max(0.0, (-_gaps_of_walls(scene, x, r, time) / r).max(initial=0.0))
    i, j = _near(x, r)
    between = (r[i] + r[j] - np.linalg.norm(x[i] - x[j], axis=1)) / np.minimum(r[i], r[j])
    return float(max(depth, between.max(initial=0.0)))


def _near(x: Array, r: Array) -> tuple[Pairs, Pairs]:
    """Pairs that may overlap: those within the sum of the largest radii of their size classes of a factor 2."""
    classes = np.floor(np.log2(r / r.min())).astype(int)
    members = [np.flatnonzero(classes == c) for c in range(classes.max() + 1)]
    trees = [cKDTree(x[m]) if len(m) else None for m in members]
    first, second = [np.empty(0, int)], [np.empty(0, int)]
    for a, big in enumerate(members):
        if not len(big):
            continue
        pairs = trees[a].query_pairs(2 * r[big].max(), output_type="ndarray")
        first.append(big[pairs[:, 0]])
        second.append(big[pairs[:, 1]])
        for b, small in enumerate(members[:a]):
            if not len(small):
                continue
            found = trees[a].query_ball_tree(trees[b], r[big].max() + r[small].max())
            first.append(np.repeat(big, [len(f) for f in found]))
            second.append(small[np.array([q for f in found for q in f], int)])
    return np.concatenate(first), np.concatenate(second)


def opening(scene: Scene, x: Array, contacts: Pairs, time: float = 0.0) -> float:
    """Largest gap over the smaller radius [-] of loaded `contacts`, (C, 2): two spheres, or a sphere and `WALL`.

    That of a wall is to the nearest face: too small where a sphere rests on the farther one of two; of meshes without planes and
    at an outlet's edge it is not known.
    """
    gaps = [0.0]
    i, j = contacts[:, 0], contacts[:, 1]
    r, pairs = scene.radius, j != WALL
    a, b = i[pairs], j[pairs]
    gaps += list((np.linalg.norm(x[a] - x[b], axis=1) - r[a] - r[b]) / np.minimum(r[a], r[b]))
    alone = i[~pairs]
    if scene.drains:
        # Those at the outlet may touch its edge, which is no plane.
        alone = alone[x[alone, 2] > 2 * r[alone]]
    if len(alone) and (scene.planes or (scene.moving is not None and (scene.moving.planes or scene.moving.box))):
        gaps += list(_gaps_of_walls(scene, x[alone], r[alone], time).min(0) / r[alone])
    return max(0.0, float(np.nanmax(gaps)))


def _gaps_of_walls(scene: Scene, x: Array, r: Array, time: float) -> Array:
    """Gap of each sphere to each wall [m], (walls, N); infinite where the sphere is beyond a face's edge."""
    rows = [np.full(len(x), np.inf)]
    if scene.planes:
        gap, foot = _heights(scene.planes, x, r)
        # Spheres touch the sloping faces, not their planes below the outlet's edge.
        rows += list(np.where(foot >= 0, gap, np.inf) if scene.drains else gap)
    body = scene.moving
    if body is not None and (body.planes or body.box):
        turned, shift = body.placed(time)
        local = turned.inv().apply(x - shift - np.array(body.point)) + np.array(body.point)
        if body.planes:
            rows += list(_heights(list(body.planes), local, r)[0])
        if body.box:
            rows.append(_from_box(np.array(body.box[0]), np.array(body.box[1]), local) - r)
    return np.array(rows)


def _heights(planes: list[Plane], x: Array, r: Array) -> tuple[Array, Array]:
    """Gaps to planes [m] and heights z of the points of the planes below the spheres [m], (planes, N)."""
    normals = np.array([p.normal for p in planes])
    above = normals @ x.T - (np.array([p.point for p in planes]) * normals).sum(1)[:, None]
    return above - r, x[:, 2] - above * normals[:, 2:]


def _from_box(low: Array, high: Array, x: Array) -> Array:
    """Distance of points from a box [m], negative inside."""
    beyond = np.maximum(low - x, x - high)
    return np.linalg.norm(np.maximum(beyond, 0.0), axis=1) + np.minimum(beyond.max(1), 0.0)


def _inside(scene: Scene, x: Array) -> NDArray[np.bool_]:
    """Spheres whose centre is within the walls; in a funnel those on their way out of it too."""
    known: NDArray[np.bool_] = np.all(np.isfinite(x), axis=1)
    if scene.name in ("slope", "feeder"):
        return known
    if scene.name == "drum":
        return known & (np.hypot(x[:, 0], x[:, 2]) < 1.05 * scene.half_width)
    if scene.name == "hopper":
        return known & (np.hypot(x[:, 0], x[:, 1]) < scene.half_width) & (x[:, 2] > -0.05)
    reach = np.array([scene.half_length or scene.half_width, scene.half_width])
    return known & (np.abs(x[:, :2]) < reach).all(1) & (x[:, 2] > (-0.05 if scene.drains else -0.01))


def end(scene: Scene, x: Array, v: Array, w: Array, time: float = 0.0) -> End:
    """Measures of the end; rows that are not numbers are spheres that a code has lost."""
    known = np.all(np.isfinite(x), axis=1)
    m, r = scene.mass, scene.radius
    energy = 0.5 * m * (v**2).sum(1) + 0.2 * m * r**2 * (w**2).sum(1)
    inside = _inside(scene, x)
    height, discharged, lost = None, None, int((~known).sum())
    if scene.rests:
        top = np.sort(x[inside, 2])[-max(1, int(inside.sum()) // 20) :]
        height = float(top.mean())
    if scene.rests or scene.name == "drum":
        lost = int((~inside).sum())
    if scene.drains:
        discharged = float(m.sum()) - _above(scene, x)
        lost = int(((x[:, 2] >= 0) & ~inside).sum())
    return End(
        overlap=overlap(scene, x, time),
        energy=float(energy[known].sum() / m[known].sum()),
        lost=lost,
        height=height,
        discharged=discharged,
        total=float(m.sum()),
    )


@dataclass(frozen=True)
class Course:
    """What positions at output times tell."""

    worst: float  # largest overlap of any pair or with a wall at any of these times, over the smaller radius [-]
    half_out: float | None  # time at which half of the mass is below the outlet [s], to one interval
    opening: float | None = None  # largest gap of a loaded contact at any of these times, over the smaller radius [-]


def course(scene: Scene, frames: Iterable[Array], interval: float, loaded: Iterable[Pairs | None] | None = None) -> Course:
    """Measures of positions (N, 3), and of the loaded contacts where they are known, at the ends of intervals [s]."""
    worst, half_out, widest = 0.0, None, None
    contacts = iter(loaded) if loaded is not None else None
    for k, x in enumerate(frames, 1):
        worst = max(worst, overlap(scene, x, k * interval))
        pairs = next(contacts) if contacts is not None else None
        if pairs is not None:
            widest = max(widest or 0.0, opening(scene, x, pairs, k * interval))
        if half_out is None and scene.drains and 2 * _above(scene, x) <= scene.mass.sum():
            half_out = k * interval
    return Course(worst, half_out, widest)


def _above(scene: Scene, x: Array) -> float:
    """Mass above the outlet [kg]; what has left a code's domain is not."""
    return float(scene.mass[x[:, 2] >= 0].sum())


def over_weight(scene: Scene, force: float) -> float:
    """A vertical force [N] over the weight of all spheres [-]."""
    return force / (float(scene.mass.sum()) * GRAVITY)


@dataclass(frozen=True)
class ForceError:
    """A force on a boundary beside the converged one, over the latter's mean [-]."""

    mean: float  # of the mean
    rms: float  # root mean square of its course about the converged mean
    natural: float  # the same of the converged run itself


def force_error(series: list[float], converged: list[float]) -> ForceError | None:
    """Errors of one force's means over output intervals; `None` where one is not known or the converged mean is zero."""
    if not series or not converged:
        return None
    known, found = np.array(converged), np.array(series)
    mean = float(known.mean())
    if mean == 0.0:
        return None

    def rms(values: Array) -> float:
        return math.sqrt(float(((values - mean) ** 2).mean())) / abs(mean)

    return ForceError(abs(float(found.mean()) - mean) / abs(mean), rms(found), rms(known))


def by_balance(scene: Scene, states: list[tuple[Array, Array, Array]], interval: float) -> list[float]:
    """The load [N, N m] over each interval between states (x, v, w), from the change of momentum and the weight.

    For codes that do not tell the forces of friction; of a scene in which one boundary alone holds the spheres.
    """
    load = scene.load
    if load is None:
        return []
    m, direction = scene.mass, np.array(load.direction)
    weight = np.outer(m, [0.0, 0.0, -GRAVITY])
    point = np.array(scene.moving.point) if load.couple and scene.moving is not None else np.zeros(3)

    def momentum(state: tuple[Array, Array, Array]) -> float:
        x, v, w = state
        if not load.couple:
            return float((m[:, None] * v).sum(0) @ direction)
        spin = 0.4 * (m * scene.radius**2)[:, None] * w
        return float((np.cross(x - point, m[:, None] * v) + spin).sum(0) @ direction)

    def driving(state: tuple[Array, Array, Array]) -> float:
        pulls = np.cross(state[0] - point, weight) if load.couple else weight
        return float(pulls.sum(0) @ direction)

    found = []
    for before, after in pairwise(states):
        pulled = 0.5 * (driving(before) + driving(after))
        found.append(pulled - (momentum(after) - momentum(before)) / interval)
    return found
