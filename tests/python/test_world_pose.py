"""Boundaries placed by position and quaternion: against the motion that the scene prescribes, the other inputs, a rigid body."""

import subprocess
import sys

import fmpy
import numpy as np
import pytest
from conftest import ROOT, scene
from fmu import Slave
from scipy.spatial.transform import Rotation
from test_fmi3 import Unit

sys.path[:0] = [str(ROOT / "examples" / "multibody")]
from swing import REST, rotation_vector, swing  # noqa: E402

STEP, H = 1e-3, 5e-3
HEAD = f"""
[simulation]
duration = 3.0
communication_step = {H}
step = {STEP}
fixed_step = true
gravity = GRAVITY
tolerance = {{ gap = 1e-8, slip = 1e-8, force = 1e-8, opening = 0 }}
[[material]]
name = "glass"
density = 2500.0
[pair_default]
friction = 0.4
"""
# A closed box that turns about an axis askew through a point outside of it, with three balls inside.
PIVOT = np.array([0.02, -0.03, 0.4])
BOX = """
[[boundary]]
name = "box"
material = "glass"
point_of_action = [0.02, -0.03, 0.4]
faces = [{ box = { min = [-0.05, -0.05, 0.3], max = [0.05, 0.05, 0.4] } }]
MOTION
[[spheres]]
name = "balls"
material = "glass"
radius = 0.015
positions = [[-0.02, 0.0, 0.35], [0.02, 0.01, 0.34], [0.0, -0.02, 0.37]]
"""
LINEAR, ANGULAR = np.array([0.05, -0.1, 0.2]), np.array([1.5, -2.0, 3.0])
POSITION, ORIENTATION = "boundary.box.targetPosition", "boundary.box.targetOrientation"


def exported(command, folder, text, version=2, name="scene"):
    source, path = folder / f"{name}.toml", folder / f"{name}.fmu"
    source.write_text(f'title = "{name}"\n{text}')
    subprocess.run([command, "export", source, "--fmi", str(version), "-o", path], check=True)
    return path


def wxyz(rotation):
    """Scalar part first, whatever its sign."""
    return rotation.as_quat(scalar_first=True)


def give(slave, position, orientation, boundary="box"):
    for name, values in (("targetPosition", position), ("targetOrientation", orientation)):
        name = f"boundary.{boundary}.{name}"
        if isinstance(slave, Unit):
            slave.set(name, *values)
        else:
            for k, value in enumerate(values, start=1):
                slave.set(f"{name}[{k}]", value)


def advance(slave, time, h):
    if isinstance(slave, Unit):
        return slave.fmi.doStep(currentCommunicationPoint=time, communicationStepSize=h)
    return slave.step(time, h)


def read(slave, name, count=3):
    if isinstance(slave, Unit):
        return np.array(slave.get(name))
    return np.array(slave.get(*(f"{name}[{k}]" for k in range(1, count + 1))))


def spheres(slave):
    """Centres [m] of all spheres: all of FMI 3.0, mean momentum and energies of FMI 2.0."""
    if isinstance(slave, Unit):
        return slave.get("spheres.position")
    return np.array([*read(slave, "momentum"), *slave.get("kineticEnergy", "potentialEnergy")])


@pytest.fixture(scope="module", params=(2, 3), ids=("fmi2", "fmi3"))
def boxes(request, command, tmp_path_factory):
    """The box moved by the scene and by its pose, and what opens either."""
    folder = tmp_path_factory.mktemp("box")
    motion = f"motion = {{ constant = {{ velocity = {LINEAR.tolist()}, angular_velocity = {ANGULAR.tolist()} }} }}"
    text = (HEAD + BOX).replace("GRAVITY", "[0.0, 0.0, -9.81]")
    paths = [
        exported(command, folder, text.replace("MOTION", how), request.param, name)
        for name, how in (("prescribed", motion), ("posed", 'input = "world_pose"'))
    ]
    return [Slave, Unit][request.param - 2], *paths


def target(time):
    """Where the prescribed motion is at a time: position, quaternion."""
    return PIVOT + LINEAR * time, wxyz(Rotation.from_rotvec(ANGULAR * time))


def test_inputs_start_as_in_the_scene(boxes):
    kind, _, posed = boxes
    with kind(posed) as slave:
        assert read(slave, POSITION).tolist() == PIVOT.tolist()
        assert read(slave, ORIENTATION, 4).tolist() == [1.0, 0.0, 0.0, 0.0]
        advance(slave, 0.0, H)
        assert read(slave, "boundary.box.position").tolist() == PIVOT.tolist()
        assert read(slave, "boundary.box.orientation", 4).tolist() == [1.0, 0.0, 0.0, 0.0]
    units = {v.name.split("[")[0]: v.unit for v in fmpy.read_model_description(str(posed)).modelVariables}
    assert (units[POSITION], units[ORIENTATION]) == ("m", None)


