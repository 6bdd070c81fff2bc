"""The Python package, as the wheel has it: scenes, simulations, results, errors."""

import gc
import json
import multiprocessing
import pickle
import subprocess
import sys
import tempfile
import time
import tomllib
import warnings
from pathlib import Path

import meshio
import numpy as np
import pytest
from wheel import digest

H = 2e-3
# A box on a shaker: 60 balls fall into it.
SHAKEN = {
    "title": "shaken box",
    "simulation": {"duration": 0.3, "communication_step": H},
    "output": {"vtu_interval": 0.05},
    "material": [{"name": "steel", "density": 7800.0}],
    "pair_default": {"friction": 0.3, "restitution": 0.4},
    "spheres": [{
        "name": "balls", "material": "steel", "radius": 0.008,
        "lattice": {"origin": np.array([-0.04, -0.04, 0.03]), "count": [5, 4, 3], "spacing": 0.02, "jitter": 0.1},
    }],
    "boundary": [
        {"name": "box", "material": "steel", "input": {"slide": [0.0, 0.0, 1.0]},
         "faces": [{"box": {"min": [-0.06, -0.06, 0.0], "max": [0.06, 0.06, 0.2]}}]},
    ],
    "sensor": [{"name": "load", "wrench": "box"}],
}


@pytest.fixture(autouse=True)
def own_command(command, monkeypatch):
    """The package's own command, not the one that the tests name."""
    monkeypatch.delenv("SPHERE_DDA", raising=False)


@pytest.fixture
def scene(sphere_dda):
    return sphere_dda.Scene(SHAKEN)


def drive(sim, steps, look=lambda sim: None):
    for k in range(steps):
        sim["boundary.box.displacement"] = 2e-3 * np.sin(100.0 * (sim.time + H))
        sim.step(H)
        look(sim)


def test_a_scene_is_checked(sphere_dda, scene):
    found = scene.check()
    assert "60" in found.summary and found.warnings == []
    assert tomllib.loads(scene.text)["spheres"][0]["lattice"]["origin"] == [-0.04, -0.04, 0.03]
    path = Path(scene.path.parent, "file.toml")
    path.write_text(scene.text)
    assert sphere_dda.Scene(path).check().summary.replace("\nfile", "\nscene").splitlines()[1:] == found.summary.splitlines()[1:]
    # Spheres of 8 m in a box of 0.1 m: it runs, but probably not as meant.
    metres = SHAKEN | {"spheres": [{"name": "far", "material": "steel", "radius": 0.008, "positions": [[0, 0, 900.0]]}]}
    assert all(isinstance(one, sphere_dda.Problem) for one in sphere_dda.Scene(metres).check().warnings)


def test_problems_of_a_scene_have_places(sphere_dda):
    wrong = SHAKEN | {"pair_default": {"frction": 0.3}, "simulation": {"duration": -1.0}}
    scene = sphere_dda.Scene(wrong, name="wrong")
    with pytest.raises(sphere_dda.SceneError) as caught:
        scene.check()
    one, two = caught.value.problems
    assert (one.path, two.path) == ("simulation.duration", "pair_default.frction")
    assert scene.text.splitlines()[two.line - 1].startswith("frction")
    assert "did you mean `friction`" in two.help and "expected a time > 0 [s]" in one.message
    assert str(caught.value).startswith(f"wrong.toml:{one.line}: simulation.duration: found -1")
    for call in (sphere_dda.Scene.view, sphere_dda.Simulation, lambda s: s.export("x.fmu"), lambda s: s.run("out")):
        with pytest.raises(sphere_dda.SceneError):
            call(scene)
    again = pickle.loads(pickle.dumps(caught.value))
    assert again.problems == caught.value.problems and str(again) == str(caught.value)
    with pytest.raises(sphere_dda.SceneError, match="cannot read"):
        sphere_dda.Scene("no/such/scene.toml").check()
    with pytest.raises(TypeError, match=r"spheres\[0\].radius: found complex"):
        sphere_dda.Scene(SHAKEN | {"spheres": [{"radius": 1j}]})


