"""Pages of `sphere-dda view --live` in headless Chromium: the solver in the page gives what the native FMU gives, and says what is wrong."""

import csv
import io
import json
import os
import shutil
import subprocess

import browser
import meshio
import numpy as np
import pytest
from conftest import scene
from test_fmi3 import Unit

pytestmark = browser.needed

# Seconds that the gate is open.
OPEN = 1.0
# A rigid sphere between a floor and a plate that comes down has no place to go.
PRESS = """
[simulation]
duration = 1.0
[[material]]
name = "glass"
density = 2500.0
[[spheres]]
name = "ball"
material = "glass"
radius = 0.01
lattice = { origin = [0, 0, 0.01], count = [1, 1, 1], spacing = 0.02 }
[[boundary]]
name = "floor"
material = "glass"
faces = [{ plane = { point = [0, 0, 0], normal = [0, 0, 1] } }]
[[boundary]]
name = "plate"
material = "glass"
faces = [{ plane = { point = [0, 0, 0.021], normal = [0, 0, -1] } }]
input = { slide = [0, 0, -1] }
"""


@pytest.fixture(scope="module")
def window(tmp_path_factory):
    with browser.started(tmp_path_factory.mktemp("profile")) as opened:
        yield opened


@pytest.fixture(scope="module")
def made(command, tmp_path_factory):
    """Name -> page, FMU with both libraries and scene file, of a scene whose sums of products are rounded as a component rounds them."""
    if not (command.parent / "platforms" / "wasm" / "sphere_dda_fmu.wasm").exists():
        pytest.skip("the module is not there, live pages NOT TESTED: fmu/platforms/build wasm")
    done = {}

    def get(name, count=None):
        if (name, count) not in done:
            folder = tmp_path_factory.mktemp("live")
            text = scene(name).read_text(encoding="utf-8").replace("[simulation]", '[simulation]\nregisters = "plain"', 1)
            if count:
                text = text.replace("count = 400", f"count = {count}")
            own, page, fmu = folder / f"{name}.toml", folder / f"{name}.html", folder / f"{name}.fmu"
            own.write_text(text, encoding="utf-8")
            run(command, "export", own, "-o", fmu, "--fmi", 3, "--platform", "wasm,linux64")
            run(command, "view", fmu, "--live", "-o", page)
            done[name, count] = page, fmu, own
        return done[name, count]

    return get


def run(command, *arguments, code=0):
    done = subprocess.run([command, *map(str, arguments)], capture_output=True, text=True, timeout=300)
    assert done.returncode == code, done.stderr
    return done


def opened(window, page):
    """Opens a page, which asks for nothing and complains of nothing."""
    window.open(page)
    assert window.log() == []
    assert [address for address in window.requests() if not address.startswith(("file:", "data:", "blob:"))] == []


def slide(window, name, value):
    """Drags the slider of an input."""
    window.run(f"""
        const k = sphereDda.live.controls.findIndex(({{ name }}) => name === {name!r});
        const slider = document.querySelectorAll('#live input[type="range"]')[k];
        slider.value = {value!r};
        slider.dispatchEvent(new Event("input"));""")


def shown(window):
    """What the solver in the page has, numbers to the bit."""
    frame = json.loads(window.run("return JSON.stringify(sphereDda.live.frame())"))
    frame["position"] = np.array(frame["position"]).reshape(-1, 3)
    return frame


def driven(window):
    """Names and rows of the table that the page saves."""
    names, *rows = csv.reader(io.StringIO(window.run("return sphereDda.live.drive()")))
    return names[1:], [[float(text) for text in row] for row in rows]


