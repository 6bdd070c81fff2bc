"""Rapier (single precision, soft constraints in substeps), through its Python package.

Its defaults keep 0.2 radii of overlap at rest; raised softness and substeps and no recycling of contacts are its accurate side.
"""

import os
import time
from importlib.metadata import version
from pathlib import Path

import numpy as np
import rapier3d

import measures
from runs import INTERVAL, MEAN, Case, Outcome
from scenes import FRICTION, GRAVITY, Array, Scene


def run(case: Case, scene: Scene, folder: Path) -> Outcome:
    """One run; only `step` is timed. `folder` is not used: the code runs in this process."""
    del folder
    s = case.settings
    before = _memory("VmRSS:")
    world = _world(case, scene)
    floor = _add_walls(world, scene)
    bodies = _add_spheres(world, scene)
    steps = round(case.duration / s["step"])
    every = max(1, round(INTERVAL / s["step"]))
    mean = round(MEAN / s["step"])
    wall = cpu = impulse = 0.0
    frames: list[Array] = []
    for k in range(1, steps + 1):
        begun, spent = time.perf_counter(), time.process_time()
        world.step()
        wall += time.perf_counter() - begun
        cpu += time.process_time() - spent
        if case.watch and k % every == 0:
            frames.append(_rows(world, bodies, "translation"))
        if scene.name == "bed" and k > steps - mean:
            impulse += _impulse(world, floor)
    memory = _memory("VmHWM:")
    x, v, w = (_rows(world, bodies, what) for what in ("translation", "linvel", "angvel"))
    return Outcome(
        version=version("rapier3d"),
        cpu_s=cpu,
        wall_s=wall,
        spheres=len(scene.radius),
        steps=steps,
        end=measures.end(scene, x, v, w),
        watched=measures.course(scene, frames, every * s["step"]) if frames else None,
        floor=measures.over_weight(scene, impulse / (mean * s["step"])) if scene.name == "bed" else None,
        memory=(memory - before) / len(x),
    )


def _world(case: Case, scene: Scene) -> rapier3d.PhysicsWorld:
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


def _add_walls(world: rapier3d.PhysicsWorld, scene: Scene) -> rapier3d.ColliderHandle:
    """The handle of the first wall: the floor of a bed."""
    if scene.sheets:
        corners = scene.triangles.reshape(-1, 3)
        shapes = [rapier3d.Collider.trimesh(corners.tolist(), np.arange(len(corners)).reshape(-1, 3).tolist())]
    else:
        shapes = [rapier3d.Collider.halfspace(p.normal).translation(p.point) for p in scene.planes]
    handles = [world.colliders.insert(shape.friction(FRICTION).restitution(0.0)) for shape in shapes]
    return handles[0]


def _add_spheres(world: rapier3d.PhysicsWorld, scene: Scene) -> list[rapier3d.RigidBodyHandle]:
    bodies = []
    for x, r in zip(scene.position.tolist(), scene.radius.tolist(), strict=True):
        body = world.rigid_bodies.insert(rapier3d.RigidBody.dynamic().translation(tuple(x)).can_sleep(False))
        ball = rapier3d.Collider.ball(r).density(scene.density).friction(FRICTION).restitution(0.0)
        world.colliders.insert_with_parent(ball, body, world.rigid_bodies)
        bodies.append(body)
    return bodies


def _rows(world: rapier3d.PhysicsWorld, bodies: list[rapier3d.RigidBodyHandle], what: str) -> Array:
    return np.array([tuple(getattr(world.rigid_bodies[body], what)) for body in bodies], float)


def _impulse(world: rapier3d.PhysicsWorld, floor: rapier3d.ColliderHandle) -> float:
    """Normal impulse on the floor in the last step [N s]."""
    pairs = world.narrow_phase.contact_pairs_with(floor)
    points = (point for pair in pairs for manifold in pair.manifolds for point in manifold.points)
    return sum(point.data.impulse if hasattr(point, "data") else point.impulse for point in points)


def _memory(row: str) -> float:
    """A row of /proc/self/status [B]."""
    lines = Path(f"/proc/{os.getpid()}/status").read_text().splitlines()
    return 1024.0 * next(float(line.split()[1]) for line in lines if line.startswith(row))
