"""Elastic grains that adhere or are bonded, through the FMUs of both versions: the curves of JKR and DMT, a liquid bridge, a beam that breaks."""

import subprocess

import fmpy
import numpy as np
import pytest

RADIUS, YOUNG, POISSON, ENERGY = 0.01, 5e6, 0.3, 0.5
EFFECTIVE = YOUNG / (1 - POISSON**2)
STEP, GAP, DEEP, SPEED = 1e-5, 1e-5, 4e-5, 1.03e-2

PLATE = f"""
[simulation]
duration = 1.0
communication_step = {STEP}
step = {STEP}
gravity = [0.0, 0.0, 0.0]
{{sharp}}
[[material]]
name = "ball"
density = 2500.0
{{ball}}
[[material]]
name = "wall"
[pair_default]
friction = 0.3
restitution = 1.0
{{pair}}
[[boundary]]
name = "plate"
material = "wall"
input = {{{{ slide = [0.0, 0.0, 1.0] }}}}
faces = [{{{{ plane = {{{{ point = [0.0, 0.0, 0.0], normal = [0.0, 0.0, 1.0] }}}} }}}}]
[[spheres]]
name = "ball"
material = "ball"
radius = {RADIUS}
positions = [[0.0, 0.0, {{height}}]]
lock = ["translations", "rotations"]
"""
SHARP = "tolerance = { gap = 1e-9, slip = 1e-9, force = 1e-9, opening = 0 }"
ELASTIC = f"young = {YOUNG}\npoisson = {POISSON}"


@pytest.fixture(scope="module", params=[2, 3], ids=["fmi2", "fmi3"])
def export(request, command, tmp_path_factory):
    folder = tmp_path_factory.mktemp("adhesion")

    def unit(name, text):
        path = folder / f"{name}.fmu"
        (folder / f"{name}.toml").write_text(text)
        subprocess.run([command, "export", folder / f"{name}.toml", "--fmi", str(request.param), "--overwrite", "-o", path], check=True)
        return path

    return unit


def driven(path, heights):
    """A plate through these heights at a speed: its height at the start of each step, and the force on it along z, but for the steps
    next to its turns, whose force has a share of its jolt."""
    time = np.concatenate([[0], np.cumsum(np.abs(np.diff(heights))) / SPEED])
    drive = np.array(list(zip(time, heights)), dtype=[("time", float), ("boundary.plate.displacement", float)])
    arrays = {v.name for v in fmpy.read_model_description(str(path)).modelVariables if v.dimensions}
    names = [f"boundary.plate.{part}" for part in ("position", "averageForce")]
    names = [name if name in arrays else f"{name}[3]" for name in names]
    told = fmpy.simulate_fmu(str(path), stop_time=time[-1] - 2 * STEP, output_interval=STEP, input=drive, output=[*names, "attachedCount"])
    height, force = (told[name] if told[name].ndim == 1 else told[name][:, 2] for name in names)
    start = told["time"][:-1]
    steady = np.min(np.abs(start[:, None] - time[None, :]), axis=1) > 3 * STEP
    return height[:-1], force[1:], steady, told["attachedCount"]


def test_the_curve_of_jkr(export):
    """Every force of loading, unloading and neck, against the closed form by the contact radius."""

    def curve(a):
        force = 4 * EFFECTIVE * a**3 / (3 * RADIUS) - np.sqrt(8 * np.pi * ENERGY * EFFECTIVE * a**3)
        return force, a**2 / RADIUS - np.sqrt(2 * np.pi * a * ENERGY / EFFECTIVE)

    fold = np.cbrt(np.pi * ENERGY * RADIUS**2 / (8 * EFFECTIVE))
    pull_off = 1.5 * np.pi * ENERGY * RADIUS

    def force_at(overlap):
        low, high = np.full_like(overlap, fold), np.full_like(overlap, RADIUS)
        for _ in range(200):
            middle = 0.5 * (low + high)
            less = curve(middle)[1] < overlap
            low, high = np.where(less, middle, low), np.where(less, high, middle)
        return curve(high)[0]

    path = export("jkr", PLATE.format(sharp=SHARP, ball=ELASTIC, pair=f'surface_energy = {ENERGY}\nadhesion = "jkr"', height=RADIUS + GAP))
    height, force, steady, _ = driven(path, [0, GAP + DEEP, 0, GAP + 0.5 * DEEP])
    overlap, held, expected, end = height - GAP, False, [], curve(fold)[1]
    for d in overlap:
        held = d > end if held else d > 0
        expected.append(held)
    expected = np.where(expected, force_at(overlap), 0)
    # The plate feels the opposite.
    error = np.abs(-force - expected) / pull_off
    steep = (overlap > 1.02 * end) & (overlap < 0.98 * end)
    assert error[~steep & steady].max() < 1e-6
    assert np.count_nonzero(steep) < 60
    assert (-force).min() == pytest.approx(-pull_off, rel=1e-4)
    # Once it came down and once up it went from nothing to 8/9 of the pull-off force.
    assert np.count_nonzero(np.diff(-force) < -0.8 * pull_off) == 2


