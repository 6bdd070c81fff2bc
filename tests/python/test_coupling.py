"""The built-in master against fmpy: coupled FMUs of this project, FMUs of others, one that is written in Python."""

import csv
import os
import shutil
import subprocess
import sys
import sysconfig
import zipfile
from pathlib import Path

import fmpy
import numpy as np
import pytest
from conftest import ROOT

sys.path.insert(0, str(ROOT / "examples" / "two_fmus"))
from couple import FORCE, OUTPUTS, WIRES, balance, couple, limit  # noqa: E402

REFERENCE = ROOT / "tests" / "foreign_fmu" / "reference_fmus"


def simulate(command, folder, *arguments, environment=None):
    """A structured array of what `sphere-dda simulate` records; names as in its CSV."""
    out = folder / "out.csv"
    arguments = [command, "simulate", *map(str, arguments), "-o", out, "--overwrite"]
    done = subprocess.run(arguments, capture_output=True, text=True, timeout=600, env=environment)
    assert done.returncode == 0, done.stderr
    return np.genfromtxt(out, delimiter=",", names=True, deletechars="", dtype=None, encoding="utf-8")


@pytest.mark.parametrize("coupling", ("jacobi", "gauss-seidel"))
def test_both_masters_give_the_same_bits(command, fmus, tmp_path, coupling):
    theirs = couple(fmus["shaker"], fmus["bed"], coupling, 0.3)
    connect = [part for source, to in WIRES for part in ("--connect", f"{source}={to}")]
    record = [part for name in OUTPUTS for part in ("--record", name)]
    ours = simulate(
        command, tmp_path, fmus["shaker"], fmus["bed"], *connect, *record, "--stop", 0.3, "--coupling", coupling
    )
    assert len(ours) == len(theirs) == 301
    for name in theirs.dtype.names:
        assert np.array_equal(ours[name], theirs[name]), name
    assert balance(theirs) < 1e-9
    assert np.abs(theirs["shaker.position"]).max() > 1e-3, "nothing moves"
    # The shaker holds what the grains gave in the step before.
    given = np.concatenate([[0.0], np.cumsum(1e-3 * theirs[FORCE][:-1])])
    assert np.abs(theirs["shaker.impulse"] - given).max() < 1e-12


def test_fmus_that_step_at_once_give_the_bits_of_one_after_another(command, fmus, units, tmp_path):
    other = tmp_path / "other.fmu"
    shutil.copy(units["bed"], other)
    wires = [part for source, to in WIRES for part in ("--connect", f"{source}={to}")]
    wires += ["--connect", "shaker.position=other.boundary.tray.displacement"]
    for others in ([], [other]):
        arguments = [fmus["shaker"], fmus["bed"], *others, *(wires if others else wires[:-2]), "--stop", 0.1]
        at_once, sequential, apart = (
            simulate(command, tmp_path, *arguments, *more) for more in ([], ["--sequential"], ["--isolate"])
        )
        assert len(at_once) == 101 and np.abs(at_once["shaker.position"]).max() > 1e-4
        assert np.array_equal(at_once, sequential) and np.array_equal(at_once, apart)
    for name in ("boundary.tray.averageForce[3]", "maxOverlap"):
        assert np.array_equal(at_once[f"bed.{name}"], at_once[f"other.{name}"]), name


def test_the_built_in_master_gives_the_same_bits_from_both_versions(command, fmus, units, tmp_path):
    wires = [part for source, to in WIRES for part in ("--connect", f"{source}={to}")]
    record = [part for name in OUTPUTS for part in ("--record", name)]
    for coupling in ("gauss-seidel", "iterated"):
        tables = [
            simulate(command, tmp_path, fmus["shaker"], bed, *wires, *record, "--stop", 0.1, "--coupling", coupling)
            for bed in (fmus["bed"], units["bed"])
        ]
        assert np.array_equal(*tables), coupling
    # One FMU alone, its input driven by a table; whole arrays are recorded under the names of their elements.
    drive = tmp_path / "drive.csv"
    drive.write_text("time,boundary.tray.displacement\n0,0\n0.1,0.002\n")
    options = ["--input", drive, "--stop", 0.1]
    own = [v.name for v in fmpy.read_model_description(str(fmus["bed"])).modelVariables if v.causality in ("output", "local")]
    named = [part for name in own for part in ("--record", name)]
    two, three = (simulate(command, tmp_path, path, *options, *named) for path in (fmus["bed"], units["bed"]))
    assert len(own) > 50 and all(np.array_equal(two[name], three[name]) for name in own)
    out = tmp_path / "spheres.csv"
    whole = ["--record", "spheres.position", "--record", "spheres.document", "-o", out]
    subprocess.run([command, "simulate", units["bed"], *map(str, options), *whole], check=True)
    with out.open(newline="") as file:
        rows = list(csv.DictReader(file))
    heights = np.array([[float(row[f"spheres.position[{k},3]"]) for row in rows] for k in range(1, 51)])
    document = bytes.fromhex(rows[-1]["spheres.document"])
    assert document[:7] == b"SDDASPH"
    numbers = np.frombuffer(document, dtype="<f8", offset=28).reshape(50, 15)
    assert np.array_equal(numbers[:, 4], heights[:, -1]) and heights.min() > 0


