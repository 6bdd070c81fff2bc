"""A drum of flat sides that turns about a horizontal axis, a good third full of spheres."""

import math

import numpy as np

from scenes.scene import Array, Load, Moving, Plane, Scene

RADIUS = 0.1  # of the inscribed circle [m]
SIDES = 24
SPIN = 2.0  # about y [rad/s]: 0.04 of the weight at the shell
PITCH = 0.0125  # of the lattice that the spheres start on [m]


def drum(n: int, seed: int) -> Scene:
    """Spheres on a lattice in the drum, which turns from the start; the axis is y through the origin."""
    rng = np.random.default_rng(seed)
    half = max(0.02, 0.04 * n / 1000)
    rows = int(2 * half / PITCH)
    m = int(RADIUS / PITCH)
    grid = PITCH * np.array([(i, k) for k in range(-m, m + 1) for i in range(-m, m + 1)], float)
    section = grid[(grid**2).sum(1) <= (RADIUS - 0.007) ** 2]
    k = np.arange(n)
    if n > len(section) * rows:
        raise ValueError(f"a drum holds at most {len(section) * rows} spheres of this lattice, not {n}")
    x = np.column_stack([section[k // rows, 0], (k % rows + 0.5) * PITCH - 0.5 * rows * PITCH, section[k // rows, 1]])
    x += rng.uniform(-0.0006, 0.0006, (n, 3))
    r = 0.005 * rng.uniform(0.9, 1.1, n)
    angles = 2 * math.pi * (np.arange(SIDES) + 0.5) / SIDES
    shell = [Plane((RADIUS * math.cos(a), 0, RADIUS * math.sin(a)), (-math.cos(a), 0, -math.sin(a))) for a in angles]
    caps = [Plane((0, -half, 0), (0, 1, 0)), Plane((0, half, 0), (0, -1, 0))]
    body = Moving("drum", planes=(*shell, *caps), spin=(0.0, SPIN, 0.0), triangles=_mesh(half))
    return Scene("drum", x, r, 2500.0, [], RADIUS, moving=body, load=Load("drum", (0, 1, 0), couple=True, window=0.5))


def _mesh(half: float) -> Array:
    """Two triangles a side and one at each end of it; normals point inwards."""
    angles = 2 * math.pi * np.arange(SIDES) / SIDES
    rim = RADIUS / math.cos(math.pi / SIDES) * np.column_stack([np.cos(angles), np.zeros(SIDES), np.sin(angles)])
    shift = np.array([0.0, half, 0.0])
    triangles = []
    for p, q in zip(rim, np.roll(rim, -1, 0), strict=True):
        a, b, c, d = p - shift, q - shift, q + shift, p + shift
        triangles += [(a, b, c), (a, c, d), (-shift, b, a), (shift, d, c)]
    return np.array(triangles)
