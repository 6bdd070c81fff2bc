"""Spheres on planes that get flatter."""

import math
from itertools import pairwise

import numpy as np

from scenes.scene import Array, Plane, Scene

ANGLES = (50, 40, 30, 20, 10)  # [deg]


def slope(n: int, seed: int) -> Scene:
    """Spheres just above five planes that get flatter, the same for every seed."""
    del seed
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
