"""Writes the meshes and the terrain of the newcomers' scenes beside them, as a CAD or GIS program would: `python make.py`."""

import math
from pathlib import Path

HERE = Path(__file__).resolve().parent


def main(folder=HERE):
    """Writes all files into `folder`."""
    meshes = {"silo_floor": silo_floor(), "hopper": hopper(), "screw": screw(), "sieve": sieve()}
    for name, triangles in meshes.items():
        (folder / f"{name}.stl").write_text(stl(name, triangles))
    (folder / "terrain.asc").write_text(terrain())


def quad(a, b, c, d):
    """Two triangles of a quadrilateral whose corners are given in order."""
    return [(a, b, c), (a, c, d)]


def silo_floor(outer=80.0, inner=42.0, parts=32):
    """A disc with a hole at z = 0 [mm]."""

    def point(radius, k):
        angle = 2 * math.pi * k / parts
        return (radius * math.cos(angle), radius * math.sin(angle), 0.0)

    # The straight edges of the disc must not leave a gap to the round wall.
    outer /= math.cos(math.pi / parts)
    return [t for k in range(parts) for t in quad(point(inner, k), point(outer, k), point(outer, k + 1), point(inner, k + 1))]


def hopper(outlet=60.0, width=200.0, cone=100.0, top=400.0):
    """A square bin over a square pyramid with an outlet at z = 0 [mm]."""

    def ring(edge, z):
        return [(x * edge / 2, y * edge / 2, z) for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1))]

    rings = [ring(outlet, 0.0), ring(width, cone), ring(width, top)]
    triangles = []
    for low, high in zip(rings, rings[1:], strict=False):
        for k in range(4):
            triangles += quad(low[k], low[k - 3], high[k - 3], high[k])
    return triangles


def screw(inner=15.0, outer=57.0, pitch=120.0, turns=4, parts=20):
    """A right-handed helicoid about the x axis from x = 0 [mm]."""

    def point(radius, k):
        angle = 2 * math.pi * k / parts
        return (pitch * k / parts, radius * math.cos(angle), radius * math.sin(angle))

    return [t for k in range(turns * parts) for t in quad(point(inner, k), point(outer, k), point(outer, k + 1), point(inner, k + 1))]


def sieve(length=240.0, width=160.0, bar=6.0, gap=18.0):
    """Flat bars along y, side by side along x, at z = 0 [mm]."""
    triangles, x = [], 0.0
    while x < length:
        triangles += quad((x, 0.0, 0.0), (x + bar, 0.0, 0.0), (x + bar, width, 0.0), (x, width, 0.0))
        x += bar + gap
    return triangles


def stl(name, triangles):
    """The triangles as an ASCII STL file."""
    lines = [f"solid {name}"]
    for triangle in triangles:
        lines += ["facet normal 0 0 0", "outer loop"]
        lines += ["vertex {:.3f} {:.3f} {:.3f}".format(*corner) for corner in triangle]
        lines += ["endloop", "endfacet"]
    return "\n".join([*lines, f"endsolid {name}"]) + "\n"


def terrain(cells=41, size=1.0):
    """An ESRI ASCII grid of a hollow with a slope and waves, in map coordinates [m]."""
    lines = [f"ncols {cells}", f"nrows {cells}", "xllcenter 511990", "yllcenter 5404990", f"cellsize {size}", "NODATA_value -9999"]
    for row in reversed(range(cells)):
        heights = []
        for column in range(cells):
            x, y = column * size - 20.0, row * size - 20.0
            height = 300.0 + 0.02 * (x * x + y * y) + 0.05 * x + 0.15 * math.sin(1.1 * x) * math.cos(0.9 * y)
            heights.append(f"{height:.3f}")
        lines.append(" ".join(heights))
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    main()
