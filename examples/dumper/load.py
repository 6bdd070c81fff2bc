"""Drops the stones through the FMU and draws what the suspension feels.

    sphere-dda export examples/dumper/dumper.toml -o dumper.fmu
    python examples/dumper/load.py --fmu dumper.fmu --output dumper.png

Needs fmpy and matplotlib.
"""

import argparse

import fmpy
import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot as plt

G, STEP = 9.81, 0.005  # [m/s^2], [s]
MASS, STIFFNESS, REST, DAMPING = 900.0, 2e5, 0.0441, 8e3  # of the body, its spring and its damper [kg], [N/m], [m], [N s/m]
TRAVEL, SPEED, STONES = "boundary.body.jointTravel", "boundary.body.jointSpeed", "boundary.body.averageForce[3]"


def simulate(fmu, stop):
    """Times [s], force of the stones and of the suspension [N], travel [m], mass of the stones [kg]."""
    found = fmpy.simulate_fmu(fmu, stop_time=stop, output_interval=STEP, output=[TRAVEL, SPEED, STONES, "mass"])
    suspension = STIFFNESS * (REST - found[TRAVEL]) - DAMPING * found[SPEED]
    return found["time"], -found[STONES], suspension, found[TRAVEL], found["mass"][-1]


def plot(times, stones, suspension, travel, path):
    figure, axes = plt.subplots(2, 1, figsize=(7, 5), sharex=True, layout="constrained")
    axes[0].plot(times, stones / 1e3, color="0.7", lw=0.8, label="stones on the body")
    axes[0].plot(times, suspension / 1e3, label="suspension")
    axes[0].set_ylabel("force [kN]")
    axes[0].legend()
    axes[1].plot(times, 1e3 * travel)
    axes[1].set(xlabel="t [s]", ylabel="travel [mm]")
    figure.savefig(path, dpi=130)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--fmu", required=True, help="the exported dumper")
    parser.add_argument("--stop", type=float, default=3.0, help="end of the run [s]")
    parser.add_argument("--output", default="dumper.png", help="the picture")
    arguments = parser.parse_args()

    times, stones, suspension, travel, mass = simulate(arguments.fmu, arguments.stop)
    weight = (MASS + mass) * G
    print(f"{mass:.0f} kg of stones: {suspension[-1] / weight:.4f} of the weight on the suspension at the end")
    print(f"at most {suspension.max() / weight:.2f} of it, travel down to {1e3 * travel.min():.0f} mm, at the end {1e3 * travel[-1]:.1f} mm")
    plot(times, stones, suspension, travel, arguments.output)
    print(f"wrote {arguments.output}")


if __name__ == "__main__":
    main()
