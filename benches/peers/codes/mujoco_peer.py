"""MuJoCo (convex contact model with soft constraints, elliptic cones, Newton's method), through its Python package.

Spheres are free bodies. A contact approaches its constraint like a damped spring of time constant `time`; MuJoCo keeps that above
two steps, so that small steps are its accurate side. What moves is a body of very large inertia that its own speed carries on:
a body that is only placed would have no surface velocity.
"""

import os
import time
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import numpy as np

try:
    import mujoco
except ModuleNotFoundError:  # `CANNOT` can be asked for without it.
    mujoco = None

import measures
from runs import INTERVAL, MEAN, Case, Outcome
from scenes import FRICTION, GRAVITY, Array, Plane, Scene

CANNOT = {
    "funnel": "MuJoCo takes the convex hull of a mesh: a funnel of triangles is closed",
    "hopper": "MuJoCo takes the convex hull of a mesh: a hopper of triangles is closed",
    "feeder": "MuJoCo is no FMU and runs none",
}
HEAVY = 1e6  # mass and inertia of what moves [kg, kg m^2]
THICK = 0.2  # of the plates that stand for moving planes [m]
TWISTING = 1e-5  # the least torsional coefficient that MuJoCo takes [m]


def run(case: Case, scene: Scene, folder: Path) -> Outcome:
    """One run; only `mj_step` is timed. `folder` is not used: the code runs in this process."""
    del folder
    if mujoco is None:
        raise RuntimeError("mujoco is not installed: pip install -r benches/peers/requirements.txt")
    before = _memory("VmRSS:")
    model = mujoco.MjModel.from_xml_string(_model(case, scene))
    data = mujoco.MjData(model)
    n, step = len(scene.radius), case.settings["step"]
    steps, every = round(case.duration / step), max(1, round(INTERVAL / step))
    load, moving = scene.load, scene.moving
    window = load.window if load else 0.0
    pushed = weighed = wall = cpu = 0.0
    frames: list[Array] = []
    loaded: list[measures.Pairs] = []
    force: list[float] = []
    for k in range(1, steps + 1):
        if moving is not None and (k - 1) * step >= moving.begin - 1e-9 and data.qvel[0] == 0.0:
            data.qvel[0] = np.linalg.norm(moving.spin) if any(moving.spin) else np.linalg.norm(moving.velocity)
        begun, spent = time.perf_counter(), time.process_time()
        mujoco.mj_step(model, data)
        wall += time.perf_counter() - begun
        cpu += time.process_time() - spent
        left = (steps - k) * step
        if load is not None and left < window - 1e-9:
            pushed += _load(model, data, scene)
            if k % every == 0:
                force.append(pushed / every)
                pushed = 0.0
        if scene.rests and left < MEAN - 1e-9:
            weighed += _on_floor(model, data)
        if case.watch and k % every == 0:
            frames.append(_positions(data, n))
            loaded.append(_loaded(data, n))
    memory = _memory("VmHWM:")
    if data.warning.number.any():
        names = [str(mujoco.mjtWarning(k)) for k in np.flatnonzero(data.warning.number)]
        raise RuntimeError(f"MuJoCo warned of {', '.join(names)}")
    state = data.qvel[-6 * n :].reshape(n, 6)
    return Outcome(
        version=mujoco.__version__,
        cpu_s=cpu,
        wall_s=wall,
        spheres=n,
        steps=steps,
        end=measures.end(scene, _positions(data, n), state[:, :3], state[:, 3:], case.duration),
        watched=measures.course(scene, frames, every * step, loaded) if frames else None,
        floor=measures.over_weight(scene, weighed * step / MEAN) if scene.rests else None,
        force=[float(f"{value:.6g}") for value in force],
        memory=(memory - before) / n,
        peak=memory,
    )


