"""The comparison with other codes measures what it says, and its scenes are good ones. No other code is needed."""

import json
import math
import re
import shutil
import struct
import subprocess
import sys
from dataclasses import asdict, replace

import numpy as np
import pytest
from conftest import ROOT

sys.path.insert(0, str(ROOT / "benches" / "peers"))
import goals
import measures
import plan
import scenes
from codes import MODULES, liggghts, missing, module, sphere_dda
from record import Record
from runs import Case, Failed, Outcome, Row, tidy

STILL = np.zeros((2, 3))


def two(x, radius, name="bed"):
    """Two spheres in a box of half width 0.2 m."""
    planes = scenes.bed(1000, 1).planes
    return scenes.Scene(name, np.array(x), np.array(radius), 2500.0, planes, 0.2)


def test_overlap_of_two_spheres_is_over_the_smaller_radius():
    x = np.array([[0.0, 0.0, 0.05], [0.0, 0.018, 0.05]])
    scene = two(x, [0.01, 0.02])
    assert measures.overlap(scene, x) == pytest.approx((0.03 - 0.018) / 0.01)
    large = two(x, [0.02, 0.02])
    assert measures.overlap(large, np.array([[0.0, 0.0, 0.05], [0.0, 0.039, 0.05]])) == pytest.approx(0.001 / 0.02)
    apart = np.array([[0.0, 0.0, 0.05], [0.0, 0.0301, 0.05]])
    assert measures.overlap(scene, apart) == 0.0


def test_overlap_with_a_wall_is_over_the_sphere_s_own_radius():
    x = np.array([[0.1, 0.0, 0.0195], [-0.191, 0.0, 0.05]])
    assert measures.overlap(two(x, [0.02, 0.01]), x) == pytest.approx(0.001 / 0.01)
    x = np.array([[0.1, 0.0, 0.015], [-0.1, 0.0, 0.05]])
    assert measures.overlap(two(x, [0.02, 0.01]), x) == pytest.approx(0.005 / 0.02)


def test_overlap_is_that_of_all_pairs():
    rng = np.random.default_rng(3)
    x, r = rng.uniform([-0.1, -0.1, 0.05], [0.1, 0.1, 0.25], (300, 3)), rng.uniform(0.004, 0.02, 300)
    i, j = np.triu_indices(300, 1)
    depth = (r[i] + r[j] - np.linalg.norm(x[i] - x[j], axis=1)) / np.minimum(r[i], r[j])
    assert measures.overlap(two(x, r), x) == pytest.approx(depth.max())


def test_a_sphere_in_the_funnel_touches_its_sloping_wall_only_above_the_outlet():
    scene = scenes.build("funnel", 1000, 1)
    r = 0.01
    foot = np.array([0.1, 0.0, 0.1 - scenes.OUTLET])
    normal = np.array([-1.0, 0.0, 1.0]) / math.sqrt(2)
    far = np.array([1.0, 1.0, -1.0])
    spheres = replace(scene, position=np.zeros((2, 3)), radius=np.full(2, r))
    pressed = np.array([foot + 0.9 * r * normal, far])
    assert measures.overlap(spheres, pressed) == pytest.approx(0.1)
    falling = np.array([[0.058, 0.0, -0.02], far])
    assert measures.overlap(spheres, falling) == 0.0


def test_energy_height_and_lost_spheres():
    x = np.array([[0.0, 0.0, 0.05], [0.3, 0.0, 0.02]])
    scene = two(x, [0.01, 0.02])
    v, w = np.array([[3.0, 0.0, 0.0], [0.0, 0.0, 0.0]]), np.array([[0.0, 0.0, 0.0], [0.0, 10.0, 0.0]])
    found = measures.end(scene, x, v, w)
    # Masses are as 1 to 8: (9/2 + 8 (1/5) 0.02^2 10^2) / 9.
    assert found.energy == pytest.approx((4.5 + 8 * 0.2 * 0.04) / 9)
    assert (found.lost, found.height) == (1, 0.05)
    gone = np.array([[0.0, 0.0, 0.05], [np.nan, np.nan, np.nan]])
    assert measures.end(scene, gone, STILL, STILL).lost == 1


