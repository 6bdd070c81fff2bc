"""The boundaries as glTF inside the FMU: a sound file, nodes with the names of the terminals, poses by variables as in the VTU files."""

import json
import struct
import sys
import xml.etree.ElementTree as ET
import zipfile

import fmpy
import meshio
import numpy as np
import pytest
import pyvista as pv
from conftest import ROOT

sys.path.insert(0, str(ROOT / "examples"))
from viewer import boundaries, followed, place, show, simulate  # noqa: E402

PLACE = "resources/boundaries.glb"


def document(content):
    """The parts of a binary glTF, judged by the words of the standard (2.0, sections 3.6, 4.4)."""
    magic, version, length = struct.unpack_from("<4sII", content)
    assert (magic, version, length) == (b"glTF", 2, len(content))
    size, kind = struct.unpack_from("<I4s", content, 12)
    assert kind == b"JSON" and size % 4 == 0
    own = json.loads(content[20 : 20 + size])
    (rest, kind), begin = struct.unpack_from("<I4s", content, 20 + size), 28 + size
    assert kind == b"BIN\0" and rest % 4 == 0 and begin + rest == len(content)
    assert 0 <= rest - own["buffers"][0]["byteLength"] < 4 and "uri" not in own["buffers"][0]
    arrays = []
    for accessor in own["accessors"]:
        view = own["bufferViews"][accessor["bufferView"]]
        dtype, width = {5126: ("<f4", 3), 5125: ("<u4", 1)}[accessor["componentType"]]
        assert view["byteOffset"] % 4 == 0 and view["byteLength"] == 4 * width * accessor["count"]
        assert accessor["type"] == {3: "VEC3", 1: "SCALAR"}[width]
        arrays.append(np.frombuffer(content, dtype, width * accessor["count"], begin + view["byteOffset"]).reshape(-1, width))
        if width == 3:
            assert np.array_equal(arrays[-1].min(axis=0), np.float32(accessor["min"]))
            assert np.array_equal(arrays[-1].max(axis=0), np.float32(accessor["max"]))
    for mesh in own["meshes"]:
        (part,) = mesh["primitives"]
        points, corners = arrays[part["attributes"]["POSITION"]], arrays[part["indices"]]
        assert len(corners) % 3 == 0 and corners.max() < len(points) and np.isfinite(points).all()
    return own


@pytest.mark.parametrize("name", ("feeder", "drum", "hopper", "chute", "dropped"))
def test_nodes_have_the_names_of_terminals_and_variables(fmus, units, name):
    contents = []
    for fmu in (fmus[name], units[name]):
        with zipfile.ZipFile(fmu) as archive:
            contents.append(archive.read(PLACE))
            terminals = ET.fromstring(archive.read("terminalsAndIcons/terminalsAndIcons.xml"))
        own = document(contents[-1])
        nodes = [node for node in own["nodes"] if "mesh" in node]
        assert [node["name"] for node in nodes] == [t.get("name") for t in terminals.findall("./Terminals/Terminal")]
        known = {v.name for v in fmpy.read_model_description(str(fmu)).modelVariables}
        for node in nodes:
            followed = node["extras"]["translation"] + node["extras"]["rotation"]
            assert len(set(followed)) == 7
            assert all(n in known or n.rsplit("[", 1)[0] in known for n in followed), followed
    assert contents[0] == contents[1], "both versions have one geometry"
    # VTK reads it as well.
    path = fmus[name].parent / f"{name}.glb"
    path.write_bytes(contents[0])
    assert pv.read(path).combine().n_cells == sum(a["count"] for a in own["accessors"] if a["type"] == "SCALAR") // 3


def at(scene, node):
    """Where the file places a node, in scene coordinates."""
    matrix, _ = scene.graph[node]
    x, y, z = matrix[:3, 3]
    return np.array([x, -z, y])


@pytest.mark.parametrize("version", (2, 3))
@pytest.mark.parametrize("name", ("feeder", "drum", "hopper"))
def test_poses_are_those_of_the_vtu_files(fmus, units, tmp_path, name, version):
    fmu, stop = str((fmus if version == 2 else units)[name]), 0.1
    scene = boundaries(fmu)
    moving = followed(scene)
    names = [n for own in moving.values() for n in own["translation"] + own["rotation"]]
    drive = {
        "feeder": {"boundary.trough.displacement": (1.5e-3, 18)},
        "drum": {"boundary.drum.appliedTorque": (2.0, 4)},
        "hopper": {"boundary.gate.angle": (0.6, 3)},
    }[name]
    result = simulate(fmu, names, drive, stop, {"output.directory": str(tmp_path)})
    (series,) = tmp_path.rglob("boundaries.pvd")
    last = ET.parse(series).findall("./Collection/DataSet")[-1]
    grid, time = meshio.read(series.parent / last.get("file")), float(last.get("timestep"))
    row = int(np.argmin(np.abs(result["time"] - time)))
    assert np.isclose(result["time"][row], time)
    place(scene, moving, result, row)
    with zipfile.ZipFile(fmu) as archive:
        nodes = [node["name"] for node in document(archive.read(PLACE))["nodes"] if "mesh" in node]
    assert set(nodes) == set(moving)
    points = []
    for node in nodes:
        matrix, geometry = scene.graph[node]
        x = np.c_[scene.geometry[geometry].vertices, np.ones(len(scene.geometry[geometry].vertices))]
        # Back from y upwards to z upwards.
        points.append((x @ matrix.T)[:, [0, 2, 1]] * [1, -1, 1])
    points = np.concatenate(points)
    extent = np.ptp(grid.points, axis=0).max()
    assert points.shape == grid.points.shape
    assert np.abs(points - grid.points).max() < 1e-6 * extent
    still = np.concatenate([scene.geometry[node].vertices + at(boundaries(fmu), node) for node in nodes])
    assert np.abs(points - still).max() > 1e-3 * extent, "nothing has moved"


def test_a_viewer_that_is_not_ours_shows_the_fmu_moving(units, tmp_path):
    picture = tmp_path / "bed.png"
    scene, result = show(units["bed"], picture, {"boundary.tray.displacement": (0.01, 5)}, 0.15, 3)
    assert "spheres.position" in result.dtype.names
    # Left, middle and right differ: the tray has moved, and the grains with it.
    image = pv.read(picture)
    width, height = image.dimensions[:2]
    pixels = image.active_scalars.reshape(height, width, -1)[: height * 9 // 10, :, :3].astype(int)
    left, middle, right = np.split(pixels, 3, axis=1)
    assert len(np.unique(pixels.reshape(-1, 3), axis=0)) > 1000, "nothing was drawn"
    for a, b in ((left, middle), (middle, right)):
        assert (np.abs(a - b).max(axis=2) > 20).mean() > 0.002
