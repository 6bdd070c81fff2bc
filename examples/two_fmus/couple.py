"""Couples the shaker to the grains through FMI: motion forward, force back. The same as `sphere-dda simulate` does.

    sphere-dda export examples/two_fmus/bed.toml -o bed.fmu
    cargo run --release -p sphere-dda-shaker          # writes shaker.fmu
    python examples/two_fmus/couple.py run --shaker shaker.fmu --bed bed.fmu --output two_fmus-output
    python examples/two_fmus/couple.py limit --shaker shaker.fmu --command sphere-dda --output two_fmus-output

`run` writes coupled.csv (one row per communication step) and coupled.png; `limit` raises the density of a mass on the
tray past the limit of loose coupling, and writes limit.csv and limit.png. Needs fmpy, numpy and matplotlib.
"""

import argparse
import shutil
import subprocess
from pathlib import Path

import fmpy
import numpy as np
from fmpy.fmi2 import FMU2Slave

FORCE = "bed.boundary.tray.averageForce[3]"
WIRES = [("shaker.position", "bed.boundary.tray.displacement"), (FORCE, "shaker.force")]
OUTPUTS = [
    "shaker.position",
    "shaker.velocity",
    "shaker.impulse",
    "bed.boundary.tray.position[3]",
    FORCE,
    "bed.momentum[3]",
    "bed.mass",
    "bed.maxOverlap",
]
GRAVITY = 9.81


class Component:
    """An FMU with the names of its variables."""

    def __init__(self, name, fmu):
        self.name = name
        self.description = fmpy.read_model_description(str(fmu))
        self.reference = {v.name: v.valueReference for v in self.description.modelVariables}
        self.folder = fmpy.extract(str(fmu))
        self.fmi = FMU2Slave(
            guid=self.description.guid,
            unzipDirectory=self.folder,
            modelIdentifier=self.description.coSimulation.modelIdentifier,
            instanceName=name,
        )
        self.fmi.instantiate()

    def close(self):
        self.fmi.freeInstance()
        shutil.rmtree(self.folder, ignore_errors=True)


class Master:
    """FMUs in the order in which they step. Names are `<component>.<variable>`."""

    def __init__(self, fmus):
        self.components = {name: Component(name, fmu) for name, fmu in fmus.items()}

    def __enter__(self):
        return self

    def __exit__(self, *_):
        for component in self.components.values():
            component.close()

    def _place(self, name):
        component, variable = name.split(".", 1)
        component = self.components[component]
        return component.fmi, [component.reference[variable]]

    def get(self, name):
        fmi, reference = self._place(name)
        return fmi.getReal(reference)[0]

    def set(self, name, value):
        fmi, reference = self._place(name)
        fmi.setReal(reference, [value])

    def inputs_of(self, target):
        """What the outputs hold now for the inputs of one component."""
        return [(to, self.get(source)) for source, to in WIRES if to.split(".", 1)[0] == target]

    def initialize(self, stop, values):
        every = [component.fmi for component in self.components.values()]
        for fmi in every:
            fmi.setupExperiment(startTime=0.0, stopTime=stop)
        for name, value in values.items():
            self.set(name, value)
        for fmi in every:
            fmi.enterInitializationMode()
        # As often as there are components: a value passes through every chain of direct feedthrough.
        for _ in every:
            for target in self.components:
                for name, value in self.inputs_of(target):
                    self.set(name, value)
        for fmi in every:
            fmi.exitInitializationMode()

    def step(self, time, h, coupling):
        if coupling == "jacobi":
            loads = [self.inputs_of(target) for target in self.components]
            for name, value in (pair for load in loads for pair in load):
                self.set(name, value)
        for target, component in self.components.items():
            if coupling == "gauss-seidel":
                for name, value in self.inputs_of(target):
                    self.set(name, value)
            component.fmi.doStep(currentCommunicationPoint=time, communicationStepSize=h)


def couple(shaker, bed, coupling="jacobi", stop=1.0, h=1e-3, values=None, outputs=OUTPUTS):
    """Runs both from 0 to `stop` [s] in steps of `h` [s]; a structured array, one row per communication point."""
    steps = round(stop / h)
    with Master({"shaker": shaker, "bed": bed}) as master:
        master.initialize(stop, values or {})
        rows = [(0.0, *map(master.get, outputs))]
        for k in range(steps):
            master.step(k * h, h, coupling)
            time = stop if k + 1 == steps else (k + 1) * h
            rows.append((time, *map(master.get, outputs)))
        for component in master.components.values():
            component.fmi.terminate()
    return np.array(rows, dtype=[(name, float) for name in ("time", *outputs)])


def balance(table):
    """Largest difference over all steps of what the grains lose and the tray gets, over the weight of a step."""
    h = table["time"][1] - table["time"][0]
    weight = table["bed.mass"][0] * GRAVITY * h
    lost = -np.diff(table["bed.momentum[3]"]) - weight
    return np.abs(lost - h * table[FORCE][1:]).max() / weight


