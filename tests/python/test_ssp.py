"""The system of two FMUs as an SSP: schema, names, units and kinds, and the same numbers as the built-in master gives."""

import csv
import subprocess
import zipfile

import fmpy
import numpy as np
import pytest
from conftest import scene
from fmpy.ssp.simulation import simulate_ssp
from fmpy.ssp.ssd import read_ssd, read_ssv
from lxml import etree

CONNECTIONS = [
    ("shaker.position", "bed.boundary.tray.displacement"),
    ("bed.boundary.tray.averageForce[3]", "shaker.force"),
]
SET = {"shaker.amplitude": "0.002", "bed.solver.kind": "GaussSeidel", "bed.gravity[1]": "0.5"}
VALUES = "resources/parameters.ssv"
NAMESPACES = {
    "ssc": "http://ssp-standard.org/SSP1/SystemStructureCommon",
    "ssd": "http://ssp-standard.org/SSP1/SystemStructureDescription",
}


def options(values=SET):
    wires = [f"--connect={a}={b}" for a, b in CONNECTIONS]
    return [*wires, *(f"--set={name}={value}" for name, value in values.items())]


def export(command, fmus, path, *more, values=SET):
    call = [command, "export", scene("bed"), "--ssp", path, "--with", fmus["shaker"], *options(values), *more]
    return subprocess.run(call, capture_output=True, text=True)


@pytest.fixture(scope="module")
def package(command, fmus, tmp_path_factory):
    path = tmp_path_factory.mktemp("ssp") / "coupled.ssp"
    done = export(command, fmus, path)
    assert done.returncode == 0, done.stderr
    return path


def test_fmpy_reads_it_by_the_schema(package, fmus):
    structure = read_ssd(str(package), validate=True)
    assert structure.name == "coupled"
    components = {c.name: c for c in structure.system.elements}
    assert list(components) == ["shaker", "bed"]
    for name, component in components.items():
        assert component.source == f"resources/{name}.fmu"
        variables = {v.name: v for v in fmpy.read_model_description(str(fmus[name])).modelVariables}
        inside = {c.name: c.kind for c in component.connectors}
        assert {n for n, kind in inside.items() if kind != "parameter"} == {
            n for n, v in variables.items() if v.causality in ("input", "output")
        }
        assert all(variables[n].causality == kind for n, kind in inside.items())
    made = {(f"{c.startElement}.{c.startConnector}", f"{c.endElement}.{c.endConnector}") for c in
            structure.system.connections}
    assert made == set(CONNECTIONS)


def test_units_and_enumerations_of_connectors_are_defined_as_the_fmus_do(package, fmus):
    with zipfile.ZipFile(package) as archive:
        root = etree.fromstring(archive.read("SystemStructure.ssd"))
    find = lambda path: root.findall(path, NAMESPACES)
    units = {u.get("name"): dict(u[0].attrib) for u in find("ssd:Units/ssc:Unit")}
    used = {r.get("unit") for r in find(".//ssc:Real")} - {None}
    assert {"m", "N"} <= used <= set(units)
    assert units["N"] == {"kg": "1", "m": "1", "s": "-2"}
    enumerations = {e.get("name"): [i.get("name") for i in e] for e in find("ssd:Enumerations/ssc:Enumeration")}
    assert enumerations == {"SolverKind": ["Auto", "Direct", "GaussSeidel"]}
    for name in ("shaker", "bed"):
        own = {v.name: v.unit for v in fmpy.read_model_description(str(fmus[name])).modelVariables}
        for connector in find(f".//ssd:Component[@name='{name}']//ssd:Connector"):
            assert connector[0].get("unit") == own[connector.get("name")]


def test_the_set_has_what_was_given_and_the_starts_of_other_numbers(package, fmus):
    values = {p.name: p for p in read_ssv(str(package), VALUES, validate=True).parameters}
    assert (values["shaker.amplitude"].value, values["bed.gravity[1]"].value) == ("0.002", "0.5")
    assert (values["bed.solver.kind"].type, values["bed.solver.kind"].value) == ("Enumeration", "GaussSeidel")
    for name in ("shaker", "bed"):
        for v in fmpy.read_model_description(str(fmus[name])).modelVariables:
            full = f"{name}.{v.name}"
            if v.causality == "parameter" and v.type in ("Real", "Integer") and full not in SET:
                assert float(values.pop(full).value) == float(v.start), full
    assert set(values) == set(SET)


def test_each_component_has_its_own_set_and_the_system_the_step(package, fmus):
    """libcosim and Ecos read sets of components only, by plain names; OMSimulator opens no system without its step."""
    components = {c.name: c for c in read_ssd(str(package)).system.elements}
    whole = {p.name: p.value for p in read_ssv(str(package), VALUES).parameters}
    for name, component in components.items():
        (binding,) = component.parameterBindings
        assert binding.source == f"resources/{name}_parameters.ssv"
        own = {f"{name}.{p.name}": p.value for p in read_ssv(str(package), binding.source, validate=True).parameters}
        assert own and own == {n: v for n, v in whole.items() if n.startswith(f"{name}.")}
    with zipfile.ZipFile(package) as archive:
        root = etree.fromstring(archive.read("SystemStructure.ssd"))
    (annotation,) = root.findall("ssd:System/ssd:Annotations/ssc:Annotation", NAMESPACES)
    assert annotation.get("type") == "org.openmodelica"
    (master,) = [e for e in annotation.iter() if etree.QName(e).localname == "FixedStepMaster"]
    steps = [fmpy.read_model_description(str(path)).defaultExperiment.stepSize for path in fmus.values()]
    assert master.get("stepSize") in steps and float(master.get("stepSize")) > 0


