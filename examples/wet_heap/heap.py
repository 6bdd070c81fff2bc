"""Runs the heaps through FMI 3.0 for several Bond numbers, cohesion over the weight of a grain, and draws their angles.

    sphere-dda export examples/wet_heap/wet_heap.toml --fmi 3 -o wet_heap.fmu
    python examples/wet_heap/heap.py --fmu wet_heap.fmu --output wet_heap.png

The cohesion is a parameter of the FMU; the dry heap beside it tells how much runs differ. Needs fmpy, numpy and matplotlib.
"""

import argparse
import shutil

import fmpy
import matplotlib
import numpy as np
from fmpy.fmi3 import FMU3Slave

matplotlib.use("Agg")
from matplotlib import pyplot as plt

RADIUS, WEIGHT = 2e-3, 2500.0 * 4 / 3 * np.pi * 2e-3**3 * 9.81
COLUMN = 0.1
STEP = 0.01


def run(fmu, cohesion, stop):
    """Positions of the grains at the end [m], `[N, 3]`, and the largest overlap over the radius."""
    description = fmpy.read_model_description(str(fmu))
    variables = {v.name: v for v in description.modelVariables}
    folder = fmpy.extract(str(fmu))
    slave = FMU3Slave(
        guid=description.guid,
        unzipDirectory=folder,
        modelIdentifier=description.coSimulation.modelIdentifier,
        instanceName="heap",
    )

    def get(name):
        shape = [int(d.start) for d in variables[name].dimensions]
        values = slave.getFloat64([variables[name].valueReference], nValues=int(np.prod(shape, dtype=int)))
        return np.array(values).reshape(shape)

    slave.instantiate()
    try:
        slave.setFloat64([variables["cohesion"].valueReference], [cohesion])
        slave.enterInitializationMode(startTime=0.0, stopTime=stop)
        slave.exitInitializationMode()
        worst = 0.0
        for k in range(round(stop / STEP)):
            slave.doStep(currentCommunicationPoint=k * STEP, communicationStepSize=STEP)
            worst = max(worst, float(get("maxOverlap")))
        position = get("spheres.position")
        slave.terminate()
    finally:
        slave.freeInstance()
        shutil.rmtree(folder, ignore_errors=True)
    return position, worst


def angle(position, middle):
    """Angle of a heap [deg]: a line through its surface, the highest grain of every slice of a grain's width, from top to toe."""
    away = np.abs(position[:, 0] - middle)
    edges = np.arange(0.0, away.max() + 2 * RADIUS, 2 * RADIUS)
    slices = [(away >= low) & (away < low + 2 * RADIUS) for low in edges]
    surface = np.array([position[own, 2].max() + RADIUS if own.any() else 0.0 for own in slices])
    # Grains that have rolled away lie in a single layer.
    toe = np.argmax(surface <= 2.5 * RADIUS) if (surface <= 2.5 * RADIUS).any() else len(surface)
    along = edges[: toe + 1] + RADIUS
    slope = np.polyfit(along, surface[: toe + 1], 1)[0]
    return np.degrees(np.arctan(-slope))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--fmu", required=True)
    parser.add_argument("--output", required=True, help="picture (PNG)")
    parser.add_argument("--bond", nargs="+", type=float, default=[0, 1, 2, 3, 5, 10], help="Bond numbers")
    parser.add_argument("--stop", type=float, default=1.0, help="end [s]")
    given = parser.parse_args()
    wet, dry = [], []
    for bond in given.bond:
        position, worst = run(given.fmu, bond * WEIGHT, given.stop)
        dry.append(angle(position[:300], -COLUMN))
        wet.append(angle(position[300:], COLUMN))
        print(f"Bond number {bond:g}: wet {wet[-1]:.1f} deg, dry {dry[-1]:.1f} deg, overlap {worst:.1e} R")
    figure, axes = plt.subplots(figsize=(6.4, 4.0), layout="constrained")
    axes.plot(given.bond, wet, "o-", label="wet")
    axes.plot(given.bond, dry, "s--", label="dry, beside it")
    axes.set_xscale("symlog", linthresh=1.0)
    axes.set(xlabel="Bond number: cohesion over the weight of a grain [-]", ylabel="angle of the heap [deg]", ylim=(0, None))
    axes.grid(alpha=0.3)
    axes.legend()
    figure.savefig(given.output, dpi=120)


if __name__ == "__main__":
    main()