def test_what_is_below_the_outlet_or_gone_is_discharged():
    scene = scenes.build("funnel", 1000, 1)
    x, still = scene.position.copy(), np.zeros_like(scene.position)
    assert measures.end(scene, x, still, still).discharged == pytest.approx(0.0, abs=1e-12)
    x[0], x[1] = [0.0, 0.0, -0.1], np.nan
    assert measures.end(scene, x, still, still).discharged == pytest.approx(scene.mass[:2].sum())


def test_the_course_holds_the_worst_overlap_and_when_half_is_out():
    scene = scenes.build("funnel", 1000, 1)
    start = scene.position.copy()
    touching, out = start.copy(), start.copy()
    touching[:2] = [[0.0, 0.0, 5.0], [0.0, 0.0, 5.019]]
    # The 500 large spheres are three quarters of the mass, the small ones a quarter.
    out[:500, 2] = -1.0
    found = measures.course(scene, [start, touching, start, out, start], 0.004)
    assert found.worst == pytest.approx(0.1)
    assert found.half_out == pytest.approx(4 * 0.004)
    out[:500], out[500:] = start[:500], [0.0, 0.0, -100.0]
    out[500:, 0] = np.arange(500.0)
    assert measures.course(scene, [start, out], 0.004).half_out is None


def test_opening_is_the_widest_gap_of_a_loaded_contact():
    # Spheres 0 and 1 are 1 mm apart, 1 and 2 overlap by 2 mm, 2 is 3 mm above the floor and 0 is 6 mm above it.
    x = np.array([[0.0, 0.0, 0.026], [0.0, 0.031, 0.026], [0.0, 0.031, 0.013 + 1e-9]])
    x[2] = [0.0, 0.031 + math.sqrt(0.018**2 - 0.013**2), 0.013]
    scene = two(x, [0.02, 0.01, 0.01])
    loaded = np.array([[0, 1], [1, 2], [2, measures.WALL], [0, measures.WALL]])
    assert measures.opening(scene, x, loaded[:1]) == pytest.approx(0.001 / 0.01)
    assert measures.opening(scene, x, loaded[1:2]) == 0.0
    assert measures.opening(scene, x, loaded[:3]) == pytest.approx(0.003 / 0.01)
    assert measures.opening(scene, x, loaded) == pytest.approx(0.006 / 0.02)
    assert measures.opening(scene, x, loaded[:0]) == 0.0
    assert measures.overlap(scene, x) == pytest.approx(0.002 / 0.01)
    found = measures.course(scene, [x, x], 0.004, [None, loaded])
    assert (found.worst, found.opening) == (pytest.approx(0.2), pytest.approx(0.3))
    assert measures.course(scene, [x], 0.004).opening is None


def test_overlap_of_ten_sizes_is_that_of_all_pairs():
    rng = np.random.default_rng(5)
    x, r = rng.uniform([-0.1, -0.1, 0.05], [0.1, 0.1, 0.25], (400, 3)), 0.002 * 10 ** rng.uniform(0, 1, 400)
    i, j = np.triu_indices(400, 1)
    depth = (r[i] + r[j] - np.linalg.norm(x[i] - x[j], axis=1)) / np.minimum(r[i], r[j])
    assert measures.overlap(two(x, r), x) == pytest.approx(depth.max())
    near = {frozenset(pair) for pair in zip(*measures._near(x, r), strict=True)}
    touching = {frozenset(pair) for pair in zip(i[depth > 0], j[depth > 0], strict=True)}
    assert touching <= near
    assert any(max(r[list(pair)]) > 4 * min(r[list(pair)]) for pair in touching)