def test_the_curve_of_dmt(export):
    pull_off, stiffness = 2 * np.pi * ENERGY * RADIUS, 4 / 3 * EFFECTIVE * np.sqrt(RADIUS)
    path = export("dmt", PLATE.format(sharp=SHARP, ball=ELASTIC, pair=f"surface_energy = {ENERGY}", height=RADIUS + GAP))
    height, force, steady, _ = driven(path, [0, GAP + DEEP, 0])
    overlap = height - GAP
    pressed = overlap > 0
    # The step that touches first attracts from its end on.
    pressed[np.argmax(pressed)] = False
    pressed &= steady
    expected = stiffness * overlap[pressed] ** 1.5 - pull_off
    assert np.abs(-force[pressed] - expected).max() < 1e-6 * pull_off
    assert np.count_nonzero(pressed) > 700
    assert (force[overlap < -1e-7] == 0).all()


def test_a_bridge_holds_up_to_its_rupture_distance(export):
    """Rigid grains: the force is constant over the gap, and ends at the rupture distance."""
    pull_off, distance = 0.05, 6e-5
    pair = f"cohesion = {pull_off}\nrupture_distance = {distance}"
    path = export("bridge", PLATE.format(sharp="", ball="", pair=pair, height=RADIUS))
    height, force, _, attached = driven(path, [0, -1e-4])
    inside, beyond = -height < distance - 2 * SPEED * STEP, -height > distance + 2 * SPEED * STEP
    assert np.count_nonzero(inside) > 500 and np.count_nonzero(beyond) > 300
    assert np.abs(force[inside] - pull_off).max() < 1e-9 * pull_off
    assert (force[beyond] == 0).all()
    assert attached[0] == 1 and attached[-1] == 0


BEAM = """
[simulation]
duration = 1.0
communication_step = 2e-3
step = 2e-3
{sharp}
gravity_motion = {{ table = {{ time = [0.0, 0.6], gravity = [[0.0, 0.0, 0.0], [0.0, 0.0, -9.81]] }} }}
[[material]]
name = "ball"
density = 2500.0
{ball}
[[material]]
name = "wall"
[pair_default]
friction = 0.3
restitution = 0.1
bond = {{ normal_strength = {strength}, shear_strength = {more}, reach = 6e-4, young = 2e7 }}
[[boundary]]
name = "wall"
material = "wall"
faces = [{{ plane = {{ point = [0.0, 0.0, 0.0], normal = [1.0, 0.0, 0.0] }} }}]
[[spheres]]
name = "ball"
material = "ball"
radius = 0.01
positions = {positions}
"""


@pytest.mark.parametrize("ball", ["young = 1e8", ""], ids=["elastic", "rigid"])
def test_a_beam_breaks_at_its_root(export, ball):
    """Four grains over gaps of 0.5 mm, from a wall: the root bears the moment of all."""
    gap = 5e-4
    places = [RADIUS + gap + k * (2 * RADIUS + gap) for k in range(4)]
    weight = 2500 * 4 / 3 * np.pi * RADIUS**3 * 9.81
    root = 4 * sum(weight * x for x in places) / RADIUS / (np.pi * RADIUS**2)
    for share, whole in ((1.01, True), (0.99, False)):
        strength = share * root
        text = BEAM.format(sharp=SHARP, ball=ball, strength=strength, more=9 * strength, positions=[[x, 0, 0] for x in places])
        path = export("beam", text)
        told = fmpy.simulate_fmu(str(path), stop_time=0.8, output_interval=2e-3, output=["bondCount", "brokenBonds"])
        bonds, broken = told["bondCount"], told["brokenBonds"]
        assert bonds[0] == 4 and broken[0] == 0
        assert (broken[-1] > 0) == (not whole)
        # The first to break is one.
        assert whole or broken[broken > 0][0] == 1
