"""The loaded contacts of a simulation: what the FMU's binary `contacts.document` holds, as arrays."""

from __future__ import annotations

import struct
from dataclasses import dataclass, field

import numpy as np

from .errors import SimulationError

_HEADER = struct.Struct("<8sIQd")
_MAGIC, _VERSION = b"SDDACON\0", 1
_RECORD = np.dtype(
    [
        ("bodies", "<i8", 2), ("position", "<f8", 3), ("normal", "<f8", 3), ("force", "<f8", 3), ("torque", "<f8", 3),
        ("gap", "<f8"),
    ]
)


@dataclass(frozen=True, eq=False)
class Contacts:
    """The contacts that carry a force or overlap, `n` of them, one for each row. Forces are means of the last internal step.

    The arrays are views of one block of memory that nothing overwrites: they stay as they are when the simulation goes on.
    """

    #: Time [s].
    time: float
    #: All columns as one structured array `[n]`, with the names below.
    table: np.ndarray = field(repr=False)

    @property
    def bodies(self) -> np.ndarray:
        """Row of the sphere; row of the other sphere, or -1 - index of the boundary in the scene's order, `[n, 2]`."""
        return self.table["bodies"]

    @property
    def position(self) -> np.ndarray:
        """Closest point on the other body [m], `[n, 3]`; in a periodic cell that of the copy beside the sphere."""
        return self.table["position"]

    @property
    def normal(self) -> np.ndarray:
        """Unit normal from the other body to the sphere, `[n, 3]`."""
        return self.table["normal"]

    @property
    def force(self) -> np.ndarray:
        """Force on the sphere [N], `[n, 3]`; its opposite acts on the other body."""
        return self.table["force"]

    @property
    def torque(self) -> np.ndarray:
        """Couple of rolling and twisting resistance on the sphere [N m], `[n, 3]`; its opposite acts on the other body."""
        return self.table["torque"]

    @property
    def gap(self) -> np.ndarray:
        """Gap [m], `[n]`; negative: overlap."""
        return self.table["gap"]

    def __len__(self) -> int:
        return len(self.table)

    @classmethod
    def read(cls, document: bytes) -> Contacts:
        """The contacts of a `contacts.document`, layout in docs/fmu.md#fmi-30.

        Raises:
            SimulationError: bytes that are none.
        """
        try:
            magic, version, count, time = _HEADER.unpack_from(document)
            if (magic, version) != (_MAGIC, _VERSION):
                raise ValueError(f"begins with {magic!r}, version {version}")
            if len(document) != _HEADER.size + count * _RECORD.itemsize:
                raise ValueError(f"has {len(document)} bytes for {count} contacts")
            return cls(time, np.frombuffer(document, _RECORD, count, _HEADER.size))
        except (struct.error, ValueError) as error:
            raise SimulationError(f"contacts.document: {error}; expected {_MAGIC!r}, version {_VERSION}") from error