def test_walls_are_measured_where_they_have_moved_to():
    blade = scenes.build("blade", 200, 1)
    body = blade.moving
    (_, right), r = body.box, blade.radius[0]
    far = np.tile([1.0, 1.0, 1.0], (len(blade.radius), 1))
    far[0] = [right[0] + 0.9 * r, 0.0, 0.05]
    # 10 mm apart from its start after 0.1 s of 0.1 m/s.
    assert measures.overlap(blade, far, body.begin) == pytest.approx(0.1)
    far[0, 0] += 0.01
    assert measures.overlap(blade, far, body.begin) == 0.0
    assert measures.overlap(blade, far, body.begin + 0.1) == pytest.approx(0.1)
    drum = scenes.build("drum", 100, 1)
    x = np.tile([0.0, 0.0, 0.0], (100, 1))
    x[:, 0], r = 1.0, drum.radius[0]
    # Below the edge between two sides, and below the middle of one after it has turned by half a side.
    x[0] = [0.0, 0.0, -(0.1 - 0.9 * r) / math.cos(math.pi / 24)]
    turned = math.pi / 24 / 2.0
    assert measures.overlap(drum, x) == pytest.approx(0.1)
    assert measures.overlap(drum, x, turned) == pytest.approx((r + -x[0, 2] - 0.1) / r)


def test_errors_of_a_force_are_about_the_converged_mean():
    # About 2: 1, 1, -1, -1 of the converged run; its mean is 2. The other one has the mean 3 and is 0, 2, 0, 2 above 2.
    error = measures.force_error([2.0, 4.0, 2.0, 4.0], [3.0, 3.0, 1.0, 1.0])
    assert (error.mean, error.rms, error.natural) == (pytest.approx(0.5), pytest.approx(math.sqrt(2) / 2), pytest.approx(0.5))
    negative = measures.force_error([-2.0, -4.0], [-2.0, -2.0])
    assert (negative.mean, negative.rms) == (pytest.approx(0.5), pytest.approx(math.sqrt(2) / 2))
    assert measures.force_error([], [1.0]) is None
    assert measures.force_error([1.0], []) is None


def test_a_load_by_balance_is_weight_less_change_of_momentum():
    scene = scenes.build("hopper", 50, 1)
    x, still = scene.position, np.zeros((50, 3))
    assert measures.by_balance(scene, [(x, still, still)] * 2, 0.004) == [pytest.approx(scene.weight)]
    fallen = np.tile([0.0, 0.0, -scenes.GRAVITY * 0.004], (50, 1))
    assert measures.by_balance(scene, [(x, still, still), (x, fallen, still)], 0.004) == [pytest.approx(0.0, abs=1e-9 * scene.weight)]
    drum = scenes.build("drum", 50, 1)
    x, still = drum.position, np.zeros((50, 3))
    # The weight's moment about y is m g x; spheres that begin to turn take 2/5 m r^2 each.
    moment = float((drum.mass * scenes.GRAVITY * x[:, 0]).sum())
    assert measures.by_balance(drum, [(x, still, still)] * 2, 0.004) == [pytest.approx(moment)]
    turning = np.tile([0.0, 3.0, 0.0], (50, 1))
    taken = float((0.4 * drum.mass * drum.radius**2).sum()) * 3.0 / 0.004
    assert measures.by_balance(drum, [(x, still, still), (x, still, turning)], 0.004) == [pytest.approx(moment - taken)]


FEW = {"bed": 20, "rolling": 20, "polydisperse": 20, "slope": 20, "funnel": 40, "hopper": 30, "drum": 30, "blade": 200, "feeder": 20}


@pytest.mark.parametrize("name", FEW)
def test_the_walls_of_a_scene_are_the_same_as_planes_and_as_triangles(name):
    scene = scenes.build(name, FEW[name], 1)
    planes = scene.moving.planes if scene.moving else scene.planes
    triangles = scene.moving.triangles if scene.moving else scene.triangles
    if not planes or not len(triangles):
        return
    normals = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    off = [min(np.abs((corners - p.point) @ np.array(p.normal)).max() + np.linalg.norm(n - p.normal) for p in planes) for corners, n in zip(triangles, normals, strict=True)]
    assert max(off) < 1e-9


