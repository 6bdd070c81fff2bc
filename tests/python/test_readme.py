"""What the README shows, runs."""

import re
import subprocess
import sys

import pytest
from conftest import ROOT


def blocks(language, page="README.md"):
    text = (ROOT / page).read_text(encoding="utf-8")
    return re.findall(rf"^```{language}\n(.*?)^```$", text, re.S | re.M)


def test_python(fmus, tmp_path):
    (tmp_path / "feeder.fmu").symlink_to(fmus["feeder"].resolve())
    (block,) = blocks("python")
    done = subprocess.run([sys.executable, "-c", block], cwd=tmp_path, capture_output=True, text=True, timeout=300)
    assert done.returncode == 0, done.stderr
    time, force, _, overlap = map(float, re.findall(r"-?[0-9.]+(?:e[-+][0-9]+)?", done.stdout))
    assert time == pytest.approx(1.0) and force <= 0 and overlap <= 1e-6


def test_scenes(command, tmp_path):
    for block in blocks("toml"):
        scene = tmp_path / "scene.toml"
        scene.write_text(block)
        subprocess.run([command, "check", scene], check=True)
        subprocess.run([command, "run", scene, "-o", tmp_path / "out", "--stop", "0.1", "--overwrite"], check=True)


def test_commands_exist(command):
    """Every `sphere-dda NAME` on the pages is a subcommand."""
    pages = ["README.md", "examples/README.md", "examples/two_fmus/README.md", "docs/scene.md", "docs/results.md", "docs/fmu.md", "docs/coupling.md"]
    text = "".join((ROOT / page).read_text(encoding="utf-8") for page in pages)
    named = set(re.findall(r"(?:sphere-dda|cargo run --release --) ([a-z]+(?:-[a-z]+)*)\b(?! --release)", text))
    assert {"demo", "run", "export", "check", "simulate", "inspect"} <= named
    told = subprocess.run([command, "--help"], capture_output=True, text=True, check=True).stdout
    commands = set(re.findall(r"^  ([a-z-]+)  ", told, re.M))
    assert named <= commands, f"no commands: {sorted(named - commands)}"


def test_links_lead_somewhere():
    for page in ["README.md", "CONTRIBUTING.md", "CHANGELOG.md", "examples/README.md", "examples/two_fmus/README.md", "docs/scene.md", "docs/results.md", "docs/fmu.md", "docs/coupling.md", "docs/theory.md"]:
        for link in re.findall(r"\]\(([^)#]+)\)", (ROOT / page).read_text(encoding="utf-8")):
            if "://" not in link:
                assert ((ROOT / page).parent / link).exists(), f"{page}: {link}"
