"""Writes chute.stl, the liner of the chute: a trough that bends from 65 degrees down to 20 degrees below the horizontal.

    python examples/chute/mesh.py

The bottom is an arc of a circle, the sides lean outwards. Cells are about 4 cm long: the wear map is as fine as its triangles.
"""

from pathlib import Path

import numpy as np

STEEP, FLAT = np.radians([65.0, 20.0])
RADIUS, WIDTH, HEIGHT, LEAN = 1.2, 0.3, 0.18, 0.05
ALONG, ACROSS, UP = 28, 8, 4


def point(u, v):
    """Along the chute, 0 to 1; across it, -1 to 1: the middle half is the bottom, the rest are the sides."""
    slope = STEEP + u * (FLAT - STEEP)
    x, z = RADIUS * (np.sin(STEEP) - np.sin(slope)), RADIUS * (np.cos(FLAT) - np.cos(slope))
    side = np.sign(v) * max(2 * abs(v) - 1, 0)
    y = WIDTH / 2 * np.clip(2 * v, -1, 1) + LEAN * side
    rise = HEIGHT * abs(side)
    return np.array([x + rise * np.sin(slope), y, z + rise * np.cos(slope)])


def triangles():
    across = np.concatenate([np.linspace(-1, -0.5, UP, False), np.linspace(-0.5, 0.5, ACROSS, False), np.linspace(0.5, 1, UP + 1)])
    grid = np.array([[point(u, v) for v in across] for u in np.linspace(0, 1, ALONG + 1)])
    a, b, c, d = grid[:-1, :-1], grid[1:, :-1], grid[1:, 1:], grid[:-1, 1:]
    return np.stack([np.stack([a, b, c], -2), np.stack([a, c, d], -2)], 2).reshape(-1, 3, 3)


def write(path):
    """Binary STL."""
    facets = triangles()
    record = np.zeros(len(facets), dtype=[("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("extra", "<u2")])
    record["corners"] = facets
    path.write_bytes(b"chute liner".ljust(80) + np.uint32(len(facets)).tobytes() + record.tobytes())


if __name__ == "__main__":
    write(Path(__file__).with_name("chute.stl"))
