"""The sweep of examples/gate: one FMU with parameters against scenes with the values typed into them, bit for bit."""

import csv
import subprocess
import sys

import fmpy
import pytest
from conftest import ROOT, scene
from fmu import Slave
from test_fmi3 import Unit

sys.path.insert(0, str(ROOT / "examples" / "gate"))
from sweep import ANGLES, FRICTIONS, MASS, STEP, plot, sweep  # noqa: E402

STOP = 0.4
TEXT = scene("gate").read_text()


def edited(friction, angle):
    """The scene with the two numbers typed where its parameters lead."""
    text = TEXT.replace("friction = 0.4", f"friction = {friction!r}")
    text = text.replace('[0.0, "30 deg", 0.0]', f"[0.0, {angle!r}, 0.0]")
    assert text != TEXT
    return text


def export(command, folder, name, text, *more):
    (folder / f"{name}.toml").write_text(text)
    fmu = folder / f"{name}.fmu"
    subprocess.run([command, "export", folder / f"{name}.toml", "-o", fmu, *more], check=True)
    return fmu


def test_fifteen_runs_of_one_fmu_are_fifteen_edited_scenes(command, tmp_path):
    runs = sweep(export(command, tmp_path, "gate", TEXT), stop=STOP)
    assert len(runs) == len(FRICTIONS) * len(ANGLES) == 15
    for (friction, angle), (time, mass) in runs.items():
        (tmp_path / "edited.toml").write_text(edited(friction, angle))
        results = tmp_path / "results"
        run = [command, "run", tmp_path / "edited.toml", "-o", results, "--stop", str(STOP), "--overwrite"]
        subprocess.run(run, check=True, capture_output=True)
        with (results / "history.csv").open(newline="") as file:
            column = [float(row[f"{MASS} [kg]"]) for row in csv.DictReader(file)]
        assert mass.tolist() == column, (friction, angle)
    final = {pair: mass[-1] for pair, (_, mass) in runs.items()}
    # Steeper and smoother lets more out; otherwise the values would not have arrived.
    assert final[0.1, 0.5] > final[0.1, 0.3] and final[0.1, 0.4] > final[0.8, 0.4]
    plot(runs, tmp_path / "sweep.png")
    assert (tmp_path / "sweep.png").stat().st_size > 10_000


@pytest.mark.parametrize("fmi", ["2", "3"])
def test_start_values_in_both_versions(command, tmp_path, fmi):
    """Start values arrive by name; values out of range, and another number of grains, are refused."""
    fmu = export(command, tmp_path, "gate", TEXT, "--fmi", fmi)
    description = fmpy.read_model_description(str(fmu))
    variables = {v.name: v for v in description.modelVariables}
    assert [variables[name].variability for name in ("friction", "angle", "count")] == ["tunable", "fixed", "fixed"]
    assert [variables["angle"].unit, variables["angle"].min, variables["angle"].max] == ["rad", "0.0", "1.2"]

    def run(**start):
        rows = fmpy.simulate_fmu(str(fmu), stop_time=0.3, output_interval=STEP, start_values=start, output=["kineticEnergy"])
        return rows["kineticEnergy"]

    plain, smooth = run(), run(friction=0.0)
    assert plain.tolist() != smooth.tolist()
    assert run(friction=0.4).tolist() == plain.tolist()
    for wrong in ({"friction": 1.5}, {"angle": -0.1}, {"count": 100}):
        with pytest.raises(Exception):
            run(**wrong)


def test_friction_turns_between_steps_alike_in_both_versions(command, tmp_path):
    """Up to 0.25 s as without it, then another motion, the same in both versions."""
    two, three = (export(command, tmp_path, f"gate{n}", TEXT, "--fmi", n) for n in "23")

    def drive(unit, energy, turned):
        values = []
        for k in range(80):
            if k == 50 and turned:
                unit.set("friction", 0.05)
            unit.step(k * STEP, STEP)
            values.append(energy())
        return values

    def by_two(turned):
        with Slave(two) as unit:
            return drive(unit, lambda: unit.get("kineticEnergy")[0], turned)

    with Unit(three) as unit:
        third = drive(unit, lambda: unit.get("kineticEnergy"), True)
        with pytest.raises(Exception):
            unit.set("angle", 0.4)
        assert any("`angle` cannot be set" in line for line in unit.lines)
    plain, turned = by_two(False), by_two(True)
    assert third == turned
    assert turned[:50] == plain[:50] and turned[51:] != plain[51:]


def test_the_command_takes_the_same_names(command, tmp_path):
    check = [command, "check", scene("gate")]
    more = subprocess.run([*check, "--set", "count=200", "--set", "friction=0.2"], check=True, capture_output=True, text=True)
    assert "200" in more.stdout
    wrong = subprocess.run([*check, "--set", "frction=0.2", "--set", "angle=2"], capture_output=True, text=True)
    assert wrong.returncode == 2
    assert "did you mean `friction`" in wrong.stderr and "expected a number from 0 to 1.2" in wrong.stderr
