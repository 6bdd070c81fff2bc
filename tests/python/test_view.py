"""Pages of `sphere-dda view` in headless Chromium: what they show is what the frames hold, offline, and soon."""

import base64
import io
import os
import re
import shutil
import subprocess
import time
from pathlib import Path
from xml.etree import ElementTree

import browser
import meshio
import numpy as np
import pytest
from conftest import ROOT, scene
from matplotlib.image import imread
from PIL import Image
from scipy.spatial.transform import Rotation

pytestmark = browser.needed
GOLDEN = Path(__file__).parent / "golden"
UPDATE = "SPHERE_DDA_GOLDEN" in os.environ

# Spheres fall into a box and are stirred by a turning paddle.
STIRRED = """
[simulation]
duration = {duration}
communication_step = {interval}
accuracy = "fast"
[output]
vtu_interval = {interval}
[[material]]
name = "glass"
density = 2500.0
[[material]]
name = "steel"
density = 7800.0
[pair_default]
friction = 0.3
restitution = 0.3
[[spheres]]
name = "balls"
material = "glass"
radius = 0.01
lattice = {{ origin = [-{half}, -{half}, 0.12], count = [{side}, {side}, {layers}], spacing = 0.022, jitter = 0.05 }}
[[boundary]]
name = "pot"
material = "steel"
faces = [
    {{ plane = {{ point = [0, 0, 0], normal = [0, 0, 1] }} }},
    {{ cylinder = {{ base = [0, 0, 0], axis = [0, 0, 1], radius = {wall}, height = {height} }} }},
]
[[boundary]]
name = "paddle"
material = "steel"
motion = {{ constant = {{ angular_velocity = [0, 0, 2.0] }} }}
faces = [{{ rectangle = {{ corner = [-0.06, 0, 0.005], u = [0.12, 0, 0], v = [0, 0, 0.1] }} }}]
"""


@pytest.fixture(scope="module")
def window(tmp_path_factory):
    with browser.started(tmp_path_factory.mktemp("profile")) as opened:
        yield opened


def frames(folder, series="spheres"):
    """(time, mesh) of each frame as meshio reads it."""
    for entry in ElementTree.parse(folder / f"{series}.pvd").iter("DataSet"):
        yield float(entry.get("timestep")), meshio.read(folder / entry.get("file"))


def made(command, *arguments):
    done = subprocess.run([command, *map(str, arguments)], capture_output=True, text=True, timeout=300)
    assert done.returncode == 0, done.stderr
    return done


@pytest.fixture(scope="module")
def runs(command, tmp_path_factory):
    """Name -> result folder with its page."""
    folders = {}
    for name, stop in {"funnel": 2.0, "drum": 1.0, "feeder": 0.5, "shear": 0.05, "hopper": 0.5, "chute": 2.0}.items():
        folders[name] = tmp_path_factory.mktemp("runs") / name
        made(command, "run", scene(name), "-o", folders[name], "--stop", stop, "--view")
    return folders


def check_positions(window, folder, every):
    """Centres of all frames to 1/1000 of the smallest radius, ids the same."""
    for time_of_frame, mesh in list(frames(folder))[::every]:
        radius = mesh.point_data["radius"]
        shown = window.run(f"await sphereDda.setTime({time_of_frame!r}); return sphereDda.positions()")
        if radius.max() == 0:
            assert shown["id"] == []
            continue
        assert shown["id"] == mesh.point_data["id"].tolist()
        error = np.linalg.norm(np.array(shown["centre"]) - mesh.points, axis=1).max()
        assert error <= 1e-3 * radius.min(), f"{error / radius.min():.2e} of a radius at {time_of_frame} s"


