"""The parameter study of examples/study on a Dask cluster of two processes: a small bin, runs that fail, a study that goes on."""

import csv
import os
import re
import subprocess
import sys

import numpy as np
import pytest
from conftest import ROOT, scene

sys.path.insert(0, str(ROOT / "examples" / "study"))
from study import discharge, judge, plot, study  # noqa: E402

OPENINGS, GRAVITIES = [0.06, 0.08], [1.62, 9.81]
WORSE = 24.8


def table(folder):
    return (folder / "study.csv").read_text()


def crash_at_worse_gravity(folder, opening, gravity):
    """The run of the example, but one gravity brings the process down, as a broken library would."""
    if gravity == WORSE:
        os._exit(1)
    return discharge(folder, opening, gravity)


def refuse(folder, opening, gravity):
    raise AssertionError("a run that is in the table already")


@pytest.fixture(scope="module")
def fmu(command, tmp_path_factory):
    """The bin with 300 grains instead of 1500."""
    text = scene("bin").read_text()
    for old, new in [("0.02, 0.25] } }, count = 1500", "0.02, 0.06] } }, count = 300"), ("max = [0.07, 0.02, 0.2]", "max = [0.07, 0.02, 0.04]")]:
        assert old in text, old
        text = text.replace(old, new)
    folder = tmp_path_factory.mktemp("study")
    (folder / "bin.toml").write_text(text)
    subprocess.run([command, "export", folder / "bin.toml", "-o", folder / "bin.fmu"], check=True)
    return folder / "bin.fmu"


@pytest.fixture(scope="module")
def done(fmu, tmp_path_factory):
    """Folder and rows of two openings over two gravities, and of an opening that the FMU refuses."""
    folder = tmp_path_factory.mktemp("done")
    return folder, study(fmu, folder, [*OPENINGS, np.inf], GRAVITIES[:1]) | study(fmu, folder, OPENINGS, GRAVITIES)


def test_the_table_has_a_sorted_row_for_every_run(done):
    folder, rows = done
    with (folder / "study.csv").open(newline="") as file:
        read = list(csv.DictReader(file))
    places = [(row["opening"], row["gravity"]) for row in read]
    good = [(repr(b), repr(g)) for b in OPENINGS for g in GRAVITIES]
    assert places == [*good, ("inf", "1.62")]
    assert len(read) == len(rows) == 5
    assert all(float(rows[key]["rate"]) > 0 and not rows[key]["error"] for key in good)
    assert all(0 < float(rows[key]["worstOverlap"]) <= 1e-4 for key in good)


def test_a_run_that_fails_is_a_row_with_what_the_fmu_said(done):
    row = done[1]["inf", "1.62"]
    assert row["rate"] == ""
    assert re.search(r"boundary\.left\.displacement.*inf", row["error"]), row["error"]


def test_rates_follow_the_root_of_gravity_and_the_width_of_the_slot(done, tmp_path):
    of_width, of_gravity, constant = judge(done[1])
    # 300 grains are few: two samples of one flow differ by some 10 %, and the bed is hardly higher than the slot is wide.
    assert abs(of_gravity[0] - 0.5) < 0.1, of_gravity
    assert 0.8 < of_width[0] < 2.2, of_width
    assert np.all((0.5 < constant) & (constant < 1.5)), constant
    plot(done[1], tmp_path / "study.png")
    assert (tmp_path / "study.png").stat().st_size > 10_000


def test_what_is_there_is_not_run_again_and_of_another_fmu_refused(done, fmu, command, tmp_path):
    folder, rows = done
    before = table(folder)
    assert study(fmu, folder, OPENINGS, GRAVITIES, run=refuse) == rows
    assert table(folder) == before
    script = [sys.executable, ROOT / "examples/study/study.py", "--fmu", fmu, "--output", folder]
    values = ["--openings", *map(str, OPENINGS), "--gravities", *map(str, GRAVITIES)]
    told = subprocess.run([*script, *values], check=True, capture_output=True, text=True).stdout
    assert "4 of 5 runs went well" in told and "exponent of g: " in told
    assert table(folder) == before
    other = tmp_path / "other.fmu"
    subprocess.run([command, "export", scene("bin"), "-o", other], check=True)
    with pytest.raises(SystemExit, match="holds runs of the FMU"):
        study(other, folder, OPENINGS, GRAVITIES)
    assert table(folder) == before


def test_a_process_that_dies_is_a_row_and_a_second_study_gives_the_same_bytes(done, fmu, tmp_path):
    rows = study(fmu, tmp_path, OPENINGS[1:], [*GRAVITIES, WORSE], run=crash_at_worse_gravity)
    assert "KilledWorker" in rows["0.08", repr(WORSE)]["error"]
    for g in GRAVITIES:
        assert rows["0.08", repr(g)] == done[1]["0.08", repr(g)]
    # Tried again where asked for, and well this time.
    again = study(fmu, tmp_path, OPENINGS[1:], [WORSE], retry=True)
    assert not again["0.08", repr(WORSE)]["error"]