def test_the_hopper_is_a_mesh_of_ten_thousand_triangles():
    assert len(scenes.build("hopper", 30, 1).triangles) == 10_000


@pytest.mark.parametrize("name", FEW)
def test_every_code_runs_a_scene_or_says_why_not(name):
    reasons = missing(name)
    assert all(len(why) > 20 for why in reasons.values())
    planned = {case.code for group in plan.groups(quick=True) for case in group.sequence() if case.scene == name}
    assert planned | set(reasons) == set(MODULES)
    assert not planned & set(reasons)


SETTINGS = {
    "sphere-dda-fmi": plan.USERS["fast"],
    "rapier": plan.RAPIER["2 ms"],
    "liggghts": plan.LIGGGHTS["soft"],
    "mujoco": plan.MUJOCO["fast"],
    "newton": plan.NEWTON["fast"],
}


@pytest.mark.parametrize(("code", "name"), [(code, name) for code in SETTINGS for name in FEW if name not in module(code).CANNOT])
def test_a_code_that_is_installed_runs_its_scenes(command, tmp_path, monkeypatch, code, name):
    if code == "liggghts" and not shutil.which("liggghts"):
        pytest.skip("liggghts is not on the PATH: its adapter is NOT tested")
    package = {"rapier": "rapier3d", "mujoco": "mujoco", "newton": "newton"}.get(code)
    if package:
        pytest.importorskip(package, reason=f"{package} is not installed: its adapter is NOT tested")
    monkeypatch.setenv("SPHERE_DDA", str(command))
    case = Case(code, name, FEW[name], SETTINGS[code], duration=0.04)
    scene = scenes.build(name, FEW[name], 1)
    found = module(code).run(case, scene, tmp_path)
    assert (found.spheres, found.end.lost) == (FEW[name], 0)
    assert found.steps >= 10
    assert found.peak > 1e6
    assert found.cpu_s > 0 or code == "sphere-dda-fmi"
    assert math.isfinite(found.end.energy)
    assert found.end.energy > 0
    if scene.load and code != "newton":
        # Every interval: windows are longer than this run.
        assert len(found.force) == 10
        assert all(map(math.isfinite, found.force))
    if code == "sphere-dda-fmi":
        assert sum(found.force) / 10 == pytest.approx(scene.weight, rel=0.5)


