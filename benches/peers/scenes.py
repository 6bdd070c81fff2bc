"""The scenes that every code runs: positions, radii, planes and triangles, in SI units, z up.

bed     N spheres r = 0.01 m +-10 %, density 2500, on a loose jittered lattice in a square box of width 0.4 m (N/1000)^(1/3),
        dropped and settled for 1.0 s.
slope   180 spheres r = 0.02 m, density 3500, 36 just above each of five planes of 50, 40, 30, 20 and 10 degrees that form one
        profile of 1 m (horizontal) each; 1.0 s.
funnel  an inverted square pyramid (45 degrees) over a square outlet of 0.12 m at z = 0, vertical walls above; two stacks of
        spheres, r = 0.01 m below and 0.007 m above, N/2 each, density 2500; 1.0 s. What is below z = 0 is discharged.

Friction is 0.5 and restitution 0 everywhere.
"""

import math
from dataclasses import dataclass, field
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

GRAVITY = 9.81
FRICTION = 0.5
OUTLET = 0.06  # half the width of the funnel's outlet [m]
ANGLES = (50, 40, 30, 20, 10)  # of the slope [deg]
DURATION = 1.0  # [s]


@dataclass(frozen=True)
class Plane:
    """A half-space: solid on the side that `normal` (of length 1) leaves."""

    point: tuple[float, float, float]
    normal: tuple[float, float, float]


@dataclass(frozen=True)
class Scene:
    """Spheres at rest at t = 0 and what holds them.

    `planes` are what overlaps with walls are measured against and the walls of codes with half-spaces, the first one is the floor
    of a bed. Where `sheets` is true the walls are `triangles`, (T, 3, 3), in every code: planes would have no outlet. Codes
    without half-spaces take the triangles of a slope too.
    """

    name: str
    position: Array  # (N, 3) [m]
    radius: Array  # (N,) [m]
    density: float  # [kg/m^3]
    planes: list[Plane]
    half_width: float = 0.0  # of the box in x and y [m]
    triangles: Array = field(default_factory=lambda: np.empty((0, 3, 3)))  # [m]
    sheets: bool = False

    @property
    def mass(self) -> Array:
        """Masses [kg], (N,)."""
        return self.density * 4 / 3 * math.pi * self.radius**3

    @property
    def weight(self) -> float:
        """Weight of all spheres [N]."""
        return float(self.mass.sum()) * GRAVITY


def build(name: str, n: int, seed: int) -> Scene:
    """The scene of this name with `n` spheres; a slope has no randomness."""
    if name == "slope":
        return slope(n)
    return {"bed": bed, "funnel": funnel}[name](n, seed)


def _half_width(n: int) -> float:
    return 0.2 * (n / 1000.0) ** (1 / 3)


def _sides(b: float) -> list[Plane]:
    return [
        Plane((-b, 0, 0), (1, 0, 0)),
        Plane((b, 0, 0), (-1, 0, 0)),
        Plane((0, -b, 0), (0, 1, 0)),
        Plane((0, b, 0), (0, -1, 0)),
    ]


