"""Runs the belt conveyor at two speeds through FMI and draws the force, the power and the load of its drive.

    sphere-dda export examples/conveyor/conveyor.toml -o conveyor.fmu
    python examples/conveyor/drive.py --fmu conveyor.fmu --output conveyor.png

In steady operation the belt brings every grain from rest to its speed v: the drive's force is the mass flow Q times v, its power Q v^2. Needs fmpy, numpy and matplotlib.
"""

import argparse

import fmpy
import matplotlib
import numpy as np

matplotlib.use("Agg")
from matplotlib import pyplot as plt

SPEED = "boundary.belt.surfaceVelocity[1]"
FORCE = "boundary.belt.averageForce[1]"
OUTPUTS = [FORCE, "sensor.head.mass", "sensor.carried.mass", "maxOverlap"]
# The belt speeds up from 0.6 m/s to 1.2 m/s within half a second.
COMMAND = [(0.0, 0.6), (4.0, 0.6), (4.5, 1.2), (8.0, 1.2)]
STEADY = [(2.5, 4.0), (6.0, 8.0)]


def simulate(fmu):
    """Outputs every communication step, with the belt's speed."""
    command = np.array(COMMAND, dtype=[("time", float), (SPEED, float)])
    table = fmpy.simulate_fmu(
        fmu,
        stop_time=COMMAND[-1][0],
        output_interval=5e-3,
        input=command,
        output=OUTPUTS,
        start_values={SPEED: COMMAND[0][1]},
    )
    return table, np.interp(table["time"], command["time"], command[SPEED])


def steady(table, speed, start, stop):
    """Mass flow [kg/s], mean force of the drive [N], mean mass on the belt [kg] and speed [m/s] between two times."""
    part = (table["time"] > start) & (table["time"] <= stop)
    left = table["sensor.head.mass"][part]
    flow = (left[-1] - left[0]) / (table["time"][part][-1] - table["time"][part][0])
    return flow, -table[FORCE][part].mean(), table["sensor.carried.mass"][part].mean(), speed[part].mean()


def plot(table, speed, path):
    time = table["time"]
    smooth = lambda y: np.convolve(y, np.ones(100) / 100, mode="same")
    figure, axes = plt.subplots(3, 1, sharex=True, figsize=(8, 7), layout="constrained")
    axes[0].plot(time, speed, color="tab:gray")
    axes[0].set_ylabel("belt speed [m/s]")
    force = smooth(-table[FORCE])[50:-50]
    axes[1].plot(time[50:-50], force, color="tab:blue", label="force [N], mean of 0.5 s")
    axes[1].plot(time[50:-50], force * speed[50:-50], color="tab:red", label="power [W]")
    axes[1].set_ylim(0, None)
    for start, stop in STEADY:
        flow, _, _, v = steady(table, speed, start, stop)
        axes[1].plot([start, stop], 2 * [flow * v], "k--", lw=1, label="Q v" if start == STEADY[0][0] else None)
    axes[1].legend(loc="upper left", fontsize="small")
    axes[2].plot(time, table["sensor.carried.mass"], color="tab:green")
    axes[2].set_ylabel("mass on the belt [kg]")
    axes[2].set_xlabel("time [s]")
    for axis in axes:
        axis.grid(alpha=0.3)
    figure.savefig(path, dpi=130)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--fmu", required=True, help="the exported conveyor")
    parser.add_argument("--output", default="conveyor.png", help="the picture")
    arguments = parser.parse_args()

    table, speed = simulate(arguments.fmu)
    for start, stop in STEADY:
        flow, force, carried, v = steady(table, speed, start, stop)
        print(f"{v:.2f} m/s: flow {flow:.3f} kg/s, force {force:.3f} N, Q v {flow * v:.3f} N, on the belt {carried:.3f} kg")
    plot(table, speed, arguments.output)
    print(f"overlap at most {table['maxOverlap'].max():.1e} radii; wrote {arguments.output}")


if __name__ == "__main__":
    main()
