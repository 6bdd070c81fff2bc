"""NVIDIA Newton on the CPU, through its Python package: block descent with an augmented Lagrangian (`SolverVBD`), single precision.

It tells no contact forces of rigid bodies: openings and loads are not measured.
"""

import os
import time
from importlib.metadata import version
from pathlib import Path
from typing import Any

import numpy as np

try:
    import newton
    import warp
except ModuleNotFoundError:  # `CANNOT` can be asked for without it.
    newton = warp = None

import measures
from runs import INTERVAL, Case, Outcome
from scenes import BUILDERS, FRICTION, GRAVITY, Array, Scene

RUNS = ("bed", "polydisperse", "slope")
CANNOT = {name: "its adapter has planes that stand still and no resistance to rolling" for name in BUILDERS if name not in RUNS}
CANNOT["feeder"] = "Newton is no FMU and runs none"
REACH = 0.2  # gap up to which contacts are looked for, over the mean radius [-]


def run(case: Case, scene: Scene, folder: Path) -> Outcome:
    """One run; detection and solution are timed, without compiling kernels: the first step is not. `folder` is not used."""
    del folder
    if newton is None:
        raise RuntimeError("newton is not installed: pip install -r benches/peers/requirements.txt")
    warp.config.quiet = True
    warp.set_device("cpu")
    before = _memory("VmRSS:")
    model = _model(case, scene)
    s, n = case.settings, len(scene.radius)
    solver = newton.solvers.SolverVBD(model, iterations=int(s["iterations"]))
    pipeline = newton.CollisionPipeline(model)
    contacts, control = pipeline.contacts(), model.control()
    state, following = model.state(), model.state()
    steps, every = round(case.duration / s["step"]), max(1, round(INTERVAL / s["step"]))
    wall = cpu = 0.0
    frames: list[Array] = []
    for k in range(1, steps + 1):
        begun, spent = time.perf_counter(), time.process_time()
        state.clear_forces()
        pipeline.collide(state, contacts)
        solver.step(state, following, control, contacts, s["step"])
        state, following = following, state
        if k > 1:
            wall += time.perf_counter() - begun
            cpu += time.process_time() - spent
        if case.watch and k % every == 0:
            frames.append(state.body_q.numpy()[:, :3].astype(float))
    memory = _memory("VmHWM:")
    speeds = state.body_qd.numpy().astype(float)
    x = state.body_q.numpy()[:, :3].astype(float)
    return Outcome(
        version=version("newton"),
        cpu_s=cpu,
        wall_s=wall,
        spheres=n,
        steps=steps,
        end=measures.end(scene, x, speeds[:, :3], speeds[:, 3:], case.duration),
        watched=measures.course(scene, frames, every * s["step"]) if frames else None,
        memory=(memory - before) / n,
        peak=memory,
    )


def _model(case: Case, scene: Scene) -> Any:
    builder = newton.ModelBuilder(gravity=(0.0, 0.0, -GRAVITY))
    shape = newton.ModelBuilder.ShapeConfig(density=scene.density, mu=FRICTION, restitution=0.0)
    shape.gap = REACH * float(scene.radius.mean())
    shape.ke, shape.kd = float(case.settings["stiffness"]), 0.0
    for x, r in zip(scene.position.tolist(), scene.radius.tolist(), strict=True):
        body = builder.add_body(xform=warp.transform(x, warp.quat_identity()))
        builder.add_shape_sphere(body, radius=r, cfg=shape)
    for plane in scene.planes:
        # n.x + d = 0
        normal = [float(q) for q in plane.normal]
        builder.add_shape_plane(plane=(*normal, -float(np.dot(plane.normal, plane.point))), width=0.0, length=0.0, cfg=shape)
    builder.color()
    return builder.finalize()


def _memory(row: str) -> float:
    """A row of /proc/self/status [B]."""
    lines = Path(f"/proc/{os.getpid()}/status").read_text().splitlines()
    return 1024.0 * next(float(line.split()[1]) for line in lines if line.startswith(row))
