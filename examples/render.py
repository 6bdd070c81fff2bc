"""Renders one frame of a run to a picture, off screen, from the run's own VTU files.

    python examples/render.py RUN PICTURE.png [--time SECONDS] [--size WIDTHxHEIGHT]

Spheres coloured by speed, boundaries translucent, contact forces as dark lines whose width grows with the
normal force. Needs pyvista; no display.
"""

import argparse
import xml.etree.ElementTree as ET
from pathlib import Path

import numpy as np
import pyvista as pv


def frames(run, series):
    """(time, path) of every frame of a series; empty where the run has none."""
    pvd = run / f"{series}.pvd"
    if not pvd.exists():
        return []
    sets = ET.parse(pvd).getroot().findall("./Collection/DataSet")
    return [(float(s.get("timestep")), run / s.get("file")) for s in sets]


def frame(run, series, time):
    """The frame nearest to a time; the last one if the time is None."""
    listed = frames(run, series)
    if not listed:
        return None
    path = listed[-1][1] if time is None else min(listed, key=lambda f: abs(f[0] - time))[1]
    return pv.read(path)


def balls(spheres):
    """A mesh of true spheres with the speed of each."""
    spheres["speed [m/s]"] = np.linalg.norm(spheres["velocity"], axis=1)
    spheres["diameter"] = 2.0 * spheres["radius"]
    unit = pv.Sphere(radius=0.5, theta_resolution=32, phi_resolution=32)
    return spheres.glyph(geom=unit, scale="diameter", orient=False)


def chains(contacts):
    """Tubes along the contacts' lines, thick where the force is large; None where nothing carries a force."""
    force = contacts["normal_force"]
    if not (force > 0).any():
        return None
    lines = contacts.extract_cells(np.flatnonzero(force > 0)).extract_surface(algorithm="dataset_surface")
    lines = lines.cell_data_to_point_data()
    # The width follows the root of the force: large and small ones differ by orders of magnitude.
    lines["width"] = np.sqrt(lines["normal_force"])
    length = np.linalg.norm(np.diff(contacts.points.reshape(-1, 2, 3), axis=1), axis=2).max()
    return lines.tube(radius=0.01 * length, scalars="width", radius_factor=15.0, n_sides=16)


def picture(run, path, time, size):
    spheres = frame(run, "spheres", time)
    contacts = frame(run, "contacts", time)
    boundaries = frame(run, "boundaries", time)
    plotter = pv.Plotter(off_screen=True, window_size=size)
    plotter.set_background("white")
    shown = boundaries if boundaries is not None else spheres
    # Colours span the speeds near the boundaries, not those of spheres that have long fallen out.
    speed = np.linalg.norm(spheres["velocity"], axis=1)
    near = np.linalg.norm(spheres.points - shown.center, axis=1) < 0.6 * shown.length
    limit = max(float(speed[near].max(initial=0.0)), 1e-3)
    # The spheres are lightly see-through so that the forces inside show.
    plotter.add_mesh(
        balls(spheres), scalars="speed [m/s]", cmap="YlOrRd", clim=[0.0, limit], smooth_shading=True, opacity=0.6,
        specular=0.3, scalar_bar_args={"color": "black", "vertical": True, "position_x": 0.87, "position_y": 0.25},
    )
    tubes = chains(contacts)
    if tubes is not None:
        plotter.add_mesh(tubes, color="midnightblue")
    if boundaries is not None:
        surface = boundaries.extract_surface(algorithm="dataset_surface")
        plotter.add_mesh(surface, color="lightsteelblue", opacity=0.22, smooth_shading=True)
        plotter.add_mesh(surface.extract_feature_edges(40), color="slategray", line_width=2)
    plotter.enable_anti_aliasing("ssaa")
    plotter.enable_depth_peeling(8)
    # A little below the middle, to show what leaves.
    centre, reach = np.array(shown.center) - [0, 0, 0.1 * shown.length], 1.7 * shown.length
    plotter.camera_position = [centre + reach * np.array([0.55, -0.75, 0.32]), centre, (0, 0, 1)]
    plotter.camera.view_angle = 30
    plotter.add_text(f"t = {spheres.field_data['TimeValue'][0]:.2f} s", color="black", font_size=14)
    path.parent.mkdir(parents=True, exist_ok=True)
    plotter.screenshot(path)
    plotter.close()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("run", type=Path, help="directory written by a run")
    parser.add_argument("picture", type=Path, help="PNG to write")
    parser.add_argument("--time", type=float, help="seconds; the last frame if left out")
    parser.add_argument("--size", default="1280x960", help="pixels, WIDTHxHEIGHT")
    arguments = parser.parse_args()
    size = [int(n) for n in arguments.size.split("x")]
    picture(arguments.run, arguments.picture, arguments.time, size)


if __name__ == "__main__":
    main()
