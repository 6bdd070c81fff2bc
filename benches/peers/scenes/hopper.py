"""A cone below a cylinder, one mesh of ten thousand triangles, and spheres that run out of it."""

import math

import numpy as np

from scenes.scene import WALLS, Array, Load, Plane, Scene

MOUTH, WIDTH, CONE = 0.04, 0.12, 0.12  # radii of mouth and cylinder, height of the cone [m]
SIDES, CONE_ROWS, UPPER_ROWS = 100, 35, 15  # flat sides, rows of two triangles each: 10 000 in all
PITCH = 0.0135  # of the lattice that the spheres start on [m]


def hopper(n: int, seed: int) -> Scene:
    """Spheres above the cone; radii of the walls are those of the sides' inscribed circles."""
    rng = np.random.default_rng(seed)
    reach = WIDTH - 0.5 * PITCH
    m = int(reach / PITCH)
    grid = PITCH * np.array([(i, k) for i in range(-m, m + 1) for k in range(-m, m + 1)], float)
    layer = grid[(grid**2).sum(1) <= (reach - 0.001) ** 2]
    k = np.arange(n)
    x = np.column_stack([layer[k % len(layer)], CONE + 0.01 + PITCH * (k // len(layer))])
    x += rng.uniform(-0.0004, 0.0004, (n, 3))
    r = 0.006 * rng.uniform(0.95, 1.05, n)
    triangles = _mesh(float(x[:, 2].max()) + 0.05)
    return Scene("hopper", x, r, 2500.0, _planes(), WIDTH * 1.01, triangles, sheets=True, load=Load(WALLS, (0, 0, -1), window=0.5))


def _planes() -> list[Plane]:
    """The flat sides of cone and cylinder, which the triangles divide."""
    slope = math.atan2(WIDTH - MOUTH, CONE)
    found = []
    for k in range(SIDES):
        angle = 2 * math.pi * (k + 0.5) / SIDES
        u, v = math.cos(angle), math.sin(angle)
        c, s = math.cos(slope), math.sin(slope)
        found.append(Plane((MOUTH * u, MOUTH * v, 0.0), (-c * u, -c * v, s)))
        found.append(Plane((WIDTH * u, WIDTH * v, 0.0), (-u, -v, 0.0)))
    return found


def _mesh(top: float) -> Array:
    """Two triangles for each side of each row; normals point to the axis."""
    cone = np.linspace(0, 1, CONE_ROWS + 1)
    upper = np.linspace(CONE, top, UPPER_ROWS + 1)[1:]
    levels = [(MOUTH + (WIDTH - MOUTH) * t, CONE * t) for t in cone] + [(WIDTH, z) for z in upper]
    angles = 2 * math.pi * np.arange(SIDES) / SIDES
    around = np.column_stack([np.cos(angles), np.sin(angles)]) / math.cos(math.pi / SIDES)
    rings = np.array([np.column_stack([r * around, np.full(SIDES, z)]) for r, z in levels])
    a, b = rings[:-1], np.roll(rings[:-1], -1, 1)
    c, d = np.roll(rings[1:], -1, 1), rings[1:]
    quads = [np.stack([a, c, b], 2), np.stack([a, d, c], 2)]
    return np.concatenate([quad.reshape(-1, 3, 3) for quad in quads])
