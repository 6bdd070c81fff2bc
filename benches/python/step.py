"""Cost of a step from Python over that of the command, on a bed of 1000 spheres that falls and settles.

    release/wheel DIST COMMAND linux64=LIBRARY && pip install DIST/*.whl
    python benches/python/step.py

CPU times of the whole: `sphere-dda run` without frames against a loop of `step`, in turn, the least of five of each; then of the
loop that also reads positions, velocities and a force in each step. The starts of both are left out: those of runs of one step.
"""

import resource
import subprocess
import tempfile
import time
from pathlib import Path

import sphere_dda
from sphere_dda.command import program

STEPS, H = 250, 2e-3
SCENE = {
    "simulation": {"duration": STEPS * H, "communication_step": H},
    "output": {"vtu_interval": 0.0},
    "material": [{"name": "glass", "density": 2500.0}],
    "pair_default": {"friction": 0.4, "restitution": 0.3},
    "spheres": [{
        "name": "bed", "material": "glass", "radius": 0.01,
        "lattice": {"origin": [-0.11, -0.11, 0.02], "count": [10, 10, 10], "spacing": 0.0244, "jitter": 0.05},
    }],
    "boundary": [{
        "name": "box", "material": "glass", "faces": [{"box": {"min": [-0.13, -0.13, 0.0], "max": [0.13, 0.13, 0.4]}}],
    }],
}


def command(scene, stop, folder):
    """CPU time of the command [s]."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    call = [program(), "run", scene.path, "-o", folder, "--overwrite", "--stop", str(stop), "--checkpoint-interval", "0"]
    subprocess.run(call, check=True, capture_output=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def loop(scene, stop, look):
    """CPU time of the loop in Python [s]."""
    with sphere_dda.Simulation(scene) as sim:
        sim.step(H)
        start = time.process_time()
        while sim.time < stop - 0.5 * H:
            sim.step(H)
            look(sim)
        return time.process_time() - start


def everything(sim):
    return sim.positions, sim.velocities, sim["boundary.box.averageForce"]


def main():
    scene = sphere_dda.Scene(SCENE)
    with tempfile.TemporaryDirectory() as folder:
        times = {"command": [], "steps": [], "steps, arrays read": []}
        for _ in range(5):
            whole = command(scene, STEPS * H, Path(folder, "run"))
            times["command"].append(whole - command(scene, H, Path(folder, "run")))
            times["steps"].append(loop(scene, STEPS * H, lambda sim: None))
            times["steps, arrays read"].append(loop(scene, STEPS * H, everything))
    least = min(times["command"])
    for name, all_times in times.items():
        print(f"{name:20} {min(all_times) / (STEPS - 1) * 1e3:8.3f} ms a step   {min(all_times) / least:.3f}")


if __name__ == "__main__":
    main()
