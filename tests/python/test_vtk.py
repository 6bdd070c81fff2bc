"""Reads every frame of result directories with meshio and with VTK.

SPHERE_DDA_RUNS names the directories, separated like a PATH. Without it: those that `cargo test --test results`
leaves in the target directory. A file `expected_NNNNNN.json` beside the frames holds the values of frame NNNNNN.
"""

import json
import math
import os
import re
import xml.etree.ElementTree as ET
from pathlib import Path

import meshio
import numpy as np
import pytest
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDataArray
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

ROOT = Path(__file__).resolve().parents[2]
ARRAYS = {
    "spheres": {
        "point": {
            "radius": 1, "velocity": 3, "angular_velocity": 3, "force": 3, "torque": 3, "orientation": 4, "id": 1, "material": 1,
            "clump": 1, "meshed": 1,
        },
        "cell": {},
    },
    "contacts": {
        "point": {},
        "cell": {
            "normal_force": 1, "force": 3, "torque": 3, "hold": 1, "overlap": 1, "slip": 1, "id1": 1, "id2": 1, "kind": 1,
        },
    },
    "boundaries": {
        "point": {"velocity": 3},
        "cell": {
            "force": 3, "boundary": 1, "area": 1, "pressure": 1, "shear": 3, "traction": 3, "friction_energy": 1, "impact_energy": 1,
            "wear_depth": 1,
        },
    },
    "clumps": {"point": {"velocity": 3}, "cell": {"clump": 1}},
}
# Written where some contact resists rolling or twisting, where some holds, and where a boundary has `wall_fields`.
WALLS = ("area", "pressure", "shear", "traction", "friction_energy", "impact_energy", "wear_depth")
OPTIONAL = {("spheres", "clump"), ("spheres", "meshed"), ("contacts", "torque"), ("contacts", "hold"), *(("boundaries", name) for name in WALLS)}
INTEGERS = {"id", "material", "clump", "meshed", "id1", "id2", "kind", "boundary", "hold"}
UNITS = {
    "radius": "m", "velocity": "m/s", "angular_velocity": "rad/s", "force": "N", "torque": "N m", "normal_force": "N",
    "overlap": "m", "slip": "m/s", "TimeValue": "s", "area": "m2", "pressure": "Pa", "shear": "Pa", "traction": "Pa",
    "friction_energy": "J", "impact_energy": "J", "wear_depth": "m",
}
CELLS = {"spheres": {"vertex"}, "contacts": {"line", "vertex"}, "boundaries": {"triangle"}, "clumps": {"triangle", "vertex"}}


def runs():
    named = os.environ.get("SPHERE_DDA_RUNS")
    if named:
        return [Path(p) for p in named.split(os.pathsep) if p]
    target = Path(os.environ.get("CARGO_TARGET_DIR", ROOT / "target"))
    return sorted((target / "tmp").glob("vtk-*"))


def listed(pvd):
    """(time, path) of every frame of a collection."""
    sets = ET.parse(pvd).getroot().findall("./Collection/DataSet")
    frames = [(float(s.get("timestep")), pvd.parent / s.get("file")) for s in sets]
    assert all(not Path(s.get("file")).is_absolute() for s in sets)
    return frames


def read_vtk(path):
    """(points, point arrays, cell arrays, time, connectivity) as VTK sees the file."""
    reader = vtkXMLUnstructuredGridReader()
    errors = []
    reader.AddObserver("ErrorEvent", lambda *_: errors.append("error"))
    reader.SetFileName(str(path))
    reader.Update()
    assert not errors, path
    grid = reader.GetOutput()

    def arrays(data):
        return {data.GetArrayName(k): vtk_to_numpy(data.GetArray(k)) for k in range(data.GetNumberOfArrays())}

    for data in (grid.GetPointData(), grid.GetCellData(), grid.GetFieldData()):
        for k in range(data.GetNumberOfArrays()):
            unit = data.GetArray(k).GetInformation().Get(vtkDataArray.UNITS_LABEL())
            assert unit == UNITS.get(data.GetArrayName(k)), (path, data.GetArrayName(k), unit)
    return {
        "points": vtk_to_numpy(grid.GetPoints().GetData()),
        "point": arrays(grid.GetPointData()),
        "cell": arrays(grid.GetCellData()),
        "time": arrays(grid.GetFieldData())["TimeValue"],
        "connectivity": vtk_to_numpy(grid.GetCells().GetConnectivityArray()),
        "cells": grid.GetNumberOfCells(),
    }


