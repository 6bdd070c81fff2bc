"""This project as a co-simulation FMU that its own master runs: what a scene costs behind FMI.

The FMU is exported as users do it, `sphere-dda simulate` steps it and records every scalar that the comparison needs; CPU time
is that of the whole process less that of starting it: unpacking, loading, reading the scene.
"""

import csv
import os
import time
from pathlib import Path

import child
import measures
from codes.sphere_dda import executable, write
from runs import INTERVAL, Case, Outcome
from scenes import BUILDERS, Scene
from scenes.feeder import displacement

CANNOT = {name: "as a scene only: its boundaries have no inputs" for name in BUILDERS if name != "feeder"}
FORCE = "boundary.trough.averageForce[{}]"
RECORDED = (
    "maxOverlap",
    "maxOpening",
    "contactCount",
    "solver.internalSteps",
    "solver.sweeps",
    "solver.factorizations",
    "solver.forceResidual",
    "kineticEnergy",
)


def build() -> Path:
    """Path of the command, built if need be with the library that goes into FMUs."""
    return executable(["build", "--release"], "sphere-dda")


def run(case: Case, scene: Scene, folder: Path) -> Outcome:
    """One run; the command is named in SPHERE_DDA, or on the PATH. The trough's displacement is the input, every interval."""
    command = os.environ.get("SPHERE_DDA", "sphere-dda")
    toml = write(scene, case, folder)
    toml.write_text(toml.read_text() + '\n[fmu]\noutputs = ["*"]\n')
    fmu = folder / "scene.fmu"
    exported = child.run([command, "export", str(toml), "-o", str(fmu)], folder)
    if exported.status != 0:
        raise RuntimeError(f"{command} export: {exported.error.strip()}")
    points = round(case.duration / INTERVAL)
    rows = [f"{k * INTERVAL:.12g},{displacement(k * INTERVAL):.12g}" for k in range(points + 1)]
    (folder / "input.csv").write_text("\n".join(["time,boundary.trough.displacement", *rows]) + "\n")
    table = folder / "outputs.csv"
    simulate = [command, "simulate", str(fmu), "--input", "input.csv", "--step", f"{INTERVAL}", "-o", str(table)]
    # One step costs what starting does.
    started = child.run([*simulate, "--stop", f"{INTERVAL}"], folder)
    table.unlink(missing_ok=True)
    clock = time.perf_counter()
    done = child.run([*simulate, "--stop", f"{case.duration}"], folder)
    wall = time.perf_counter() - clock
    if done.status != 0 or started.status != 0:
        raise RuntimeError(f"{command} simulate: {(done.error or started.error).strip()}")
    course = _columns(table)
    mass = float(scene.mass.sum())
    load = scene.load
    force = (
        []
        if load is None
        else [sum(d * f for d, f in zip(load.direction, row, strict=True)) for row in zip(*(course[FORCE.format(k)] for k in (1, 2, 3)), strict=True)]
    )
    window = force[-round(load.window / INTERVAL) :] if load else []
    total = {name: sum(course[f"solver.{name}"]) for name in ("internalSteps", "sweeps", "factorizations")}
    return Outcome(
        version=_version(command, folder),
        cpu_s=done.cpu_s - started.cpu_s,
        wall_s=wall,
        spheres=len(scene.radius),
        steps=round(total["internalSteps"]),
        end=measures.End(course["maxOverlap"][-1], course["kineticEnergy"][-1] / mass, 0, None, None, mass),
        worst=max(course["maxOverlap"]),
        opening=max(course["maxOpening"]) if "maxOpening" in course else None,
        force=[float(f"{value:.6g}") for value in window],
        peak=done.peak,
        sweeps=round(total["sweeps"]),
        factorizations=round(total["factorizations"]),
        force_residual=max(course["solver.forceResidual"]),
        contacts=sum(course["contactCount"]) / len(course["contactCount"]),
    )


def _columns(path: Path) -> dict[str, list[float]]:
    """Columns of the outputs without the row of the start, by their names without units."""
    with path.open() as file:
        head, *rows = csv.reader(file)
    names = [name.split(" [")[0] for name in head]
    return {name: [float(row[k]) for row in rows[1:]] for k, name in enumerate(names)}


def _version(command: str, folder: Path) -> str:
    return child.run([command, "--version"], folder).out.split()[-1]
