"""A settled bed in a trough and an upright plate that begins to move into it."""

import numpy as np

from scenes.scene import Load, Moving, Plane, Scene, box_triangles, sides

HALF_WIDTH, HEIGHT, THICK, CLEARANCE = 0.08, 0.15, 0.01, 0.001  # of the trough and the plate [m]
SPEED, BEGIN = 0.1, 0.5  # of the plate [m/s], when it starts [s]
PITCH = 0.025  # of the lattice that the spheres start on [m]


def blade(n: int, seed: int) -> Scene:
    """Spheres on one side of the plate; the trough is as long as there are spheres, of the same depth."""
    rng = np.random.default_rng(seed)
    half = 0.3 * n / 1000
    low, high = (-half + 0.01, CLEARANCE - HALF_WIDTH, CLEARANCE), (-half + 0.01 + THICK, HALF_WIDTH - CLEARANCE, HEIGHT)
    start = high[0] + 0.012
    columns, rows = int((half - 0.012 - start) / PITCH) + 1, int(2 * HALF_WIDTH / PITCH)
    k = np.arange(n)
    x = np.column_stack([start + PITCH * (k % columns), PITCH * (k // columns % rows - 0.5 * (rows - 1)), PITCH * (0.5 + k // (columns * rows))])
    x += rng.uniform(-0.0008, 0.0008, (n, 3))
    r = 0.01 * rng.uniform(0.9, 1.1, n)
    plate = Moving("blade", box=(low, high), velocity=(SPEED, 0.0, 0.0), begin=BEGIN, triangles=box_triangles(low, high))
    planes = [Plane((0, 0, 0), (0, 0, 1)), *sides(half, HALF_WIDTH)]
    return Scene("blade", x, r, 2500.0, planes, HALF_WIDTH, half_length=half, moving=plate, load=Load("blade", (1, 0, 0), window=0.2))
