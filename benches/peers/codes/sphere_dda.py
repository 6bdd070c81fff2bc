"""This project: the scene as TOML with CSV and STL, run by the bench target `peers`."""

import json
import os
import subprocess
from pathlib import Path

import numpy as np

import measures
from runs import INTERVAL, Case, Outcome
from scenes import FRICTION, GRAVITY, Array, Plane, Scene

FORCE = 0.1  # force residual that goes with every gap tolerance [-]
ROOT = Path(__file__).resolve().parents[3]


def build() -> Path:
    """Path of the driver, built if need be."""
    command = ["cargo", "bench", "--locked", "--bench", "peers", "--no-run", "--message-format", "json"]
    done = subprocess.run(command, cwd=ROOT, stdout=subprocess.PIPE, text=True, check=True)
    for line in done.stdout.splitlines():
        message = json.loads(line)
        if message.get("executable") and message["target"]["name"] == "peers":
            return Path(message["executable"])
    raise SystemExit("cargo built no bench target `peers`")


def write(scene: Scene, case: Case, folder: Path) -> Path:
    """Writes `scene.toml` and the files it names; settings are keys of `[simulation]`, a tolerance is that of gap and slip."""
    table = np.column_stack([scene.position, scene.radius])
    np.savetxt(folder / "spheres.csv", table, "%.17g", ",", header="x,y,z,radius", comments="")
    lines = [
        f'title = "{scene.name} of {len(scene.radius)} spheres"',
        "",
        "[simulation]",
        f"duration = {case.duration}",
        f"communication_step = {INTERVAL}",
        f"gravity = [0.0, 0.0, {-GRAVITY}]",
        f"threads = {case.threads}",
        *(_setting(name, value) for name, value in case.settings.items()),
        "",
        "[[material]]",
        'name = "grain"',
        f"density = {scene.density}",
        "",
        "[pair_default]",
        f"friction = {FRICTION}",
        "",
        "[[spheres]]",
        'name = "grains"',
        'material = "grain"',
        'csv = "spheres.csv"',
    ]
    if scene.sheets:
        write_stl(folder / "walls.stl", scene.triangles)
        lines += _boundary("walls", ['stl = { file = "walls.stl" }'])
    else:
        first, *others = scene.planes
        lines += _boundary("floor", [_face(first)]) + _boundary("walls", [_face(p) for p in others])
    path = folder / "scene.toml"
    path.write_text("\n".join(lines) + "\n")
    return path


def _setting(name: str, value: float | bool | str) -> str:
    if name == "tolerance":
        return f"tolerance = {{ gap = {value}, slip = {value}, force = {FORCE} }}"
    return f"{name} = {json.dumps(value)}"


def _boundary(name: str, faces: list[str]) -> list[str]:
    listed = [f"    {{ {face} }}," for face in faces]
    return ["", "[[boundary]]", f'name = "{name}"', 'material = "grain"', "faces = [", *listed, "]"]


def _face(plane: Plane) -> str:
    point, normal = [[float(q) for q in v] for v in (plane.point, plane.normal)]
    return f"plane = {{ point = {point}, normal = {normal} }}"


def write_stl(path: Path, triangles: Array) -> None:
    """Writes an ASCII STL file."""
    lines = ["solid walls"]
    for corners in triangles:
        normal = np.cross(corners[1] - corners[0], corners[2] - corners[0])
        normal /= np.linalg.norm(normal)
        lines.append("facet normal {:.9g} {:.9g} {:.9g}".format(*normal))
        lines += ["outer loop", *("vertex {:.12g} {:.12g} {:.12g}".format(*c) for c in corners), "endloop", "endfacet"]
    path.write_text("\n".join([*lines, "endsolid walls"]) + "\n")


def run(case: Case, scene: Scene, folder: Path) -> Outcome:
    """One run; the driver is named in SPHERE_DDA_PEERS."""
    driver = os.environ["SPHERE_DDA_PEERS"]
    frames, end = folder / "frames", folder / "end"
    command = [driver, write(scene, case, folder), "--end", end]
    if case.watch:
        command += ["--frames", frames]
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise RuntimeError(done.stderr.strip())
    told = json.loads(done.stdout)
    n = len(scene.radius)
    x, v, w = np.split(np.fromfile(end).reshape(n, 9), 3, axis=1)
    watched = None
    if case.watch:
        watched = measures.course(scene, np.fromfile(frames).reshape(-1, n, 3), INTERVAL)
    floor, memory = told["floor_force"], told["memory_bytes"]
    return Outcome(
        version=told["version"],
        cpu_s=told["cpu_s"],
        wall_s=told["wall_s"],
        spheres=n,
        steps=told["internal_steps"],
        end=measures.end(scene, x, v, w),
        watched=watched,
        worst=told["max_overlap"],
        floor=measures.over_weight(scene, floor) if scene.name == "bed" else None,
        memory=None if memory is None else memory / n,
        sweeps=told["sweeps"],
        factorizations=told["factorizations"],
        force_residual=told["force_residual"],
        contacts=told["loaded_contacts"],
        course=told["course"] if case.trace else {},
    )