@pytest.mark.parametrize("name", ["funnel", "drum", "feeder", "shear", "hopper"])
def test_frames_are_shown_as_they_are(window, runs, name):
    folder = runs[name]
    head = window.open(folder / "view.html")
    assert window.log() == []
    assert [address for address in window.requests() if not address.startswith(("file:", "data:", "blob:"))] == []
    times = [moment for moment, _ in frames(folder)]
    assert head["times"] == times
    check_positions(window, folder, max(1, len(times) // 7))
    assert window.log() == []


def test_between_frames_places_are_interpolated(window, runs):
    window.open(runs["funnel"] / "view.html")
    (t0, a), (t1, b) = list(frames(runs["funnel"]))[4:6]
    shown = window.run(f"await sphereDda.setTime({t0 + 0.25 * (t1 - t0)!r}); return sphereDda.positions()")
    expected = a.points + 0.25 * (b.points - a.points)
    assert np.abs(np.array(shown["centre"]) - expected).max() < 1e-3 * a.point_data["radius"].min()


def test_boundaries_move_as_the_run_has_them(window, command, tmp_path):
    """The pose in the page puts the first frame's points where each frame has them."""
    folder = tmp_path / "run"
    made(command, "run", stirred(tmp_path, 3, 2, 1.0, 0.1), "-o", folder, "--view")
    head = window.open(folder / "view.html")
    listed = list(frames(folder, "boundaries"))
    first = listed[0][1]
    owner, triangles = first.cell_data["boundary"][0], first.cells[0].data
    paddle = next(b for b in head["boundaries"] if b["name"] == "paddle")
    own = np.unique(triangles[owner == paddle["index"]])
    for moment, mesh in listed:
        x, y, z, *quaternion = window.run(f"await sphereDda.setTime({moment!r}); return sphereDda.boundaries().paddle")
        turn = Rotation.from_quat(quaternion)
        assert turn.as_rotvec() == pytest.approx([0, 0, 2.0 * moment], abs=1e-5)
        shown = turn.apply(first.points[own] - paddle["centre"]) + [x, y, z]
        assert np.abs(shown - mesh.points[own]).max() < 1e-6


def test_picking_names_what_is_there(window, runs):
    folder = runs["funnel"]
    window.open(folder / "view.html")
    moment, mesh = list(frames(folder))[3]
    window.run(f"await sphereDda.setTime({moment!r}); await sphereDda.set({{view: 'top'}})")
    # From above the highest sphere is hidden by none.
    highest = int(np.argmax(mesh.points[:, 2] + mesh.point_data["radius"]))
    centre = mesh.points[highest].tolist()
    found = window.run(f"const at = sphereDda.project({centre}); return await sphereDda.pick(...at)")
    assert (found["kind"], found["id"]) == ("sphere", mesh.point_data["id"][highest])

    def magnitude(text):
        return float(text.split()[0])

    assert magnitude(found["values"]["radius"]) == pytest.approx(float(mesh.point_data["radius"][highest]), rel=0.01)
    for field in ("velocity", "force"):
        expected = float(np.linalg.norm(mesh.point_data[field][highest]))
        largest = float(np.abs(mesh.point_data[field]).max())
        assert magnitude(found["values"][field]) == pytest.approx(expected, rel=0.01, abs=1e-3 * largest)
    rim = window.run("const [x, y] = sphereDda.project([3.3, 0, 2.6]); await sphereDda.set({spheres: false}); return await sphereDda.pick(x, y)")
    assert (rim["kind"], rim["name"]) == ("boundary", "funnel")
    assert {"force", "torque", "averageForce"} <= set(rim["values"])
    assert window.run("return await sphereDda.pick(0.01, 0.99)") is None


def test_forces_are_those_of_the_frame(window, runs):
    folder = runs["funnel"]
    head = window.open(folder / "view.html")
    listed = list(frames(folder, "contacts"))
    for moment, mesh in listed[::5]:
        force = mesh.cell_data["normal_force"][0]
        weakest = head["forces"]["largest"] * 10 ** -head["forces"]["decades"]
        lines = window.run(f"await sphereDda.setTime({moment!r}); await sphereDda.set({{forces: true}}); return sphereDda.lines()")
        # A force at the very end of the scale may fall on either side of it.
        assert (force > 1.03 * weakest).sum() <= lines <= (force > 0.97 * weakest).sum()
    assert lines > 50


def test_plots_follow_the_time(window, runs):
    window.open(runs["funnel"] / "view.html")
    assert "sensor.discharge.mass" in window.run("return sphereDda.plots()")
    window.run("await sphereDda.add('kineticEnergy'); await sphereDda.setTime(1.5)")
    rows = np.genfromtxt(runs["funnel"] / "history.csv", delimiter=",", skip_header=1)
    header = (runs["funnel"] / "history.csv").read_text(encoding="utf-8").splitlines()[0].split(",")
    column = [name.split(" [")[0] for name in header].index("kineticEnergy")
    expected = rows[np.searchsorted(rows[:, 0], 1.5 + 1e-9) - 1, column]
    shown = window.run(
        "return [...document.querySelectorAll('figure')].find((f) => f.textContent.startsWith('kineticEnergy')).querySelector('output').textContent"
    )
    assert float(shown) == pytest.approx(expected, rel=1e-3)


def picture(window, width=480, height=360):
    url = window.run(f"return sphereDda.picture({width}, {height})")
    return imread(io.BytesIO(base64.b64decode(url.split(",")[1])))[..., :3]


@pytest.mark.parametrize(
    ("name", "moment", "settings"),
    [
        ("funnel", 1.5, "{}"),
        ("funnel", 1.5, "{forces: true, view: 'front'}"),
        ("drum", 1.0, "{colour: 'height', cut: '-y', names: true}"),
        ("feeder", 0.5, "{colour: 'material', view: 'top', opacity: 1}"),
        ("chute", 2.0, "{wall: 'wear_depth'}"),
    ],
)
def test_golden_pictures(window, runs, tmp_path, name, moment, settings):
    """Renewed by SPHERE_DDA_GOLDEN=1, after a look at the pictures."""
    window.open(runs[name] / "view.html")
    window.run(f"await sphereDda.set({settings}); await sphereDda.setTime({moment})")
    shown = picture(window)
    kind = re.sub(r"\W+", "-", settings).strip("-") or "plain"
    golden = GOLDEN / f"view-{name}-{kind}.png"
    place = golden if UPDATE else tmp_path / golden.name
    place.parent.mkdir(exist_ok=True)
    Image.fromarray((shown * 255).round().astype(np.uint8)).quantize(128).save(place, optimize=True)
    if UPDATE:
        return
    expected = np.asarray(Image.open(golden).convert("RGB")) / 255
    # Text is drawn with the fonts of the machine: what differs may be a small part of the picture, elsewhere little.
    differs = (np.abs(shown - expected).max(axis=-1) > 0.12).mean()
    assert differs < 0.02, f"{differs:.1%} of the picture differs: look at {place} and {golden}"


def stirred(folder, side, layers, duration, interval):
    half = 0.5 * (side - 1) * 0.022
    path = folder / "stirred.toml"
    path.write_text(
        STIRRED.format(
            half=half, side=side, layers=layers, duration=duration, interval=interval, wall=1.42 * half + 0.03, height=0.022 * layers + 0.15
        )
    )
    return path


def test_first_picture_of_a_thousand_spheres(window, command, tmp_path):
    """1000 spheres x 300 frames: the first picture within 2 s, on a machine without a graphics card."""
    made(command, "run", stirred(tmp_path, 10, 10, 1.5, 0.005), "-o", tmp_path / "run", "--view")
    page = tmp_path / "run" / "view.html"
    took = [9.0]
    # On a machine that others use as well one try says little.
    while min(took) > 2.0 and len(took) < 8:
        head = window.open(page)
        took.append(window.run("return sphereDda.stats().firstPicture / 1000"))
    assert (head["spheres"], len(head["times"])) == (1000, 301)
    stats = window.run("for (const t of sphereDda.head.times.slice(0, 40)) await sphereDda.setTime(t); return sphereDda.stats()")
    print(f"{page.stat().st_size / 1e6:.1f} MB, first picture after {min(took):.2f} s, {stats['mean']:.0f} ms a picture, {stats['heap'] / 1e6:.0f} MB")
    if min(took) > 2.0 and os.getloadavg()[0] > os.cpu_count():
        pytest.skip(f"first picture after {min(took):.2f} s, NOT JUDGED: others use this machine")
    assert min(took) <= 2.0
    check_positions(window, tmp_path / "run", 100)


def test_long_runs_are_no_coarser_than_they_must_be(command, tmp_path):
    """Some blocks tell beforehand what has room: a limit just above a page's size gives this page, one just below it the next coarser."""
    folder = tmp_path / "run"
    made(command, "run", stirred(tmp_path, 6, 6, 1.5, 0.005), "-o", folder)

    def page(limit):
        name = tmp_path / f"{limit}.html"
        done = made(command, "view", folder, "-o", name, "--max-size", f"{limit}B")
        return name.stat().st_size, done.stderr

    size, told = page(50_000_000)
    assert "keep the page within" not in told
    for expected in ("to 2 %", "as finely as colours show", "of other values their magnitudes", "other values are not"):
        assert page(int(1.01 * size))[0] == size
        size, told = page(int(0.99 * size))
        assert expected in told


@pytest.mark.parametrize(("share", "told"), [(0.75, r"values of spheres are in it to 2 %"), (0.55, r"as finely as colours show, to 6 %"), (0.4, r"to 6 %, of other values their magnitudes"), (0.15, r"\d+ of \d+ frames are in it: one in \d+ and the last")])
def test_size_is_kept(window, command, runs, tmp_path, share, told):
    """`--max-size`: values get coarser, then every n-th frame and the last are kept; the command says so, centres stay exact."""
    folder = runs["hopper"]
    text = (folder / "view.html").read_text(encoding="utf-8")
    moving = sum(map(len, re.findall(r'id="(?:motion|contacts|field\d)-\d+">([^<]*)<', text)))
    limit = int(len(text) - (1 - share) * moving)
    done = made(command, "view", folder, "-o", tmp_path / "small.html", "--max-size", f"{limit}B")
    assert re.search(told, done.stderr), done.stderr
    size = (tmp_path / "small.html").stat().st_size
    assert size <= limit < len(text)
    head = window.open(tmp_path / "small.html")
    times = [moment for moment, _ in frames(folder)]
    assert head["times"][0] == times[0] and head["times"][-1] == times[-1]
    assert (len(head["times"]) < len(times)) == ("frames" in told)
    moment, mesh = next((moment, mesh) for moment, mesh in frames(folder) if moment == head["times"][1])
    shown = window.run(f"await sphereDda.setTime({moment!r}); return sphereDda.positions()")
    assert np.abs(np.array(shown["centre"]) - mesh.points).max() < 1e-3 * mesh.point_data["radius"].min()
    velocity = next(field for field in head["fields"] if field["name"] == "velocity")
    assert (velocity["steps"], velocity["magnitude"]) == (25 if "2 %" in told else 8, "frames" in told)
    spin = [field["magnitude"] for field in head["fields"] if field["name"] == "angular_velocity"]
    assert spin == ([] if "frames" in told else ["magnitudes" in told])
    assert (len(head["fields"]) == 4) == ("frames" not in told), "nothing that the page shows is left out before"
    fastest = int(np.argmax(np.linalg.norm(mesh.point_data["velocity"], axis=1)))
    expected = float(np.linalg.norm(mesh.point_data["velocity"][fastest]))
    rank = mesh.point_data["id"][fastest]
    value = window.run(f"return (await sphereDda.describe({rank})).values.velocity")
    assert float(value.split()[0]) == pytest.approx(expected, rel=0.04 if "2 %" in told else 0.08)


def test_scene_before_it_runs(window, command, tmp_path, fmus):
    """t = 0 with names of boundaries, inputs and sensors; the FMU shows the same."""
    made(command, "view", scene("feeder"), "-o", tmp_path / "scene.html")
    made(command, "view", fmus["feeder"], "-o", tmp_path / "fmu.html")
    shown = []
    for name in ("scene.html", "fmu.html"):
        head = window.open(tmp_path / name)
        assert window.log() == []
        assert head["still"] and head["times"] == [0]
        assert {b["name"] for b in head["boundaries"]} >= {"trough"}
        texts = {label["text"]: label["kind"] for label in head["labels"]}
        assert texts["boundary.trough.displacement"] == "input" and texts["sensor.flow"] == "sensor"
        shown.append(window.run("return sphereDda.positions()"))
    assert shown[0] == shown[1] and len(shown[0]["id"]) == 150


def test_page_renews_itself(window, command, tmp_path):
    """--watch: saved changes arrive in the browser, which keeps its camera; problems stand on the page."""
    path = stirred(tmp_path, 3, 2, 0.1, 0.1)
    page = tmp_path / "scene.html"
    process = subprocess.Popen(
        [command, "view", path, "-o", page, "--watch"], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    )
    try:
        until(lambda: page.exists())
        window.open(page)
        window.run("await sphereDda.set({view: 'top', colour: 'height'})")
        shown = "window.sphereDda?.head && [sphereDda.head.spheres, document.getElementById('colour').value]"
        assert window.at_once(shown) == [18, "height"]
        text = path.read_text()
        path.write_text(text.replace("count = [3, 3, 2]", "count = [3, 3, 4]"))
        until(lambda: window.at_once(shown) == [36, "height"])
        path.write_text(text.replace('material = "glass"', 'material = "gloss"'))
        notice = "document.querySelector('#notice:not([hidden])')?.textContent ?? ''"
        until(lambda: "gloss" in window.at_once(notice))
    finally:
        process.send_signal(2)
        _, error = process.communicate(timeout=30)
    assert process.returncode == 0, error
    assert "gloss" in error
    window.open(page)
    assert window.run("return sphereDda.head.watched") == ""


def until(there, patience=20):
    end = time.monotonic() + patience
    while not there():
        assert time.monotonic() < end, "it did not come"
        time.sleep(0.1)


def test_simulate_ends_with_a_page(window, command, fmus, tmp_path):
    """The FMU's frames and what was recorded of it."""
    done = made(command, "simulate", fmus["feeder"], "--stop", "0.3", "-o", tmp_path / "out.csv", "--view", tmp_path / "page.html")
    assert "page.html" in done.stderr
    assert sorted(path.name for path in tmp_path.iterdir()) == ["out.csv", "page.html"]
    head = window.open(tmp_path / "page.html")
    assert head["spheres"] == 150 and len(head["times"]) > 5
    assert {table["name"] for table in head["tables"]} == {"history.csv", "outputs.csv"}


def test_page_that_was_cut_short_says_so(window, runs, tmp_path):
    text = (runs["funnel"] / "view.html").read_text(encoding="utf-8")
    damaged = re.sub(r'(id="motion-0">).{40}', r"\1", text, count=1)
    assert damaged != text
    (tmp_path / "damaged.html").write_text(damaged, encoding="utf-8")
    window.driver.get((tmp_path / "damaged.html").as_uri())
    until(lambda: "cannot be shown" in window.run("return document.getElementById('notice').textContent"))
    window.log()


def test_bundle_is_what_the_recipe_makes():
    if not shutil.which("npm"):
        pytest.skip("no `npm`: the bundle of the viewer NOT COMPARED with its recipe; install node and npm")
    done = subprocess.run([ROOT / "picture/src/viewer/web/build", "--check"], capture_output=True, text=True, timeout=300)
    assert done.returncode == 0, done.stdout + done.stderr