def test_dicts_are_the_toml_they_mean(sphere_dda):
    from sphere_dda.toml import document

    data = {
        "title": 'quotes " and \\ and\nlines \x7f ü', "x": 1, "y": [1.5, 1e300, -2], "empty": [], "flag": True,
        "table": {"a b": {"c": [True, "x"]}}, "list": [{"k": [[1, 2], [3]]}, {}], "mixed": [{"a": 1}, 2],
    }
    assert tomllib.loads(document(data)) == data
    numbers = {"a": np.float64(0.1), "b": np.arange(3), "c": np.int64(2), "d": np.bool_(True), "p": Path("x/y"), "none": None}
    assert tomllib.loads(document(numbers)) == {"a": 0.1, "b": [0, 1, 2], "c": 2, "d": True, "p": "x/y"}


def test_files_of_a_dict_are_found(sphere_dda, tmp_path):
    (tmp_path / "data").mkdir()
    (tmp_path / "data" / "places.csv").write_text("x,y,z\n0,0,0.1\n0.03,0,0.1\n")
    data = SHAKEN | {"spheres": [{"name": "two", "material": "steel", "radius": 0.008, "csv": "data/places.csv"}]}
    with sphere_dda.Simulation(sphere_dda.Scene(data, folder=tmp_path)) as sim:
        assert sim.positions.tolist() == [[0, 0, 0.1], [0.03, 0, 0.1]]
    with pytest.raises(sphere_dda.SceneError, match="cannot read"):
        sphere_dda.Scene(data, folder=tmp_path / "data").check()


def test_arrays_have_their_shapes_and_follow_the_steps(sphere_dda, scene):
    with sphere_dda.Simulation(scene) as sim:
        start = sim.positions.copy()
        assert start.shape == sim.velocities.shape == sim.angular_velocities.shape == (60, 3)
        assert sim.radii.tolist() == [0.008] * 60 and sim.orientations.tolist() == [[1, 0, 0, 0]] * 60
        assert sim.present.dtype == bool and sim.present.all()
        assert sim.time == 0.0 and sim["sphereCount"] == 60 and isinstance(sim["sphereCount"], int)
        memory = sim.positions
        sim.step(H)
        fallen = sim.positions
        assert fallen is memory, "read into the same memory"
        # One internal step of free fall.
        assert np.allclose(fallen[:, 2] - start[:, 2], -0.5 * 9.81 * H**2, atol=1e-12) and sim.time == H
        assert np.allclose(sim.velocities, [0, 0, -9.81 * H])
        assert sim["momentum"].shape == (3,) and sim["momentum[3]"] == sim["momentum"][2] < 0
        sim.step()
        assert sim.time == 2 * H
        assert sim.variables["boundary.box.displacement"].unit == "m" and "maxOverlap" in sim
        force = sim["boundaries.averageForce"]
        assert force.shape == (1, 3) and np.array_equal(force[0], sim["boundary.box.averageForce"])
    assert fallen.shape == (60, 3) and "has ended: it was closed" in refusal(sphere_dda, lambda: sim.step(H))


def refusal(sphere_dda, call):
    with pytest.raises(sphere_dda.SimulationError) as caught:
        call()
    return str(caught.value)


