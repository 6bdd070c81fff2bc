"""Writes stone.stl, a piece of crushed rock: the convex hull of points on an ellipsoid.

    python examples/dumper/mesh.py

Needs numpy and scipy.
"""

from pathlib import Path

import numpy as np
from scipy.spatial import ConvexHull

AXES = (100.0, 75.0, 60.0)  # half axes [mm]
CORNERS = 34


def facets():
    """Corners of the triangles [mm]: spiral points, moved a little so that no two faces are alike."""
    k = np.arange(CORNERS)
    z = 1 - (2 * k + 1) / CORNERS
    turn = k * np.pi * (3 - np.sqrt(5)) + 0.4 * np.sin(7 * k)
    around = np.sqrt(1 - z * z)
    points = np.stack([around * np.cos(turn), around * np.sin(turn), z], 1) * AXES
    return points[ConvexHull(points).simplices]


def write(path):
    """Binary STL."""
    triangles = facets()
    record = np.zeros(len(triangles), dtype=[("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("extra", "<u2")])
    record["corners"] = triangles
    path.write_bytes(b"stone".ljust(80) + np.uint32(len(triangles)).tobytes() + record.tobytes())


if __name__ == "__main__":
    write(Path(__file__).with_name("stone.stl"))
