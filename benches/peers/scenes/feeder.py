"""Grains on the vibrating trough of examples/feeder, without its bin."""

import math

import numpy as np

from scenes.scene import Array, Load, Moving, Scene

LENGTH, HALF_WIDTH, HEIGHT = 0.6, 0.075, 0.08  # of the trough [m]
AMPLITUDE, FREQUENCY = 0.0015, 20.0  # along the line of vibration [m], [Hz]
LINE = (math.cos(math.radians(30)), 0.0, 0.5)  # 30 degrees above the horizontal


def feeder(n: int, seed: int) -> Scene:
    """Two layers of grains; the trough is open at its front."""
    rng = np.random.default_rng(seed)
    k = np.arange(n)
    columns = -(-n // 10)
    x = np.column_stack([0.05 + 0.022 * (k // 10), 0.022 * (k % 5 - 2), 0.011 + 0.022 * (k // 5 % 2)])
    x += rng.uniform(-0.0008, 0.0008, (n, 3))
    if 0.05 + 0.022 * columns > LENGTH:
        raise ValueError(f"the trough of {LENGTH} m does not hold {n} grains")
    r = 0.009 * rng.uniform(0.9, 1.1, n)
    trough = Moving("trough", triangles=_mesh())
    return Scene("feeder", x, r, 2500.0, [], HALF_WIDTH, sheets=True, moving=trough, load=Load("trough", (0, 0, -1), window=0.5))


def displacement(time: float) -> float:
    """Of the trough along `LINE` at `time` [s], [m]."""
    return AMPLITUDE * math.sin(2 * math.pi * FREQUENCY * time)


def _mesh() -> Array:
    """Floor, two sides and the back."""
    w, h, length = HALF_WIDTH, HEIGHT, LENGTH
    quads = [
        ((0, -w, 0), (length, -w, 0), (length, w, 0), (0, w, 0)),
        ((0, -w, 0), (length, -w, 0), (length, -w, h), (0, -w, h)),
        ((0, w, 0), (length, w, 0), (length, w, h), (0, w, h)),
        ((0, -w, 0), (0, w, 0), (0, w, h), (0, -w, h)),
    ]
    return np.array([(q[0], q[k], q[k + 1]) for q in quads for k in (1, 2)], float)