def test_refusals_say_what_was_found(sphere_dda, scene):
    with sphere_dda.Simulation(scene) as sim:
        def told(name, value):
            return refusal(sphere_dda, lambda: sim.__setitem__(name, value))

        assert "did you mean `boundary.box.displacement`" in told("boundary.box.displacment", 1.0)
        assert "expected one number of type Float64 [m]" in told("boundary.box.displacement", [1.0, 2.0])
        assert "expected one number" in told("boundary.box.displacement", "far")
        assert "expected an array of shape (3,)" in told("gravity", 9.81)
        assert "no such element, its shape is (3,)" in told("gravity[4]", 1.0)
        assert "expected one of Auto, Direct, GaussSeidel" in told("solver.kind", "Newton")
        assert "expected one number of type Int32" in told("solver.maxSweeps", 2.5)
        assert "cannot be set" in told("mass", 1.0)
        sim["solver.kind"] = "Direct"
        assert sim["solver.kind"] == 2
        sim["gravity[3]"] = -1.0
        assert sim["gravity"].tolist() == [0.0, 0.0, -1.0]
        assert "expected a positive length" in refusal(sphere_dda, lambda: sim.step(-1.0))
        sim.step(H)
        assert "before or in initialization" in told("solver.step", 1e-3)
        assert "not a saved state" in refusal(sphere_dda, lambda: sim.restore(b"no state"))
        assert "before the first step" in refusal(sphere_dda, lambda: sim.record("out").__enter__())
    told = refusal(sphere_dda, lambda: sphere_dda.Simulation(scene, **{"solver.toleranse.gap": 0.4}))
    assert told.startswith("found no parameter `solver.toleranse.gap`; did you mean `solver.tolerance.gap`")
    assert "there are gravity, output.directory" in refusal(sphere_dda, lambda: sphere_dda.Simulation(scene, xyz=0.4))
    assert "found no parameter `boundary" in refusal(sphere_dda, lambda: sphere_dda.Simulation(scene, **{"boundary.box.displacement": 1.0}))
    assert "expected a number" in refusal(sphere_dda, lambda: sphere_dda.Simulation(scene, **{"solver.step": -1.0}))
    with sphere_dda.Simulation(scene, **{"solver.tolerance.gap": 1e-6}) as sim:
        assert sim["solver.tolerance.gap"] == 1e-6


def test_a_discarded_step_can_be_mended_and_a_warning_is_one(sphere_dda):
    # Two plates squeeze a sphere: there is no solution.
    plate = {"material": "steel", "input": {"slide": [0, 0, 1]}}
    squeezed = SHAKEN | {
        "spheres": [{"name": "one", "material": "steel", "radius": 0.01, "positions": [[0, 0, 0.01]]}],
        "sensor": [],
        "boundary": [
            {"name": "floor", "material": "steel", "faces": [{"plane": {"point": [0, 0, 0], "normal": [0, 0, 1]}}]},
            plate | {"name": "press", "faces": [{"plane": {"point": [0, 0, 0.021], "normal": [0, 0, -1]}}]},
        ],
    }

    def press(sim):
        sim.step(H)
        sim["boundary.press.displacement"] = -4e-3
        sim.step(H)

    with sphere_dda.Simulation(squeezed) as sim, pytest.warns(sphere_dda.SimulationWarning) as told:
        press(sim)
    assert told[0].filename == __file__, "at the line of the caller"
    strict = squeezed | {"simulation": SHAKEN["simulation"] | {"strict": True}}
    with sphere_dda.Simulation(strict) as sim:
        with pytest.raises(sphere_dda.SimulationError, match="fmi3DoStep.*squeezed between `floor` and `press`") as caught:
            press(sim)
        assert caught.value.status == "discard" and sim.time == H
        sim["boundary.press.displacement"] = 0.0
        sim.step(0.5 * H)
        assert sim.time == 1.5 * H and np.allclose(sim.positions, [[0, 0, 0.01]], atol=1e-6)


def test_save_and_restore_are_bitwise(sphere_dda, scene):
    def look(sim):
        return sim.positions.tobytes(), sim.velocities.tobytes(), sim["sensor.load.force"].tobytes()

    with sphere_dda.Simulation(scene) as sim:
        drive(sim, 60)
        state, here = sim.save(), look(sim)
        drive(sim, 40)
        there, time = look(sim), sim.time
        assert there != here
        sim.restore(state)
        assert look(sim)[:2] == here[:2] and sim.time == pytest.approx(60 * H)
        drive(sim, 40)
        assert look(sim) == there and sim.time == time
    with sphere_dda.Simulation(scene) as other:
        other.restore(state)
        drive(other, 40)
        assert look(other) == there


