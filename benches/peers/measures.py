"""What is measured of every code alike, from positions and velocities."""

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from scenes import GRAVITY, Array, Scene


@dataclass(frozen=True)
class End:
    """The state at the end of a run; what a scene does not have is `None`."""

    overlap: float  # largest overlap of any pair or with a wall, over the smaller radius [-]
    energy: float  # kinetic energy per mass [J/kg]
    lost: int  # spheres outside of the walls
    height: float | None  # mean height of the highest twentieth's centres [m]
    discharged: float | None  # mass below the outlet [kg]
    total: float  # mass of all [kg]


def overlap(scene: Scene, x: Array) -> float:
    """Largest overlap over the smaller radius [-], of spheres that are within the walls."""
    inside = _inside(scene, x)
    x, r = x[inside], scene.radius[inside]
    if len(x) == 0:
        return 0.0
    pairs = cKDTree(x).query_pairs(2 * r.max(), output_type="ndarray")
    i, j = pairs[:, 0], pairs[:, 1]
    between = (r[i] + r[j] - np.linalg.norm(x[i] - x[j], axis=1)) / np.minimum(r[i], r[j])
    walls = _depths(scene, x, r) / r
    return max(0.0, between.max(initial=0.0), walls.max(initial=0.0))


def _depths(scene: Scene, x: Array, r: Array) -> Array:
    """Depth of each sphere in each wall [m], (planes, N)."""
    points = np.array([p.point for p in scene.planes])
    normals = np.array([p.normal for p in scene.planes])
    depth = r - ((x - points[:, None]) * normals[:, None]).sum(2)
    if scene.name == "funnel":
        # Spheres touch the sloping faces, not their planes below the outlet's edge: a foot is r/sqrt(2) below its centre.
        depth = np.where(x[:, 2] > r, depth, -1.0)
    return depth


def _inside(scene: Scene, x: Array) -> NDArray[np.bool_]:
    """Spheres whose centre is within the walls; in a funnel those on their way out of it too."""
    known: NDArray[np.bool_] = np.all(np.isfinite(x), axis=1)
    if scene.name == "slope":
        return known
    within = known & (np.abs(x[:, :2]) < scene.half_width).all(1)
    if scene.name == "bed":
        return within & (x[:, 2] > -0.01)
    return within & (x[:, 2] > -0.05)


def end(scene: Scene, x: Array, v: Array, w: Array) -> End:
    """Measures of the end; rows that are not numbers are spheres that a code has lost."""
    known = np.all(np.isfinite(x), axis=1)
    m, r = scene.mass, scene.radius
    energy = 0.5 * m * (v**2).sum(1) + 0.2 * m * r**2 * (w**2).sum(1)
    inside = _inside(scene, x)
    height, discharged, lost = None, None, int((~known).sum())
    if scene.name == "bed":
        top = np.sort(x[inside, 2])[-max(1, int(inside.sum()) // 20) :]
        height = float(top.mean())
        lost = int((~inside).sum())
    if scene.name == "funnel":
        discharged = float(m.sum()) - _above(scene, x)
        lost = int(((x[:, 2] >= 0) & ~inside).sum())
    return End(
        overlap=overlap(scene, x),
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


def course(scene: Scene, frames: Iterable[Array], interval: float) -> Course:
    """Measures of positions (N, 3) at the ends of intervals [s]."""
    worst, half_out = 0.0, None
    for k, x in enumerate(frames, 1):
        worst = max(worst, overlap(scene, x))
        if half_out is None and scene.name == "funnel" and 2 * _above(scene, x) <= scene.mass.sum():
            half_out = k * interval
    return Course(worst, half_out)


def _above(scene: Scene, x: Array) -> float:
    """Mass above the outlet [kg]; what has left a code's domain is not."""
    return float(scene.mass[x[:, 2] >= 0].sum())


def over_weight(scene: Scene, force: float) -> float:
    """A vertical force [N] over the weight of all spheres [-]."""
    return force / (float(scene.mass.sum()) * GRAVITY)
