"""LIGGGHTS of the distribution (discrete elements: Hertz springs, tangential history), one MPI process a thread."""

import math
import os
import re
from pathlib import Path

import numpy as np

import child
import measures
from codes.sphere_dda import write_stl
from runs import INTERVAL, MEAN, Case, Outcome
from scenes import FRICTION, GRAVITY, Array, Scene

POISSON = 0.3
RESTITUTION = 0.1  # the least that its damping allows
RAYLEIGH = 0.15  # step over the Rayleigh time, as its users choose it
SAMPLES = 10  # steps between two samples of the force on the floor
CANNOT = {"feeder": "LIGGGHTS is no FMU and runs none"}
MARGIN = 0.03  # of the domain around the spheres [m]


def run(case: Case, scene: Scene, folder: Path) -> Outcome:
    """One run of its own process; CPU time is that of all processes less what writing positions took."""
    steps = _steps(case, scene)
    (folder / "in").write_text("\n".join(_script(case, scene, folder, steps)) + "\n")
    command = ["liggghts", "-in", "in", "-log", "log"]
    if case.threads > 1:
        command = ["mpirun", "--allow-run-as-root", "--oversubscribe", "-np", str(case.threads), *command]
    done = child.run(command, folder, dict(os.environ, OMP_NUM_THREADS="1"))
    told = done.out
    loops = [float(time) for time, count in re.findall(r"Loop time of (\S+) on \d+ procs for (\d+) steps", told) if count != "0"]
    if done.status != 0 or not loops:
        raise RuntimeError((told[-2000:] + done.error[-1000:]).strip())
    writing = _writing(told)
    state = frames(folder / "end.bin", len(scene.radius), 9)[-1]
    watched = None
    if case.watch:
        # The first frame is the start.
        watched = measures.course(scene, frames(folder / "frames.bin", len(scene.radius), 3)[1:], INTERVAL)
    memory = re.findall(r"Memory usage per processor = (\S+) Mbytes", told)
    version = re.search(r"Version LIGGGHTS-PUBLIC ([^,\s]+)", (folder / "log").read_text() + told)
    return Outcome(
        version=version[1] if version else "unknown",
        cpu_s=done.cpu_s - writing * case.threads,
        wall_s=sum(loops) - writing,
        spheres=len(scene.radius),
        steps=steps,
        end=measures.end(scene, *np.split(state, 3, axis=1), case.duration),
        watched=watched,
        floor=measures.over_weight(scene, _floor(told, steps)) if scene.rests else None,
        force=_force(scene, folder),
        peak=done.peak,
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
        *([f"fix m5 all property/global coefficientRollingFriction peratomtypepair 1 {scene.rolling}"] if scene.rolling else []),
        f"pair_style gran {_model(scene)}",
        "pair_coeff * *",
        f"timestep {case.duration / steps:.15g}",
        f"fix weight all gravity {GRAVITY} vector 0.0 0.0 -1.0",
        *_walls(scene, folder),
        "fix motion all nve/sphere",
    ]
    report = "0"
    if scene.load:
        what = f"f_body[{(4 if scene.load.couple else 1) + int(np.argmax(np.abs(scene.load.direction)))}]"
        if scene.load.on == "floor":
            what = "c_sum"
    if scene.rests:
        # The end of the last average is the last step.
        samples = max(1, round(MEAN / case.duration * steps / SAMPLES))
        lines += [
            "compute sum all reduce sum f_force_floor[3]",
            f"fix mean all ave/time {SAMPLES} {samples} {steps} c_sum",
        ]
        report = "f_mean"
    if scene.load:
        lines.append(f"fix course all ave/time 1 {watch} {watch} {what} file force.txt")
    lines += [
        "thermo_style custom step cpu " + ("ke" if report == "0" else report),
        "thermo_modify lost ignore norm no",
        f"thermo {steps}",
    ]
    if case.watch:
        lines.append(f"dump frames all custom {watch} frames.bin id x y z")
    body = scene.moving
    if body is not None and any(body.spin):
        axis, speed = "{:g} {:g} {:g}".format(*body.spin), np.linalg.norm(body.spin)
        origin = "{:g} {:g} {:g}".format(*body.point)
        lines.append(f"fix move all move/mesh mesh body rotate origin {origin} axis {axis} period {2 * math.pi / speed:.15g}")
    first = min(steps, round(body.begin / INTERVAL) * watch) if body is not None else 0
    if first and first < steps:
        push = "fix move all move/mesh mesh body linear {:g} {:g} {:g}".format(*body.velocity)
        lines += [f"run {first}", push]
    lines += [
        f"run {steps - first if first < steps else steps}",
        f"dump end all custom {steps} end.bin id x y z vx vy vz omegax omegay omegaz",
        "run 0",
    ]
    return lines