@pytest.mark.parametrize("name", FEW)
def test_scenes_run_for_a_moment(command, tmp_path, name):
    scene = scenes.build(name, FEW[name], 1)
    case = Case("sphere-dda", name, FEW[name], plan.USERS["fast"], duration=0.02)
    path = sphere_dda.write(scene, case, tmp_path)
    done = subprocess.run([command, "run", path, "-o", tmp_path / "results"], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr


@pytest.mark.parametrize(
    ("name", "n"),
    [("bed", 100), ("bed", 1000), ("slope", 180), ("funnel", 1000), ("polydisperse", 300), ("hopper", 1500), ("drum", 1000), ("blade", 1000), ("feeder", 150)],
)
def test_scenes_start_without_overlap_and_are_read(command, tmp_path, name, n):
    scene = scenes.build(name, n, 1)
    assert len(scene.position) == n
    assert measures.overlap(scene, scene.position) == 0.0
    path = sphere_dda.write(scene, Case("sphere-dda", name, n, plan.OURS["1e-4"]), tmp_path)
    done = subprocess.run([command, "check", path], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    found = dict(re.findall(r"^  (spheres|mass|initial overlaps) +([0-9.e+-]+)", done.stdout, re.MULTILINE))
    assert (int(found["spheres"]), int(found["initial overlaps"])) == (n, 0)
    assert float(found["mass"]) == pytest.approx(scene.mass.sum(), rel=1e-5)


def test_frames_of_several_processes_are_put_together(tmp_path):
    def block(rows):
        return struct.pack("<i", 4 * len(rows)) + np.array(rows, float).tobytes()

    head = struct.pack("<qq7i6dii", 8, 3, 0, *[1] * 6, *[0.0] * 6, 4, 2)
    frame = head + block([[4, 0.4, 0.5, 0.6]]) + block([[1, 0.1, 0.2, 0.3], [2, 1.0, 2.0, 3.0]])
    (tmp_path / "frames.bin").write_bytes(frame + frame)
    lost = [np.nan] * 3
    expected = [[0.1, 0.2, 0.3], [1.0, 2.0, 3.0], lost, [0.4, 0.5, 0.6]]
    for found in (frames := liggghts.frames(tmp_path / "frames.bin", 4, 3)):
        np.testing.assert_array_equal(found, expected)
    assert len(frames) == 2


def test_ratios_are_to_the_rows_just_before_and_after():
    still = measures.End(0.0, 0.0, 0, None, None, 1.0)
    ours, rapier = Case("sphere-dda", "bed", 1000, plan.OURS["1e-4"]), Case("rapier", "bed", 1000, plan.RAPIER["4 ms"])

    def row(case, cpu):
        return Row(case, "bed", Outcome("1", cpu, cpu, 1, 1, still))

    rows = [row(rapier, 4.0), row(ours, 1.0), row(rapier, 6.0), row(ours, 3.0), row(rapier, 14.0)]
    record = Record({}, rows)
    assert record.ratios("bed") == {ours.key: [pytest.approx(1.0 / 5.0), pytest.approx(3.0 / 10.0)]}
    failed = Record({}, [*rows[:2], Failed(rapier, "bed", "no reason")])
    assert failed.ratios("bed") == {}


def test_a_ratio_is_to_a_reference_of_the_same_project_too():
    still = measures.End(0.0, 0.0, 0, None, None, 1.0)
    wide = Case("sphere-dda", "bed", 1000, plan.OURS["1e-4"])
    narrow, other = replace(wide, settings={**wide.settings, "registers": "avx2"}), replace(wide, n=10)

    def row(case, cpu):
        return Row(case, "registers", Outcome("1", cpu, cpu, 1, 1, still))

    record = Record({}, [row(wide, 1.0), row(narrow, 3.0), row(wide, 2.0), row(other, 7.0)])
    assert record.ratios("registers") == {narrow.key: [pytest.approx(2.0)]}


def test_what_has_settled_beside_the_blade_costs_what_the_longer_trough_costs_more():
    still = measures.End(0.0, 0.0, 0, None, None, 1.0)
    time = [0.004 * k for k in range(1, 376)]

    def row(n, moving, settled):
        course = {"time": time, "wall_s": [moving if t < 0.5 else settled for t in time]}
        return Row(Case("sphere-dda", "blade", n, {}, trace=True), "heap", Outcome("1", 1.0, 1.0, n, 1, still, course=course))

    record = Record({}, [row(plan.HEAPS[0], 1.0, 3.0), row(plan.HEAPS[1], 5.0, 3.1)])
    assert goals.beside_blade(record) == (pytest.approx(4.0), pytest.approx(0.1))
    goal = next(goal for goal in goals.table(record) if goal.what.startswith("settled beside"))
    assert goal.met
    record.rows[1] = row(plan.HEAPS[1], 5.0, 3.4)
    assert not next(goal for goal in goals.table(record) if goal.what.startswith("settled beside")).met


def test_records_are_read_as_they_were_written(tmp_path):
    end = measures.End(1e-5, 2e-6, 0, 0.05, None, 10.0)
    case = Case("sphere-dda", "bed", 1000, plan.OURS["1e-4"])
    outcome = Outcome("1", 1.0, 1.1, 1000, 2000, end, watched=measures.Course(1e-4, None), worst=1e-4, course={"time": [0.5, 1.0]})
    record = Record({"cores": "2"}, [Row(case, "bed", outcome), Failed(case, "bed", "why")])
    record.write(tmp_path)
    assert Record.read(tmp_path) == record
    assert json.loads(json.dumps(asdict(record.rows[0])))["outcome"]["course"] == {"time": [0.5, 1.0]}


def test_an_earlier_record_gives_the_rows_that_are_not_run_anew():
    case = Case("rapier", "bed", 1000, plan.RAPIER["4 ms"])
    new = Record({"command": "run --only bed --keep"}, [])
    new.add(Record({"command": "run"}, [Failed(case, "bed", "a"), Failed(case, "slope", "b")]), without={"bed"})
    assert new == Record({"command": "run; run --only bed --keep"}, [Failed(case, "slope", "b")])


def test_numbers_are_short():
    numbers = (1e-4, 4.95e-5, 0.25, 16.63, 1500.0, 1e7, 1.3e10, 0.0)
    assert [tidy(x) for x in numbers] == ["1e-4", "4.95e-5", "0.25", "16.6", "1500", "1e7", "1.3e10", "0"]


def test_a_reference_runs_before_and_after_every_case():
    group = next(group for group in plan.groups(quick=True) if group.name == "bed")
    codes = [case.code for case in group.sequence()]
    assert codes == ["rapier", "sphere-dda"] * (len(plan.OURS) + len(plan.USERS)) + ["rapier"]


@pytest.mark.parametrize("name", ["bed", "slope", "funnel"])
def test_scenes_run_at_the_accuracies_that_users_get(name):
    cases = next(group for group in plan.groups(quick=True) if group.name == name).cases
    assert [case.label for case in cases if "accuracy" in case.settings] == ["fast", "standard", "reference"]


def test_the_funnel_runs_with_steps_of_one_length_and_with_chosen_ones():
    for quick, tolerances in ((True, {1e-4}), (False, {1e-4, 1e-5, 1e-6})):
        settings = [case.settings for case in next(g for g in plan.groups(quick) if g.name == "funnel").cases]
        for steps in ("fixed_step", "smallest_step"):
            assert {s["tolerance"] for s in settings if steps in s} == tolerances


def test_the_physics_of_every_tolerance_is_judged_by_the_median_of_all_seeds():
    seeded = {case.seed for group in plan.groups(quick=False) if group.name == "seeds" for case in group.cases if case.settings == plan.OURS["1e-6"]}
    assert seeded == set(plan.SEEDS)
    floors, heights, energies = [0.97, 1.02, 1.0, 1.0, 1.0], [0.05, 0.05, 0.05, 0.06, 0.04], [1e-6, 2e-6, 1e-3, 3e-6, 4e-6]
    rows = [
        Row(
            Case("sphere-dda", "bed", 1000, plan.OURS["1e-6"], seed=1 + k),
            "bed" if k == 0 else "seeds",
            Outcome("1", 1.0, 1.0, 1000, 1, measures.End(0.0, energies[k], 0, heights[k], None, 1.0), floor=floors[k]),
        )
        for k in range(5)
    ]
    judged = {goal.what: goal for goal in goals.table(Record({}, rows)) if "median of 5 seeds" in goal.what}
    assert len(judged) == 9
    found = {what.split(": ")[1]: goal for what, goal in judged.items() if "1e-6" in what}
    assert [(goal.found, goal.met) for goal in found.values()] == [("1", True), ("0.05 m", True), ("3e-6 J/kg", True)]
    assert {goal.met for what, goal in judged.items() if "1e-6" not in what} == {None}
    shaking = [replace(row, outcome=replace(row.outcome, end=replace(row.outcome.end, energy=2e-5), floor=1.1)) for row in rows]
    judged = {goal.what: goal.met for goal in goals.table(Record({}, shaking)) if "1e-6, median" in goal.what}
    assert list(judged.values()) == [False, True, False]
