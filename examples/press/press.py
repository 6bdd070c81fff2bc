"""Presses glass beads through the FMU and draws the lid's force over its way: loading, unloading, reloading.

    sphere-dda export examples/press/press.toml -o press.fmu
    python examples/press/press.py --fmu press.fmu --output press.png

Young's modulus is a parameter of the FMU. Needs fmpy, numpy and matplotlib.
"""

import argparse

import fmpy
import matplotlib
import numpy as np

matplotlib.use("Agg")
from matplotlib import pyplot as plt

FORCE, HEIGHT = "boundary.lid.averageForce[3]", "boundary.lid.position[3]"
ERROR, COMPRESSION = "maxOverlap", "maxCompression"


def press(fmu, young, stop):
    """Time [s], way of the lid from where it feels 10 N [mm], force [kN], largest error and compression over the radius."""
    told = fmpy.simulate_fmu(
        str(fmu),
        stop_time=stop,
        output_interval=0.005,
        start_values={"young": young},
        output=[FORCE, HEIGHT, ERROR, COMPRESSION],
    )
    force = np.maximum(told[FORCE], 0.0)
    touched = told[HEIGHT][np.argmax(force > 10.0)]
    return told["time"], 1e3 * (touched - told[HEIGHT]), 1e-3 * force, told[ERROR].max(), told[COMPRESSION].max()


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--fmu", required=True)
    parser.add_argument("--output", required=True, help="picture (PNG)")
    parser.add_argument("--young", nargs="+", type=float, default=[70e9], help="Young's moduli [Pa]")
    parser.add_argument("--stop", type=float, default=1.0, help="end [s]")
    given = parser.parse_args()
    figure, axes = plt.subplots(figsize=(6.4, 4.0), layout="constrained")
    for young in given.young:
        _, way, force, error, compression = press(given.fmu, young, given.stop)
        axes.plot(way, force, label=f"E = {1e-9 * young:g} GPa")
        print(f"E = {1e-9 * young:g} GPa: {force.max():.2f} kN, beads compressed by {compression:.1e} R, off by {error:.1e} R")
    axes.set(xlabel="way of the lid from where it feels 10 N [mm]", ylabel="force on the lid [kN]", xlim=(-0.5, None))
    axes.grid(alpha=0.3)
    axes.legend()
    figure.savefig(given.output, dpi=120)


if __name__ == "__main__":
    main()