def limit(shaker, command, folder, h=1e-3, steps=200):
    """Runs a mass on the tray on both sides of the limit; rows (scheme, ratio of masses, force over weight by step)."""
    scene = (Path(__file__).parent / "plate.toml").read_text()
    density = "density = 3819.718634205488"
    assert density in scene
    rows = []
    for coupling, bound in (("jacobi", np.sqrt(5) - 1), ("gauss-seidel", 2.0)):
        for part in (0.85, 0.95, 1.05, 1.15):
            # The shaker has 2 kg, and so has the mass at that density.
            ratio = float(part * bound)
            path = folder / "plate.toml"
            path.write_text(scene.replace(density, f"density = {3819.718634205488 * ratio!r}"))
            bed = folder / "plate.fmu"
            subprocess.run([command, "export", path, "-o", bed, "--overwrite"], check=True, capture_output=True)
            weight = 2.0 * ratio * GRAVITY
            # The support carries the mass; a small velocity at the start is what grows or fades.
            values = {
                "shaker.amplitude": 0.0,
                "shaker.support": weight,
                "shaker.velocity": 0.01 * h,
                "bed.solver.step": h,
            }
            table = couple(shaker, bed, coupling, steps * h, h, values, [FORCE])
            rows.append((coupling, part, ratio, -table[FORCE] / weight))
    return rows


def plot_run(tables, path):
    plt = pyplot()
    figure, axes = plt.subplots(2, 1, sharex=True, figsize=(8, 6), layout="constrained")
    for coupling, table in tables.items():
        weight = table["bed.mass"][0] * GRAVITY
        axes[0].plot(table["time"], 1e3 * table["bed.boundary.tray.position[3]"], lw=1, label=coupling)
        axes[1].plot(table["time"], -table[FORCE] / weight, lw=0.6, label=coupling)
    axes[0].set_ylabel("tray [mm]")
    axes[1].set_ylabel("force on the tray / weight")
    axes[1].set_xlabel("time [s]")
    axes[0].legend(fontsize="small")
    for axis in axes:
        axis.grid(alpha=0.3)
    figure.savefig(path, dpi=90)
    plt.close(figure)


def plot_limit(rows, path):
    plt = pyplot()
    figure, axes = plt.subplots(1, 2, sharey=True, figsize=(9, 3.6), layout="constrained")
    for axis, wanted, bound in zip(axes, ("jacobi", "gauss-seidel"), ("√5 - 1", "2")):
        for coupling, part, ratio, force in rows:
            if coupling == wanted:
                axis.semilogy(np.maximum(np.abs(force - 1), 1e-9), lw=0.8, label=f"{ratio:.2f} = {part} of the limit")
        axis.set_title(f"{wanted}: limit {bound}", fontsize="medium")
        axis.set_xlabel("communication step")
        axis.grid(alpha=0.3)
        axis.legend(title="mass of the grains / of the shaker", fontsize="x-small", title_fontsize="x-small")
    axes[0].set_ylabel("|force / weight - 1|")
    figure.savefig(path, dpi=90)
    plt.close(figure)


def pyplot():
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot as plt

    return plt


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("task", choices=("run", "limit"))
    parser.add_argument("--shaker", type=Path, required=True, help="the exported shaker")
    parser.add_argument("--bed", type=Path, default=Path("bed.fmu"), help="run: the exported grains")
    parser.add_argument("--command", default="sphere-dda", help="limit: the sphere-dda command")
    parser.add_argument("--stop", type=float, default=1.0, help="run: end time [s]")
    parser.add_argument("--step", type=float, default=1e-3, help="communication step [s]")
    parser.add_argument("--output", type=Path, default=Path("two_fmus-output"), help="folder for CSV and picture")
    arguments = parser.parse_args()
    folder = arguments.output
    folder.mkdir(parents=True, exist_ok=True)

    if arguments.task == "run":
        schemes = ("jacobi", "gauss-seidel")
        tables = {c: couple(arguments.shaker, arguments.bed, c, arguments.stop, arguments.step) for c in schemes}
        for coupling, table in tables.items():
            name = f"coupled-{coupling}.csv"
            np.savetxt(folder / name, table, delimiter=",", header=",".join(table.dtype.names), comments="", fmt="%.17g")
            print(f"{coupling}: momentum balance {balance(table):.1e} of the weight, overlap {table['bed.maxOverlap'].max():.1e} R")
        plot_run(tables, folder / "coupled.png")
        return
    rows = limit(arguments.shaker, arguments.command, folder, arguments.step)
    with open(folder / "limit.csv", "w") as file:
        print("coupling,part of the limit,mass ratio,largest deviation of the force over the weight in steps 150..200", file=file)
        for coupling, part, ratio, force in rows:
            late = np.abs(force[150:] - 1).max()
            print(f"{coupling},{part},{ratio:.6g},{late:.3e}", file=file)
            print(f"{coupling}: mass ratio {ratio:.3f}, {part} of the limit: force off by {late:.1e} of the weight after 150 steps")
    plot_limit(rows, folder / "limit.png")


if __name__ == "__main__":
    main()