def test_opened_gate_lets_out_what_that_of_the_native_fmu_does(window, made):
    page, fmu, _ = made("live_hopper")
    opened(window, page)
    step = window.run("return sphereDda.head.live.step")
    steps, closed = round(OPEN / step), 100
    window.run(f"await sphereDda.live.step({closed})")
    assert shown(window)["outputs"]["sensor.outflow.mass"] == 0.0
    slide(window, "boundary.gate.displacement", 0.08)
    window.run(f"await sphereDda.live.step({steps})")
    there = shown(window)
    assert there["time"] == (closed + steps) * step and there["values"][0] == 0.08
    names, rows = driven(window)
    assert names == ["boundary.gate.displacement"]
    inputs = {round(time / step): value for time, value in rows}
    # The gate follows the slider at its own speed.
    assert max(np.diff([value for _, value in rows])) < 0.005 and len(rows) > 50
    with Unit(fmu) as native:
        for k in range(closed + steps):
            if k in inputs:
                native.set(names[0], inputs[k])
            native.step(k * step, step)
        assert there["outputs"]["sensor.outflow.mass"] == native.get("sensor.outflow.mass") > 0.1
        assert np.array_equal(there["position"], native.get("spheres.position"))
        for name in ("averageForce", "averageTorque"):
            found = [there["outputs"][f"boundary.gate.{name}[{axis}]"] for axis in (1, 2, 3)]
            assert np.array_equal(found, native.get(f"boundary.gate.{name}"))
    assert window.log() == []


def test_saved_inputs_drive_the_fmu_by_simulate(command, window, made, tmp_path):
    page, fmu, _ = made("live_hopper")
    opened(window, page)
    slide(window, "boundary.gate.displacement", 0.05)
    window.run("await sphereDda.live.step(200)")
    slide(window, "boundary.gate.displacement", 0.08)
    window.run("await sphereDda.live.step(150)")
    there = shown(window)
    (tmp_path / "inputs.csv").write_text(window.run("return sphereDda.live.drive()"))
    record = ["--record", "sensor.outflow.mass", "--record", "spheres.position"]
    run(command, "simulate", fmu, "--input", tmp_path / "inputs.csv", "--stop", there["time"], "-o", tmp_path / "out.csv", *record)
    last = [float(text) for text in (tmp_path / "out.csv").read_text().splitlines()[-1].split(",")]
    assert last[1] == there["outputs"]["sensor.outflow.mass"]
    assert np.array_equal(last[2:], there["position"].ravel())


def test_same_numbers_in_library_native_fmu_wasmtime_and_browser(command, window, made, tmp_path):
    component = pytest.importorskip("component")
    page, fmu, own = made("drum")
    opened(window, page)
    window.run("await sphereDda.live.step(100)")
    there = shown(window)["position"]
    step = 1e-3
    with Unit(fmu) as native:
        unit = component.Module(fmu)
        hosted = unit.instantiate()
        hosted.start()
        start = native.get("spheres.position")
        for k in range(100):
            native.step(k * step, step)
            hosted.do_step(k * step, step, False)
        assert np.array_equal(there, native.get("spheres.position"))
    assert np.array_equal(there, np.reshape(hosted.get("spheres.position"), (-1, 3)))
    run(command, "run", own, "-o", tmp_path / "results", "--stop", 0.1)
    # Frames hold single precision, the history all digits.
    library = meshio.read(sorted((tmp_path / "results").glob("spheres_*.vtu"))[-1])
    assert np.array_equal(there.astype(np.float32), library.points)
    with (tmp_path / "results" / "history.csv").open() as table:
        *_, last = csv.DictReader(table)
    for name, row in {"first": 0, "middle": 18, "last": 35}.items():
        found = [float(last[f"probe.{name}.position[{axis}] [m]"]) for axis in (1, 2, 3)]
        assert np.array_equal(found, there[row])
    assert np.abs(there - start).max() > 1e-3


