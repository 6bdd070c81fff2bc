"""Turns the two drums through FMI 3.0 and measures the dynamic angle of repose of spheres and of clumps.

    sphere-dda export examples/clump_drum/clump_drum.toml --fmi 3 -o clump_drum.fmu
    python examples/clump_drum/turn.py --fmu clump_drum.fmu --output clump_drum.png

The angle of the surface is that of a line through the highest grains of the middle of a bed, that of the centre of mass the angle
between gravity and the line from the drum's axis to it: both are one angle where the surface is flat. In steady rotation the mean torque
on a drum is the weight of the bed times the distance of its centre of mass from the axis. Needs fmpy, numpy and matplotlib.
"""

import argparse
import shutil
from contextlib import contextmanager
from pathlib import Path

import fmpy
import matplotlib
import numpy as np
from fmpy.fmi3 import FMU3Slave

matplotlib.use("Agg")
from matplotlib import pyplot as plt

RADIUS, DRUM, G = 5e-3, 0.1, 9.81
# The drums stand until the beds have settled.
FILL, SPEED, STEP = 0.4, 1.0, 0.01
# Group and sensor, boundary, axis [m], spheres of a grain.
BEDS = {"spheres": ("left", -0.11, 1), "clumps": ("right", 0.11, 4)}


@contextmanager
def opened(fmu):
    """An instance of the FMU that is not initialized, its variables by name, and what gives the values of one of them."""
    description = fmpy.read_model_description(str(fmu))
    variables = {v.name: v for v in description.modelVariables}
    folder = fmpy.extract(str(fmu))
    slave = FMU3Slave(
        guid=description.guid,
        unzipDirectory=folder,
        modelIdentifier=description.coSimulation.modelIdentifier,
        instanceName="grains",
    )

    def get(name):
        shape = [int(d.start) for d in variables[name].dimensions]
        values = slave.getFloat64([variables[name].valueReference], nValues=int(np.prod(shape, dtype=int)))
        return np.array(values).reshape(shape)

    slave.instantiate()
    try:
        yield slave, variables, get
        slave.terminate()
    finally:
        slave.freeInstance()
        shutil.rmtree(folder, ignore_errors=True)


def surface(x, z, slope):
    """Angle [rad] of the surface of spheres with tops at `x`, `z` [m] from a drum's axis, near `slope` [rad], and its distance from the
    axis [m].

    The highest three of each slice of a grain's width across the surface, within half a radius of the axis.
    """
    for _ in range(5):
        along, up = x * np.cos(slope) + z * np.sin(slope), z * np.cos(slope) - x * np.sin(slope)
        slices = np.arange(-DRUM / 2, DRUM / 2, 2 * RADIUS)
        own = [up[(along >= low) & (along < low + 2 * RADIUS)] for low in slices]
        tops = np.array([np.sort(heights)[-3:].mean() if len(heights) else np.nan for heights in own])
        there = np.isfinite(tops)
        slope = slope + np.arctan(np.polyfit(slices[there], tops[there], 1)[0])
    return slope, np.nanmean(tops)


