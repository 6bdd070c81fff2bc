"""Smoke tests in FMUs (FMI-LS-REF): what the exporter packs, what `verify` and others make of it, and that changes are refused."""

import csv
import hashlib
import io
import subprocess
import zipfile

import fmpy
import numpy as np
import pytest
from conftest import scene
from lxml import etree

FOLDER = "extra/org.fmi-standard.fmi-ls-ref/"
NAMESPACE = "{http://fmi-standard.org/fmi-ls-manifest}"
STOP, STEP = 0.04, 0.002
DRIVE = "time,boundary.trough.displacement\n0,0\n0.01,0.001\n0.03,-0.001\n0.04,0\n"


@pytest.fixture(scope="module", params=[2, 3])
def proven(request, command, tmp_path_factory):
    """An FMU of the feeder with a smoke test, of either version."""
    folder = tmp_path_factory.mktemp(f"proven{request.param}")
    (folder / "drive.csv").write_text(DRIVE)
    fmu = folder / "feeder.fmu"
    arguments = ["--fmi", str(request.param), "--smoke-test", str(STOP), "--smoke-input", folder / "drive.csv"]
    subprocess.run([command, "export", scene("feeder"), "-o", fmu, *arguments], check=True, capture_output=True)
    return fmu


def verify(command, fmu):
    done = subprocess.run([command, "verify", fmu], capture_output=True, text=True)
    return done.returncode, done.stdout, done.stderr


def changed(fmu, path, change):
    """A copy of the archive with the files that `change` makes of name and content; None: left out."""
    with zipfile.ZipFile(fmu) as old, zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as new:
        for info in old.infolist():
            content = change(info.filename, old.read(info.filename))
            if content is not None:
                new.writestr(info.filename, content)
    return path


def test_the_command_replays_it(command, proven):
    code, told, error = verify(command, proven)
    assert code == 0, error
    assert "files as exported" in told
    # The same machine computes the same bits.
    assert f"{round(STOP / STEP) + 1} rows of" in told and "largest deviation 0.0e0" in told


