"""LIGGGHTS of the distribution (discrete elements: Hertz springs, tangential history), one MPI process a thread."""

import math
import os
import re
import resource
import subprocess
from pathlib import Path

import numpy as np

import measures
from codes.sphere_dda import write_stl
from runs import INTERVAL, MEAN, Case, Outcome
from scenes import FRICTION, GRAVITY, Array, Scene

POISSON = 0.3
RESTITUTION = 0.1  # the least that its damping allows
RAYLEIGH = 0.15  # step over the Rayleigh time, as its users choose it
SAMPLES = 10  # steps between two samples of the force on the floor
MARGIN = 0.03  # of the domain around the spheres [m]


def run(case: Case, scene: Scene, folder: Path) -> Outcome:
    """One run of its own process; CPU time is that of all processes less what writing positions took."""
    steps = _steps(case, scene)
    (folder / "in").write_text("\n".join(_script(case, scene, folder, steps)) + "\n")
    command = ["liggghts", "-in", "in", "-log", "log"]
    if case.threads > 1:
        command = ["mpirun", "--allow-run-as-root", "--oversubscribe", "-np", str(case.threads), *command]
    environment = dict(os.environ, OMP_NUM_THREADS="1")
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True, errors="replace", check=False)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    told = done.stdout
    loops = re.findall(rf"Loop time of (\S+) on \d+ procs for {steps} steps", told)
    if done.returncode != 0 or not loops:
        raise RuntimeError((told[-2000:] + done.stderr[-1000:]).strip())
    writing = _writing(told)
    state = frames(folder / "end.bin", len(scene.radius), 9)[-1]
    watched = None
    if case.watch:
        # The first frame is the start.
        watched = measures.course(scene, frames(folder / "frames.bin", len(scene.radius), 3)[1:], INTERVAL)
    cpu = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    memory = re.findall(r"Memory usage per processor = (\S+) Mbytes", told)
    version = re.search(r"Version LIGGGHTS-PUBLIC ([^,\s]+)", (folder / "log").read_text() + told)
    return Outcome(
        version=version[1] if version else "unknown",
        cpu_s=cpu - writing * case.threads,
        wall_s=float(loops[0]) - writing,
        spheres=len(scene.radius),
        steps=steps,
        end=measures.end(scene, *np.split(state, 3, axis=1)),
        watched=watched,
        floor=measures.over_weight(scene, _floor(told, steps)) if scene.name == "bed" else None,
        memory=float(memory[-1]) * case.threads * 2**20 / len(scene.radius) if memory else None,
    )


def _steps(case: Case, scene: Scene) -> int:
    """Steps within the share of the Rayleigh time, a whole number of samples of the floor's force per output interval."""
    shear = case.settings["young"] / (2 * (1 + POISSON))
    rayleigh = math.pi * scene.radius.min() * math.sqrt(scene.density / shear) / (0.1631 * POISSON + 0.8766)
    points = round(case.duration / INTERVAL)
    return points * SAMPLES * math.ceil(INTERVAL / (SAMPLES * RAYLEIGH * rayleigh))


def _script(case: Case, scene: Scene, folder: Path, steps: int) -> list[str]:
    young = case.settings["young"]
    _write_spheres(folder / "spheres.data", scene)
    watch = steps // round(case.duration / INTERVAL)
    lines = ["hard_particles yes"] if young > 1e9 else []
    lines += [
        "units si",
        "atom_style granular",
        "atom_modify map array",
        "boundary f f f",
        "newton off",
        # A layer of spheres on the floor is cut upright, so that every process has its share.
        "processors * * 1",
        "communicate single vel yes",
        "read_data spheres.data",
        f"neighbor {0.4 * scene.radius.mean():g} bin",
        "neigh_modify delay 0",
        f"fix m1 all property/global youngsModulus peratomtype {young:g}",
        f"fix m2 all property/global poissonsRatio peratomtype {POISSON}",
        f"fix m3 all property/global coefficientRestitution peratomtypepair 1 {RESTITUTION}",
        f"fix m4 all property/global coefficientFriction peratomtypepair 1 {FRICTION}",
        "pair_style gran model hertz tangential history",
        "pair_coeff * *",
        f"timestep {case.duration / steps:.15g}",
        f"fix weight all gravity {GRAVITY} vector 0.0 0.0 -1.0",
        *_walls(scene, folder),
        "fix motion all nve/sphere",
    ]
    report = "0"
    if scene.name == "bed":
        # The end of the last average is the last step.
        samples = max(1, round(MEAN / case.duration * steps / SAMPLES))
        lines += [
            "compute sum all reduce sum f_force_floor[3]",
            f"fix mean all ave/time {SAMPLES} {samples} {steps} c_sum",
        ]
        report = "f_mean"
    lines += [
        "thermo_style custom step cpu " + ("ke" if report == "0" else report),
        "thermo_modify lost ignore norm no",
        f"thermo {steps}",
    ]
    if case.watch:
        lines.append(f"dump frames all custom {watch} frames.bin id x y z")
    lines += [
        f"run {steps}",
        f"dump end all custom {steps} end.bin id x y z vx vy vz omegax omegay omegaz",
        "run 0",
    ]
    return lines


