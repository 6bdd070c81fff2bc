"""Carries a tray of grains by a rigid body that knows position and quaternion, as MultiBody and most tools for rigid bodies do.

    sphere-dda export examples/multibody/tray.toml --fmi 3 -o tray.fmu
    python examples/multibody/swing.py --fmu tray.fmu --output tray-output

The body hangs on springs and dampers and is thrown off at the start: m v' = F - k (r - r_0) - c v, I w' + w x I w = T - K phi - C w,
q' = w q / 2, with the force F and torque T of the grains about its centre of mass, averaged over the last step, and the rotation
vector phi of q; its own weight is in the rest length of the springs. Statics says where it comes to rest: m_g g / k lower, and
turned by (centre of mass of the grains - r) x weight / K. Writes tray.csv. Needs fmpy and numpy.
"""

import argparse
import shutil
from pathlib import Path

import fmpy
import numpy as np
from fmpy.fmi3 import FMU3Slave

MASS, INERTIA = 1.0, np.diag([1e-3, 2e-3, 2.5e-3])  # the inertia in the body's axes [kg, kg.m2]
STIFFNESS, DAMPING = 1000.0, 40.0  # along every axis [N/m, N.s/m]
TURNING, TURNING_DAMPING = 2.0, 0.06  # about every axis [N.m/rad, N.m.s/rad]
GRAVITY = 9.81
REST = np.array([0.0, 0.0, 0.5])  # as the scene draws it
TRAY = "boundary.tray."


def product(p, q):
    """The product of two quaternions w, x, y, z: first q, then p."""
    return np.array([p[0] * q[0] - p[1:] @ q[1:], *(p[0] * q[1:] + q[0] * p[1:] + np.cross(p[1:], q[1:]))])


def quaternion(rotation):
    """The unit quaternion of a rotation vector."""
    half = np.linalg.norm(rotation) / 2
    return np.array([np.cos(half), *(np.sinc(half / np.pi) / 2 * np.asarray(rotation))])


def rotation_vector(q):
    """The rotation vector, at most pi long, of a unit quaternion."""
    q = q if q[0] >= 0 else -q
    sine = np.linalg.norm(q[1:])
    return 2 * q[1:] if sine == 0 else 2 * np.arctan2(sine, q[0]) / sine * q[1:]


def matrix(q):
    """Columns: the body's axes in the world."""
    back = q * [1, -1, -1, -1]
    return np.array([product(product(q, np.array([0, *axis])), back)[1:] for axis in np.eye(3)]).T


class Body:
    """Position of the centre of mass, quaternion w, x, y, z, and twist, in world axes."""

    def __init__(self):
        self.position, self.orientation = REST.copy(), np.array([1.0, 0.0, 0.0, 0.0])
        self.velocity, self.spin = np.array([0.1, 0.0, 0.0]), np.array([0.0, 1.0, 4.0])

    def advance(self, h, force, torque):
        """One step with the wrench held, springs and dampers taken at its end."""
        load = force - STIFFNESS * (self.position - REST)
        self.velocity = (MASS * self.velocity + h * load) / (MASS + h * DAMPING + h**2 * STIFFNESS)
        axes = matrix(self.orientation)
        inertia = axes @ INERTIA @ axes.T
        moment = torque - TURNING * rotation_vector(self.orientation) - np.cross(self.spin, inertia @ self.spin)
        held = inertia + (h * TURNING_DAMPING + h**2 * TURNING) * np.eye(3)
        self.spin = np.linalg.solve(held, inertia @ self.spin + h * moment)
        self.position = self.position + h * self.velocity
        self.orientation = product(quaternion(h * self.spin), self.orientation)


def swing(fmu, stop=1.5, h=1e-3):
    """Runs both: a structured array with one row per step, and what statics says of the end."""
    description = fmpy.read_model_description(str(fmu))
    variables = {v.name: v for v in description.modelVariables}
    folder = fmpy.extract(str(fmu))
    slave = FMU3Slave(
        guid=description.guid,
        unzipDirectory=folder,
        modelIdentifier=description.coSimulation.modelIdentifier,
        instanceName="tray",
    )

    def get(name):
        shape = [int(d.start) for d in variables[name].dimensions]
        values = slave.getFloat64([variables[name].valueReference], nValues=int(np.prod(shape)))
        return np.array(values).reshape(shape) if shape else values[0]

    def give(name, values):
        slave.setFloat64([variables[TRAY + name].valueReference], list(values))

    body, rows, impulse = Body(), [], np.zeros(3)
    slave.instantiate()
    try:
        slave.enterInitializationMode(startTime=0.0, stopTime=stop)
        slave.exitInitializationMode()
        before = get("momentum")
        force, torque = np.zeros(3), np.zeros(3)
        for k in range(round(stop / h)):
            body.advance(h, force, torque)
            give("targetPosition", body.position)
            give("targetOrientation", body.orientation)
            slave.doStep(currentCommunicationPoint=k * h, communicationStepSize=h)
            force, torque = get(TRAY + "averageForce"), get(TRAY + "averageTorque")
            impulse += h * force
            rows.append(((k + 1) * h, *body.position, *body.orientation, *force, *torque))
        weight = get("mass") * GRAVITY * np.array([0.0, 0.0, -1.0])
        # What the grains got, they got from the tray and from gravity.
        lost = np.abs(get("momentum") - before + impulse - weight * stop).max() / np.linalg.norm(weight)
        masses = get("spheres.radius") ** 3
        centre = masses @ get("spheres.position") / masses.sum()
        slave.terminate()
    finally:
        slave.freeInstance()
        shutil.rmtree(folder, ignore_errors=True)
    names = [f"{name}[{k}]" for name, count in (("r", 3), ("q", 4), ("force", 3), ("torque", 3)) for k in range(1, count + 1)]
    table = np.array(rows, dtype=[(name, float) for name in ("time", *names)])
    turn = np.cross(centre - body.position, weight) / TURNING
    return table, {"sag": weight[2] / STIFFNESS, "turn": turn, "lost": lost}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--fmu", type=Path, default=Path("tray.fmu"))
    parser.add_argument("--output", type=Path, default=Path("tray-output"))
    arguments = parser.parse_args()
    arguments.output.mkdir(parents=True, exist_ok=True)
    table, statics = swing(arguments.fmu)
    np.savetxt(arguments.output / "tray.csv", table, delimiter=",", header=",".join(table.dtype.names), comments="")
    last = table[-1]
    turn = rotation_vector(np.array([last[f"q[{k}]"] for k in (1, 2, 3, 4)]))
    print(f"sag {1e3 * (last['r[3]'] - REST[2]):.4f} mm, statics {1e3 * statics['sag']:.4f} mm")
    print(f"turn {np.degrees(turn).round(4)} deg, statics {np.degrees(statics['turn']).round(4)} deg")
    print(f"impulse that got lost between the two: {statics['lost']:.1e} s of the weight")


if __name__ == "__main__":
    main()