def _lattice(n: int, b: float, pitch: float, m: int, low: float) -> Array:
    """`n` points, `m` in a row, in layers from `low` [m] on, centred in a box of half width `b` [m]."""
    i = np.arange(n)
    edge = 0.5 * m * pitch
    return np.stack([(i % m + 0.5) * pitch - edge, (i // m % m + 0.5) * pitch - edge, low + i // (m * m) * pitch], 1)


def bed(n: int, seed: int) -> Scene:
    """Spheres dropped into a box."""
    rng = np.random.default_rng(seed)
    b, pitch = _half_width(n), 0.025
    x = _lattice(n, b, pitch, int(2 * b / pitch + 1e-9), 0.5 * pitch)
    x += rng.uniform(-0.0014, 0.0014, (n, 3))
    r = 0.01 * rng.uniform(0.9, 1.1, n)
    return Scene("bed", x, r, 2500.0, [Plane((0, 0, 0), (0, 0, 1)), *_sides(b)], b)


def funnel(n: int, seed: int) -> Scene:
    """Two stacks of spheres over an open funnel."""
    rng = np.random.default_rng(seed)
    b = _half_width(n)
    low = b - OUTLET + 0.012
    positions, radii = [], []
    for r, pitch, count in ((0.01, 0.022, n // 2), (0.007, 0.0158, n - n // 2)):
        x = _lattice(count, b, pitch, int((2 * b - 0.002) / pitch), low)
        x += rng.uniform(-0.0006, 0.0006, (count, 3))
        positions.append(x)
        radii.append(np.full(count, r))
        low = x[:, 2].max() + 0.02
    s = math.sqrt(0.5)
    o = OUTLET
    sloping = [
        Plane((-o, 0, 0), (s, 0, s)),
        Plane((o, 0, 0), (-s, 0, s)),
        Plane((0, -o, 0), (0, s, s)),
        Plane((0, o, 0), (0, -s, s)),
    ]
    x = np.vstack(positions)
    walls = _funnel_walls(b, x[:, 2].max() + 0.05)
    return Scene("funnel", x, np.concatenate(radii), 2500.0, sloping + _sides(b), b, walls, sheets=True)


def _funnel_walls(b: float, top: float) -> Array:
    """8 triangles of the pyramid and 8 of the walls above; normals point to the spheres."""
    square = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]])
    levels = [(OUTLET, 0.0), (b, b - OUTLET), (b, top)]
    rings = [np.column_stack([half * square, np.full(4, z)]) for half, z in levels]
    triangles = []
    for a, c in pairwise(rings):
        for k in range(4):
            m = (k + 1) % 4
            triangles += [(a[k], c[m], a[m]), (a[k], c[k], c[m])]
    return np.array(triangles)


def slope(n: int) -> Scene:
    """Spheres just above five planes that get flatter."""
    r, gap, pitch = 0.02, 1e-4, 0.06
    per = n // len(ANGLES)
    rows = max(4, round(math.sqrt(per / 2.25)))
    columns = -(-per // rows)
    k = np.arange(per)
    planes, positions, profile = [], [], []
    x, z = 0.0, sum(math.tan(math.radians(a)) for a in ANGLES)
    for angle in ANGLES:
        t = math.radians(angle)
        normal, tangent = np.array([math.sin(t), 0, math.cos(t)]), np.array([math.cos(t), 0, -math.sin(t)])
        along = (0.25 + 0.5 * (k % columns + 0.5) / columns) / math.cos(t)
        across = (k // columns - 0.5 * (rows - 1)) * pitch
        start = np.array([x, 0, z]) + normal * (r + gap)
        positions.append(start + np.outer(along, tangent) + np.outer(across, [0, 1, 0]))
        planes.append(Plane((x, 0.0, z), (math.sin(t), 0.0, math.cos(t))))
        profile.append((x, z))
        x, z = x + 1, z - math.tan(t)
    profile.append((x, z))
    centres = np.vstack(positions)
    return Scene("slope", centres, np.full(len(centres), r), 3500.0, planes, triangles=_slope_strips(profile))


def _slope_strips(profile: list[tuple[float, float]], before: float = 0.3, after: float = 1.5, half: float = 0.5) -> Array:
    """Two triangles a plane, the first and the last one extended [m]; 1 m wide."""
    points = np.array(profile)
    falls = np.diff(points, axis=0)
    points[0] -= before * falls[0]
    points[-1] += after * falls[-1]
    triangles = []
    for (x0, z0), (x1, z1) in pairwise(points):
        a, b, c, d = (x0, -half, z0), (x1, -half, z1), (x1, half, z1), (x0, half, z0)
        triangles += [(a, b, c), (a, c, d)]
    return np.array(triangles)
