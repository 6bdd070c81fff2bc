"""A scene as every code gets it: spheres, what holds them, what moves, and the force that is told."""

import math
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

Array = NDArray[np.float64]
Vector = tuple[float, float, float]

GRAVITY = 9.81
FRICTION = 0.5
DURATION = 1.0  # [s]
FLOOR, WALLS = "floor", "walls"  # names of the first plane of a scene, and of its other planes or its triangles


@dataclass(frozen=True)
class Plane:
    """A half-space: solid on the side that `normal` (of length 1) leaves."""

    point: Vector
    normal: Vector


@dataclass(frozen=True)
class Moving:
    """A rigid boundary that moves: planes with the spheres between them, or a box among the spheres.

    It stands still until `begin`, then has `velocity` [m/s] and turns with `spin` [rad/s] about `point`. `triangles` are the
    same faces for codes without moving planes.
    """

    name: str
    planes: tuple[Plane, ...] = ()
    box: tuple[Vector, Vector] | None = None  # lower and upper corner
    velocity: Vector = (0.0, 0.0, 0.0)
    spin: Vector = (0.0, 0.0, 0.0)
    point: Vector = (0.0, 0.0, 0.0)
    begin: float = 0.0
    triangles: Array = field(default_factory=lambda: np.empty((0, 3, 3)))

    def placed(self, time: float) -> tuple[Rotation, Array]:
        """Rotation about `point` and translation [m] at `time` [s]."""
        past = max(0.0, time - self.begin)
        return Rotation.from_rotvec(past * np.array(self.spin)), past * np.array(self.velocity)


@dataclass(frozen=True)
class Load:
    """The force (or couple about `Moving.point`) of the spheres on a boundary, along `direction`, that codes are judged by."""

    on: str
    direction: Vector
    couple: bool = False
    window: float = 0.1  # before the end, over which it is compared [s]


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
    half_length: float = 0.0  # of the box in x where that is not `half_width` [m]
    rolling: float = 0.0  # couple of rolling resistance over reduced radius and normal force [-]
    moving: Moving | None = None
    load: Load | None = None

    @property
    def mass(self) -> Array:
        """Masses [kg], (N,)."""
        return self.density * 4 / 3 * math.pi * self.radius**3

    @property
    def weight(self) -> float:
        """Weight of all spheres [N]."""
        return float(self.mass.sum()) * GRAVITY

    @property
    def rests(self) -> bool:
        """Whether it is a bed that comes to rest: its spheres lie on the first plane and none may leave."""
        return self.name in ("bed", "rolling", "polydisperse", "blade")

    @property
    def drains(self) -> bool:
        """Whether spheres run out of it below z = 0."""
        return self.name in ("funnel", "hopper")


def half_width(n: int) -> float:
    """Half the width of the square box of `n` spheres of 10 mm [m]."""
    return 0.2 * (n / 1000.0) ** (1 / 3)


def sides(a: float, b: float | None = None) -> list[Plane]:
    """Four upright planes at x = -+a and y = -+b [m]."""
    b = a if b is None else b
    return [
        Plane((-a, 0, 0), (1, 0, 0)),
        Plane((a, 0, 0), (-1, 0, 0)),
        Plane((0, -b, 0), (0, 1, 0)),
        Plane((0, b, 0), (0, -1, 0)),
    ]


def lattice(n: int, b: float, pitch: float, m: int, low: float) -> Array:
    """`n` points, `m` in a row, in layers from `low` [m] on, centred in a box of half width `b` [m]."""
    i = np.arange(n)
    edge = 0.5 * m * pitch
    return np.stack([(i % m + 0.5) * pitch - edge, (i // m % m + 0.5) * pitch - edge, low + i // (m * m) * pitch], 1)


def box_triangles(low: Vector, high: Vector) -> Array:
    """The twelve triangles of a box, normals outwards."""
    corner = np.array([[(low, high)[k >> axis & 1][axis] for axis in range(3)] for k in range(8)])
    quads = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
    return np.array([(corner[q[0]], corner[q[a]], corner[q[a + 1]]) for q in quads for a in (1, 2)])
