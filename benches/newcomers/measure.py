"""One run of a scene by the command, one export, and steps of the FMU in a process of their own."""

import csv
import json
import os
import shutil
import subprocess
import sys
import time
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from fmpy.fmi1 import FMICallException

from cases import CASES, FOLDER, OVERLAP, REFERENCE, ROOT, TIME, UNCONVERGED, Case

sys.path.insert(0, str(ROOT / "tests" / "python"))
from fmu import Slave

DISCARD = 2  # fmi2Status
PARTS = 10  # into which a discarded step is cut
WINDOW = 0.05  # of running means, as a part of the duration
SHARE = 1.0 / 3.0  # of the run, at its end, over which the mean of a steady scene is taken
Record = dict[str, object]


class Failed(Exception):
    """A run or an export that ended with an error."""


def command() -> str:
    """Path of the `sphere-dda` command."""
    return os.environ.get("SPHERE_DDA", str(ROOT / "target" / "release" / "sphere-dda"))


def written(text: str, source: Path, folder: Path, keys: str) -> Path:
    """Writes a scene with more `keys` in its `[simulation]`, and the files beside `source`, into `folder`."""
    head = "[simulation]\n"
    if text.count(head) != 1:
        raise ValueError(f"{source}: no single [simulation]")
    folder.mkdir(parents=True, exist_ok=True)
    for suffix in ("stl", "asc", "csv"):
        for path in source.parent.glob(f"*.{suffix}"):
            shutil.copy(path, folder)
    scene = folder / source.name
    scene.write_text(text.replace(head, f"{head}{keys}\n"))
    return scene


def at_accuracy(name: str, accuracy: str, folder: Path, more: str = "") -> Path:
    """The scene of a newcomer at an accuracy, with `more` keys."""
    source = FOLDER / f"{name}.toml"
    return written(source.read_text(), source, folder, f'accuracy = "{accuracy}"\n{more}')


def timed(words: list[object], limit: float) -> float:
    """CPU time of a command [s]."""
    before = os.times()
    try:
        done = subprocess.run([str(word) for word in words], capture_output=True, text=True, timeout=limit, check=False)
    except subprocess.TimeoutExpired as error:
        raise Failed(f"not done after {limit:g} s") from error
    after = os.times()
    if done.returncode != 0:
        raise Failed(_reason(done.stderr) or f"exit status {done.returncode}")
    return after.children_user + after.children_system - before.children_user - before.children_system


def _reason(text: str) -> str:
    """The sentence that the command marks as its error, after lines of progress."""
    marked = text.rpartition("\u00d7")[2].splitlines()
    return marked[0].strip() if marked else ""


@dataclass(frozen=True)
class Run:
    """A run that reached its end: CPU time [s], simulated time [s], its history by column."""

    cpu: float
    simulated: float
    history: dict[str, np.ndarray]

    @property
    def overlap(self) -> float:
        """Worst overlap over the smaller radius."""
        return float(self.history[OVERLAP].max())

    @property
    def unconverged(self) -> int:
        """Internal steps that did not meet the tolerances."""
        return int(self.history[UNCONVERGED].sum())


def run(scene: Path, folder: Path, limit: float, stop: float | None = None) -> Run:
    """Runs a scene by the command."""
    words: list[object] = [command(), "run", scene, "-o", folder, "--overwrite"]
    cpu = timed(words if stop is None else [*words, "--stop", stop], limit)
    history = read(folder / "history.csv")
    return Run(cpu, float(history[TIME][-1]), history)


def read(path: Path) -> dict[str, np.ndarray]:
    """The columns of a history by name."""
    with path.open(newline="") as file:
        head = next(csv.reader(file))
        rows = np.loadtxt(file, delimiter=",", ndmin=2)
    return dict(zip(head, rows.T, strict=True))


def error(case: Case, run: Run, reference: Run) -> float:
    """Error of the force against the reference: of the means at the end if steady, else of the running means."""
    times, wanted = (reference.history[name] for name in (TIME, case.column))
    found = np.interp(times, run.history[TIME], run.history[case.column])
    if case.steady:
        late = times > (1.0 - SHARE) * times[-1]
        return float(abs(found[late].mean() / wanted[late].mean() - 1.0))
    return apart(found, wanted)


def apart(found: np.ndarray, wanted: np.ndarray) -> float:
    """Root mean square of the difference of the running means of two signals over that of the second."""
    width = max(1, round(WINDOW * len(wanted)))
    found, wanted = (np.convolve(values, np.full(width, 1.0 / width), "valid") for values in (found, wanted))
    return float(np.linalg.norm(found - wanted) / np.linalg.norm(wanted))


def export(scene: Path, fmu: Path, until_rest: bool, limit: float) -> float:
    """Exports a scene; CPU time [s]."""
    words: list[object] = [command(), "export", scene, "-o", fmu, "--overwrite"]
    return timed([*words, "--until-rest"] if until_rest else words, limit)


def driven(name: str, fmu: Path, count: int, limit: float) -> Record:
    """`count` communication steps of a newcomer's FMU in a process of their own: see `advance`."""
    words = [sys.executable, __file__, name, str(fmu), str(count)]
    try:
        done = subprocess.run(words, capture_output=True, text=True, timeout=limit, check=False)
    except subprocess.TimeoutExpired as error:
        raise Failed(f"not done after {limit:g} s") from error
    if done.returncode != 0:
        raise Failed((done.stderr.strip().splitlines() or [f"exit status {done.returncode}"])[-1])
    return json.loads(done.stdout.splitlines()[-1])


def advance(case: Case, slave: Slave, count: int) -> Record:
    """Steps an FMU with its inputs; a discarded step is taken again in parts, and ends it if one of them is discarded."""
    h = float(slave.description.defaultExperiment.stepSize)
    discards = done = 0
    begun = time.process_time()
    for k in range(count):
        for name, value in case.inputs((k + 1) * h).items():
            slave.set(name, value)
        try:
            slave.step(k * h, h)
        except FMICallException as failure:
            if failure.status != DISCARD:
                raise
            discards += 1
            try:
                for part in range(PARTS):
                    slave.step((k + part / PARTS) * h, h / PARTS)
            except FMICallException:
                break
        done += 1
    return {"steps": done, "discards": discards, "cpu": time.process_time() - begun, "simulated": done * h}


def compared(runs: dict[str, Run], case: Case) -> dict[str, Record]:
    """Accuracy -> what its run cost and reached."""
    return {
        accuracy: {
            "cpu": run.cpu,
            "simulated": run.simulated,
            "overlap": run.overlap,
            "unconverged": run.unconverged,
            "error": error(case, run, runs[REFERENCE]) if REFERENCE in runs and accuracy != REFERENCE else None,
        }
        for accuracy, run in runs.items()
    }


def main() -> None:
    """`measure.py NAME FMU COUNT`: a record as JSON, the last line of standard output."""
    name, fmu, count = sys.argv[1:]
    with Slave(Path(fmu), stop=1e6) as slave:
        print(json.dumps(advance(CASES[name], slave, int(count))))


if __name__ == "__main__":
    main()
