"""Reads the frames of a result folder: VTU with raw appended data, as docs/results.md has them."""

from __future__ import annotations

import struct
import xml.etree.ElementTree as xml
from pathlib import Path
from typing import NamedTuple

import numpy as np

from .errors import SphereDdaError

Arrays = dict[str, np.ndarray]


class Grid(NamedTuple):
    """Points, and cells between them."""

    #: Points [m], `[n, 3]`.
    points: np.ndarray
    #: Rows of the points of all cells, one cell after the other.
    corners: np.ndarray
    #: Data of points and cells by name, `[n]` or `[n, k]`.
    arrays: Arrays


def read(path: Path) -> Grid:
    """The grid of a frame."""
    raw = path.read_bytes()
    start = raw.find(_MARK)
    data = raw.find(b"_", start + len(_MARK)) + 1
    if start < 0 or data == 0:
        raise SphereDdaError(f"`{path}`: found no raw appended data, expected a frame that sphere-dda wrote")
    try:
        root = xml.fromstring(raw[:start] + b"</VTKFile>")
        points, cells, *rest = (_arrays(root.find(f".//{section}"), raw, data) for section in _SECTIONS)
        return Grid(points["Points"], cells["connectivity"], rest[0] | rest[1])
    except (xml.ParseError, struct.error, ValueError, TypeError, KeyError) as error:
        raise SphereDdaError(f"`{path}`: damaged ({error}); restore it, or run the scene again") from error


_MARK = b'<AppendedData encoding="raw">'
_SECTIONS = ("Points", "Cells", "PointData", "CellData")


def _arrays(section: xml.Element | None, raw: bytes, data: int) -> Arrays:
    """The arrays of a section: each has its length [bytes] as u64 before its numbers."""
    arrays = {}
    for one in () if section is None else section.iter("DataArray"):
        at = data + int(one.get("offset", ""))
        (size,) = struct.unpack_from("<Q", raw, at)
        kind = np.dtype(one.get("type", "").lower()).newbyteorder("<")
        array = np.frombuffer(raw, kind, size // kind.itemsize, at + 8)
        columns = int(one.get("NumberOfComponents", "1"))
        arrays[one.get("Name", "")] = array.reshape(-1, columns) if columns > 1 else array
    return arrays