def test_a_recording_is_the_run_of_the_command(sphere_dda, scene, tmp_path):
    run = scene.run(tmp_path / "command")
    with sphere_dda.Simulation(scene) as sim:
        assert sim.positions.shape == (60, 3), "read before"
        sim["boundary.box.displacement"] = 0.0
        with sim.record(tmp_path / "python=0.5") as recorded:
            sim.run()
        assert sim.time == 0.3 and sim["mass"] > 0
        assert "has ended" in refusal(sphere_dda, lambda: sim.step(H))
    files = [path.name for path in run.folder.glob("*.vtu")]
    assert len(files) == 3 * 7
    for name in ("history.csv", *files):
        assert digest(run.folder / name) == digest(recorded.folder / name), name
    assert json.loads((recorded.folder / "run.json").read_text())["settings"] == run.about["settings"]
    with pytest.raises(sphere_dda.CommandError, match="already holds a run") as caught:
        scene.run(tmp_path / "command")
    assert caught.value.code == 2
    with sphere_dda.Simulation(scene) as sim, pytest.raises(sphere_dda.SimulationError, match="already holds a run"):
        with sim.record(tmp_path / "command"):
            pass
    assert digest(run.folder / "history.csv") == digest(recorded.folder / "history.csv")


def test_results_are_arrays(sphere_dda, scene, tmp_path):
    assert scene.run(tmp_path / "out").folder == tmp_path / "out"
    run = sphere_dda.open(tmp_path / "out")
    table = np.genfromtxt(run.folder / "history.csv", delimiter=",", skip_header=1)
    assert list(run.history)[0] == "time" and run.units["time"] == "s" and run.units["maxOverlap"] == "-"
    assert np.array_equal(np.column_stack(list(run.history.values())), table) and len(table) == 151
    assert run.boundaries == ["box"] and len(run.frames) == 7 and "7 frames" in repr(run)
    assert np.allclose(run.frames.times, np.arange(7) * 0.05)
    frame = run.frames[-1]
    for series, grid in (("spheres", frame.spheres), ("contacts", frame.contacts), ("boundaries", frame.boundaries)):
        mesh = meshio.read(run.folder / f"{series}_000006.vtu")
        corners = mesh.points[mesh.cells[0].data]
        places = {"spheres": ("position", mesh.points), "contacts": ("ends", corners), "boundaries": ("triangles", corners)}
        name, expected = places[series]
        assert np.array_equal(grid[name], expected)
        arrays = {k: v[0] for k, v in mesh.cell_data.items()} | (mesh.point_data if series == "spheres" else {})
        assert arrays and len(arrays) == len(grid) - (2 if series == "boundaries" else 1)
        for key, value in arrays.items():
            assert np.array_equal(np.squeeze(grid[key]), np.squeeze(value)), key
    assert len(frame.contacts["normal_force"]) > 50 and frame.spheres["id"].tolist() == list(range(60))
    first = run.frames[0]
    assert first.contacts["ends"].shape == (0, 2, 3) and first.time == 0.0 and run.frames.near(0.149).time == frame_time(run, 3)
    assert [one.time for one in run.frames[1:3]] == [run.frames[1].time, run.frames[2].time]
    with pytest.raises(IndexError):
        run.frames[7]
    assert run.pyvista().n_points == 60
    with pytest.raises(sphere_dda.SphereDdaError, match="no result folder"):
        sphere_dda.open(tmp_path)
    (run.folder / "spheres_000002.vtu").write_bytes(b"<VTKFile>")
    with pytest.raises(sphere_dda.SphereDdaError, match="spheres_000002.vtu"):
        run.frames[2]


def frame_time(run, k):
    return float(run.frames.times[k])


