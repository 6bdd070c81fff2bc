"""Sphere-based three-dimensional DDA: scenes, simulations and results as numpy arrays. All values are in SI units.

    import sphere_dda

    scene = sphere_dda.Scene("hopper.toml")
    with sphere_dda.Simulation(scene) as sim:
        sim.step(1e-3)
        print(sim.time, sim.positions)
"""

from .contacts import Contacts
from .errors import CommandError, Problem, SceneError, SimulationError, SimulationWarning, SphereDdaError
from .page import Page
from .results import Frame, Frames, Run, open  # noqa: A004 - `sphere_dda.open` reads like `numpy.load`
from .scene import Check, Scene
from .simulation import Simulation

__all__ = [
    "Check", "CommandError", "Contacts", "Frame", "Frames", "Page", "Problem", "Run", "Scene", "SceneError", "Simulation",
    "SimulationError", "SimulationWarning", "SphereDdaError", "open",
]