def test_component_that_jco_transpiles_gives_the_same_numbers(window, made, tmp_path):
    jco = os.environ.get("JCO") or shutil.which("jco")
    if not jco:
        pytest.skip("no `jco` (npm install -g @bytecodealliance/jco, or JCO=PATH): the transpiled component is NOT TESTED")
    page, fmu, _ = made("drum")
    opened(window, page)
    window.run("await sphereDda.live.step(100)")
    subprocess.run(["unzip", "-q", fmu, "binaries/*", "-d", tmp_path], check=True)
    wasm = tmp_path / "binaries/wasm32-wasip2/drum.wasm"
    options = ["--instantiation", "async", "--no-nodejs-compat", "--no-typescript", "--name", "drum", "-q"]
    subprocess.run([jco, "transpile", wasm, "-o", tmp_path / "js", *options], check=True)
    about = window.run("return sphereDda.head.live")
    (tmp_path / "js" / "run.mjs").write_text(f"""
        import {{ readFile }} from "node:fs/promises";
        import {{ instantiate }} from "./drum.js";
        const core = async (name) => WebAssembly.compile(await readFile(new URL(name, import.meta.url)));
        const root = await instantiate(core, {{
          "fmi:fmi3/callbacks": {{ logMessage: console.error }},
          "fmi:fmi3/intermediate-update-callbacks": {{ intermediateUpdate: () => [false, 0] }},
        }});
        const {{ CoSimulationInstance }} = root.coSimulation ?? root["fmi:fmi3/co-simulation@3.0.0"];
        const fmu = CoSimulationInstance.instantiateCoSimulation("drum", {about["token"]!r}, "", false, false, false, false, new Uint32Array());
        fmu.enterInitializationMode(undefined, 0, undefined);
        fmu.exitInitializationMode();
        for (let k = 0; k < 100; k++) fmu.doStep(k * 1e-3, 1e-3, false);
        console.log(JSON.stringify(Array.from(fmu.getFloat64(Uint32Array.of({about["spheres"]["position"]})))));
    """)
    (tmp_path / "js" / "package.json").write_text('{"type": "module"}')
    done = subprocess.run(["node", tmp_path / "js" / "run.mjs"], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    assert json.loads(done.stdout) == shown(window)["position"].ravel().tolist()


def test_picture_shows_what_the_solver_has(window, made):
    page, fmu, _ = made("live_hopper")
    opened(window, page)
    window.run("await sphereDda.set({forces: true}); await sphereDda.live.step(150)")
    there, drawn = shown(window), window.run("return sphereDda.positions()")
    assert np.array_equal(drawn["centre"], there["position"])
    with Unit(fmu) as native:
        for k in range(150):
            native.step(k * 2e-3, 2e-3)
        document = bytes(native.fmi.getBinary([native.reference("contacts.document")])[0])
    records = np.frombuffer(document, "<f8", offset=28).reshape(-1, 15)
    pressing = np.sum(records[:, 5:8] * records[:, 8:11], axis=1)
    assert window.run("return sphereDda.lines()") == np.count_nonzero(pressing > 0) > 100
    assert window.run("return sphereDda.head.forces.largest") == pytest.approx(pressing.max(), rel=1e-6)
    assert "m/s" in window.run("return (await sphereDda.describe(0)).values")["velocity"]


def test_moved_boundaries_are_drawn_where_they_are(window, made):
    page, _, _ = made("live_hopper")
    opened(window, page)
    slide(window, "boundary.gate.displacement", 0.05)
    window.run("await sphereDda.live.step(150)")
    gate = window.run("return sphereDda.boundaries().gate")
    assert np.allclose(gate, [-0.05, 0.0, -0.001, 0.0, 0.0, 0.0, 1.0], atol=1e-7)
    # The scene turns this flap by 30 degrees about an edge.
    page, _, _ = made("gate")
    opened(window, page)
    window.run("await sphereDda.live.step(45)")
    flap = window.run("return sphereDda.boundaries().flap")
    turn = np.deg2rad(30)
    assert np.allclose(flap[:3], [0.06 * np.cos(turn), 0.04, -0.06 * np.sin(turn)], atol=1e-6)
    assert np.allclose(flap[3:], [0.0, np.sin(turn / 2), 0.0, np.cos(turn / 2)], atol=1e-6)


def test_gravity_tilts_and_reset_begins_anew(window, made):
    page, _, _ = made("live_box")
    opened(window, page)
    start = shown(window)["position"]
    slide(window, "gravity[1]", 9.81)
    window.run("await sphereDda.live.step(200)")
    assert shown(window)["position"][:, 0].mean() > start[:, 0].mean() + 0.01
    window.run("await sphereDda.live.reset()")
    again = shown(window)
    assert again["time"] == 0.0 and np.array_equal(again["position"], start)
    assert window.run("return Number(document.querySelector('#live input').value)") == 0.0


def test_page_says_what_the_component_says(window, made):
    page, _, _ = made("live_hopper")
    opened(window, page)
    said = "return document.getElementById('notice').hidden ? '' : document.getElementById('notice').textContent"
    assert window.run(said) == ""
    window.run("sphereDda.live.set('gravity[3]', 1e308); await sphereDda.live.step(20)")
    text = window.run(said)
    print(text)
    assert text.startswith("The solver has stopped. It says: ") and "gravity" in text
    window.run("await sphereDda.live.reset(); await sphereDda.live.step(1)")
    assert window.run(said) == "" and shown(window)["time"] > 0.0


def test_page_shows_warnings_of_the_component(command, window, made, tmp_path):
    made("live_box")
    (tmp_path / "press.toml").write_text(PRESS, encoding="utf-8")
    run(command, "view", tmp_path / "press.toml", "--live", "-o", tmp_path / "press.html")
    opened(window, tmp_path / "press.html")
    warned = "return document.querySelector('#live .warned').textContent"
    assert window.run(warned) == ""
    slide(window, "boundary.plate.displacement", 0.005)
    window.run("await sphereDda.live.step(100)")
    assert "did not meet solver.tolerance" in window.run(warned)
    window.run("await sphereDda.live.reset()")
    assert window.run(warned) == ""


@pytest.mark.parametrize("count", [300, 1000])
def test_page_plays(window, made, count):
    page, _, _ = made("live_hopper", count)
    opened(window, page)
    slide(window, "boundary.gate.displacement", 0.08)
    window.run("document.getElementById('play').click(); await new Promise((done) => setTimeout(done, 8000)); await sphereDda.live.stop()")
    there, pace = shown(window), window.run("return sphereDda.live.pace()")
    size = page.stat().st_size * 1e-6
    print(
        f"{count} grains, page of {size:.1f} MB: {pace['frames']} frames in 8 s, solver {pace['solver']:.1f} ms, picture {pace['draw']:.1f} ms "
        f"a frame (software rendering), {pace['factor']:.2f} of real time, {there['time']:.2f} s simulated"
    )
    # How fast is printed: a busy machine is no fault of the page.
    assert pace["frames"] > 1 and there["time"] > 0.0
    assert window.log() == []
    plotted = window.run("return sphereDda.plots()")
    assert "sensor.outflow.rate" in plotted or "sensor.outflow.mass" in plotted


def test_results_have_run_already(command, made, tmp_path):
    _, _, own = made("live_box")
    run(command, "run", own, "-o", tmp_path / "results", "--stop", 0.01)
    done = run(command, "view", tmp_path / "results", "--live", code=2)
    assert "--live" in done.stderr and "expected a scene file or an FMU" in done.stderr


def test_without_the_module_the_page_says_how_to_build_it(command, tmp_path):
    alone = shutil.copy2(command, tmp_path / "sphere-dda")
    done = run(alone, "view", scene("live_box"), "--live", "-o", tmp_path / "x.html", code=2)
    assert "fmu/platforms/build wasm" in done.stderr
    assert not (tmp_path / "x.html").exists()