def test_the_limit_of_loose_coupling_shows(command, fmus, tmp_path):
    for coupling, part, ratio, force in limit(fmus["shaker"], command, tmp_path):
        early, late = (np.abs(force[a:b] - 1).max() for a, b in ((3, 30), (150, 201)))
        assert (late < 0.3 * early) if part < 1 else (late > 5 * early), (coupling, ratio, early, late)


def reference_fmu(folder, model):
    """Builds one of the Reference FMUs."""
    library = folder / f"{model}.so"
    sources = [REFERENCE / "src/fmi2Functions.c", REFERENCE / "src/cosimulation.c", REFERENCE / model / "model.c"]
    include = [f"-I{REFERENCE / 'include'}", f"-I{REFERENCE / model}"]
    flags = ["-O2", "-w", "-shared", "-fPIC", "-DFMI_VERSION=2", "-DDISABLE_PREFIX"]
    subprocess.run(["cc", *flags, *include, *sources, "-o", library, "-lm"], check=True)
    path = folder / f"{model}.fmu"
    with zipfile.ZipFile(path, "w") as archive:
        archive.write(REFERENCE / model / "FMI2.xml", "modelDescription.xml")
        archive.write(library, f"binaries/linux64/{model}.so")
    return path


@pytest.mark.parametrize("model", ("BouncingBall", "Dahlquist", "VanDerPol"))
def test_reference_fmus_give_the_same_in_both_masters(command, tmp_path, model):
    fmu = reference_fmu(tmp_path, model)
    ours = simulate(command, tmp_path, fmu)
    step = float(fmpy.read_model_description(str(fmu)).defaultExperiment.stepSize)
    theirs = fmpy.simulate_fmu(str(fmu), output_interval=step, fmi_type="CoSimulation")
    assert len(ours) == len(theirs)
    for name in theirs.dtype.names:
        assert np.allclose(ours[name], theirs[name], rtol=0, atol=1e-12), name


DECAY = '''
from math import exp

from pythonfmu import Fmi2Causality, Fmi2Slave, Real


class Decay(Fmi2Slave):
    """x' = u - x / T, T = 0.5 s, u held: exact."""

    def __init__(self, **kwargs):
        super().__init__(**kwargs)
        self.u, self.x = 0.0, 2.0
        self.register_variable(Real("u", causality=Fmi2Causality.input))
        self.register_variable(Real("x", causality=Fmi2Causality.output))

    def do_step(self, time, step):
        self.x = 0.5 * self.u + (self.x - 0.5 * self.u) * exp(-step / 0.5)
        return True
'''


def test_an_fmu_written_in_python_runs_alone_and_coupled(command, tmp_path):
    pytest.importorskip("pythonfmu")
    # Such an FMU takes the interpreter from its host; the command has none unless the loader gives it one.
    library = Path(sysconfig.get_config_var("LIBDIR") or "") / (sysconfig.get_config_var("LDLIBRARY") or "none")
    if not library.name.endswith(".so") or not library.exists():
        pytest.skip("this Python has no shared library to host the FMU")
    environment = {
        **os.environ,
        "LD_PRELOAD": str(library),
        "PYTHONHOME": sys.base_prefix,
        "PYTHONPATH": os.pathsep.join(path for path in sys.path if path.endswith("site-packages")),
    }
    script = tmp_path / "decay.py"
    script.write_text(DECAY)
    subprocess.run([sys.executable, "-m", "pythonfmu", "build", "-f", script, "-d", tmp_path], check=True, capture_output=True)
    fmu = tmp_path / "Decay.fmu"
    alone = simulate(command, tmp_path, fmu, "--stop", 1, "--step", 0.1, environment=environment)
    assert np.allclose(alone["x"], 2 * np.exp(-alone["time"] / 0.5), rtol=1e-14)

    # x_n of the Dahlquist equation is 0.9^n; the decay holds it over the step from n to n + 1.
    source = reference_fmu(tmp_path, "Dahlquist")
    arguments = [source, fmu, "--connect", "Dahlquist.x=Decay.u", "--stop", 1]
    coupled = simulate(command, tmp_path, *arguments, environment=environment)
    x = 2.0
    for n, found in enumerate(coupled["Decay.x"]):
        assert found == pytest.approx(x, rel=1e-12)
        x = 0.5 * 0.9**n + (x - 0.5 * 0.9**n) * np.exp(-0.1 / 0.5)

    # Without an interpreter it is refused with the symbol that is missing.
    refused = subprocess.run([command, "simulate", fmu, "--stop", "1"], capture_output=True, text=True)
    assert refused.returncode == 2 and "undefined symbol" in refused.stderr, refused.stderr
