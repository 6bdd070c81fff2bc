"""The scenes of tests/newcomers: what is measured of each, and how its FMU is driven."""

from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[2]
FOLDER = ROOT / "tests" / "newcomers"
ACCURACIES = ("fast", "standard", "reference")
REFERENCE = ACCURACIES[-1]

# Columns of history.csv.
TIME = "time [s]"
OVERLAP = "maxOverlap [-]"
UNCONVERGED = "solver.unconvergedSteps [-]"

Course = tuple[tuple[float, float], ...]


@dataclass(frozen=True)
class Case:
    """A scene.

    `column` of its history is compared between accuracies: by its mean if the scene is `steady` at the end, else
    over time. It is exported `--until-rest` if it `rests`. `drive` gives inputs of the FMU as (time, value), linear
    between and held outside.
    """

    column: str
    steady: bool = True
    rests: bool = True
    drive: dict[str, Course] = field(default_factory=dict)

    def inputs(self, time: float) -> dict[str, float]:
        """The inputs of the FMU at a time."""
        return {name: float(np.interp(time, *zip(*course, strict=True))) for name, course in self.drive.items()}


def _lift(boundary: str) -> str:
    return f"boundary.{boundary}.averageForce[3] [N]"


OPENING = ((0.1, 0.0), (0.6, 0.06))
# The bucket tilts while it comes down, cuts forwards and slowly deeper, and comes up again.
BUCKET = {
    "boundary.bucket.translation[1]": ((1.0, 0.0), (3.0, 0.2)),
    "boundary.bucket.translation[3]": ((0.0, 0.0), (1.0, -0.11), (3.0, -0.14), (4.5, 0.0)),
    "boundary.bucket.rotation[2]": ((0.0, 0.0), (1.0, 0.5), (3.0, 0.5), (4.5, -0.3)),
}
CASES = {
    "belts": Case(
        "boundary.upper.averageForce[1] [N]",
        steady=False,
        rests=False,
        drive={"boundary.upper.surfaceVelocity[1]": ((0.0, 1.2), (1.0, 1.6), (3.0, 0.8))},
    ),
    "bin": Case(_lift("bin"), steady=False, rests=False),
    "box": Case(_lift("box")),
    "box5000": Case(_lift("box")),
    "bucket": Case(_lift("tray"), drive=BUCKET),
    "chute": Case(_lift("plate"), steady=False, rests=False),
    "cone": Case(_lift("flap"), drive={"boundary.flap.angle": ((0.1, 0.0), (1.1, 1.2))}),
    "drum": Case("boundary.drum.averageTorque[2] [N.m]", rests=False),
    "flap": Case(_lift("flap"), drive={"boundary.flap.appliedTorque": ((0.2, 0.0), (1.0, 4.5), (2.0, 4.5), (3.0, 0.0))}),
    "flow": Case("sensor.layer.stress[6] [Pa]", rests=False),
    "hopper": Case(_lift("gate"), drive={"boundary.gate.displacement": OPENING}),
    "mill": Case("boundary.mill.averageTorque[2] [N.m]", rests=False),
    "mixer": Case(_lift("vessel"), drive={"boundary.blade.angularSpeed": ((0.0, 0.0), (0.5, 2.0))}),
    "piston": Case(_lift("box"), drive={"boundary.piston.appliedForce": ((0.0, 0.0), (1.0, -30.0), (3.0, 15.0))}),
    "rolling_heap": Case(_lift("table")),
    "rolling_hopper": Case(_lift("gate"), drive={"boundary.gate.displacement": OPENING}),
    "screw": Case("boundary.screw.averageTorque[1] [N.m]", steady=False, rests=False),
    "sieve": Case(_lift("sieve"), rests=False),
    "silo": Case(_lift("floor"), steady=False),
    "sizes": Case(_lift("box")),
    "terrain": Case(_lift("ground")),
    "two_materials": Case(_lift("box")),
}
