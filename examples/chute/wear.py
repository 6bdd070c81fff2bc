"""Runs the chute through FMI 3.0 and draws where its liner wears, from arrays of its triangles.

    sphere-dda export examples/chute/chute.toml --fmi 3 -o chute.fmu
    python examples/chute/wear.py --fmu chute.fmu --output chute.png

In every step the tractions times the areas of the triangles add up to the force on the chute. Needs fmpy, numpy and matplotlib.
"""

import argparse
import shutil

import fmpy
import matplotlib
import numpy as np
from fmpy.fmi3 import FMU3Slave

matplotlib.use("Agg")
from matplotlib import pyplot as plt

WALL = "wall.chute."
STEP = 0.01
# The stream has to reach the lip first.
FROM = 1.0


def simulate(fmu, stop):
    """What the triangles felt at the end, their mean pressure since `FROM`, and how far tractions missed the force on the chute."""
    description = fmpy.read_model_description(str(fmu))
    variables = {v.name: v for v in description.modelVariables}
    folder = fmpy.extract(str(fmu))
    slave = FMU3Slave(
        guid=description.guid,
        unzipDirectory=folder,
        modelIdentifier=description.coSimulation.modelIdentifier,
        instanceName="chute",
    )

    def get(name):
        shape = [int(d.start) for d in variables[name].dimensions]
        values = slave.getFloat64([variables[name].valueReference], nValues=int(np.prod(shape, dtype=int)))
        return np.array(values).reshape(shape)

    slave.instantiate()
    try:
        slave.enterInitializationMode(startTime=0.0, stopTime=stop)
        slave.exitInitializationMode()
        corners, area = get(WALL + "corners"), get(WALL + "area")
        impulse, worst = np.zeros(len(area)), 0.0
        count = round(stop / STEP)
        for k in range(count):
            slave.doStep(currentCommunicationPoint=k * STEP, communicationStepSize=STEP)
            force = get("boundary.chute.averageForce")
            missed = np.linalg.norm(area @ get(WALL + "traction") - force)
            worst = max(worst, missed / max(np.linalg.norm(force), 1e-9))
            if (k + 1) * STEP > FROM:
                impulse += STEP * get(WALL + "pressure")
        felt = {name: get(WALL + name) for name in ("wearDepth", "frictionEnergy", "impactEnergy")}
        totals = {name: get(f"boundary.chute.{name}") for name in ("frictionEnergy", "impactEnergy", "wearVolume")}
        slave.terminate()
    finally:
        slave.freeInstance()
        shutil.rmtree(folder, ignore_errors=True)
    felt |= {"corners": corners, "area": area, "pressure": impulse / max(stop - FROM, STEP)}
    return felt, totals, worst


def plot(felt, stop, path):
    """The bottom of the chute from above: depth worn in 1000 h at this rate, and mean pressure."""
    corners = felt["corners"]
    bottom = np.abs(corners[:, :, 1]).max(1) < 0.151
    outlines = corners[bottom][:, :, :2]
    hours = 1000 * 3600 / stop
    figure, axes = plt.subplots(1, 2, figsize=(9, 3.2), sharey=True, layout="constrained")
    maps = [(1e3 * hours * felt["wearDepth"], "worn in 1000 h [mm]"), (1e-3 * felt["pressure"], "mean pressure [kPa]")]
    for axis, (values, label) in zip(axes, maps):
        patches = matplotlib.collections.PolyCollection(outlines, array=values[bottom], cmap="YlOrRd", edgecolor="face")
        axis.add_collection(patches)
        axis.set(xlim=(0, 0.7), ylim=(-0.16, 0.16), aspect="equal", xlabel="x [m]")
        figure.colorbar(patches, ax=axis, label=label, orientation="horizontal")
    axes[0].set_ylabel("y [m]")
    figure.savefig(path, dpi=130)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--fmu", required=True, help="the exported chute, of FMI 3.0")
    parser.add_argument("--stop", type=float, default=4.0, help="end of the run [s]")
    parser.add_argument("--output", default="chute.png", help="the picture")
    arguments = parser.parse_args()

    felt, totals, worst = simulate(arguments.fmu, arguments.stop)
    for name, values in (("frictionEnergy", felt["frictionEnergy"]), ("impactEnergy", felt["impactEnergy"])):
        print(f"{name}: {values.sum():.6f} J on the triangles, {totals[name]:.6f} J on the chute")
    volume = felt["area"] @ felt["wearDepth"]
    print(f"worn: {1e9 * volume:.6f} mm^3 by the triangles, {1e9 * totals['wearVolume']:.6f} mm^3")
    deepest = felt["corners"][felt["wearDepth"].argmax()].mean(0)
    print(f"deepest at x = {deepest[0]:.3f} m, tractions miss the force by at most {worst:.1e} of it")
    plot(felt, arguments.stop, arguments.output)
    print(f"wrote {arguments.output}")


if __name__ == "__main__":
    main()