def _walls(scene: Scene, folder: Path) -> list[str]:
    wall = "all wall/gran model hertz tangential history"
    if scene.name == "bed":
        b = scene.half_width
        sides = [f"{axis}plane {at:.15g}" for axis in "xy" for at in (-b, b)]
        floor = f"fix floor {wall} primitive type 1 zplane 0.0 store_force yes"
        return [floor, *(f"fix side{k} {wall} primitive type 1 {side}" for k, side in enumerate(sides))]
    write_stl(folder / "walls.stl", scene.triangles)
    return [
        "fix mesh all mesh/surface file walls.stl type 1",
        f"fix walls {wall} mesh n_meshes 1 meshes mesh",
    ]


def _write_spheres(path: Path, scene: Scene) -> None:
    x, r = scene.position, scene.radius
    corners = np.vstack([scene.triangles.reshape(-1, 3), x])
    low, high = corners.min(0) - MARGIN, corners.max(0) + MARGIN
    if scene.name == "bed":
        low[2], high[2] = low[2] - MARGIN, high[2] + 4 * MARGIN
    if scene.name == "funnel":
        low[2] -= 6.0
    head = ["spheres", "", f"{len(r)} atoms", "1 atom types"]
    head += [f"{a:.12g} {b:.12g} {q}lo {q}hi" for a, b, q in zip(low, high, "xyz", strict=True)]
    table = np.column_stack([np.arange(1, len(r) + 1), np.ones(len(r)), 2 * r, np.full(len(r), scene.density), x])
    np.savetxt(path, table, "%d %d %.15g %g %.15g %.15g %.15g", header="\n".join([*head, "", "Atoms", ""]), comments="")


def frames(path: Path, n: int, columns: int) -> list[Array]:
    """Frames of a binary dump of `id` and `columns` more, in the order of the spheres; lost ones are not numbers.

    A frame is: step and count (int64), triclinic and six kinds of borders (int32), six borders (f64), columns and blocks
    (int32), and for each block (one a process) its count of numbers (int32) and the numbers (f64).
    """
    data = path.read_bytes()
    found, at = [], 0
    while at < len(data):
        at += 16 + 7 * 4 + 6 * 8
        width, blocks = np.frombuffer(data, np.int32, 2, at)
        at += 8
        frame = np.full((n, columns), np.nan)
        for _ in range(blocks):
            count = int(np.frombuffer(data, np.int32, 1, at)[0])
            rows = np.frombuffer(data, np.float64, count, at + 4).reshape(-1, width)
            frame[rows[:, 0].astype(int) - 1] = rows[:, 1:]
            at += 4 + 8 * count
        found.append(frame)
    return found


def _writing(told: str) -> float:
    """Time it took to write positions [s], by its own account."""
    found = re.findall(r"Outpt time \(%\) = (\S+)", told)
    return float(found[0]) if found else 0.0


def _floor(told: str, steps: int) -> float:
    """Mean force on the floor [N]: the third number in the line of the last step."""
    rows = re.findall(rf"^\s*{steps}\s+\S+\s+(\S+)\s*$", told, re.MULTILINE)
    if not rows:
        raise RuntimeError("no force on the floor in what LIGGGHTS printed")
    return abs(float(rows[0]))
