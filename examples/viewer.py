"""Shows an FMU while it runs, in a viewer that knows nothing of sphere-dda: from the FMU alone, by fmpy, trimesh and pyvista.

    python examples/viewer.py FMU PICTURE.png [--drive INPUT=AMPLITUDE,FREQUENCY] [--stop SECONDS] [--pictures COUNT]

The boundaries are `resources/boundaries.glb`: each node's `extras` name the variables of its translation [m] and rotation
(quaternion x, y, z, w). Spheres are the arrays `spheres.position` and `spheres.radius`, which FMUs of FMI 3.0 have. `--drive` moves a
scalar input as A sin(2 pi f t). The pictures stand side by side, the last at the stop time.
"""

import argparse
import io
import re
import zipfile

import fmpy
import numpy as np
import pyvista as pv
import trimesh

# What boundaries are drawn with, and how far apart the rows of a simulation are, as a part of its time.
STEEL = {"color": "#8fa3b5", "opacity": 0.45, "smooth_shading": False}
ROWS = 200


def boundaries(fmu):
    """The boundaries as a scene graph; z is up in its inner nodes, y in its world."""
    with zipfile.ZipFile(fmu) as archive:
        content = archive.read("resources/boundaries.glb")
    return trimesh.load(io.BytesIO(content), file_type="glb", process=False)


def followed(scene):
    """Name of each moving node -> names of the variables of its translation and rotation."""
    edges = scene.graph.transforms.edge_data.items()
    return {node: own["metadata"] for (_, node), own in edges if own.get("metadata")}


def column(result, name):
    """A variable over time; an element of an array of FMI 3.0 by its index from 1."""
    if name in result.dtype.names:
        return result[name]
    array, index = re.fullmatch(r"(.+)\[(\d+)\]", name).groups()
    return result[array][:, int(index) - 1]


def simulate(fmu, names, drive, stop, start=None):
    """The variables of these names over time, with what the FMU has of its spheres."""
    known = {v.name for v in fmpy.read_model_description(fmu).modelVariables}
    wanted = {name if name in known else name.rsplit("[", 1)[0] for name in names}
    time = np.linspace(0.0, stop, ROWS + 1)
    inputs = None
    if drive:
        rows = [(t, *(a * np.sin(2 * np.pi * f * t) for a, f in drive.values())) for t in time]
        inputs = np.array(rows, dtype=[("time", float), *((name, float) for name in drive)])
    spheres = {"spheres.position", "spheres.radius"} & known
    return fmpy.simulate_fmu(
        fmu,
        stop_time=stop,
        output_interval=stop / ROWS,
        input=inputs,
        output=sorted(wanted | spheres),
        start_values=start or {},
    )


def place(scene, moving, result, row):
    """Moves the nodes of the scene graph to where the variables are in this row."""
    for node, own in moving.items():
        x, y, z, w = (column(result, name)[row] for name in own["rotation"])
        matrix = trimesh.transformations.quaternion_matrix([w, x, y, z])
        matrix[:3, 3] = [column(result, name)[row] for name in own["translation"]]
        parent = scene.graph.transforms.parents[node]
        scene.graph.update(node, parent, matrix=matrix)


def draw(plotter, scene, result, row):
    """One moment: boundaries by their nodes, spheres below the same node as these."""
    for node in scene.graph.nodes_geometry:
        matrix, geometry = scene.graph[node]
        plotter.add_mesh(pv.wrap(scene.geometry[geometry].copy().apply_transform(matrix)), **STEEL)
    if "spheres.position" in result.dtype.names:
        parents = scene.graph.transforms.parents
        upright = scene.graph[parents[next(iter(scene.graph.nodes_geometry))]][0]
        points = result["spheres.position"][row].reshape(-1, 3)
        cloud = pv.PolyData(points @ upright[:3, :3].T)
        cloud["diameter"] = 2 * result["spheres.radius"][row].ravel()
        ball = pv.Sphere(radius=0.5, theta_resolution=24, phi_resolution=24)
        plotter.add_mesh(cloud.glyph(geom=ball, scale="diameter", orient=False), color="#c99a4b")
    plotter.add_text(f"t = {result['time'][row]:.3g} s", font_size=10)


def show(fmu, picture, drive, stop, count):
    """Runs the FMU and writes the pictures; the scene graph and the rows."""
    fmu = str(fmu)
    stop = stop or float(fmpy.read_model_description(fmu).defaultExperiment.stopTime)
    scene = boundaries(fmu)
    moving = followed(scene)
    names = [name for own in moving.values() for name in own["translation"] + own["rotation"]]
    result = simulate(fmu, names, drive, stop)
    plotter = pv.Plotter(off_screen=True, shape=(1, count), window_size=(420 * count, 420), border=False)
    for k in range(count):
        plotter.subplot(0, k)
        row = (len(result) - 1) * (k + 1) // count
        place(scene, moving, result, row)
        draw(plotter, scene, result, row)
    # One camera for all: what moves, moves in the picture.
    plotter.link_views()
    plotter.view_vector((0.5, 0.4, 0.8), viewup=(0, 1, 0))
    plotter.screenshot(picture)
    plotter.close()
    return scene, result


def driven(text):
    name, numbers = text.rsplit("=", 1)
    amplitude, frequency = map(float, numbers.split(","))
    return name, (amplitude, frequency)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("fmu")
    parser.add_argument("picture")
    parser.add_argument("--drive", type=driven, action="append", default=[], metavar="INPUT=AMPLITUDE,FREQUENCY")
    parser.add_argument("--stop", type=float)
    parser.add_argument("--pictures", type=int, default=3)
    options = parser.parse_args()
    show(options.fmu, options.picture, dict(options.drive), options.stop, options.pictures)
