"""Contacts that give way, through the FMUs of both versions: Hertz's force of a squeezed sphere, its impact at steps that resolve it
and at ones that do not, and states that are restored."""

import subprocess

import fmpy
import numpy as np
import pytest
from fmu import Slave

RADIUS, YOUNG, POISSON = 0.01, 1e9, 0.3
# Of a ball on a rigid wall.
HERTZ = 4 / 3 * YOUNG / (1 - POISSON**2) * RADIUS**0.5

HEAD = f"""
[simulation]
duration = 0.1
communication_step = "1 ms"
gravity = [0.0, 0.0, 0.0]
{{simulation}}
tolerance = {{{{ gap = 1e-9, slip = 1e-9, force = 1e-8 }}}}
[[material]]
name = "ball"
density = 2500.0
young = "1 GPa"
poisson = {POISSON}
friction = 0.3
restitution = 0.7
[[material]]
name = "wall"
[[boundary]]
name = "floor"
material = "wall"
faces = [{{{{ plane = {{{{ point = [0.0, 0.0, 0.0], normal = [0.0, 0.0, 1.0] }}}} }}}}]
[[parameter]]
name = "young"
sets = "material.ball.young"
[[parameter]]
name = "restitution"
sets = "material.ball.restitution"
[[spheres]]
name = "ball"
material = "ball"
radius = {RADIUS}
positions = [[0.0, 0.0, {{height}}]]
{{motion}}
[[probe]]
name = "ball"
sphere = "ball"
"""
LID = """
[[boundary]]
name = "lid"
material = "wall"
faces = [{ plane = { point = [0.0, 0.0, 0.02], normal = [0.0, 0.0, -1.0] } }]
input = { slide = [0.0, 0.0, -1.0] }
"""
SQUEEZE = HEAD.format(simulation="", height=RADIUS, motion="") + LID
FALL = {"simulation": 'step = "{step}"\nfixed_step = true', "height": 0.0101, "motion": "velocity = [0.2, 0.0, -1.0]"}


def simulate(path, wanted, **how):
    """The last of the wanted results by name, `name[3]` also where FMI 3.0 has arrays, and the largest `maxOverlap`."""
    arrays = {v.name for v in fmpy.read_model_description(str(path)).modelVariables if v.dimensions}
    whole = {name: name.partition("[")[0] if name.partition("[")[0] in arrays else name for name in wanted}
    output = sorted({*whole.values(), "maxOverlap"})
    told = fmpy.simulate_fmu(str(path), output_interval=1e-3, output=output, **how)

    def last(name):
        value = told[whole[name]][-1]
        return value[int(name[-2]) - 1] if np.ndim(value) else value

    return {name: last(name) for name in wanted}, told["maxOverlap"].max()


@pytest.fixture(scope="module", params=[2, 3], ids=["fmi2", "fmi3"])
def export(request, command, tmp_path_factory):
    folder = tmp_path_factory.mktemp("compliance")

    def unit(name, text):
        path = folder / f"{name}.fmu"
        if not path.exists():
            (folder / f"{name}.toml").write_text(text)
            subprocess.run([command, "export", folder / f"{name}.toml", "--fmi", str(request.param), "-o", path], check=True)
        return path

    return unit


def test_a_squeezed_sphere_answers_with_hertz(export):
    """The lid is an input; both contacts take half of its way. The modulus is a parameter."""
    path = export("squeeze", SQUEEZE)
    way = np.array([(0.0, 0.0), (0.1, 1e-4)], dtype=[("time", float), ("boundary.lid.displacement", float)])
    force, compression = "boundary.lid.averageForce[3]", "maxCompression"
    for factor in (1.0, 10.0):
        told, error = simulate(path, [force, compression], stop_time=0.1, input=way, start_values={"young": factor * YOUNG})
        # fmpy hands over what an input is at the start of a step.
        squeezed = 0.5 * 0.99e-4
        # The mean of the last step of 1 ms.
        assert told[force] == pytest.approx(factor * HERTZ * squeezed**1.5, rel=0.01)
        assert told[compression] == pytest.approx(squeezed / RADIUS, rel=1e-3)
        assert error <= 1e-9


@pytest.mark.parametrize("step", ["5 us", "1 ms"])
def test_the_rebound_keeps_the_restitution(export, step):
    """1.6e-4 s of contact in thirty steps, and in one that is six times as long; the energy stored in contacts is given back."""
    text = {**FALL, "simulation": FALL["simulation"].format(step=step)}
    path = export("fall-" + step.replace(" ", ""), HEAD.format(**text))
    speed = "probe.ball.velocity[3]"
    for e in (0.7, 0.3):
        wanted = [speed, "contactWork", "impactEnergy"]
        told, _ = simulate(path, wanted, stop_time=0.01, start_values={"restitution": e})
        assert told[speed] == pytest.approx(e, abs=0.02)
        energy = 0.5 * 2500 * 4 / 3 * np.pi * RADIUS**3
        assert told["contactWork"] == pytest.approx(0.0, abs=1e-9 * energy)
        assert told["impactEnergy"] == pytest.approx(energy * (1 - e**2), rel=0.05)


def test_a_restored_state_goes_on_with_the_same_bits(export):
    """Stretched springs are part of the state."""
    path = export("fall-5us", HEAD.format(**{**FALL, "simulation": FALL["simulation"].format(step="5 us")}))
    if fmpy.read_model_description(str(path)).fmiVersion != "2.0":
        pytest.skip("this test speaks FMI 2.0")
    with Slave(path) as unit:

        def steps(first, count):
            seen = []
            for k in range(first, first + count):
                unit.step(k * 2e-5, 2e-5)
                seen += unit.get("probe.ball.velocity[1]")
            return seen

        # The ball touches at 1e-4 s, for 1.6e-4 s.
        steps(0, 8)
        saved, blob = unit.fmi.getFMUstate(), unit.save()
        once = steps(8, 10)
        unit.fmi.setFMUstate(saved)
        assert steps(8, 10) == once
        unit.restore(blob)
        assert steps(8, 10) == once
        assert len(set(once)) > 3, "it was not in contact"
        unit.fmi.freeFMUstate(saved)
