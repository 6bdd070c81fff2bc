"""A run that is killed with SIGKILL at random moments and resumed each time, as other programs see its files.

After each kill every frame that a collection lists is read whole by meshio and by VTK, and the history by a CSV reader; in
the end the directory is the one of a run that was not killed, byte for byte. SPHERE_DDA_KILLS: how often, 50 if absent.
"""

import csv
import os
import random
import subprocess
import time

from conftest import scene
from test_vtk import listed, read_meshio, read_vtk

KILLS = int(os.environ.get("SPHERE_DDA_KILLS", "50"))
OUTPUT = "[output]\nvtu_interval = 0.02\ncheckpoint_interval = 0.06\n"


def files(folder):
    return {path.name: path.read_bytes() for path in folder.iterdir()}


class Reader:
    """Reads what is listed, each version of a file once."""

    def __init__(self):
        self.seen, self.frames, self.rows = set(), 0, 0

    def read(self, folder):
        for pvd in folder.glob("*.pvd"):
            for at, path in listed(pvd):
                status = path.stat()
                version = (path.name, status.st_mtime_ns, status.st_ino)
                if version in self.seen:
                    continue
                by_vtk, by_meshio = read_vtk(path), read_meshio(path)
                assert by_vtk["time"][0] == at, path
                assert (by_vtk["points"] == by_meshio["points"]).all(), path
                self.seen.add(version)
                self.frames += 1
        history = folder / "history.csv"
        if history.exists() and history.stat().st_size:
            with history.open(newline="") as text:
                header, *rows = csv.reader(text)
            assert all(len(row) == len(header) for row in rows)
            times = [float(row[0]) for row in rows]
            assert times == sorted(set(times))
            [float(value) for row in rows for value in row]
            self.rows += len(rows)


def test_a_run_killed_at_random_moments_is_resumed_to_the_same_files(command, tmp_path):
    text = scene("funnel").read_text()
    start = text.index("[output]")
    file = tmp_path / "funnel.toml"
    file.write_text(text[:start] + OUTPUT)
    # The heap forms at the mouth from 0.5 s on; contacts make the state that a checkpoint must carry.
    run = [command, "run", file, "--stop", "1.5", "-o"]
    quiet = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}

    began = time.monotonic()
    subprocess.run([*run, tmp_path / "whole"], check=True, **quiet)
    duration = time.monotonic() - began
    whole = files(tmp_path / "whole")

    draw, reader = random.Random(1), Reader()
    kills = rounds = at_rest = 0
    while kills < KILLS or rounds == 0:
        folder = tmp_path / f"run-{rounds}"
        while True:
            process = subprocess.Popen([*run, folder, "--resume"], **quiet)
            # From before the first file to some checkpoints on.
            limit = draw.uniform(0, duration / 5) if kills < KILLS else None
            try:
                assert process.wait(limit) == 0
                break
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()
            kills += 1
            at_rest += not folder.exists()
            if folder.exists():
                reader.read(folder)
        reader.read(folder)
        found = files(folder)
        assert sorted(found) == sorted(whole)
        different = [name for name in whole if found[name] != whole[name]]
        assert not different, different
        rounds += 1
    print(f"{kills} kills, {at_rest} of them before the first file, {rounds} runs: {reader.frames} frames, {reader.rows} rows read")
