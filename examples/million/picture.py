"""Renders the spheres of a large run to a picture, off screen, from its own VTU files.

    python examples/million/picture.py RUN PICTURE.png [--time SECONDS] [--size WIDTHxHEIGHT]

The view is from above one corner of the bed across the whole of it, spheres coloured by speed. Needs pyvista; no display.
"""

import argparse
import xml.etree.ElementTree as ET
from pathlib import Path

import numpy as np
import pyvista as pv
import vtk

def frame(run, time):
    """The spheres nearest to a time, the last ones if that is None."""
    sets = ET.parse(run / "spheres.pvd").getroot().findall("./Collection/DataSet")
    listed = [(float(s.get("timestep")), run / s.get("file")) for s in sets]
    return pv.read(listed[-1][1] if time is None else min(listed, key=lambda f: abs(f[0] - time))[1])


def picture(run, path, time, size):
    grid = frame(run, time)
    speed = np.linalg.norm(grid["velocity"], axis=1)
    spheres = pv.PolyData(grid.points)
    spheres["radius"], spheres["speed [m/s]"] = grid["radius"], speed
    plotter = pv.Plotter(off_screen=True, window_size=size)
    plotter.set_background("white")
    table = pv.LookupTable("Spectral_r", scalar_range=(0.0, max(float(np.quantile(speed, 0.999)), 1e-3)))
    # Points on which rays find the spheres: a million of them take seconds, as meshes they would be billions of triangles.
    mapper = vtk.vtkOpenGLSphereMapper()
    mapper.SetInputData(spheres)
    mapper.SetScaleArray("radius")
    mapper.SetScalarModeToUsePointFieldData()
    mapper.SelectColorArray("speed [m/s]")
    mapper.SetLookupTable(table)
    mapper.UseLookupTableScalarRangeOn()
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetAmbient(0.25)
    actor.GetProperty().SetDiffuse(0.85)
    plotter.add_actor(actor)
    plotter.add_scalar_bar(
        "speed [m/s]", mapper=mapper, color="#333333", vertical=True, position_x=0.91, position_y=0.56, height=0.34, width=0.04,
        n_labels=3, fmt="%.2g", title_font_size=22, label_font_size=20,
    )
    low, high = spheres.points.min(axis=0), spheres.points.max(axis=0)
    corner = np.array([high[0], low[1], high[2]])
    middle = 0.5 * (low + high)
    radius = float(spheres["radius"].max())
    towards = (middle - corner) / np.linalg.norm(middle - corner)
    eye = corner + radius * (np.array([0.0, 0.0, 30.0]) - 18 * towards)
    plotter.camera_position = [eye, corner + 50 * radius * towards, (0, 0, 1)]
    plotter.camera.view_angle = 55
    plotter.reset_camera_clipping_range()
    plotter.enable_anti_aliasing("ssaa")
    path.parent.mkdir(parents=True, exist_ok=True)
    plotter.screenshot(path)
    plotter.close()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("run", type=Path, help="directory written by a run")
    parser.add_argument("picture", type=Path, help="PNG to write")
    parser.add_argument("--time", type=float, help="seconds; the last frame if left out")
    parser.add_argument("--size", default="1600x900", help="pixels, WIDTHxHEIGHT")
    arguments = parser.parse_args()
    picture(arguments.run, arguments.picture, arguments.time, [int(n) for n in arguments.size.split("x")])


if __name__ == "__main__":
    main()