def read_meshio(path):
    mesh = meshio.read(path)
    assert len(mesh.cells) == 1, "one cell type per file"
    block = mesh.cells[0]
    return {
        "points": mesh.points,
        "point": mesh.point_data,
        "cell": {name: blocks[0] for name, blocks in mesh.cell_data.items()},
        "time": mesh.field_data["TimeValue"],
        "connectivity": block.data.ravel(),
        "cells": len(block.data),
        "type": block.type,
    }


def check_frame(series, time, path):
    vtk, mio = read_vtk(path), read_meshio(path)
    assert mio["type"] in CELLS[series]
    assert vtk["cells"] == mio["cells"] >= 1
    assert np.array_equal(vtk["connectivity"], mio["connectivity"])
    assert np.array_equal(vtk["points"], mio["points"])
    assert vtk["time"].tolist() == mio["time"].tolist() == [time]
    for where in ("point", "cell"):
        names = {n: k for n, k in ARRAYS[series][where].items() if n in vtk[where] or (series, n) not in OPTIONAL}
        assert list(vtk[where]) == list(mio[where]) == list(names)
        for name, components in names.items():
            a, b = vtk[where][name], mio[where][name]
            shape = () if components == 1 else (components,)
            assert a.shape[1:] == b.shape[1:] == shape
            assert a.dtype == b.dtype and (a.dtype.kind == "i") == (name in INTEGERS)
            assert np.array_equal(a, b), f"{path}: {name}"
            assert np.isfinite(a).all()
    if series == "spheres":
        # Spheres that wait in a source are left out; a frame without any has one point with id -1.
        ids = vtk["point"]["id"]
        assert (np.diff(ids) > 0).all() and (ids[0] >= 0 or list(ids) == [-1])
        assert np.allclose(np.linalg.norm(vtk["point"]["orientation"], axis=1), 1, atol=1e-6)
    if series == "contacts":
        data = vtk["cell"]
        order = np.lexsort((data["id2"], data["kind"], data["id1"]))
        assert np.array_equal(order, np.arange(vtk["cells"])), "contacts sorted by id1, kind, id2"
        empty = data["kind"][0] == -1
        assert empty == (mio["type"] == "vertex")
        # Without cohesion never a pull (with it, in the step that lets go also where `hold` is 0 then); a force that only
        # friction makes has a normal part of rounding.
        pushes = data["normal_force"]
        assert empty or "hold" in data or pushes.min() >= -1e-12 * pushes.max()
    return vtk


def close(found, expected):
    """Equal up to the precision of the file."""
    expected = np.asarray(expected)
    if found.dtype.kind == "i":
        return np.array_equal(found, expected)
    return np.array_equal(found, expected.astype(found.dtype))


def check_values(frame, expected):
    assert close(frame["points"], np.reshape(expected["points"], (-1, 3)))
    assert np.array_equal(frame["connectivity"], expected["connectivity"])
    for where in ("point", "cell"):
        arrays = expected[f"{where}_data"]
        assert list(arrays) and set(arrays) == set(frame[where]) or not frame[where]
        for name, array in arrays.items():
            assert close(frame[where][name].ravel(), array["values"]), name


@pytest.mark.parametrize("run", runs(), ids=lambda p: p.name)
def test_every_frame_opens_in_meshio_and_vtk(run):
    collections = sorted(run.glob("*.pvd"))
    assert {c.stem for c in collections} <= set(ARRAYS) and collections
    for pvd in collections:
        frames = listed(pvd)
        assert frames
        times = [time for time, _ in frames]
        assert times == sorted(set(times))
        for time, path in frames:
            frame = check_frame(pvd.stem, time, path)
            number = re.search(r"_(\d+)\.vtu$", path.name).group(1)
            values = run / f"expected_{number}.json"
            if values.exists():
                expected = json.loads(values.read_text())
                assert math.isclose(expected["time"], time, rel_tol=0, abs_tol=0)
                check_values(frame, expected["series"][pvd.stem])


@pytest.mark.parametrize("run", runs(), ids=lambda p: p.name)
def test_history_and_description(run):
    lines = (run / "history.csv").read_text().splitlines()
    header = lines[0].split(",")
    assert header[0] == "time [s]" and len(set(header)) == len(header)
    assert all(re.search(r" \[[^\]]+\]$", name) for name in header)
    if len(lines) > 1 and not run.name.endswith("killed"):
        table = np.array([[float(x) for x in line.split(",")] for line in lines[1:]])
        assert table.shape[1] == len(header)
        assert (np.diff(table[:, 0]) > 0).all()
    about = json.loads((run / "run.json").read_text())
    assert about["generator"] == "sphere-dda" and about["settings"]["step"] > 0


def test_there_is_something_to_read():
    assert runs(), "no result directory: run `cargo test --test results` or set SPHERE_DDA_RUNS"
