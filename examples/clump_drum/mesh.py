"""Writes ribs.stl, the 24 ribs of a drum: radial strips of 4 mm height on a shell of 100 mm radius about the y axis.

    python examples/clump_drum/mesh.py
"""

from pathlib import Path

import numpy as np

RADIUS, HEIGHT, RIBS = 0.1, 0.004, 24
ENDS = -0.01, 0.05


def triangles():
    facets = []
    for angle in 2 * np.pi * np.arange(RIBS) / RIBS:
        out = np.array([np.cos(angle), 0.0, np.sin(angle)])
        a, b, c, d = [r * out + [0.0, y, 0.0] for r, y in zip((RADIUS, RADIUS, RADIUS - HEIGHT, RADIUS - HEIGHT), (*ENDS, *ENDS[::-1]))]
        facets += [[a, b, c], [a, c, d]]
    return np.array(facets)


def write(path):
    """Binary STL."""
    facets = triangles()
    record = np.zeros(len(facets), dtype=[("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("extra", "<u2")])
    record["corners"] = facets
    path.write_bytes(b"ribs of a drum".ljust(80) + np.uint32(len(facets)).tobytes() + record.tobytes())


if __name__ == "__main__":
    write(Path(__file__).with_name("ribs.stl"))
