"""The scenes that every code runs: positions, radii, planes and triangles, in SI units, z up.

bed           N spheres r = 0.01 m +-10 %, density 2500, on a loose jittered lattice in a square box of width
              0.4 m (N/1000)^(1/3), dropped and settled for 1.0 s.
rolling       the same with rolling resistance.
polydisperse  N spheres r = 1 to 10 mm, as many in every ratio of radii, dropped at random into a square box; 1.0 s.
slope         180 spheres r = 0.02 m, density 3500, 36 just above each of five planes of 50, 40, 30, 20 and 10 degrees that form
              one profile of 1 m (horizontal) each; 1.0 s.
funnel        an inverted square pyramid (45 degrees) over a square outlet of 0.12 m at z = 0, vertical walls above; two stacks
              of spheres, r = 0.01 m below and 0.007 m above, N/2 each, density 2500; 1.0 s. What is below z = 0 is discharged.
hopper        N spheres r = 6 mm +-5 % run out of a cone below a cylinder, one mesh of 10 000 triangles; 1.0 s.
drum          N spheres r = 5 mm +-10 % in a drum of 24 flat sides that turns at 2 rad/s; 1.5 s.
blade         N spheres r = 10 mm +-10 % settle in a trough for 0.5 s, then an upright plate moves into them for 0.5 s.
feeder        150 grains on a trough that vibrates at 20 Hz; 1.0 s.

Friction is 0.5 and restitution 0 everywhere.
"""

from collections.abc import Callable

from scenes.bed import bed, polydisperse, rolling
from scenes.blade import blade
from scenes.drum import drum
from scenes.feeder import feeder
from scenes.funnel import OUTLET, funnel
from scenes.hopper import hopper
from scenes.scene import DURATION, FRICTION, GRAVITY, Array, Load, Moving, Plane, Scene
from scenes.slope import slope

BUILDERS: dict[str, Callable[[int, int], Scene]] = {
    "bed": bed,
    "rolling": rolling,
    "polydisperse": polydisperse,
    "slope": slope,
    "funnel": funnel,
    "hopper": hopper,
    "drum": drum,
    "blade": blade,
    "feeder": feeder,
}
__all__ = ["BUILDERS", "DURATION", "FRICTION", "GRAVITY", "OUTLET", "Array", "Load", "Moving", "Plane", "Scene", "build"]


def build(name: str, n: int, seed: int) -> Scene:
    """The scene of this name with `n` spheres; a slope has no randomness."""
    return BUILDERS[name](n, seed)
