"""Static angle of repose of spheres and of clumps through FMI 3.0: slopes that stay when a wall is lifted, for several packings.

    sphere-dda export examples/clump_drum/clump_repose.toml --fmi 3 -o clump_repose.fmu
    python examples/clump_drum/repose.py --fmu clump_repose.fmu --output clump_repose.png

The angle is that of a line through the highest grains of slices of one and a half grains, without those at the wall and the edge.
Friction and seed are parameters of the FMU. Needs fmpy, numpy and matplotlib.
"""

import argparse

import matplotlib
import numpy as np

matplotlib.use("Agg")
from matplotlib import pyplot as plt
from turn import RADIUS, STEP, opened

LENGTH = 0.12
# Boxes: where they are across [m].
BOXES = {"spheres": (0.0, 0.03), "clumps": (0.04, 0.07)}


def run(fmu, seed, friction, stop):
    """Centres [m] and radii [m] of the spheres at the end, which of them are still there, their largest speed [m/s]; the largest
    overlap over the radius."""
    with opened(fmu) as (slave, variables, get):
        slave.setInt32([variables["seed"].valueReference], [seed])
        slave.setFloat64([variables["friction"].valueReference], [friction])
        slave.enterInitializationMode(startTime=0.0, stopTime=stop)
        slave.exitInitializationMode()
        worst = 0.0
        for k in range(round(stop / STEP)):
            slave.doStep(currentCommunicationPoint=k * STEP, communicationStepSize=STEP)
            worst = max(worst, float(get("maxOverlap")))
        position, radius = get("spheres.position"), get("spheres.radius")
        speed = np.linalg.norm(get("spheres.velocity"), axis=1)
    # The sink takes what has fallen off the edge; grains on their way are not the slope.
    there = (position[:, 0] < LENGTH) & (position[:, 2] > 0.0)
    return position, radius, there, speed[there].max(), worst


def slope(position, radius, there, box):
    """Angle of the surface in a box [deg], and its points (distance from the wall, height) [m]."""
    low, high = box
    own = there & (position[:, 1] > low) & (position[:, 1] < high)
    along, top = position[own, 0], (position[own, 2] + radius[own])
    width = 3 * RADIUS
    edges = width * np.arange(int(LENGTH / width))
    tops = [np.sort(top[(along >= low) & (along < low + width)])[-5:].mean() for low in edges]
    points = np.array([edges + width / 2, tops])[:, 1:-1]
    return np.degrees(np.arctan(-np.polyfit(*points, 1)[0])), points


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--fmu", required=True)
    parser.add_argument("--output", required=True, help="picture (PNG)")
    parser.add_argument("--packings", type=int, default=4)
    parser.add_argument("--friction", type=float, default=0.5)
    parser.add_argument("--stop", type=float, default=5.0, help="end [s]")
    given = parser.parse_args()
    angles = {name: [] for name in BOXES}
    figure, axes = plt.subplots(figsize=(6.4, 4.0), layout="constrained")
    for seed in range(1, given.packings + 1):
        *spheres, speed, worst = run(given.fmu, seed, given.friction, given.stop)
        for (name, box), colour in zip(BOXES.items(), ("tab:blue", "tab:orange")):
            angle, points = slope(*spheres, box)
            angles[name].append(angle)
            axes.plot(*1e3 * points, "o-", color=colour, alpha=0.6, label=name if seed == 1 else None)
        told = ", ".join(f"{name} {found[-1]:.1f} deg" for name, found in angles.items())
        print(f"packing {seed}: {told}; fastest {speed:.1e} m/s, overlap {worst:.1e} R", flush=True)
    for name, found in angles.items():
        error = np.std(found, ddof=1) / np.sqrt(len(found)) if len(found) > 1 else float("nan")
        print(f"{name}: {np.mean(found):.1f} +- {error:.1f} deg")
    axes.set(xlabel="distance from the wall [mm]", ylabel="height [mm]", aspect="equal")
    axes.grid(alpha=0.3)
    axes.legend()
    figure.savefig(given.output, dpi=120)


if __name__ == "__main__":
    main()
