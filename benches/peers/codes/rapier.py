"""Rapier (single precision, soft constraints in substeps), through its Python package.

Its defaults keep 0.2 radii of overlap at rest; raised softness and substeps and no recycling of contacts are its accurate side.
"""

import os
import time
from collections.abc import Iterator
from importlib.metadata import version
from pathlib import Path
from typing import Any

import numpy as np

try:
    import rapier3d
except ModuleNotFoundError:  # `CANNOT` can be asked for without it.
    rapier3d = None

import measures
from runs import INTERVAL, MEAN, Case, Outcome
from scenes import FRICTION, GRAVITY, Array, Moving, Scene

LOOK = 10  # output times between two at which contacts are read, which takes longer than the steps between
CANNOT = {
    "rolling": "Rapier has no rolling resistance",
    "feeder": "Rapier is no FMU and runs none",
}


def run(case: Case, scene: Scene, folder: Path) -> Outcome:
    """One run; only `step` is timed. `folder` is not used: the code runs in this process."""
    del folder
    if rapier3d is None:
        raise RuntimeError("rapier3d is not installed: pip install -r benches/peers/requirements.txt")
    s = case.settings
    before = _memory("VmRSS:")
    world = _world(case, scene)
    walls = _add_walls(world, scene)
    body, moving = _add_moving(world, scene)
    bodies = _add_spheres(world, scene)
    index = {collider: i for i, collider in enumerate(c for b in bodies for c in [world.rigid_bodies[b].colliders[0]])}
    steps = round(case.duration / s["step"])
    every = max(1, round(INTERVAL / s["step"]))
    mean = round(MEAN / s["step"])
    wall = cpu = impulse = pushed = 0.0
    frames: list[Array] = []
    loaded: list[measures.Pairs | None] = []
    states: list[tuple[Array, Array, Array]] = []
    force: list[float] = []
    load = scene.load
    window = load.window if load else 0.0
    direct = scene.rests and load is not None
    begun_moving = False
    if load and not direct and window >= case.duration:
        states.append(_state(world, bodies))
    for k in range(1, steps + 1):
        if scene.moving and not begun_moving and (k - 1) * s["step"] >= scene.moving.begin - 1e-9:
            begun_moving = _move(world, body, scene.moving)
        begun, spent = time.perf_counter(), time.process_time()
        world.step()
        wall += time.perf_counter() - begun
        cpu += time.process_time() - spent
        if case.watch and k % every == 0:
            frames.append(_rows(world, bodies, "translation"))
            loaded.append(_loaded(world, index) if k % (LOOK * every) == 0 else None)
        late = k > steps - round(window / s["step"])
        if direct and late:
            pushed += _pushed(world, [walls[0]] if load.on == "floor" else moving, load.direction)
            if k % every == 0:
                force.append(pushed / (every * s["step"]))
                pushed = 0.0
        elif load and not direct and k % every == 0 and k * s["step"] > case.duration - window - 1e-9:
            states.append(_state(world, bodies))
        if scene.rests and k > steps - mean:
            impulse += _pushed(world, [walls[0]], (0, 0, -1))
    memory = _memory("VmHWM:")
    x, v, w = _state(world, bodies)
    return Outcome(
        version=version("rapier3d"),
        cpu_s=cpu,
        wall_s=wall,
        spheres=len(scene.radius),
        steps=steps,
        end=measures.end(scene, x, v, w, case.duration),
        watched=measures.course(scene, frames, every * s["step"], loaded) if frames else None,
        floor=measures.over_weight(scene, impulse / (mean * s["step"])) if scene.rests else None,
        force=force or measures.by_balance(scene, states, every * s["step"]),
        memory=(memory - before) / len(x),
        peak=memory,
    )


def _world(case: Case, scene: Scene) -> Any:
    world = rapier3d.PhysicsWorld(gravity=(0.0, 0.0, -GRAVITY))
    world.set_num_threads(case.threads)
    s, parameters = case.settings, world.integration_parameters
    parameters.dt = s["step"]
    parameters.num_solver_iterations = int(s["substeps"])
    parameters.length_unit = float(2 * scene.radius.mean())
    parameters.contact_recycling = False
    # How far ahead contacts are looked for: in lengths, of which one is the mean diameter.
    if "prediction" in s:
        parameters.normalized_prediction_distance = s["prediction"]
    # By default 400 lengths a second: less than spheres reach that fall out of the funnel.
    parameters.normalized_max_linear_velocity = 1e6
    # The second number is the damping ratio; contacts with what is fixed are twice as stiff, as by default.
    parameters.contact_softness = rapier3d.SpringCoefficients(s["softness"], 5.0)
    parameters.static_contact_softness = rapier3d.SpringCoefficients(2 * s["softness"], 5.0)
    return world


