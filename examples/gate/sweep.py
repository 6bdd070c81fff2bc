"""Runs the box with a flap over frictions and angles on Dask: one FMU, its parameters set for each run, one table, one picture.

    sphere-dda export examples/gate/gate.toml -o gate.fmu
    python examples/gate/sweep.py --fmu gate.fmu --output gate-sweep

Every run has the bits of the scene with the same values typed into it. Needs distributed, fmpy, numpy and matplotlib.
"""

import argparse
import itertools
import shutil
from pathlib import Path

import fmpy
import numpy as np
from distributed import Client, LocalCluster

FRICTIONS = [0.1, 0.2, 0.3, 0.5, 0.8]
ANGLES = [0.3, 0.4, 0.5]  # [rad]
STEP = 5e-3  # communication step of the scene [s]
MASS = "sensor.out.mass"


def outflow(folder, friction, angle, stop):
    """Times [s] and the mass [kg] that has left by then, of one run of the unpacked FMU."""
    rows = fmpy.simulate_fmu(
        folder, stop_time=stop, output_interval=STEP, start_values={"friction": friction, "angle": angle}, output=[MASS]
    )
    return rows["time"], rows[MASS]


def sweep(fmu, frictions=FRICTIONS, angles=ANGLES, stop=0.6, workers=2):
    """(friction, angle) -> times and masses, runs spread over processes."""
    folder = fmpy.extract(str(fmu))
    pairs = list(itertools.product(frictions, angles))
    try:
        with LocalCluster(n_workers=workers, threads_per_worker=1, dashboard_address=":0") as cluster, Client(cluster) as client:
            runs = [client.submit(outflow, folder, *pair, stop) for pair in pairs]
            return dict(zip(pairs, client.gather(runs)))
    finally:
        shutil.rmtree(folder, ignore_errors=True)


def plot(runs, path):
    """What has left at the end, over the friction, a line for each angle."""
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    figure, axes = plt.subplots(figsize=(6, 4), layout="constrained")
    for angle in sorted({angle for _, angle in runs}):
        line = sorted((friction, mass[-1]) for (friction, own), (_, mass) in runs.items() if own == angle)
        axes.plot(*zip(*line), "o-", label=f"{np.degrees(angle):.0f} deg")
    axes.set_xlabel("friction")
    axes.set_ylabel("mass that has left [kg]")
    axes.grid(alpha=0.3)
    axes.legend(title="flap")
    figure.savefig(path, dpi=110)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--fmu", type=Path, default=Path("gate.fmu"))
    parser.add_argument("--output", type=Path, default=Path("gate-sweep"), help="folder for CSV and picture")
    parser.add_argument("--stop", type=float, default=0.6, help="end time [s]")
    parser.add_argument("--workers", type=int, default=2, help="processes")
    a = parser.parse_args()
    runs = sweep(a.fmu, stop=a.stop, workers=a.workers)
    a.output.mkdir(parents=True, exist_ok=True)
    with (a.output / "sweep.csv").open("w") as file:
        file.write("friction,angle,mass\n")
        for (friction, angle), (_, mass) in sorted(runs.items()):
            file.write(f"{friction},{angle},{float(mass[-1])!r}\n")
    plot(runs, a.output / "sweep.png")
    print(f"{len(runs)} runs, wrote {a.output / 'sweep.csv'} and {a.output / 'sweep.png'}")


if __name__ == "__main__":
    main()
