"""Contacts that hold, through the FMUs of both versions: pull-off, a chain, a block on a slope, bonds, and states that are restored."""

import subprocess

import fmpy
import numpy as np
import pytest
from fmu import Slave

RADIUS = 0.01
MASS = 2500 * 4 / 3 * np.pi * RADIUS**3
WEIGHT = MASS * 9.81
SECTION = np.pi * RADIUS**2

HEAD = """
[simulation]
duration = 1.0
communication_step = "1 ms"
gravity = [0.0, 0.0, -9.81]
tolerance = {{ gap = 1e-9, slip = 1e-9, force = 1e-9, opening = {opening} }}
[[material]]
name = "ball"
density = 2500.0
[[material]]
name = "wall"
[pair_default]
friction = 0.4
{pair}
[[boundary]]
name = "wall"
material = "wall"
faces = [{{ plane = {{ point = [0.0, 0.0, 0.0], normal = {normal} }} }}]
[[spheres]]
name = "ball"
material = "ball"
radius = 0.01
positions = {positions}
{lock}
[[probe]]
name = "last"
sphere = "ball[{last}]"
"""
COHESION = """
[[parameter]]
name = "cohesion"
sets = "pair_default.cohesion"
"""


@pytest.fixture(scope="module", params=[2, 3], ids=["fmi2", "fmi3"])
def export(request, command, tmp_path_factory):
    folder = tmp_path_factory.mktemp("cohesion")

    def unit(name, pair, normal, positions, lock="", more="", opening=0):
        path = folder / f"{name}.fmu"
        text = HEAD.format(pair=pair, normal=normal, positions=positions, lock=lock, last=len(positions) - 1, opening=opening) + more
        (folder / f"{name}.toml").write_text(text)
        subprocess.run([command, "export", folder / f"{name}.toml", "--fmi", str(request.param), "--overwrite", "-o", path], check=True)
        return path

    return unit


def last(path, wanted, stop=0.3, **start):
    """The last of each wanted result, `name[3]` also where FMI 3.0 has arrays."""
    arrays = {v.name for v in fmpy.read_model_description(str(path)).modelVariables if v.dimensions}
    whole = {name: name.partition("[")[0] if name.partition("[")[0] in arrays else name for name in wanted}
    told = fmpy.simulate_fmu(
        str(path), stop_time=stop, output_interval=1e-3, output=sorted({*whole.values(), "maxOverlap"}), start_values=start
    )
    assert told["maxOverlap"].max() <= 1e-9

    def of(name):
        value = told[whole[name]][-1]
        return value[int(name[-2]) - 1] if np.ndim(value) else value

    return [of(name) for name in wanted]


HEIGHT, HELD = "probe.last.position[3]", "attachedCount"


def test_pull_off_is_sharp(export):
    path = export("hang", "cohesion = 1.0", [0, 0, -1], [[0, 0, -RADIUS]], more=COHESION)
    for cohesion, holds in ((WEIGHT * (1 + 1e-9), 1), (WEIGHT * (1 - 1e-9), 0)):
        height, held, force = last(path, [HEIGHT, HELD, "boundary.wall.averageForce[3]"], cohesion=cohesion)
        assert held == holds
        if holds:
            assert height == pytest.approx(-RADIUS, abs=1e-10)
            assert force == pytest.approx(-WEIGHT, rel=1e-6)
        else:
            assert height < -2 * RADIUS


def test_an_allowed_opening_blurs_the_pull_off_by_a_hundredth_of_the_weight(export):
    """A contact opens to its reserve with a hundredth of gravity, which needs as much force more."""
    path = export("open", "cohesion = 1.0", [0, 0, -1], [[0, 0, -RADIUS]], more=COHESION, opening=1e-3)
    for share, holds in ((1.011, 1), (0.999, 0)):
        assert last(path, [HELD], cohesion=share * WEIGHT) == [holds]


def test_a_chain_parts_at_its_top(export):
    """Four grains: the ceiling's contact bears all of them, and parts where it bears less."""
    positions = [[0, 0, -RADIUS * (2 * k + 1)] for k in range(4)]
    path = export("chain", "cohesion = 1.0", [0, 0, -1], positions, more=COHESION)
    assert last(path, [HELD], cohesion=4.001 * WEIGHT) == [4]
    height, held, hung = last(path, [HEIGHT, HELD, "boundary.wall.contactCount"], stop=0.2, cohesion=3.999 * WEIGHT)
    assert (held, hung) == (3, 0)
    # It falls as one once the ceiling's contact has opened.
    assert height < -7 * RADIUS - 0.05


def test_a_block_slips_later(export):
    """tan a = mu (1 + f_c/(m g cos a)) at a = 45 degrees: f_c = m g cos a (1/mu - 1)."""
    needed = WEIGHT * np.sqrt(0.5) * (1 / 0.4 - 1)
    s = float(np.sqrt(0.5))
    path = export("slope", "cohesion = 1.0", [s, 0, s], [[s * RADIUS, 0, s * RADIUS]], 'lock = ["rotations"]', COHESION)
    for share, moves in ((1.001, False), (0.98, True)):
        (height,) = last(path, [HEIGHT], cohesion=share * needed)
        assert (height < s * RADIUS - 1e-4) == moves


@pytest.mark.parametrize(
    "normal, position, lock, tension, shear",
    [([0, 0, -1], [0, 0, -RADIUS], "", 1, 9), ([1, 0, 0], [RADIUS, 0, 0], 'lock = ["rotations"]', 9, 1), ([1, 0, 0], [RADIUS, 0, 0], "", 4, 9)],
    ids=["tension", "shear", "bending"],
)
def test_bonds_break_at_their_strength(export, normal, position, lock, tension, shear):
    for share, broken in ((1.01, 0), (0.99, 1)):
        strengths = [share * WEIGHT * s / SECTION for s in (tension, shear)]
        bond = f"bond = {{ normal_strength = {strengths[0]}, shear_strength = {strengths[1]} }}"
        path = export(f"bond{broken}", bond, normal, [position], lock)
        assert last(path, ["bondCount", "brokenBonds"], stop=0.1) == [1 - broken, broken]


def test_a_restored_state_goes_on_with_the_same_bits(export):
    """What holds is part of the state: the chain is saved before it parts, and again."""
    positions = [[0, 0, -RADIUS * (2 * k + 1)] for k in range(4)]
    path = export("restored", f"cohesion = {3.99 * WEIGHT}", [0, 0, -1], positions)
    if fmpy.read_model_description(str(path)).fmiVersion != "2.0":
        pytest.skip("this test speaks FMI 2.0")
    with Slave(path) as unit:

        def steps(first, count):
            seen = []
            for k in range(first, first + count):
                unit.step(k * 1e-3, 1e-3)
                seen += unit.get(HEIGHT)
            return seen

        steps(0, 5)
        state, blob = unit.fmi.getFMUstate(), unit.save()
        once = steps(5, 60)
        unit.fmi.setFMUstate(state)
        assert steps(5, 60) == once
        unit.restore(blob)
        assert steps(5, 60) == once
        unit.fmi.freeFMUstate(state)