def test_libcosim_runs_it_with_its_parameters(command, fmus, tmp_path):
    from libcosimpy.CosimExecution import CosimExecution
    from libcosimpy.CosimObserver import CosimObserver

    path, folder, table = tmp_path / "coupled.ssp", tmp_path / "coupled", tmp_path / "coupled.csv"
    assert export(command, fmus, path, values={"shaker.amplitude": "0.002"}).returncode == 0
    with zipfile.ZipFile(path) as archive:
        archive.extractall(folder)
    run = CosimExecution.from_ssp_file(ssp_path=str(folder), step_size=1_000_000)
    observer = CosimObserver.create_last_value()
    assert run.add_observer(observer=observer)
    assert run.step(step_count=40), run.status()
    shaker = run.slave_index_from_instance_name("shaker")
    variables = {v.name.decode(): v.reference for v in run.slave_variables(shaker)}
    (theirs,) = observer.last_real_values(shaker, [variables["position"]])
    call = [command, "simulate", path, "--step", "0.001", "--stop", "0.04", "-o", table]
    subprocess.run(call, check=True)
    with open(table) as file:
        ours = float(list(csv.DictReader(file))[-1]["shaker.position"])
    assert abs(theirs / ours - 1) < 1e-6, (theirs, ours)


def test_the_archive_keeps_the_rules_and_is_reproducible(package, command, fmus, tmp_path):
    with zipfile.ZipFile(package) as archive:
        names = archive.namelist()
        assert names[0] == "SystemStructure.ssd" and VALUES in names
        assert all("\\" not in n and not n.startswith("/") for n in names)
        assert {i.compress_type for i in archive.infolist()} <= {zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED}
        assert archive.read("resources/shaker.fmu") == fmus["shaker"].read_bytes()
        assert archive.read("resources/bed.fmu") == fmus["bed"].read_bytes()
    again = tmp_path / "coupled.ssp"
    assert export(command, fmus, again).returncode == 0
    assert again.read_bytes() == package.read_bytes()


def test_fmpy_runs_it_with_its_parameters_as_the_built_in_master_does(command, fmus, tmp_path):
    # fmpy knows numbers only.
    values = {"shaker.amplitude": "0.002", "bed.gravity[1]": "0.5"}
    path, step, count = tmp_path / "coupled.ssp", 2.0**-10, 60
    assert export(command, fmus, path, values=values).returncode == 0
    theirs = simulate_ssp(str(path), stop_time=count * step, step_size=step, parameter_set=read_ssv(str(path), VALUES))
    table = tmp_path / "coupled.csv"
    call = [command, "simulate", fmus["shaker"], fmus["bed"], *options(values), "--step", str(step)]
    subprocess.run([*call, "--stop", str(count * step), "-o", table], check=True)
    with open(table) as file:
        rows = list(csv.DictReader(file))
    assert len(theirs) == count and len(rows) == count + 1
    moved = 0
    for column in (CONNECTIONS[0][0], CONNECTIONS[1][0], "bed.momentum[1]"):
        ours = np.array([float(row[column]) for row in rows[1:]])
        assert np.array_equal(theirs[column], ours), column
        moved += np.ptp(ours) > 0
    assert moved == 3


@pytest.mark.parametrize(
    "more, told",
    [
        (["--set=bed.gravty[3]=1"], "did you mean `bed.gravity[3]`"),
        (["--set=shaker.force=1"], "expected Parameter"),
        (["--set=bed.solver.kind=newton"], "expected an item of `Auto`, `Direct`, `GaussSeidel`"),
        (["--connect=shaker.position=bed.boundary.tray.displacement"], "fed by `shaker.position` already"),
        (["--fmi", "3"], "--fmi"),
        (["-o", "x.fmu"], "cannot be used with"),
    ],
)
def test_what_does_not_fit_is_refused_and_leaves_nothing(command, fmus, tmp_path, more, told):
    path = tmp_path / "coupled.ssp"
    done = export(command, fmus, path, *more)
    assert done.returncode == 2 and told in done.stderr, done.stderr
    assert list(tmp_path.iterdir()) == []


def test_the_built_in_master_runs_it_as_it_runs_the_parts(command, package, fmus, tmp_path):
    wanted = ["shaker.position", "shaker.impulse", "bed.boundary.tray.averageForce[3]", "bed.momentum[1]"]
    options = ["--stop", "0.1", "--step", "1e-3", *(f"--record={name}" for name in wanted)]
    for coupling in ("jacobi", "gauss-seidel", "iterated"):
        files = [tmp_path / f"{coupling}-{kind}.csv" for kind in ("ssp", "parts")]
        more = [*options, "--coupling", coupling]
        wires = [f"--connect={a}={b}" for a, b in CONNECTIONS]
        values = [f"--set={name}={value}" for name, value in SET.items()]
        parts = [fmus["shaker"], fmus["bed"], *wires, *values]
        for out, what in zip(files, ([package], parts)):
            subprocess.run([command, "simulate", *what, *more, "-o", out], check=True, capture_output=True)
        assert files[0].read_bytes() == files[1].read_bytes(), coupling
        rows = np.genfromtxt(files[0], delimiter=",", names=True, deletechars="")
        assert len(rows) == 101 and np.abs(rows["shaker.position"]).max() > 1e-3
    # What is given on the command line goes before the set of the package.
    out = tmp_path / "still.csv"
    still = ["--set", "shaker.amplitude=0", "--set", "bed.gravity[1]=0"]
    subprocess.run([command, "simulate", package, *options, *still, "-o", out], check=True, capture_output=True)
    assert out.read_bytes() != files[0].read_bytes()
