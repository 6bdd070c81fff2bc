"""`sphere-dda new`: the driver of each folder runs its FMU and writes its picture; the README's parameter works as it says."""

import re
import subprocess
import sys

import pytest

KINDS = {"feeder": 0.1, "hopper": 0.05, "drum": 0.1, "conveyor": 0.2, "bucket": 0.1, "landslide": 1.0, "paper": 0.5}


def run(*arguments, folder):
    done = subprocess.run(list(map(str, arguments)), cwd=folder, capture_output=True, text=True, timeout=600)
    assert done.returncode == 0, done.stderr
    return done.stdout


@pytest.mark.parametrize("kind", KINDS)
def test_the_driver_runs(command, tmp_path, kind):
    run(command, "new", kind, "mine", folder=tmp_path)
    folder = tmp_path / "mine"
    run(command, "export", "mine.toml", "-o", "mine.fmu", folder=folder)
    said = run(sys.executable, "drive.py", "--stop", KINDS[kind], folder=folder)
    values = [float(value) for value in re.findall(r"= (\S+) at", said)]
    outputs = len(re.search(r"^OUTPUTS = \[(.*)\]", (folder / "drive.py").read_text(), re.M).group(1).split(","))
    assert len(values) == outputs and any(values), said
    assert f"at {KINDS[kind]:g} s" in said
    assert (folder / "mine.png").stat().st_size > 5_000


def test_the_parameter_of_the_readme(command, tmp_path):
    """As a newcomer would: append it, set it for a run, set it in the driver."""
    run(command, "new", "feeder", "mine", folder=tmp_path)
    folder = tmp_path / "mine"
    (block,) = re.findall(r"```toml\n(.*?)```", (folder / "README.md").read_text(), re.S)
    with (folder / "mine.toml").open("a") as scene:
        scene.write("\n" + block)
    run(command, "run", "mine.toml", "-o", "results", "--set", "friction=0.2", "--stop", "0.02", folder=folder)
    run(command, "export", "mine.toml", "-o", "mine.fmu", folder=folder)
    driver = folder / "drive.py"
    said = []
    for friction in (0.4, 0.0):
        driver.write_text(re.sub(r"^PARAMETERS = .*$", f'PARAMETERS = {{"friction": {friction}}}', driver.read_text(), flags=re.M))
        said.append(run(sys.executable, "drive.py", "--stop", "0.1", folder=folder))
    assert said[0] != said[1]
