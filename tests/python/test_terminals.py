"""Two FMUs connected by their terminals alone: a body in one, the boundary that follows it and the grains in the other."""

import csv
import subprocess
import zipfile

import fmpy
import numpy as np
import pytest
from lxml import etree

STEP, MASS = 1e-3, 0.5
HEAD = f"""
[simulation]
duration = 0.3
communication_step = {STEP}
step = {STEP}
fixed_step = true
[[material]]
name = "glass"
density = 2500.0
"""
PLATE = """
[[boundary]]
name = "plate"
material = "glass"
point_of_action = [0.0, 0.0, -0.01]
faces = [{ box = { min = [-0.1, -0.1, -0.02], max = [0.1, 0.1, 0.0] } }]
"""
GRAINS = """
[[spheres]]
name = "grains"
material = "glass"
radius = 0.02
positions = [[-0.04, 0.0, 0.03], [0.05, 0.02, 0.04], [0.02, -0.04, 0.05]]
"""
FAR = """
[[spheres]]
name = "far"
material = "glass"
radius = 0.01
positions = [[9.0, 9.0, 9.0]]
"""
# How the plate moves as a body, and how it follows.
JOINTS = {
    "free": ("body = { mass = 0.5, inertia = [2e-3, 2e-3, 4e-3], gravity = false }", 'input = "pose"'),
    "world": ("body = { mass = 0.5, inertia = [2e-3, 2e-3, 4e-3], gravity = false }", 'input = "world_pose"'),
    "slide": (
        "body = { mass = 0.5, inertia = [2e-3, 2e-3, 4e-3], gravity = false, joint = { slide = [0.0, 0.0, 1.0] } }",
        "input = { slide = [0.0, 0.0, 1.0] }",
    ),
    "hinge": (
        "body = { mass = 0.5, inertia = [2e-3, 2e-3, 4e-3], gravity = false, joint = { hinge = [0.0, 1.0, 0.0] } }",
        "input = { hinge = [0.0, 1.0, 0.0] }",
    ),
}


def exported(command, folder, name, text, version):
    scene, path = folder / f"{name}.toml", folder / f"{name}.fmu"
    scene.write_text(f'title = "{name}"\n{text}')
    subprocess.run([command, "export", scene, "-o", path, "--fmi", version], check=True)
    return path


def members(path):
    """Variable and causality of each member of the terminal `plate`, by part and member name."""
    with zipfile.ZipFile(path) as archive:
        root = etree.fromstring(archive.read("terminalsAndIcons/terminalsAndIcons.xml"))
    (terminal,) = root.findall("Terminals/Terminal[@name='plate']")
    causality = {v.name: v.causality for v in fmpy.read_model_description(str(path)).modelVariables}
    found = {}
    for part in [terminal, *terminal.findall("Terminal")]:
        for member in part.findall("TerminalMemberVariable"):
            key = (part.get("name"), member.get("memberName"))
            assert key not in found, "matching members are ambiguous"
            found[key] = (member.get("variableName"), causality[member.get("variableName")])
    return found


def connections(one, other):
    """`output=input` for all members of the same name."""
    first, second = ({key: (f"{path.stem}.{name}", kind) for key, (name, kind) in members(path).items()} for path in (one, other))
    for key in first.keys() & second.keys():
        (a, kind), (b, opposite) = first[key], second[key]
        if (kind, opposite) == ("output", "input"):
            yield f"{a}={b}"
        elif (kind, opposite) == ("input", "output"):
            yield f"{b}={a}"


@pytest.mark.parametrize("version", ("2", "3"))
@pytest.mark.parametrize("joint", JOINTS)
def test_a_body_and_its_follower_connect_by_terminal(command, tmp_path, joint, version):
    body, follows = JOINTS[joint]
    plate = exported(command, tmp_path, "plate", f'{HEAD}{PLATE}{body}\ninput = "load"\n{FAR}', version)
    bed = exported(command, tmp_path, "bed", f"{HEAD}{PLATE}{follows}\n{GRAINS}", version)
    wires = list(connections(plate, bed))
    elements = {"free": (12, 4), "world": (13, 4)}.get(joint, (2, 2))
    assert len(wires) == elements[version == "3"], wires
    out = tmp_path / "out.csv"
    wired = [part for wire in wires for part in ("--connect", wire)]
    subprocess.run([command, "simulate", plate, bed, *wired, "-o", out, "--stop", "0.3"], check=True)
    with out.open(newline="") as file:
        rows = list(csv.DictReader(file))
    column = lambda name: np.array([float(row[name]) for row in rows])
    # The plate has the momentum that the grains gave it up to the step before, and the follower stands where the plate does.
    if joint == "hinge":
        given = column("bed.boundary.plate.hingeTorque")
        momentum = 2e-3 * column("plate.boundary.plate.jointSpeed")
        angle = column("plate.boundary.plate.jointAngle")
        follower = 2 * np.arctan2(column("bed.boundary.plate.orientation[3]"), column("bed.boundary.plate.orientation[1]"))
        moved = (angle, follower)
    else:
        given = column("bed.boundary.plate.averageForce[3]")
        momentum = MASS * column("plate.boundary.plate.velocity[3]")
        moved = (column("plate.boundary.plate.position[3]"), column("bed.boundary.plate.position[3]"))
    total = np.cumsum(STEP * given)
    assert np.abs(momentum).max() > 1e-3, "nothing happens"
    # Velocities lie half a step beside the loads.
    lag = 1.5 * STEP * np.abs(given).max()
    assert np.abs(momentum - total).max() <= lag
    assert np.abs(momentum[-1] - total[-1]) <= lag
    apart = np.abs(moved[0][:-1] - moved[1][1:]).max()
    assert apart < 1e-9 + 0.02 * np.abs(moved[0]).max(), apart
