"""Hangs a bucket of grains on springs: a rigid body of six degrees of freedom here, the grains in an FMU of FMI 3.0.

    sphere-dda export examples/bucket/bucket.toml --fmi 3 -o bucket.fmu
    python examples/bucket/hang.py --fmu bucket.fmu --output bucket-output

The body's centre of mass is the boundary's point of action. m v' = F - k x - c v and I w' + w x I w = T - K r - C w,
with the force F and torque T of the grains averaged over the last step; the bucket's own weight is in the rest length
of the springs. What the bucket comes to rest at is known from statics: sag m_g g / k, and a tilt r that solves
K r = (centre of mass of the grains - point of action) x weight. Writes bucket.csv and bucket.png. Needs fmpy, numpy and
matplotlib.
"""

import argparse
import shutil
from pathlib import Path

import fmpy
import numpy as np
from fmpy.fmi3 import FMU3Slave

MASS, INERTIA = 2.0, np.array([2e-3, 4e-3, 4e-3])  # [kg, kg.m2]
STIFFNESS, DAMPING = 2000.0, 80.0  # of the suspension, along every axis [N/m, N.s/m]
TURNING, TURNING_DAMPING = 4.0, 0.12  # about every axis [N.m/rad, N.m.s/rad]
GRAVITY = 9.81
BUCKET = "boundary.bucket."


def rotated(rotation, vector):
    """The vector turned by a rotation vector (Rodrigues)."""
    angle = np.linalg.norm(rotation)
    if angle == 0:
        return vector
    axis = rotation / angle
    across = np.cross(axis, vector)
    return vector + np.sin(angle) * across + (1 - np.cos(angle)) * np.cross(axis, across)


class Body:
    """The bucket: displacement, rotation vector and twist, in world axes."""

    def __init__(self):
        self.place, self.turn, self.velocity, self.spin = np.zeros((4, 3))

    def advance(self, h, force, torque):
        """One step with the wrench held: forces at the new place (implicit Euler), the turn still small."""
        load = force - STIFFNESS * self.place
        self.velocity = (MASS * self.velocity + h * load) / (MASS + h * DAMPING + h**2 * STIFFNESS)
        moment = torque - TURNING * self.turn - np.cross(self.spin, INERTIA * self.spin)
        self.spin = (INERTIA * self.spin + h * moment) / (INERTIA + h * TURNING_DAMPING + h**2 * TURNING)
        self.place = self.place + h * self.velocity
        # Turns do not add up as vectors: the new one acts on a frame that is turned already.
        frame = np.array([rotated(h * self.spin, rotated(self.turn, axis)) for axis in np.eye(3)]).T
        self.turn = rotation_vector(frame)


def rotation_vector(frame):
    """The rotation vector, shorter than pi, of a rotation matrix."""
    axis = np.array([frame[2, 1] - frame[1, 2], frame[0, 2] - frame[2, 0], frame[1, 0] - frame[0, 1]]) / 2
    sine, cosine = np.linalg.norm(axis), (np.trace(frame) - 1) / 2
    return axis if sine == 0 else axis / sine * np.arctan2(sine, cosine)


def hang(fmu, stop=1.5, h=1e-3):
    """Runs both: a structured array with one row per step, and what statics says of the end."""
    description = fmpy.read_model_description(str(fmu))
    variables = {v.name: v for v in description.modelVariables}
    folder = fmpy.extract(str(fmu))
    slave = FMU3Slave(
        guid=description.guid,
        unzipDirectory=folder,
        modelIdentifier=description.coSimulation.modelIdentifier,
        instanceName="bucket",
    )

    def get(name):
        shape = [int(d.start) for d in variables[name].dimensions]
        count = int(np.prod(shape)) if shape else 1
        values = slave.getFloat64([variables[name].valueReference], nValues=count)
        return np.array(values).reshape(shape) if shape else values[0]

    def set_(name, values):
        slave.setFloat64([variables[name].valueReference], list(values))

    body, rows, impulse = Body(), [], np.zeros(3)
    slave.instantiate()
    try:
        slave.enterInitializationMode(startTime=0.0, stopTime=stop)
        slave.exitInitializationMode()
        before = get("momentum")
        force, torque = np.zeros(3), np.zeros(3)
        for k in range(round(stop / h)):
            body.advance(h, force, torque)
            set_(BUCKET + "velocity", body.velocity)
            set_(BUCKET + "angularVelocity", body.spin)
            slave.doStep(currentCommunicationPoint=k * h, communicationStepSize=h)
            force, torque = get(BUCKET + "averageForce"), get(BUCKET + "averageTorque")
            impulse += h * force
            rows.append(((k + 1) * h, *body.place, *body.turn, *force, *torque))
        weight = get("mass") * GRAVITY * np.array([0.0, 0.0, -1.0])
        # What the grains got, they got from the bucket and from gravity.
        lost = np.abs(get("momentum") - before + impulse - weight * stop).max() / np.linalg.norm(weight)
        masses = get("spheres.radius") ** 3
        centre = masses @ get("spheres.position") / masses.sum()
        arm = centre - (body.place + np.array([0.0, 0.0, 0.03]))
        slave.terminate()
    finally:
        slave.freeInstance()
        shutil.rmtree(folder, ignore_errors=True)
    names = [f"{name}[{axis}]" for name in ("place", "turn", "force", "torque") for axis in (1, 2, 3)]
    table = np.array(rows, dtype=[(name, float) for name in ("time", *names)])
    return table, {"sag": weight[2] / STIFFNESS, "turn": np.cross(arm, weight) / TURNING, "lost": lost}


def plot(table, statics, path):
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    figure, (left, right) = plt.subplots(1, 2, figsize=(9, 3.5), layout="constrained")
    left.plot(table["time"], 1e3 * table["place[3]"])
    left.axhline(1e3 * statics["sag"], color="grey", linestyle=":")
    left.set_ylabel("height [mm]")
    for axis, name in enumerate("xyz", start=1):
        right.plot(table["time"], np.degrees(table[f"turn[{axis}]"]), label=f"about {name}")
    for turn in statics["turn"]:
        right.axhline(np.degrees(turn), color="grey", linestyle=":")
    right.set_ylabel("turn [deg]")
    right.legend()
    for axes in (left, right):
        axes.set_xlabel("time [s]")
        axes.grid(alpha=0.3)
    figure.savefig(path, dpi=120)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--fmu", type=Path, default=Path("bucket.fmu"))
    parser.add_argument("--output", type=Path, default=Path("bucket-output"))
    arguments = parser.parse_args()
    arguments.output.mkdir(parents=True, exist_ok=True)
    table, statics = hang(arguments.fmu)
    header = ",".join(table.dtype.names)
    np.savetxt(arguments.output / "bucket.csv", table, delimiter=",", header=header, comments="")
    plot(table, statics, arguments.output / "bucket.png")
    last = table[-1]
    turn = [last[f"turn[{axis}]"] for axis in (1, 2, 3)]
    print(f"sag {1e3 * last['place[3]']:.4f} mm, statics {1e3 * statics['sag']:.4f} mm")
    print(f"turn {np.degrees(turn).round(4)} deg, statics {np.degrees(statics['turn']).round(4)} deg")
    print(f"impulse that got lost between the two: {statics['lost']:.1e} s of the weight")


if __name__ == "__main__":
    main()
