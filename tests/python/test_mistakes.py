"""Ten mistakes: docs/faq.md shows what the program prints. `SPHERE_DDA_GOLDEN=1` writes that anew, after a look at it."""

import os
import re
import subprocess
import sys

import pytest
from conftest import ROOT

PAGE = ROOT / "docs" / "faq.md"
SILO = (ROOT / "docs" / "howto" / "silo.toml").read_text(encoding="utf-8")
FLOOR = "faces = [{ rectangle = { corner = [-0.06, -0.025, 0.0], u = [0.06, 0.0, 0.0], v = [0.0, 0.05, 0.0] } }]"
MILLIMETRES = """[simulation]
duration = 1.0

[[material]]
name = "steel"
density = 7850.0

[[spheres]]
name = "balls"
material = "steel"
radius = 8
lattice = { origin = [0, 0, 10], count = [10, 10, 5], spacing = 20 }

[[boundary]]
name = "floor"
material = "steel"
faces = [{ plane = { point = [0, 0, 0], normal = [0, 0, 1] } }]
"""
CLOSED = """
import fmpy
from fmpy.fmi2 import FMU2Slave

description = fmpy.read_model_description("silo.fmu")
fmu = FMU2Slave(
    guid=description.guid, unzipDirectory=fmpy.extract("silo.fmu"), instanceName="silo",
    modelIdentifier=description.coSimulation.modelIdentifier,
)
fmu.instantiate()
fmu.setupExperiment(startTime=0.0)
fmu.enterInitializationMode()
fmu.exitInitializationMode()
fmu.terminate()
fmu.doStep(currentCommunicationPoint=0.0, communicationStepSize=0.01)
"""


def changed(old, new):
    assert SILO.count(old) == 1, old
    return SILO.replace(old, new)


def checked(text):
    return {"scene.toml": text}, ["check", "scene.toml"]


def driven(name, to):
    table = f"time,{name}\n0,0\n0.1,{to}\n"
    return {"drive.csv": table}, ["simulate", "silo.fmu", "--input", "drive.csv", "--stop", "0.1", "-o", "out.csv"]


# Title -> files that are written, and the arguments of the command (or a script in Python).
MISTAKES = {
    "Millimetres for metres": checked(MILLIMETRES),
    "A key misspelt": checked(changed("friction = 0.4", "frction = 0.4")),
    "A name that the FMU does not have": driven("boundary.gat.displacement", 0.02),
    "A fill that overlaps": checked(
        re.sub(
            r"size = .*\npacking = .*",
            "radius = 0.008\nlattice = { origin = [-0.045, -0.012, 0.01], count = [6, 2, 10], spacing = 0.014 }",
            SILO,
            count=1,
        )
    ),
    "Too large a step of an input": driven("boundary.gate.displacement", 20.0),
    "A mesh that is not there": checked(changed(FLOOR, 'faces = [{ stl = { file = "flor.stl" } }]')),
    "A wrong unit": checked(changed("density = 2500.0", 'density = "2.5 g"')),
    "Negative friction": checked(changed("friction = 0.4", "friction = -0.4")),
    "A closed FMU used again": ({}, CLOSED),
    "A file that exists": ({}, ["export", "scene.toml", "-o", "silo.fmu"]),
}


@pytest.fixture(scope="module")
def folder(command, tmp_path_factory):
    folder = tmp_path_factory.mktemp("mistakes")
    (folder / "scene.toml").write_text(SILO, encoding="utf-8")
    subprocess.run([command, "export", "scene.toml", "-o", "silo.fmu"], cwd=folder, check=True)
    return folder


def message(command, folder, files, call):
    """What the program says, without the layers of the tool that calls it."""
    for name, text in files.items():
        (folder / name).write_text(text, encoding="utf-8")
    script = isinstance(call, str)
    line = [sys.executable, "-c", call] if script else [command, *call]
    done = subprocess.run(line, cwd=folder, capture_output=True, text=True, timeout=60)
    if script:
        assert done.returncode != 0
        return done.stdout.strip()
    advice = re.search(r"^.*⚠.*", done.stderr, re.S | re.M)
    assert done.returncode in (1, 2) or advice, done.stdout + done.stderr
    lines = [line.rstrip() for line in done.stderr.strip("\n").splitlines()]
    return "\n".join(line for line in lines if "wall time" not in line)


def test_the_messages_are_those_on_the_page(command, folder):
    parts = []
    for title, (files, call) in MISTAKES.items():
        shown = "by `fmpy`" if isinstance(call, str) else f"`sphere-dda {' '.join(call)}`"
        parts.append(f"### {title}\n\n{shown}\n\n```text\n{message(command, folder, files, call)}\n```\n")
    begin, end = "<!-- Written by tests/python/test_mistakes.py. -->\n\n", "\n<!-- Until here. -->"
    page = PAGE.read_text(encoding="utf-8")
    head, rest = page.split(begin)
    shown, tail = rest.split(end)
    wanted = "\n".join(parts)
    if os.environ.get("SPHERE_DDA_GOLDEN"):
        PAGE.write_text(head + begin + wanted + end + tail, encoding="utf-8")
    else:
        assert shown == wanted