def _add_walls(world: Any, scene: Scene) -> list[Any]:
    """The handles of walls that stand still; the first one is the floor of a bed."""
    if scene.sheets:
        corners = scene.triangles.reshape(-1, 3)
        shapes = [rapier3d.Collider.trimesh(corners.tolist(), np.arange(len(corners)).reshape(-1, 3).tolist())]
    else:
        shapes = [rapier3d.Collider.halfspace(p.normal).translation(p.point) for p in scene.planes]
    return [world.colliders.insert(shape.friction(FRICTION).restitution(0.0)) for shape in shapes]


def _add_moving(world: Any, scene: Scene) -> tuple[Any, list[Any]]:
    """The body that moves and its shapes; its frame is that of the scene, moved to `point`."""
    moving = scene.moving
    if moving is None:
        return None, []
    body = world.rigid_bodies.insert(rapier3d.RigidBody.kinematic_velocity_based().translation(moving.point))
    point = np.array(moving.point)
    if moving.box:
        low, high = np.array(moving.box[0]), np.array(moving.box[1])
        middle = tuple((0.5 * (low + high) - point).tolist())
        shapes = [rapier3d.Collider.cuboid(*(0.5 * (high - low)).tolist()).translation(middle)]
    else:
        places = [tuple((np.array(p.point) - point).tolist()) for p in moving.planes]
        shapes = [rapier3d.Collider.halfspace(p.normal).translation(at) for p, at in zip(moving.planes, places, strict=True)]
    made = [shape.friction(FRICTION).restitution(0.0) for shape in shapes]
    return body, [world.colliders.insert_with_parent(shape, body, world.rigid_bodies) for shape in made]


def _move(world: Any, body: Any, moving: Moving) -> bool:
    world.rigid_bodies[body].linvel = moving.velocity
    world.rigid_bodies[body].angvel = moving.spin
    return True


def _add_spheres(world: Any, scene: Scene) -> list[Any]:
    bodies = []
    for x, r in zip(scene.position.tolist(), scene.radius.tolist(), strict=True):
        body = world.rigid_bodies.insert(rapier3d.RigidBody.dynamic().translation(tuple(x)).can_sleep(False))
        ball = rapier3d.Collider.ball(r).density(scene.density).friction(FRICTION).restitution(0.0)
        world.colliders.insert_with_parent(ball, body, world.rigid_bodies)
        bodies.append(body)
    return bodies


def _rows(world: Any, bodies: list[Any], what: str) -> Array:
    return np.array([tuple(getattr(world.rigid_bodies[body], what)) for body in bodies], float)


def _state(world: Any, bodies: list[Any]) -> tuple[Array, Array, Array]:
    """Positions, velocities and spins."""
    x, v, w = (_rows(world, bodies, what) for what in ("translation", "linvel", "angvel"))
    return x, v, w


def _pushed(world: Any, colliders: list[Any], direction: tuple[float, float, float]) -> float:
    """Normal impulses of the last step on shapes, along a direction [N s]."""
    total = 0.0
    for collider in colliders:
        for pair in world.narrow_phase.contact_pairs_with(collider):
            own = np.dot(tuple(pair.total_impulse()), direction)
            total += own if pair.collider2 == collider else -own
    return float(total)


def _loaded(world: Any, index: dict[Any, int]) -> measures.Pairs:
    """Pairs with a normal impulse in the last step."""

    def found() -> Iterator[tuple[int, int]]:
        for pair in world.narrow_phase.contact_pairs():
            if pair.total_impulse_magnitude() > 0:
                a, b = (index.get(c, measures.WALL) for c in (pair.collider1, pair.collider2))
                yield (a, b) if a != measures.WALL else (b, a)

    return np.array(list(found()), np.int64).reshape(-1, 2)


def _memory(row: str) -> float:
    """A row of /proc/self/status [B]."""
    lines = Path(f"/proc/{os.getpid()}/status").read_text().splitlines()
    return 1024.0 * next(float(line.split()[1]) for line in lines if line.startswith(row))