def turn(fmu, stop, friction=None, results=None):
    """One row per step: time, then of each bed its mass, centre of mass from the axis (x, z), torque of the drum on it, angle of the
    surface [deg] and its distance from the axis; the spheres at the end (centre, radius); the largest overlap over the radius."""
    with opened(fmu) as (slave, variables, get):
        if friction is not None:
            slave.setFloat64([variables["friction"].valueReference], [friction])
        if results is not None:
            slave.setString([variables["output.directory"].valueReference], [str(results)])
        slave.enterInitializationMode(startTime=0.0, stopTime=stop)
        slave.exitInitializationMode()
        radius, rows, worst = get("spheres.radius"), [], 0.0
        slopes = dict.fromkeys(BEDS, 0.0)
        for k in range(round(stop / STEP)):
            speed = SPEED if k * STEP >= FILL else 0.0
            for boundary, _, _ in BEDS.values():
                slave.setFloat64([variables[f"boundary.{boundary}.angularSpeed"].valueReference], [speed])
            slave.doStep(currentCommunicationPoint=k * STEP, communicationStepSize=STEP)
            worst = max(worst, float(get("maxOverlap")))
            position, row, first = get("spheres.position"), [(k + 1) * STEP], 0
            for name, (boundary, axis, members) in BEDS.items():
                own = slice(first, first + members * (len(radius) // sum(m for _, _, m in BEDS.values())))
                first = own.stop
                centre = get(f"sensor.{name}.centreOfMass")
                slopes[name], height = surface(axis - position[own, 0], position[own, 2] + radius[own], slopes[name])
                torque = -get(f"boundary.{boundary}.averageTorque")[1]
                row += [float(get(f"sensor.{name}.mass")), axis - centre[0], centre[2], torque, np.degrees(slopes[name]), height]
            rows.append(row)
    return np.array(rows), (position, radius), worst


def steady(rows, since):
    """Of each bed over steady rotation: angles of the surface and of the centre of mass [deg], torque of the drum and of the weight [N m]."""
    late = rows[rows[:, 0] > since]
    found = {}
    for k, name in enumerate(BEDS):
        mass, across, up, torque, angle = late[:, 1 + 6 * k : 6 + 6 * k].T
        centre = np.degrees(np.arctan2(across, -up))
        found[name] = angle.mean(), angle.std(), centre.mean(), torque.mean(), (mass * G * across).mean()
    return found


def plot(rows, since, spheres, found, path):
    position, radius = spheres
    figure = plt.figure(figsize=(10, 4), layout="constrained")
    left, right = figure.subplots(1, 2, width_ratios=[2, 1.2])
    order = np.argsort(-position[:, 1])
    for i in order:
        first_clump = len(position) // 5
        grain = i if i < first_clump else (i - first_clump) // 4
        colour = plt.cm.viridis((37 * grain % 101) / 101)
        left.add_patch(plt.Circle(position[i, ::2], radius[i], facecolor=colour, edgecolor="k", linewidth=0.2))
    for k, (name, (_, axis, _)) in enumerate(BEDS.items()):
        left.add_patch(plt.Circle((axis, 0), DRUM, fill=False, linewidth=1.5))
        angle, height = np.radians(found[name][0]), rows[rows[:, 0] > since, 6 + 6 * k].mean()
        along = np.sqrt(DRUM**2 - height**2) * np.array([1.0, -1.0])
        left.plot(axis - along * np.cos(angle) + height * np.sin(angle), height * np.cos(angle) + along * np.sin(angle), "r", lw=1.5)
    left.set_title("spheres and clumps at the end, mean slopes", fontsize=9)
    left.set(xlim=(-0.22, 0.22), ylim=(-0.11, 0.11), aspect="equal")
    left.axis("off")
    for k, name in enumerate(BEDS):
        right.plot(rows[:, 0], rows[:, 5 + 6 * k], label=name)
    right.set(xlabel="time [s]", ylabel="angle of the surface [deg]", ylim=(0, 60))
    right.grid(alpha=0.3)
    right.legend()
    figure.savefig(path, dpi=110)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--fmu", type=Path, required=True)
    parser.add_argument("--output", required=True, help="picture (PNG)")
    parser.add_argument("--stop", type=float, default=8.0, help="end [s]")
    parser.add_argument("--since", type=float, default=2.0, help="begin of the means [s]")
    parser.add_argument("--friction", type=float, help="coefficient of friction instead of 0.5")
    parser.add_argument("--results", type=Path, help="folder for result files")
    given = parser.parse_args()
    rows, spheres, worst = turn(given.fmu, given.stop, given.friction, given.results)
    found = steady(rows, given.since)
    plot(rows, given.since, spheres, found, given.output)
    for name, (angle, sway, centre, torque, weight) in found.items():
        print(f"{name}: surface {angle:.1f} deg, sways by {sway:.1f} deg, centre of mass {centre:.1f} deg", end="; ")
        print(f"torque {torque:.4f} N m, of the weight {weight:.4f} N m")
    more = [found["clumps"][k] - found["spheres"][k] for k in (0, 2)]
    print(f"clumps stand {more[0]:.1f} deg steeper, their centre of mass {more[1]:.1f} deg; overlap {worst:.1e} R")


if __name__ == "__main__":
    main()
