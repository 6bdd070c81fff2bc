"""Turns a drum of grains with a motor of a straight torque-speed curve: speed out, torque in.

    sphere-dda export examples/drum/drum.toml -o drum.fmu
    python examples/drum/turn.py --fmu drum.fmu --output drum-output

The motor gives T = stall (1 - w / idle). Nothing must be lost between it and the grains: J (w - w_0) is the sum of
h (T + torque of the grains), up to what acts in half a step of the solver, by which velocities and impulses are apart;
and while the drum turns steadily, both torques are the same on average, on the motor's curve: grains slide down one by
one and the speed sways by 0.1 rad/s, so the average is taken over 10 s. Writes drum.csv and drum.png. Needs fmpy, numpy
and matplotlib.
"""

import argparse
import shutil
from pathlib import Path

import fmpy
import numpy as np
from fmpy.fmi2 import FMU2Slave

STALL, IDLE = 0.25, 6.0  # torque at rest [N.m], speed without load [rad/s]
INERTIA = 0.01  # of the drum about its hinge [kg.m2]
DRUM = "boundary.drum."
OUTPUTS = [DRUM + "angularVelocity[2]", DRUM + "averageTorque[2]"]


def turn(fmu, stop=12.0, h=1e-3):
    """A structured array, one row per step: time, torque of the motor held over the step, outputs at its end."""
    description = fmpy.read_model_description(str(fmu))
    reference = {v.name: v.valueReference for v in description.modelVariables}
    folder = fmpy.extract(str(fmu))
    slave = FMU2Slave(
        guid=description.guid,
        unzipDirectory=folder,
        modelIdentifier=description.coSimulation.modelIdentifier,
        instanceName="drum",
    )
    slave.instantiate()
    rows = []
    try:
        slave.setupExperiment(startTime=0.0, stopTime=stop)
        slave.enterInitializationMode()
        slave.exitInitializationMode()
        outputs = [reference[name] for name in OUTPUTS]
        values = slave.getReal(outputs)
        rows.append((0.0, 0.0, *values))
        for k in range(round(stop / h)):
            torque = STALL * (1 - values[0] / IDLE)
            slave.setReal([reference[DRUM + "appliedTorque"]], [torque])
            slave.doStep(currentCommunicationPoint=k * h, communicationStepSize=h)
            values = slave.getReal(outputs)
            rows.append(((k + 1) * h, torque, *values))
        slave.terminate()
    finally:
        slave.freeInstance()
        shutil.rmtree(folder, ignore_errors=True)
    return np.array(rows, dtype=[(name, float) for name in ("time", "motor", *OUTPUTS)])


def balance(table):
    """What is missing at most in the drum's angular momentum [N.m.s], and what acts at most in half a step [N.m.s]."""
    h = np.diff(table["time"])
    speed, motor, grains = (table[name] for name in (DRUM + "angularVelocity[2]", "motor", DRUM + "averageTorque[2]"))
    missing = INERTIA * (speed[1:] - speed[0]) - np.cumsum(h * (motor + grains)[1:])
    half = 0.5 * h * (np.abs(motor) + np.abs(grains))[1:]
    return np.abs(missing).max(), half.max()


def steady(table, since=2.0):
    """Mean speed [rad/s], mean torque of motor and grains [N.m] from `since` [s] on."""
    late = table[table["time"] > since]
    return tuple(late[name].mean() for name in (DRUM + "angularVelocity[2]", "motor", DRUM + "averageTorque[2]"))


def plot(table, path):
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    figure, (left, right) = plt.subplots(1, 2, figsize=(9, 3.5), layout="constrained")
    left.plot(table["time"], table[DRUM + "angularVelocity[2]"])
    left.set_xlabel("time [s]")
    left.set_ylabel("speed of the drum [rad/s]")
    window = np.ones(100) / 100
    for name, label in (("motor", "motor"), (DRUM + "averageTorque[2]", "- grains")):
        sign = -1 if label.startswith("-") else 1
        right.plot(table["time"], sign * np.convolve(table[name], window, "same"), label=label)
    right.set_xlabel("time [s]")
    right.set_ylabel("torque, mean over 0.1 s [N.m]")
    right.legend()
    for axes in (left, right):
        axes.grid(alpha=0.3)
    figure.savefig(path, dpi=120)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--fmu", type=Path, default=Path("drum.fmu"))
    parser.add_argument("--output", type=Path, default=Path("drum-output"))
    arguments = parser.parse_args()
    arguments.output.mkdir(parents=True, exist_ok=True)
    table = turn(arguments.fmu)
    header = ",".join(table.dtype.names)
    np.savetxt(arguments.output / "drum.csv", table, delimiter=",", header=header, comments="")
    plot(table, arguments.output / "drum.png")
    speed, motor, grains = steady(table)
    print(f"steady: {speed:.4f} rad/s, motor {motor:.5f} N.m, grains {grains:.5f} N.m")
    print(f"the motor's curve at that speed: {STALL * (1 - speed / IDLE):.5f} N.m")
    missing, half = balance(table)
    print(f"angular momentum: {missing:.1e} N.m.s are missing at most; in half a step act up to {half:.1e} N.m.s")


if __name__ == "__main__":
    main()