def test_manifest_and_checksums_are_as_others_read_them(proven, tmp_path):
    """Attributes and roles of the draft, every file there, and `sha256sum --check` of the unpacked archive."""
    with zipfile.ZipFile(proven) as archive:
        archive.extractall(tmp_path)
        names = set(archive.namelist())
        manifest = etree.fromstring(archive.read(FOLDER + "fmi-ls-manifest.xml"))
    assert manifest.tag == "fmiReferences"
    assert manifest.get(NAMESPACE + "fmi-ls-name") == "org.fmi-standard.fmi-ls-ref"
    assert manifest.get(NAMESPACE + "fmi-ls-version") == "1.0.0-beta.1"
    roles = {related.get("source"): related.get("role") for related in manifest.findall("Related")}
    assert roles == {
        "smoke-test.exp": "experiment/smoke-test",
        "smoke-test-in.csv": "testcase",
        "smoke-test-out.csv": "result",
        "../../resources/scene.toml": "model",
        "checksums.sha256": "signature",
    }
    for source in roles:
        assert (tmp_path / FOLDER / source).resolve().relative_to(tmp_path.resolve()).as_posix() in names
    done = subprocess.run(["sha256sum", "--check", "--strict", "checksums.sha256"], cwd=tmp_path / FOLDER, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    assert len(done.stdout.splitlines()) == len(names) - 1


def test_fmpy_replays_it(proven, tmp_path):
    """An importer that knows nothing of this project reads times, inputs and results, and gets the same."""
    assert fmpy.validation.validate_fmu(str(proven)) == []
    with zipfile.ZipFile(proven) as archive:
        (test,) = etree.fromstring(archive.read(FOLDER + "smoke-test.exp")).findall("Experiment")
        tables = {
            element: archive.read(FOLDER + test.find(element).get("source")).decode() for element in ("Stimuli", "References")
        }
    read = {name: list(csv.reader(io.StringIO(text))) for name, text in tables.items()}
    names = read["References"][0]
    expected = np.array(read["References"][1:], dtype=float)
    stop, step = float(test.get("stopTime")), float(test.get("stepSize"))
    assert (stop, step) == (STOP, STEP)
    known = {v.name for v in fmpy.read_model_description(str(proven)).modelVariables}
    # fmpy names no elements of arrays: it compares the numbers.
    asked = [name for name in names[1:] if name in known]
    assert len(asked) > 3
    stimuli = np.array([tuple(map(float, row)) for row in read["Stimuli"][1:]], dtype=[(n, float) for n in read["Stimuli"][0]])
    told = fmpy.simulate_fmu(
        str(proven), start_time=float(test.get("startTime")), stop_time=stop, output_interval=step, step_size=step,
        input=stimuli, output=asked,
    )
    assert told["time"] == pytest.approx(expected[:, 0], abs=1e-12)
    tolerances = test.find("Annotations/Annotation/Tolerances")
    for name in asked:
        column = expected[:, names.index(name)]
        allowed = float(tolerances.get("absolute")) + float(tolerances.get("relative")) * np.abs(column).max()
        assert np.abs(told[name] - column).max() <= allowed, name


def result(content):
    """The last number of the results, twice as large and a bit."""
    lines = content.decode().splitlines()
    cells = lines[-1].split(",")
    cells[1] = repr(2 * float(cells[1]) + 1)
    return "\n".join([*lines[:-1], ",".join(cells), ""]).encode()


@pytest.mark.parametrize(
    "file, change",
    [
        (FOLDER + "smoke-test.exp", lambda text: text.replace(b"0.04", b"0.02")),
        (FOLDER + "smoke-test-out.csv", result),
        (FOLDER + "smoke-test-in.csv", lambda text: text.replace(b"0.001", b"0.0")),
        (FOLDER + "fmi-ls-manifest.xml", lambda text: text.replace(b"smoke-test-in.csv", b"smoke-test-out.csv")),
        ("resources/scene.toml", lambda text: text.replace(b"friction", b"friction ", 1)),
        ("modelDescription.xml", lambda text: text + b"\n"),
    ],
)
def test_what_was_changed_is_named(command, proven, tmp_path, file, change):
    copy = changed(proven, tmp_path / "changed.fmu", lambda name, content: change(content) if name == file else content)
    code, _, error = verify(command, copy)
    assert code == 2
    said = " ".join(error.replace("│", " ").split())
    assert f"`{file.removeprefix(FOLDER)}` was changed after the export" in said, error


def test_what_is_missing_is_named(command, proven, units, tmp_path):
    def without(*files):
        return changed(proven, tmp_path / "less.fmu", lambda name, content: None if name.removeprefix(FOLDER) in files else content)

    for files, told in [
        (["fmi-ls-manifest.xml"], "found no `extra/org.fmi-standard.fmi-ls-ref/fmi-ls-manifest.xml`"),
        (["checksums.sha256"], "it was taken out"),
        (["smoke-test-out.csv", "resources/scene.toml"], "`smoke-test-out.csv` is missing"),
    ]:
        code, _, error = verify(command, without(*files))
        said = " ".join(error.replace("│", " ").split())
        assert code == 2 and told in said, error
    code, _, error = verify(command, units["feeder"])
    assert code == 2 and "--smoke-test" in error


def test_results_that_are_not_reached_are_named(command, proven, tmp_path):
    """Checksums made anew hide the change of a file, not that the FMU computes something else."""
    file = FOLDER + "smoke-test-out.csv"

    def change(name, content):
        return result(content) if name == file else content

    with zipfile.ZipFile(proven) as archive:
        old, new = (hashlib.sha256(text).hexdigest().encode() for text in (archive.read(file), result(archive.read(file))))
    forged = changed(proven, tmp_path / "once.fmu", change)
    forged = changed(forged, tmp_path / "forged.fmu", lambda name, text: text.replace(old, new) if name.endswith("sha256") else text)
    code, _, error = verify(command, forged)
    assert code == 1
    assert f"at {STOP} s: found" in " ".join(error.replace("│", " ").split()), error


def test_of_an_fmu_of_another_tool(command, fmus, tmp_path):
    """Its manifest may be of an older version, its experiment have the newest form, no checksums and no tolerances."""
    manifest = """<fmiReferences xmlns:l="http://fmi-standard.org/fmi-ls-manifest" l:fmi-ls-name="org.fmi-standard.fmi-ls-ref"
        l:fmi-ls-version="1.0.0-alpha.1" l:fmi-ls-description="d"><Related source="t/one.exp" role="experiment"/></fmiReferences>"""
    experiment = """<Experiments name="x"><Experiment name="at rest"><TransientSimulation startTime="0" stopTime="0.01" stepSize="0.001"/>
        <References source="out.csv"/></Experiment></Experiments>"""
    with zipfile.ZipFile(fmus["shaker"]) as old:
        outputs = [v.name for v in fmpy.read_model_description(str(fmus["shaker"])).modelVariables if v.causality == "output"]
        content = {name: old.read(name) for name in old.namelist()}
    for expected, code in (("0", 0), ("1e6", 1)):
        table = f"time,{outputs[0]}\n0,{expected}\n"
        path = tmp_path / f"other{code}.fmu"
        with zipfile.ZipFile(path, "w") as new:
            for name, text in content.items():
                new.writestr(name, text)
            for name, text in (("fmi-ls-manifest.xml", manifest), ("t/one.exp", experiment), ("t/out.csv", table)):
                new.writestr(FOLDER + name, text)
        found, told, error = verify(command, path)
        assert found == code, told + error
        assert "not checked" in told