def test_pages_show_in_notebooks(sphere_dda, scene, tmp_path):
    page = sphere_dda.Scene(SHAKEN).view()
    gc.collect()
    shown = page._repr_html_()
    assert shown.startswith("<iframe srcdoc=") and shown.count('"') == 8 and "&lt;script" in shown
    run = scene.run(tmp_path / "out", stop=0.1)
    assert run.view(max_size="1MB").path == tmp_path / "out" / "view.html"
    assert run.view().path.stat().st_size > 1e5


def test_a_settled_start_is_made_once(sphere_dda, scene):
    with sphere_dda.Simulation(scene, settle="rest") as sim, sphere_dda.Simulation(scene, settle="rest") as other:
        assert np.abs(sim.velocities).max() < 1e-3 and np.array_equal(sim.positions, other.positions)
        assert sim.positions[:, 2].max() < 0.05
        other.step(H)
        assert other["sensor.load.force[3]"] == pytest.approx(-other["mass"] * 9.81, rel=2e-2)
    assert len(scene._prepared) == 1


def study(scene):
    import sphere_dda

    with warnings.catch_warnings(), sphere_dda.Simulation(scene, **{"solver.tolerance.gap": 1e-5}) as sim:
        drive(sim, 50)
        return sim.positions.tobytes()


def test_processes_share_a_scene(scene):
    before = temporary()
    with multiprocessing.get_context("spawn").Pool(2) as pool:
        results = pool.map(study, [scene] * 3)
        # Leaving the block kills workers where they are.
        pool.close()
        pool.join()
    assert set(results) == {study(scene)}
    del scene
    gc.collect()
    assert temporary() - before == set(), "left behind"


def temporary():
    return set(Path(tempfile.gettempdir()).glob("sphere-dda-*"))


def test_a_step_costs_what_the_library_does(sphere_dda):
    """A step is one call, and what Python adds takes 5 % of it at most at 1000 spheres.

    Python's part is measured with a step that does nothing: beside real ones, on a busy machine, it shows what others have left of
    the caches. benches/python/step.py compares the whole with the command.
    """
    lattice = {"origin": [-0.11, -0.11, 0.02], "count": [10, 10, 10], "spacing": 0.0244, "jitter": 0.05}
    box = [{"box": {"min": [-0.13, -0.13, 0.0], "max": [0.13, 0.13, 0.4]}}]
    bed = SHAKEN | {
        "spheres": [SHAKEN["spheres"][0] | {"radius": 0.01, "lattice": lattice}],
        "boundary": [SHAKEN["boundary"][0] | {"faces": box}],
    }

    def cost(steps):
        start = time.thread_time()
        drive(sim, steps)
        return (time.thread_time() - start) / steps

    with sphere_dda.Simulation(bed) as sim:
        drive(sim, 100)
        before, counted = sim.calls, []
        whole = min(cost(20) for _ in range(5))
        sys.setprofile(lambda _, event, __: counted.append(event))
        try:
            drive(sim, 1, lambda sim: (sim.positions, sim.velocities))
        finally:
            sys.setprofile(None)
        made = {name: count - before.get(name, 0) for name, count in sim.calls.items() if count != before.get(name, 0)}
        functions = sim._instance._library.calls
        step = functions["DoStep"]
        functions["DoStep"] = lambda *_: 0
        try:
            share = min(cost(1000) for _ in range(5)) / whole
        finally:
            functions["DoStep"] = step
    assert made == {"DoStep": 101, "SetFloat64": 101, "GetFloat64": 2}
    assert counted.count("call") + counted.count("c_call") < 60, "calls of Python functions"
    assert share <= 0.05, f"{share:.4f} of {whole * 1e3:.3f} ms"


def test_the_program_is_the_package(sphere_dda, wheel):
    program = sphere_dda.command.program()
    assert program.is_relative_to(Path(sphere_dda.__file__).parent)
    told = subprocess.run([program, "--version"], capture_output=True, text=True, check=True).stdout
    assert told.split()[1] == wheel.name.split("-")[1]
