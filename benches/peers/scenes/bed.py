"""Beds: spheres dropped into a box, plain, with rolling friction, or of sizes 1 to 10."""

import math
from dataclasses import replace

import numpy as np

from scenes.scene import FLOOR, Load, Plane, Scene, half_width, lattice, sides

ROLLING = 0.05  # couple of rolling resistance over reduced radius and normal force [-]
SMALLEST, LARGEST = 0.001, 0.01  # radii of the bed of many sizes [m]
FILL = 0.15  # part of the volume that spheres of many sizes start with [-]
WEIGHED = Load(FLOOR, (0, 0, -1))


def bed(n: int, seed: int) -> Scene:
    """Spheres dropped into a box."""
    rng = np.random.default_rng(seed)
    b, pitch = half_width(n), 0.025
    x = lattice(n, b, pitch, int(2 * b / pitch + 1e-9), 0.5 * pitch)
    x += rng.uniform(-0.0014, 0.0014, (n, 3))
    r = 0.01 * rng.uniform(0.9, 1.1, n)
    return Scene("bed", x, r, 2500.0, [Plane((0, 0, 0), (0, 0, 1)), *sides(b)], b, load=WEIGHED)


def rolling(n: int, seed: int) -> Scene:
    """The bed with rolling resistance."""
    return replace(bed(n, seed), name="rolling", rolling=ROLLING)


def polydisperse(n: int, seed: int) -> Scene:
    """Spheres whose radii are uniform on a logarithmic scale, placed at random without overlap, large ones first."""
    rng = np.random.default_rng(seed)
    b = 0.07 * (n / 1000.0) ** (1 / 3)
    r = np.sort(SMALLEST * (LARGEST / SMALLEST) ** rng.uniform(0, 1, n))[::-1]
    height = float((r**3).sum()) * 4 / 3 * math.pi / FILL / (2 * b) ** 2
    low, high = np.array([-b, -b, 0.0]), np.array([b, b, height + 2 * LARGEST])
    x = np.empty((n, 3))
    for k in range(n):
        gap = 0.01 * r[k]
        while True:
            x[k] = rng.uniform(low + r[k] + gap, high - r[k] - gap)
            if np.all(((x[:k] - x[k]) ** 2).sum(1) > (r[:k] + r[k] + gap) ** 2):
                break
    return Scene("polydisperse", x, r.copy(), 2500.0, [Plane((0, 0, 0), (0, 0, 1)), *sides(b)], b, load=WEIGHED)