def _model(scene: Scene) -> str:
    return "model hertz tangential history" + (" rolling_friction epsd2" if scene.rolling else "")


def _walls(scene: Scene, folder: Path) -> list[str]:
    """Upright and level planes as such, all else as one mesh `body` that tells its force; `floor` tells its own."""
    wall, lines = f"all wall/gran {_model(scene)}", []
    triangles = scene.triangles
    if scene.rests:
        lines.append(f"fix floor {wall} primitive type 1 zplane 0.0 store_force yes")
        for k, plane in enumerate(scene.planes[1:]):
            axis = int(np.argmax(np.abs(plane.normal)))
            lines.append(f"fix side{k} {wall} primitive type 1 {'xyz'[axis]}plane {plane.point[axis]:.15g}")
    if scene.moving is not None:
        triangles = scene.moving.triangles
    if len(triangles):
        write_stl(folder / "walls.stl", triangles)
        point = "{:g} {:g} {:g}".format(*(scene.moving.point if scene.moving is not None else (0, 0, 0)))
        lines += [
            f"fix body all mesh/surface/stress file walls.stl type 1 reference_point {point}",
            f"fix walls {wall} mesh n_meshes 1 meshes body",
        ]
    return lines


def _write_spheres(path: Path, scene: Scene) -> None:
    x, r = scene.position, scene.radius
    moving = scene.moving.triangles.reshape(-1, 3) if scene.moving is not None else np.empty((0, 3))
    corners = np.vstack([scene.triangles.reshape(-1, 3), moving, x])
    low, high = corners.min(0) - MARGIN, corners.max(0) + MARGIN
    for plane in scene.planes if scene.rests else []:
        low, high = np.minimum(low, np.array(plane.point) - MARGIN), np.maximum(high, np.array(plane.point) + MARGIN)
    if scene.rests:
        low[2], high[2] = low[2] - MARGIN, high[2] + 4 * MARGIN
    if scene.drains:
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


def _force(scene: Scene, folder: Path) -> list[float]:
    """The scene's load over its last intervals; a floor stores the forces on the spheres."""
    if scene.load is None:
        return []
    rows = [line.split() for line in (folder / "force.txt").read_text().splitlines() if not line.startswith("#")]
    # A floor tells minus the force on it along z, as the load is counted; a mesh that on it.
    sign = 1.0 if scene.load.on == "floor" else float(sum(scene.load.direction))
    return [float(f"{sign * float(row[1]):.6g}") for row in rows[-round(scene.load.window / INTERVAL) :]]


def _writing(told: str) -> float:
    """Time it took to write positions [s], by its own account."""
    return sum(float(found) for found in re.findall(r"Outpt time \(%\) = (\S+)", told))


def _floor(told: str, steps: int) -> float:
    """Mean force on the floor [N]: the third number in the line of the last step."""
    rows = re.findall(rf"^\s*{steps}\s+\S+\s+(\S+)\s*$", told, re.MULTILINE)
    if not rows:
        raise RuntimeError("no force on the floor in what LIGGGHTS printed")
    return abs(float(rows[0]))
