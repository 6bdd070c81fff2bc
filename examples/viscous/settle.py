"""Lets beads settle in a viscous fluid: buoyancy and Stokes drag are computed here, from the velocities that the FMU reports.

    sphere-dda export examples/viscous/viscous.toml --fmi 3 -o viscous.fmu
    python examples/viscous/settle.py --fmu viscous.fmu --output viscous.png

The coupling is one-way: the fluid rests. Needs fmpy, numpy and matplotlib.
"""

import argparse
import shutil

import fmpy
import matplotlib
import numpy as np
from fmpy.fmi3 import FMU3Slave

matplotlib.use("Agg")
from matplotlib import pyplot as plt

STEP, G = 1e-3, 9.81
BEADS = 2500.0
# Glycerol.
DENSITY, VISCOSITY = 1260.0, 1.0


def terminal(radius):
    """Speed at which drag and buoyancy balance the weight [m/s]: 2/9 (rho_s - rho_f) g R^2/mu."""
    return 2 / 9 * (BEADS - DENSITY) * G * radius**2 / VISCOSITY


def settle(fmu, stop):
    """Times [s], heights and vertical velocities of all beads [m, m/s], radii [m], work of the fluid's forces [J]."""
    description = fmpy.read_model_description(str(fmu))
    reference = {v.name: v.valueReference for v in description.modelVariables}
    folder = fmpy.extract(str(fmu))
    slave = FMU3Slave(
        guid=description.guid,
        unzipDirectory=folder,
        modelIdentifier=description.coSimulation.modelIdentifier,
        instanceName="viscous",
    )

    def get(name, width=1):
        return np.array(slave.getFloat64([reference[name]], nValues=width * len(radius))).reshape(-1, width)

    slave.instantiate()
    try:
        slave.enterInitializationMode(startTime=0.0, stopTime=stop)
        beads = slave.getInt32([reference["sphereCount"]])[0]
        radius = np.array(slave.getFloat64([reference["spheres.radius"]], nValues=beads))
        buoyancy = DENSITY * 4 / 3 * np.pi * radius**3 * G
        drag = 6 * np.pi * VISCOSITY * radius

        def push():
            force = -drag[:, None] * get("spheres.velocity", 3)
            force[:, 2] += buoyancy
            slave.setFloat64([reference["spheres.appliedForce"]], force.ravel())

        # The accelerations at t = 0 are those with the fluid's forces.
        push()
        slave.exitInitializationMode()
        times, heights, velocities = [0.0], [get("spheres.position", 3)[:, 2]], [np.zeros(beads)]
        for k in range(round(stop / STEP)):
            push()
            slave.doStep(currentCommunicationPoint=k * STEP, communicationStepSize=STEP)
            times.append((k + 1) * STEP)
            heights.append(get("spheres.position", 3)[:, 2])
            velocities.append(get("spheres.velocity", 3)[:, 2])
        work = slave.getFloat64([reference["loadWork"]])[0]
        slave.terminate()
    finally:
        slave.freeInstance()
        shutil.rmtree(folder, ignore_errors=True)
    return np.array(times), np.array(heights), np.array(velocities), radius, work


def plot(times, heights, velocities, radius, path):
    figure, axes = plt.subplots(1, 2, figsize=(9, 3.4), layout="constrained")
    for size, colour in zip(np.unique(radius)[::-1], ("C0", "C1")):
        of_size = radius == size
        axes[0].plot(times, 1e3 * heights[:, of_size], color=colour, linewidth=0.6)
        axes[1].plot(times, -1e3 * velocities[:, of_size].mean(1), color=colour, label=f"R = {1e3 * size:g} mm")
        axes[1].axhline(1e3 * terminal(size), color=colour, linestyle=":")
    axes[0].set(xlabel="time [s]", ylabel="heights [mm]")
    axes[1].set(xlabel="time [s]", ylabel="mean speed, dotted: Stokes [mm/s]")
    axes[1].legend()
    figure.savefig(path, dpi=130)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--fmu", required=True, help="the exported beads, of FMI 3.0")
    parser.add_argument("--stop", type=float, default=4.0, help="end of the run [s]")
    parser.add_argument("--output", default="viscous.png", help="the picture")
    arguments = parser.parse_args()

    times, heights, velocities, radius, work = settle(arguments.fmu, arguments.stop)
    # Before the first bead touches the floor, long after the start.
    k = np.searchsorted(times, min(0.5, arguments.stop))
    for size in np.unique(radius)[::-1]:
        off = np.abs(velocities[k, radius == size] / -terminal(size) - 1).max()
        print(f"R = {1e3 * size:g} mm: {1e3 * terminal(size):.4f} mm/s by Stokes, off by {off:.1e} at {times[k]:.2f} s")
    print(f"the fluid did {1e3 * work:.6f} mJ of work")
    plot(times, heights, velocities, radius, arguments.output)
    print(f"wrote {arguments.output}")


if __name__ == "__main__":
    main()
