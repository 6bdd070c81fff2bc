"""ParaView shows a run: the script that lies with the results draws grains, boundaries and force tubes."""

import os
import re
import shutil
import subprocess

import numpy as np
import pytest
from conftest import scene
from matplotlib.image import imread

PVBATCH = shutil.which("pvbatch")
pytestmark = pytest.mark.skipif(
    PVBATCH is None, reason="no `pvbatch`: view.py NOT TESTED; install ParaView (Debian: paraview, python3-paraview, xvfb)"
)
# Runs view.py with the arguments that follow its path, then counts the cells of what it made.
COUNT = """
import runpy, sys
sys.argv = sys.argv[1:]
runpy.run_path(sys.argv[0])
from paraview import simple
for name in ("spheres", "boundaries", "boundary edges", "force tubes"):
    source = simple.FindSource(name)
    source.UpdatePipeline(simple.GetAnimationScene().AnimationTime)
    print(name + ":", source.GetDataInformation().GetNumberOfCells())
force = simple.FindSource("forces over points").PointData.GetArray("normal_force")
print("largest force:", force.GetRange()[1] if force else 0)
view = simple.GetActiveView()
away = [a - b for a, b in zip(view.CameraPosition, view.CameraFocalPoint)]
print("camera height:", away[2] / sum(x * x for x in away) ** 0.5)
print("time:", simple.GetAnimationScene().AnimationTime)
"""
# Simulated seconds [s] of a run.
STOP = {"funnel": 1.2, "feeder": 0.3, "bucket": 0.8}


@pytest.fixture(scope="module")
def results(command, tmp_path_factory):
    """Name -> result directory."""
    folders = {}
    for name, stop in STOP.items():
        folders[name] = tmp_path_factory.mktemp("runs") / name
        subprocess.run([command, "run", scene(name), "-o", folders[name], "--stop", str(stop)], check=True, timeout=60)
    return folders


@pytest.fixture(scope="module")
def pvbatch():
    """Runs pvbatch and returns what it prints; where there is no display, on a virtual one if that is installed."""
    server, environment = None, dict(os.environ)
    if "DISPLAY" not in environment and shutil.which("Xvfb"):
        told, tells = os.pipe()
        # Without -noreset it starts anew after each client, and may refuse the next.
        screen = ["-noreset", "-screen", "0", "1280x1024x24"]
        server = subprocess.Popen(["Xvfb", "-displayfd", str(tells), *screen], pass_fds=[tells], stderr=subprocess.DEVNULL)
        os.close(tells)
        with os.fdopen(told) as numbers:
            environment["DISPLAY"] = ":" + numbers.readline().strip()

    def run(*arguments):
        command = [PVBATCH, *map(str, arguments)]
        done = subprocess.run(command, capture_output=True, text=True, timeout=120, env=environment)
        printed = done.stdout + done.stderr
        assert done.returncode == 0 and "Traceback" not in printed and "ERR|" not in printed, printed
        return printed

    yield run
    if server:
        server.terminate()
        server.wait()


def counted(pvbatch, tmp_path, *arguments):
    (tmp_path / "count.py").write_text(COUNT)
    told = pvbatch(tmp_path / "count.py", *arguments)
    return {name: float(value) for name, value in re.findall(r"^([a-z ]+): (\S+)$", told, re.MULTILINE)}


def check_picture(path, coloured):
    """Something fills the middle, nothing is cut off on the left; a share of the middle is colourful, as grains are."""
    picture = imread(path)[..., :3]
    height, width, _ = picture.shape
    assert (width, height) == (1280, 960)
    middle = picture[height // 4 : 3 * height // 4, width // 4 : 3 * width // 4]
    drawn = (middle < 0.97).any(axis=-1)
    assert drawn.mean() > 0.25
    assert (np.ptp(middle, axis=-1) > 0.2).mean() > coloured
    assert len(np.unique((middle * 255).astype(int).reshape(-1, 3), axis=0)) > 1000
    assert (picture[:, : width // 40][height // 20 :] > 0.97).all()


@pytest.mark.parametrize("name", STOP)
def test_picture(pvbatch, results, tmp_path, name):
    found = counted(pvbatch, tmp_path, results[name] / "view.py", tmp_path / "picture.png")
    assert found["time"] == pytest.approx(STOP[name])
    assert all(found[part] > 0 for part in ("spheres", "boundaries", "boundary edges", "force tubes"))
    assert found["largest force"] > 0
    # From the side, a little from above.
    assert 0.2 < found["camera height"] < 0.5
    check_picture(tmp_path / "picture.png", 0.02)


def test_forces(pvbatch, results, tmp_path):
    """The documented line, with a time and force tubes in glassy grains."""
    pvbatch(results["funnel"] / "view.py", tmp_path / "speeds.png", "0.8")
    pvbatch(results["funnel"] / "view.py", tmp_path / "forces.png", "0.8", "--forces")
    check_picture(tmp_path / "speeds.png", 0.05)
    check_picture(tmp_path / "forces.png", 0.005)
    assert np.abs(imread(tmp_path / "speeds.png") - imread(tmp_path / "forces.png")).mean() > 0.01


def test_frame_without_contacts(pvbatch, results, tmp_path):
    """What stands for contacts in such a frame is no force."""
    found = counted(pvbatch, tmp_path, results["bucket"] / "view.py", tmp_path / "picture.png", "0")
    assert found["time"] == 0 and found["force tubes"] == 0 and found["largest force"] == 0
    check_picture(tmp_path / "picture.png", 0.02)
