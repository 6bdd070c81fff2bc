"""docs/fmu-tutorial.md runs as it stands, block by block."""

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest
from conftest import ROOT


def blocks():
    """Language and text of all blocks in order."""
    page = (ROOT / "docs" / "fmu-tutorial.md").read_text(encoding="utf-8")
    return re.findall(r"^```(sh|python)\n(.*?)^```$", page, re.S | re.M)


def test_the_tutorial(command, tmp_path):
    (tmp_path / "examples").symlink_to(ROOT / "examples")
    path = os.pathsep.join([str(command.parent), str(Path(sys.executable).parent), os.environ["PATH"]])
    said = ""
    for language, block in blocks():
        runner = ["bash", "-euc", block] if language == "sh" else [sys.executable, "-c", block]
        done = subprocess.run(
            runner, cwd=tmp_path, env={**os.environ, "PATH": path}, capture_output=True, text=True, timeout=300
        )
        assert done.returncode == 0, block + done.stdout + done.stderr
        said += done.stdout
    assert float(re.search(r"([\d.]+) kg in 2 s", said)[1]) == pytest.approx(0.15, abs=0.05)
    assert float(re.search(r"([\d.]+) kg/s on average", said)[1]) == pytest.approx(0.2, abs=0.05)
    for picture in ("feeder.png", "driven.png", "controlled.png", "grains.png"):
        assert (tmp_path / picture).stat().st_size > 1000, picture
    assert (tmp_path / "results" / "controlled" / "history.csv").exists()
