"""The JSON schema that editors use accepts the scenes that the command accepts, and refuses bad keys, types and ranges."""

import json
import re
import subprocess
import tomllib

import jsonschema
import pytest
from conftest import ROOT, scene

SCENES = sorted(path for path in ROOT.glob("examples/*/*.toml") if "[simulation]" in path.read_text())
FUNNEL = scene("funnel").read_text()

# What is written instead of what in the funnel.
BAD = [
    ("step = 0.01", "stepp = 0.01"),
    ("duration = 8.6\n", ""),
    ('step = 0.01', 'step = "fast"'),
    ("step = 0.01", "step = 0"),
    ("duration = 8.6", "duration = -1.0"),
    ("penalty = 1e5", "penalty = 0.0"),
    ("penalty = 1e5", 'method = "almm"'),
    ("penalty = 1e5", "max_iterations = 0"),
    ("penalty = 1e5", "max_iterations = 1.5"),
    ("penalty = 1e5", "max_cuts = 21"),
    ("gap = 1e-6", "gap = 1e-20"),
    ("penalty = 1e5", "gravity = [0.0, -9.81]"),
    ("penalty = 1e5", "gravity = [0.0, 0.0, 0.0, 0.0]"),
    ("[[material]]", "[[materials]]"),
    ("density = 2500.0", "density = 0.0"),
    ("density = 2500.0", "density = [2500.0]"),
    ('name = "rock"', 'name = "2 rocks"'),
    ("friction_angle = 5.0", "friction_angle = 90"),
    ("friction_angle = 5.0", "restitution = 1.5"),
    ("{ cone =", "{ kone ="),
    ("{ cone =", "{ plane = { point = [0, 0, 0], normal = [0, 0, 1] }, cone ="),
    ("r0 = 0.7", "r0 = -0.7"),
    ("height = 3.3", "height = 0"),
    (", height = 3.3", ""),
    ("radius = 0.25", "radius = 0.0"),
    ("radius = 0.25", "radius = [0.25, -0.1]"),
    ("radius = 0.25", 'radius = 0.25\nlock = "q"'),
    ("radius = 0.25", "radius = 0.25\nradius_jitter = 1.0"),
    ("count = [10, 10, 1]", "count = [10, 0, 1]"),
    ("count = [10, 10, 1]", "count = [10, 10]"),
    ("spacing = 0.56", "spacing = [0.5, 0.5, 0.0]"),
    ("jitter = 0.05", "jitter = 0.6"),
    ("vtu_interval = 0.1", "vtu_interval = -0.1"),
    ("vtu_interval = 0.1", 'vtu_interval = 0.1\nfloat64 = "yes"'),
]


@pytest.fixture(scope="module")
def schema():
    schema = json.loads((ROOT / "docs/scene.schema.json").read_text())
    jsonschema.Draft7Validator.check_schema(schema)
    return jsonschema.Draft7Validator(schema)


def problems(schema, text):
    return [f"{error.json_path}: {error.message}" for error in schema.iter_errors(tomllib.loads(text))]


@pytest.mark.parametrize("path", SCENES, ids=lambda path: path.stem)
def test_example_scenes(schema, path):
    text = path.read_text()
    assert text.startswith("#:schema ../../docs/scene.schema.json\n"), "the line by which editors find the schema"
    assert problems(schema, text) == []


def test_examples_of_the_reference(schema):
    """They are parts of scenes: only the table that every scene has may be missing."""
    blocks = re.findall(r"```toml\n(.*?)```", (ROOT / "docs/scene.md").read_text(), re.S)
    assert len(blocks) > 30
    for block in blocks:
        rest = "" if "[simulation]" in block else "\n[simulation]\nduration = 1.0\nstep = 1e-3\n"
        assert problems(schema, block + rest) == [], block


@pytest.mark.parametrize("good, bad", BAD)
def test_bad_scenes(command, schema, tmp_path, good, bad):
    text = FUNNEL.replace(good, bad, 1)
    assert text != FUNNEL
    (tmp_path / "bad.toml").write_text(text)
    assert subprocess.run([command, "check", tmp_path / "bad.toml"], capture_output=True).returncode == 2
    assert problems(schema, text), "the command refuses it, the schema does not"
