"""Writes valley.asc, the synthetic valley of the landslide example: python examples/landslide/valley.py

Height in metres at x along and y across the valley:

    z = 90 exp(-x/80)                            a slope of 48 degrees at its top, 5 at its foot
      + 25 (1 - exp(-((y - c)/w)^2))             a channel of width w = 22 + x/10 ...
                                                 ... that winds: c = 80 + 14 sin(x/40)
      + 0.015 max(0, x - 190)^2                  the opposite slope
      + 0.4 sin(0.9 x) sin(0.7 y)                roughness
"""

import math
from pathlib import Path

COLUMNS, ROWS, CELL = 120, 80, 2.0
# South-western corner on the map [m].
EAST, NORTH = 3456000.0, 5678000.0


def height(x, y):
    centre, width = 80 + 14 * math.sin(x / 40), 22 + x / 10
    channel = 25 * (1 - math.exp(-(((y - centre) / width) ** 2)))
    opposite = 0.015 * max(0.0, x - 190) ** 2
    return 90 * math.exp(-x / 80) + channel + opposite + 0.4 * math.sin(0.9 * x) * math.sin(0.7 * y)


def grid():
    yield from (f"ncols {COLUMNS}", f"nrows {ROWS}", f"xllcorner {EAST:.0f}", f"yllcorner {NORTH:.0f}", f"cellsize {CELL:.0f}")
    yield "NODATA_value -9999"
    for row in reversed(range(ROWS)):
        yield " ".join(f"{height((column + 0.5) * CELL, (row + 0.5) * CELL):.3f}" for column in range(COLUMNS))


if __name__ == "__main__":
    Path(__file__).with_name("valley.asc").write_text("\n".join(grid()) + "\n")