def _model(case: Case, scene: Scene) -> str:
    """The scene as MJCF; a body that moves comes first, so that its coordinate and speed are the first ones."""
    s = case.settings
    root = ElementTree.Element("mujoco")
    option = {"timestep": s["step"], "gravity": f"0 0 {-GRAVITY}", "integrator": "implicitfast", "cone": "elliptic", "solver": "Newton"}
    option |= {"iterations": int(s["iterations"]), "tolerance": 1e-10, "jacobian": "sparse"}
    ElementTree.SubElement(root, "option", _words(option))
    ElementTree.SubElement(root, "size", memory="2G")
    world = ElementTree.SubElement(root, "worldbody")
    rolling = scene.rolling > 0
    material = {"condim": 6 if rolling else 3, "solref": f"{s['time']} 1", "solimp": "0.99 0.9999 0.0001 0.5 2"}
    radius = float(scene.radius.mean())

    def geom(parent: ElementTree.Element, kind: str, reduced: float, **others: Any) -> None:
        friction = f"{FRICTION} {TWISTING} {max(scene.rolling * reduced, 1e-9)}"
        ElementTree.SubElement(parent, "geom", _words({"type": kind, "friction": friction, **material, **others}))

    for k, plane in enumerate(scene.planes):
        # The larger coefficient counts: that of walls, whose reduced radius is the sphere's own.
        geom(world, "plane", radius, name=f"wall{k}", size="0 0 1", pos=plane.point, zaxis=plane.normal)
    body = scene.moving
    if body is not None:
        moved = ElementTree.SubElement(world, "body", _words({"name": "moving", "pos": body.point, "gravcomp": 1}))
        turns = any(body.spin)
        ElementTree.SubElement(moved, "inertial", _words({"pos": "0 0 0", "mass": HEAVY, "diaginertia": (HEAVY,) * 3}))
        axis = body.spin if turns else body.velocity
        ElementTree.SubElement(moved, "joint", _words({"type": "hinge" if turns else "slide", "axis": axis}))
        if body.box:
            low, high = np.array(body.box[0]), np.array(body.box[1])
            geom(moved, "box", radius, size=tuple(0.5 * (high - low)), pos=tuple(0.5 * (low + high) - np.array(body.point)))
        reach = 1.3 * max(scene.half_width, float(np.abs(scene.position).max()))
        for plane in body.planes:
            geom(moved, "box", radius, **_plate(plane, np.array(body.point), reach))
    for x, r in zip(scene.position, scene.radius, strict=True):
        grain = ElementTree.SubElement(world, "body", _words({"pos": tuple(x)}))
        ElementTree.SubElement(grain, "freejoint")
        geom(grain, "sphere", 0.5 * r, size=r, density=scene.density)
    return ElementTree.tostring(root, encoding="unicode")


def _plate(plane: Plane, origin: Array, reach: float) -> dict[str, Any]:
    """A box whose inner face lies in the plane."""
    middle = np.array(plane.point) - origin - 0.5 * THICK * np.array(plane.normal)
    return {"size": (reach, reach, 0.5 * THICK), "pos": tuple(middle), "zaxis": plane.normal}


def _words(values: dict[str, Any]) -> dict[str, str]:
    return {k: " ".join(f"{float(q):.17g}" for q in v) if isinstance(v, tuple) else str(v) for k, v in values.items()}


def _positions(data: Any, n: int) -> Array:
    return np.array(data.qpos[-7 * n :].reshape(n, 7)[:, :3])


def _normal_forces(data: Any) -> tuple[Array, Array]:
    """Rows of contacts with a constraint and their normal forces [N]."""
    address = np.array(data.contact.efc_address)
    rows = np.flatnonzero(address >= 0)
    return rows, np.array(data.efc_force[address[rows]])


def _loaded(data: Any, n: int) -> measures.Pairs:
    rows, force = _normal_forces(data)
    geoms = np.array(data.contact.geom)[rows[force > 0]].reshape(-1, 2)
    # Spheres are the last geoms.
    pairs = np.sort(np.maximum(geoms - (_geoms(data) - n), measures.WALL), axis=1)[:, ::-1]
    return pairs[pairs[:, 0] >= 0]


def _geoms(data: Any) -> int:
    return len(data.geom_xpos)


def _on_floor(model: Any, data: Any) -> float:
    """Normal force on the first plane [N]."""
    rows, force = _normal_forces(data)
    floor = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_GEOM, "wall0")
    touching = (np.array(data.contact.geom)[rows] == floor).any(1)
    return float(force[touching].sum())


def _load(model: Any, data: Any, scene: Scene) -> float:
    """The scene's load in the last step [N, N m]: on the floor, or the constraint force of the first joint along its axis."""
    load = scene.load
    if load is None or load.on == "floor":
        return _on_floor(model, data)
    return float(data.qfrc_constraint[0])


def _memory(row: str) -> float:
    """A row of /proc/self/status [B]."""
    lines = Path(f"/proc/{os.getpid()}/status").read_text().splitlines()
    return 1024.0 * next(float(line.split()[1]) for line in lines if line.startswith(row))
