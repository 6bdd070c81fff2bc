"""Drives the vibrating feeder through FMI: displacement in, reaction force and mass flow out.

    sphere-dda export examples/feeder/feeder.toml -o feeder.fmu
    python examples/feeder/drive.py --fmu feeder.fmu --stop 4 --output feeder-output

Writes feeder.csv (one row per communication step) and feeder.png. Any FMI 2.0 master does the same: set
`boundary.trough.displacement`, step, get the outputs. Needs fmpy, numpy and matplotlib.
"""

import argparse
import shutil
from pathlib import Path

import fmpy
import numpy as np
from fmpy.fmi2 import FMU2Slave

INPUT = "boundary.trough.displacement"
OUTPUTS = [
    *(f"boundary.trough.averageForce[{axis}]" for axis in (1, 2, 3)),
    *(f"boundary.bin.averageForce[{axis}]" for axis in (1, 2, 3)),
    *(f"momentum[{axis}]" for axis in (1, 2, 3)),
    "sensor.flow.rate",
    "sensor.flow.mass",
    "sensor.collected.mass",
    "mass",
    "maxOverlap",
]
GRAVITY = 9.81


def displacement(time, amplitude, frequency):
    """A sinusoid that starts softly: full amplitude after a tenth of a second, no jump of the velocity at t = 0."""
    ramp = np.clip(time / 0.1, 0, 1)
    return amplitude * ramp**2 * (3 - 2 * ramp) * np.sin(2 * np.pi * frequency * time)


def drive(fmu, stop, step, amplitude, frequency):
    """Runs the FMU and returns a structured array: time, displacement and all outputs, one row per step."""
    description = fmpy.read_model_description(fmu)
    reference = {v.name: v.valueReference for v in description.modelVariables}
    folder = fmpy.extract(fmu)
    slave = FMU2Slave(
        guid=description.guid,
        unzipDirectory=folder,
        modelIdentifier=description.coSimulation.modelIdentifier,
        instanceName="feeder",
    )
    slave.instantiate()
    rows = []
    try:
        slave.setupExperiment(startTime=0.0, stopTime=stop)
        slave.enterInitializationMode()
        slave.exitInitializationMode()
        outputs = [reference[name] for name in OUTPUTS]
        rows.append((0.0, 0.0, *slave.getReal(outputs)))
        for k in range(round(stop / step)):
            end = (k + 1) * step
            # The trough reaches the commanded displacement at the end of the step.
            command = displacement(end, amplitude, frequency)
            slave.setReal([reference[INPUT]], [command])
            slave.doStep(currentCommunicationPoint=k * step, communicationStepSize=step)
            rows.append((end, command, *slave.getReal(outputs)))
        slave.terminate()
    finally:
        slave.freeInstance()
        shutil.rmtree(folder, ignore_errors=True)
    return np.array(rows, dtype=[(name, float) for name in ("time", "displacement", *OUTPUTS)])


def plot(table, frequency, path):
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot as plt

    time = table["time"]
    up = -(table["boundary.trough.averageForce[3]"] + table["boundary.bin.averageForce[3]"])
    weight = table["mass"][0] * GRAVITY
    # Averages over one period of vibration show what is conveyed.
    width = max(1, round(1 / (frequency * (time[1] - time[0]))))
    smooth = lambda y: np.convolve(y, np.ones(width) / width, mode="same")

    figure, axes = plt.subplots(3, 1, sharex=True, figsize=(8, 8), layout="constrained")
    axes[0].plot(time, 1e3 * table["displacement"], color="tab:gray", lw=0.8)
    axes[0].set_ylabel("displacement [mm]")
    axes[1].plot(time[1:], up[1:], color="tab:blue", lw=0.4, alpha=0.5, label="reaction, mean of each step")
    axes[1].plot(time[width:-width], smooth(up)[width:-width], color="tab:blue", label="mean of a period")
    axes[1].axhline(weight, color="black", ls="--", lw=1, label="weight of the grains")
    axes[1].set_ylim(0, 4 * weight)
    axes[1].set_ylabel("vertical force [N]")
    axes[1].legend(loc="upper right", fontsize="small")
    axes[2].plot(time, table["sensor.flow.mass"], color="tab:orange", label="left the trough")
    axes[2].plot(time, table["sensor.collected.mass"], color="tab:green", label="in the bin")
    axes[2].set_ylabel("mass [kg]")
    axes[2].set_xlabel("time [s]")
    axes[2].legend(loc="upper left", fontsize="small")
    for axis in axes:
        axis.grid(alpha=0.3)
    figure.savefig(path, dpi=130)
    plt.close(figure)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--fmu", type=Path, required=True, help="the exported feeder")
    parser.add_argument("--stop", type=float, default=4.0, help="end time [s]")
    parser.add_argument("--step", type=float, default=2e-3, help="communication step [s]")
    parser.add_argument("--amplitude", type=float, default=1.5e-3, help="amplitude of the vibration [m]")
    parser.add_argument("--frequency", type=float, default=18.0, help="its frequency [Hz]")
    parser.add_argument("--output", type=Path, default=Path("feeder-output"), help="folder for CSV and picture")
    arguments = parser.parse_args()

    table = drive(str(arguments.fmu), arguments.stop, arguments.step, arguments.amplitude, arguments.frequency)
    arguments.output.mkdir(parents=True, exist_ok=True)
    csv = arguments.output / "feeder.csv"
    np.savetxt(csv, table, delimiter=",", header=",".join(table.dtype.names), comments="", fmt="%.17g")
    plot(table, arguments.frequency, arguments.output / "feeder.png")

    reaction = -(table["boundary.trough.averageForce[3]"] + table["boundary.bin.averageForce[3]"])[1:]
    print(f"mean vertical reaction {reaction.mean():.3f} N, weight of the grains {table['mass'][0] * GRAVITY:.3f} N")
    print(f"conveyed {table['sensor.flow.mass'][-1]:.4f} kg in {arguments.stop} s, overlap at most {table['maxOverlap'].max():.1e} radii")
    print(f"wrote {csv} and {arguments.output / 'feeder.png'}")


if __name__ == "__main__":
    main()