def test_a_box_turned_by_quaternions_is_the_one_that_the_scene_turns(boxes):
    """Two turns and a half about an axis askew: the pose agrees to rounding, and so do the balls while they lie still enough."""
    kind, prescribed, posed = boxes
    apart, turned = [], 0.0
    with kind(prescribed) as own, kind(posed) as other:
        for k in range(800):
            position, orientation = target((k + 1) * H)
            # A tool may change the sign whenever it likes.
            give(other, position, orientation * (-1) ** (k // 7))
            for slave in (own, other):
                advance(slave, k * H, H)
            found = read(other, "boundary.box.position"), read(other, "boundary.box.orientation", 4)
            assert np.abs(found[0] - position).max() < 1e-13
            assert min(np.abs(found[1] - orientation).max(), np.abs(found[1] + orientation).max()) < 1e-12
            turned = (k + 1) * H * np.linalg.norm(ANGULAR)
            apart.append(np.abs(spheres(own) - spheres(other)).max())
    assert turned > 2.4 * 2 * np.pi
    # Rounding of the pose, which rolling balls carry on.
    assert max(apart[:200]) < 1e-9, max(apart[:200])


def test_the_sign_of_a_quaternion_changes_no_bit(boxes):
    kind, _, posed = boxes
    with kind(posed) as plus, kind(posed) as minus:
        for k in range(100):
            position, orientation = target((k + 1) * H)
            give(plus, position, orientation)
            give(minus, position, orientation * (1 if k % 3 else -1))
            for slave in (plus, minus):
                advance(slave, k * H, H)
            assert spheres(plus).tobytes() == spheres(minus).tobytes()
            for name in ("averageForce", "averageTorque", "position"):
                assert read(plus, f"boundary.box.{name}").tobytes() == read(minus, f"boundary.box.{name}").tobytes()


def test_quaternions_of_single_precision_are_taken_and_others_are_not(boxes):
    kind, _, posed = boxes
    lines = []
    with kind(posed) as slave:
        position, orientation = target(H)
        for scale in (1 + 1e-7, 0.992, 1.008):
            give(slave, position, orientation * scale)
            saved = slave.fmi.getFMUState() if kind is Unit else slave.fmi.getFMUstate()
            advance(slave, 0.0, H)
            found = read(slave, "boundary.box.orientation", 4)
            assert np.abs(found - orientation).max() < 1e-14
            (slave.fmi.setFMUState if kind is Unit else slave.fmi.setFMUstate)(saved)
        before = read(slave, "boundary.box.orientation", 4).tobytes()
        for bad in ((0, 0, 0, 0), (0.98, 0, 0, 0), 1.02 * orientation, (0.0, 0.1, 0.2, 0.3)):
            give(slave, position, bad)
            with pytest.raises(fmpy.fmi1.FMICallException):
                advance(slave, 0.0, H)
            lines.append(getattr(slave, "lines", [""])[-1])
            assert read(slave, "boundary.box.orientation", 4).tobytes() == before
        with pytest.raises(fmpy.fmi1.FMICallException):
            give(slave, position, (np.nan, 0, 0, 0))
        # Nothing has happened: a good one goes on.
        give(slave, position, orientation)
        advance(slave, 0.0, H)
        assert np.abs(read(slave, "boundary.box.orientation", 4) - orientation).max() < 1e-14
    if kind is Unit:
        for line in lines:
            assert "boundary.box.targetOrientation: found [" in line and "expected a unit quaternion w, x, y, z" in line, line


def test_a_start_elsewhere_places_the_box_without_velocity(command, tmp_path):
    """Poses set before the end of initialization move the box there at once, the balls not."""
    text = (HEAD + BOX).replace("GRAVITY", "[0.0, 0.0, -9.81]").replace("MOTION", 'input = "world_pose"')
    # The balls beside the box: it comes from the origin of its own frame to under them.
    text = text.replace("positions = [[-0.02, 0.0, 0.35], [0.02, 0.01, 0.34], [0.0, -0.02, 0.37]]", "positions = [[1.0, 0.0, 0.7]]")
    orientation = Rotation.from_euler("y", 90, degrees=True)
    position = np.array([1.0, 0.0, 0.0])
    with Unit(exported(command, tmp_path, text, 3), initialize=False) as unit:
        unit.fmi.enterInitializationMode(startTime=0.0, stopTime=1.0)
        give(unit, position, -wxyz(orientation))
        unit.fmi.exitInitializationMode()
        assert np.abs(read(unit, "boundary.box.position") - position).max() == 0.0
        ball = spheres(unit)[0]
        advance(unit, 0.0, H)
        # Moreau: half a step of velocity first, then the fall.
        assert spheres(unit)[0] == pytest.approx(ball - [0, 0, 9.81 * H**2 / 2], abs=1e-12)


@pytest.mark.parametrize("orders", (1, 2))
def test_derivatives_of_a_quaternion_turn_without_lag(command, tmp_path, orders):
    """q' = w q/2 and q'' = w w q/4: constant angular velocity is exact, and the position follows its polynomial."""
    text = (HEAD + BOX).replace("GRAVITY", "[0.0, 0.0, 0.0]").replace("MOTION", 'input = "world_pose"')
    acceleration = np.array([3.0, 1.0, -2.0])
    with Slave(exported(command, tmp_path, text)) as slave:
        for k in range(40):
            time = k * H
            position = PIVOT + LINEAR * time + acceleration * time**2 / 2
            turn = Rotation.from_rotvec(ANGULAR * time)
            x, y, z, w = turn.as_quat()
            # (0, omega) q, from its definition.
            first = 0.5 * np.array([-ANGULAR @ [x, y, z], *(w * ANGULAR + np.cross(ANGULAR, [x, y, z]))])
            second = -(ANGULAR @ ANGULAR) / 4 * np.array([w, x, y, z])
            give(slave, position, (w, x, y, z))
            names = [f"{POSITION}[{i}]" for i in (1, 2, 3)] + [f"{ORIENTATION}[{i}]" for i in (1, 2, 3, 4)]
            rates = [[*(LINEAR + acceleration * time), *first], [*acceleration, *second]]
            for order in range(1, orders + 1):
                references = [slave.reference[name] for name in names]
                slave.fmi.setRealInputDerivatives(references, [order] * 7, rates[order - 1])
            slave.step(time, H)
            expected = wxyz(Rotation.from_rotvec(ANGULAR * (time + H)))
            found = read(slave, "boundary.box.orientation", 4)
            assert min(np.abs(found - expected).max(), np.abs(found + expected).max()) < 1e-12
            if orders == 2:
                end = PIVOT + LINEAR * (time + H) + acceleration * (time + H) ** 2 / 2
                assert np.abs(read(slave, "boundary.box.position") - end).max() < 1e-13


def test_directional_derivatives_are_those_of_differences(command, tmp_path):
    """Where the box goes and what it feels, by its position and by the components of its quaternion."""
    text = (HEAD + BOX).replace("GRAVITY", "[0.0, 0.0, -9.81]").replace("MOTION", 'input = "world_pose"')
    outputs = [f"boundary.box.{name}[{k}]" for name, n in (("position", 3), ("orientation", 4)) for k in range(1, n + 1)]
    inputs = [f"{POSITION}[{k}]" for k in (1, 2, 3)] + [f"{ORIENTATION}[{k}]" for k in (1, 2, 3, 4)]
    values = dict(zip(inputs, np.concatenate(target(H)), strict=True))
    with Slave(exported(command, tmp_path, text)) as slave:
        start = slave.save()

        def stepped(**changed):
            slave.restore(start)
            for name, value in (values | changed).items():
                slave.set(name, value)
            slave.step(0.0, H)
            return np.array(slave.get(*outputs))

        eps = 1e-6
        differences = {n: (stepped(**{n: values[n] + eps}) - stepped(**{n: values[n] - eps})) / (2 * eps) for n in inputs}
        stepped()
        unknowns = [slave.reference[name] for name in outputs]
        for name in inputs:
            found = slave.fmi.getDirectionalDerivative(unknowns, [slave.reference[name]], [1.0])
            assert np.abs(np.array(found) - differences[name]).max() < 1e-6, name
        # Longer or shorter is no other rotation: the derivative along the quaternion is none.
        along = [slave.reference[f"{ORIENTATION}[{k}]"] for k in (1, 2, 3, 4)]
        found = slave.fmi.getDirectionalDerivative(unknowns, along, list(target(H)[1]))
        assert np.abs(np.array(found)).max() < 1e-8


def test_states_continue_bit_for_bit(boxes):
    kind, _, posed = boxes
    save, restore = ("getFMUState", "setFMUState") if kind is Unit else ("getFMUstate", "setFMUstate")
    with kind(posed) as slave:
        for k in range(20):
            give(slave, *target((k + 1) * H))
            advance(slave, k * H, H)
        give(slave, *target(21 * H))
        state, seen = getattr(slave.fmi, save)(), []
        for _ in range(2):
            for k in range(20, 40):
                advance(slave, k * H, H)
                give(slave, *target((k + 2) * H))
            seen.append(spheres(slave).tobytes())
            getattr(slave.fmi, restore)(state)
            assert read(slave, ORIENTATION, 4).tolist() == target(21 * H)[1].tolist()
        assert seen[0] == seen[1]


# Scenes that nobody tuned: what moves, another input that says the same, its values and the pose at a time.
def mesh(path):
    """A tumbling box as ASCII STL, in mm, in its own axes: corners askew."""
    corners = np.array([[x, y, z] for x in (-60, 70) for y in (-50, 55) for z in (-45, 65)], float)
    faces = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    lines = ["solid box"]
    for a, b, c, d in faces:
        for corner in ((a, b, c), (a, c, d)):
            lines += ["facet normal 0 0 0", "outer loop"]
            lines += [f"vertex {' '.join(map(str, corners[i]))}" for i in corner] + ["endloop", "endfacet"]
    path.write_text("\n".join([*lines, "endsolid box", ""]))


NATURAL = """
[simulation]
duration = 2.0
communication_step = 4e-3
[[material]]
name = "glass"
density = 2500.0
[pair_default]
friction = 0.4
restitution = 0.3
"""
SKEW = np.array([2.0, 3.0, -1.0])
Y = np.array([0.0, 1.0, 0.0])
UNTUNED = {
    "tumbler": (
        """
[[boundary]]
name = "part"
material = "glass"
point_of_action = [0.01, 0.0, 0.02]
faces = [{ stl = { file = "box.stl", unit = "mm" } }]
INPUT
[[spheres]]
name = "grains"
material = "glass"
radius = 0.012
lattice = { origin = [-0.03, -0.03, -0.02], count = [3, 3, 2], spacing = 0.03, jitter = 0.05 }
""",
        '"pose"',
        np.array([0.01, 0.0, 0.02]),
        lambda t: (0.02 * np.sin(3 * t) * np.array([1.0, 0.5, -1.0]), SKEW * t),
    ),
    "drum": (
        """
[[boundary]]
name = "part"
material = "glass"
faces = [{ cylinder = { base = [0.0, -0.04, 0.0], axis = [0.0, 1.0, 0.0], radius = 0.1, height = 0.08, closed = true } }]
INPUT
[[spheres]]
name = "grains"
material = "glass"
radius = 0.01
lattice = { origin = [-0.05, -0.025, -0.05], count = [5, 3, 3], spacing = 0.025, jitter = 0.05 }
""",
        "{ hinge = [0.0, 1.0, 0.0] }",
        np.zeros(3),
        lambda t: (np.zeros(3), Y * (8.0 * t + 2.0 * np.sin(4.0 * t))),
    ),
    "paddle": (
        """
[[boundary]]
name = "floor"
material = "glass"
faces = [{ box = { min = [-0.2, -0.2, 0.0], max = [0.2, 0.2, 0.4] } }]
[[boundary]]
name = "part"
material = "glass"
point_of_action = [0.0, 0.0, 0.12]
faces = [{ rectangle = { corner = [-0.1, 0.0, 0.035], u = [0.2, 0.0, 0.0], v = [0.0, 0.0, 0.06] } }]
INPUT
[[spheres]]
name = "grains"
material = "glass"
radius = 0.014
lattice = { origin = [-0.07, -0.13, 0.02], count = [5, 4, 2], spacing = 0.035, jitter = 0.05 }
""",
        '"pose"',
        np.array([0.0, 0.0, 0.12]),
        lambda t: (np.array([0.0, 0.02 * np.sin(5 * t), 0.0]), np.array([0.0, 0.3 * np.sin(4 * t), 5.0 * t])),
    ),
}


@pytest.mark.parametrize("name", UNTUNED)
def test_untuned_scenes_move_as_by_the_other_input(command, tmp_path, name):
    text, kind, reference, law = UNTUNED[name]
    mesh(tmp_path / "box.stl")
    h, poses = 4e-3, []
    paths = [
        exported(command, tmp_path, NATURAL + text.replace("INPUT", f"input = {how}"), 3, f"{name}{k}")
        for k, how in enumerate((kind, '"world_pose"'))
    ]

    def turn(unit, translation, rotation):
        if kind == '"pose"':
            unit.set("boundary.part.translation", *translation)
            unit.set("boundary.part.rotation", *rotation)
        else:
            unit.set("boundary.part.angle", float(rotation @ Y))

    apart, rounding = [], []
    with Unit(paths[0]) as one, Unit(paths[1]) as other, Unit(paths[0]) as rounded:
        for k in range(500):
            translation, rotation = law((k + 1) * h)
            turn(one, translation, rotation)
            turn(rounded, translation, rotation * (1 + 1e-15))
            give(other, reference + translation, wxyz(Rotation.from_rotvec(rotation)), "part")
            for unit in (one, other, rounded):
                unit.fmi.doStep(currentCommunicationPoint=k * h, communicationStepSize=h)
            poses.append(max(
                np.abs(one.get("boundary.part.position") - other.get("boundary.part.position")).max(),
                (Rotation.from_quat(one.get("boundary.part.orientation"), scalar_first=True).inv()
                 * Rotation.from_quat(other.get("boundary.part.orientation"), scalar_first=True)).magnitude(),
            ))
            apart.append(np.abs(spheres(one) - spheres(other)).max())
            rounding.append(np.abs(spheres(one) - spheres(rounded)).max())
        energies = [unit.get("boundaryWork") for unit in (one, other)]
        overlaps = [unit.get("maxOverlap") for unit in (one, other)]
    assert max(poses) < 1e-12
    # Grains that knock together carry rounding on: they are apart by no more than where the rotation vector changes in its last digits.
    assert np.all(apart < 1e-9 + 10 * np.maximum.accumulate(rounding))
    assert max(apart[:50]) < 1e-9, "0.2 s of rounding are not seen"
    assert max(overlaps) < 2e-4
    assert energies[0] > 0.01, "nothing is moved"
    assert abs(energies[0] - energies[1]) < 0.05 * energies[0]


def test_a_tray_on_springs_comes_to_rest_where_statics_says(command, tmp_path):
    fmu = tmp_path / "tray.fmu"
    subprocess.run([command, "export", scene("tray"), "--fmi", "3", "-o", fmu], check=True)
    table, statics = swing(fmu)
    last = table[-1]
    turn = rotation_vector(np.array([last[f"q[{k}]"] for k in (1, 2, 3, 4)]))
    assert abs((last["r[3]"] - REST[2]) / statics["sag"] - 1) < 1e-3
    assert np.linalg.norm(statics["turn"]) > 5e-3, "the grains do not lie at one side"
    assert np.linalg.norm(turn - statics["turn"]) < 1e-2 * np.linalg.norm(statics["turn"])
    assert statics["lost"] < 1e-12
    # It has swung before.
    swung = max(np.linalg.norm(rotation_vector(np.array([row[f"q[{k}]"] for k in (1, 2, 3, 4)]))) for row in table)
    assert swung > 4 * np.linalg.norm(statics["turn"])


def to_t(q):
    """Modelica.Mechanics.MultiBody.Frames.Quaternions.to_T of its {x, y, z, w}, as the library has it."""
    x, y, z, w = q
    return np.array([
        [2 * (x * x + w * w) - 1, 2 * (x * y + z * w), 2 * (x * z - y * w)],
        [2 * (y * x - z * w), 2 * (y * y + w * w) - 1, 2 * (y * z + x * w)],
        [2 * (z * x + y * w), 2 * (z * y - x * w), 2 * (z * z + w * w) - 1],
    ])


def test_the_quaternion_of_a_multibody_frame_is_ours_in_another_order(command, tmp_path):
    """What BoundaryFrame.mo does, with matrices: T of a frame is to_T of our quaternion reordered, and the boundary goes where the
    frame's axes are, also where the frame did not stand along the world's axes at first."""
    text = (HEAD + BOX).replace("GRAVITY", "[0.0, 0.0, 0.0]").replace("MOTION", 'input = "world_pose"')
    first, frame = Rotation.from_rotvec([0.4, -1.2, 0.3]), Rotation.from_rotvec([0.5, -1.1, 0.4])
    # from_T is the inverse of to_T: the q whose to_T is transpose(to_T(Q_scene)) R.T.
    wanted = to_t(first.as_quat()).T @ to_t(frame.as_quat())
    q = Rotation.from_matrix(wanted.T).as_quat()
    assert np.abs(to_t(q) - wanted).max() < 1e-14
    with Slave(exported(command, tmp_path, text)) as slave:
        give(slave, PIVOT, (q[3], *q[:3]))
        for k in range(5):
            slave.step(k * H, H)
        turned = Rotation.from_quat(read(slave, "boundary.box.orientation", 4), scalar_first=True)
    # An axis of the frame in the scene, carried along, is that axis of the frame now. Rows of T: the frame's axes in the world.
    for axis in np.eye(3):
        assert np.abs(turned.apply(first.apply(axis)) - to_t(frame.as_quat()).T @ axis).max() < 1e-12
