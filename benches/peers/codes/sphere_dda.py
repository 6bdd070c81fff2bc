"""This project: the scene as TOML with CSV and STL, run by the bench target `peers`."""

import json
import os
import subprocess
from collections.abc import Iterator
from pathlib import Path

import numpy as np

import child
import measures
from runs import INTERVAL, Case, Outcome
from scenes import FRICTION, GRAVITY, Array, Moving, Plane, Scene
from scenes.feeder import AMPLITUDE, FREQUENCY, LINE

FORCE, SLIP = 0.1, 7.0  # force residual that goes with every gap tolerance [-], and slip over gap as every `accuracy` has it
ROOT = Path(__file__).resolve().parents[3]
CANNOT: dict[str, str] = {}  # scenes that this code does not run, and why


def build() -> Path:
    """Path of the driver, built if need be."""
    return executable(["bench", "--bench", "peers", "--no-run"], "peers")


def executable(words: list[str], target: str) -> Path:
    """What `cargo` has built for a target."""
    command = ["cargo", *words, "--locked", "--message-format", "json"]
    done = subprocess.run(command, cwd=ROOT, stdout=subprocess.PIPE, text=True, check=True)
    for line in done.stdout.splitlines():
        message = json.loads(line)
        if message.get("executable") and message["target"]["name"] == target:
            return Path(message["executable"])
    raise SystemExit(f"cargo built no target `{target}`")


def write(scene: Scene, case: Case, folder: Path) -> Path:
    """Writes `scene.toml` and the files it names; settings are keys of `[simulation]`, a tolerance is that of the gap."""
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
        *([f"rolling_friction = {scene.rolling}"] if scene.rolling else []),
        "",
        "[[spheres]]",
        'name = "grains"',
        'material = "grain"',
        'csv = "spheres.csv"',
    ]
    if len(scene.triangles) and scene.sheets:
        write_stl(folder / "walls.stl", scene.triangles)
        lines += _boundary("walls", ['stl = { file = "walls.stl" }'])
    elif scene.planes:
        first, *others = scene.planes
        lines += _boundary("floor", [_face(first)]) + _boundary("walls", [_face(p) for p in others])
    if scene.moving is not None:
        lines += _moving(scene, scene.moving, case, folder)
    path = folder / "scene.toml"
    path.write_text("\n".join(lines) + "\n")
    return path


def _setting(name: str, value: float | bool | str) -> str:
    if name == "tolerance":
        return f"tolerance = {{ gap = {value}, slip = {SLIP * value}, force = {FORCE} }}"
    return f"{name} = {json.dumps(value)}"


def _boundary(name: str, faces: list[str]) -> list[str]:
    listed = [f"    {{ {face} }}," for face in faces]
    return ["", "[[boundary]]", f'name = "{name}"', 'material = "grain"', "faces = [", *listed, "]"]


def _face(plane: Plane) -> str:
    point, normal = [[float(q) for q in v] for v in (plane.point, plane.normal)]
    return f"plane = {{ point = {point}, normal = {normal} }}"


def _moving(scene: Scene, body: Moving, case: Case, folder: Path) -> list[str]:
    """The boundary that moves; that of the feeder by its FMU's input or by the same motion in the scene."""
    if scene.name == "feeder":
        write_stl(folder / "moving.stl", body.triangles)
        line = [float(q) for q in LINE]
        shaken = f"sinusoid = {{ translation = {[AMPLITUDE * q for q in line]}, frequency = {FREQUENCY} }}"
        key = f"input = {{ slide = {line} }}" if case.code == "sphere-dda-fmi" else f"motion = {{ {shaken} }}"
        return [*_boundary(body.name, ['stl = { file = "moving.stl" }']), key]
    if body.box:
        low, high = ([float(q) for q in corner] for corner in body.box)
        faces = [f"box = {{ min = {low}, max = {high} }}"]
    else:
        faces = [_face(plane) for plane in body.planes]
    past = max(case.duration - body.begin, 1e-3)
    spin, velocity = ([float(q) for q in v] for v in (body.spin, body.velocity))
    if any(spin):
        motion = f"constant = {{ velocity = {velocity}, angular_velocity = {spin} }}"
    else:
        ways = [[0.0] * 3, [0.0] * 3, [q * past for q in velocity]]
        motion = f"table = {{ time = {[0.0, body.begin, body.begin + past]}, translation = {ways} }}"
    return [*_boundary(body.name, faces), f"motion = {{ {motion} }}", f"point_of_action = {[float(q) for q in body.point]}"]


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
    frames, contacts, end = folder / "frames", folder / "contacts", folder / "end"
    command = [driver, str(write(scene, case, folder)), "--end", str(end)]
    if case.watch:
        command += ["--frames", str(frames), "--contacts", str(contacts)]
    done = child.run(command, folder)
    if done.status != 0:
        raise RuntimeError(done.error.strip())
    told = json.loads(done.out)
    n = len(scene.radius)
    x, v, w = np.split(np.fromfile(end).reshape(n, 9), 3, axis=1)
    watched = None
    if case.watch:
        watched = measures.course(scene, np.fromfile(frames).reshape(-1, n, 3), INTERVAL, loaded(contacts))
    floor, memory = told["floor_force"], told["memory_bytes"]
    return Outcome(
        version=told["version"],
        cpu_s=told["cpu_s"],
        wall_s=told["wall_s"],
        spheres=n,
        steps=told["internal_steps"],
        end=measures.end(scene, x, v, w, case.duration),
        watched=watched,
        worst=told["max_overlap"],
        # Of versions that report it.
        opening=told.get("max_opening"),
        floor=measures.over_weight(scene, floor) if scene.rests else None,
        force=force(scene, told["wrenches"]),
        memory=None if memory is None else memory / n,
        peak=done.peak,
        sweeps=told["sweeps"],
        factorizations=told["factorizations"],
        force_residual=told["force_residual"],
        contacts=told["loaded_contacts"],
        course=told["course"] if case.trace else {},
    )


def force(scene: Scene, wrenches: dict[str, list[list[float]]]) -> list[float]:
    """The scene's load over its last intervals, of the wrenches of all boundaries."""
    load = scene.load
    if load is None:
        return []
    part = slice(3, 6) if load.couple else slice(0, 3)
    course = [float(np.dot(wrench[part], load.direction)) for wrench in wrenches[load.on]]
    return [float(f"{value:.6g}") for value in course[-round(load.window / INTERVAL) :]]


def loaded(path: Path) -> Iterator[measures.Pairs]:
    """Loaded contacts at the ends of intervals, as the driver wrote them."""
    data, at = np.fromfile(path, np.int64), 0
    while at < len(data):
        count = int(data[at])
        yield data[at + 1 : at + 1 + 2 * count].reshape(count, 2)
        at += 1 + 2 * count
