"""A funnel of two stacks of spheres."""

import math
from itertools import pairwise

import numpy as np

from scenes.scene import WALLS, Array, Load, Plane, Scene, half_width, lattice, sides

OUTLET = 0.06  # half the width of the outlet [m]


def funnel(n: int, seed: int) -> Scene:
    """Two stacks of spheres over an open funnel."""
    rng = np.random.default_rng(seed)
    b = half_width(n)
    low = b - OUTLET + 0.012
    positions, radii = [], []
    for r, pitch, count in ((0.01, 0.022, n // 2), (0.007, 0.0158, n - n // 2)):
        x = lattice(count, b, pitch, int((2 * b - 0.002) / pitch), low)
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
    return Scene("funnel", x, np.concatenate(radii), 2500.0, sloping + sides(b), b, walls, sheets=True, load=Load(WALLS, (0, 0, -1)))


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
