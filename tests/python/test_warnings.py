"""Steps that miss the tolerances: the FMU answers Warning, with the reason in its log, and goes on."""

import subprocess

import pytest
from fmu import Slave
from test_fmi3 import Unit

WARNING = 1  # fmi2Status, fmi3Status
H = 0.01
LID = "boundary.lid.displacement"
# The lid comes down on a ball until there is no rigid answer.
SCENE = """
[simulation]
duration = 1.0

[[material]]
name = "steel"
density = 7800

[[spheres]]
name = "ball"
material = "steel"
radius = 0.01
positions = [[0, 0, 0.01]]

[[boundary]]
name = "floor"
material = "steel"
faces = [{ plane = { point = [0, 0, 0], normal = [0, 0, 1] } }]

[[boundary]]
name = "lid"
material = "steel"
faces = [{ plane = { point = [0, 0, 0.0205], normal = [0, 0, -1] } }]
input = { slide = [0, 0, -1] }
"""


@pytest.fixture(scope="module")
def squeezed(command, tmp_path_factory):
    """FMI version -> FMU."""
    folder = tmp_path_factory.mktemp("squeezed")
    scene = folder / "squeezed.toml"
    scene.write_text(SCENE)
    paths = {}
    for version in (2, 3):
        paths[version] = folder / f"squeezed{version}.fmu"
        subprocess.run([command, "export", scene, "-o", paths[version], "--fmi", str(version)], check=True)
    return paths


def statuses(unit):
    """Statuses of the steps while the lid comes down by 0.8 mm, 0.3 mm into the ball."""
    found, call = [], unit.fmi._call

    def spy(name, *arguments):
        status = call(name, *arguments)
        if name.endswith("DoStep"):
            found.append(status)
        return status

    unit.fmi._call = spy
    for k in range(8):
        unit.set(LID, 1e-4 * (k + 1))
        unit.step(k * H, H)
    return found


def judged(found):
    """No warning before the lid touches, warnings after."""
    assert WARNING not in found[:4]
    assert WARNING in found[4:]


def test_fmi_2_answers_warning(squeezed):
    with Slave(squeezed[2]) as slave:
        judged(statuses(slave))


@pytest.mark.parametrize("watched", [False, True])
def test_fmi_3_answers_warning_in_one_go_and_by_internal_steps(squeezed, watched):
    options = {"intermediateUpdate": lambda *_: None} if watched else {}
    with Unit(squeezed[3], **options) as unit:
        judged(statuses(unit))
        assert any("best iterate" in line for line in unit.lines)
