"""Renders one frame of a run to a picture, off screen, from the run's own VTU files.

    python examples/render.py RUN PICTURE.png [--time SECONDS] [--size WIDTHxHEIGHT] [--forces] [--solid]

Spheres coloured by speed, boundaries translucent or, with --solid, opaque. With --forces the spheres turn to glass
and the contact forces show as dark tubes whose width grows with the normal force. Needs pyvista; no display.
"""

import argparse
import xml.etree.ElementTree as ET
from pathlib import Path

import numpy as np
import pyvista as pv


# Where the camera is, seen from the scene, and the angle in degrees that its picture is high.
DIRECTION = np.array([0.55, -0.75, 0.34]) / np.linalg.norm([0.55, -0.75, 0.34])
ANGLE = 30.0


def frame(run, series, time):
    """The frame of a series nearest to a time, the last one if the time is None; None if the run has no such series."""
    pvd = run / f"{series}.pvd"
    if not pvd.exists():
        return None
    sets = ET.parse(pvd).getroot().findall("./Collection/DataSet")
    listed = [(float(s.get("timestep")), run / s.get("file")) for s in sets]
    path = listed[-1][1] if time is None else min(listed, key=lambda f: abs(f[0] - time))[1]
    return pv.read(path)


def balls(spheres):
    """A mesh of true spheres with the speed of each."""
    spheres["speed [m/s]"] = np.linalg.norm(spheres["velocity"], axis=1)
    spheres["diameter"] = 2.0 * spheres["radius"]
    unit = pv.Sphere(radius=0.5, theta_resolution=48, phi_resolution=48)
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


def light(plotter, centre, reach):
    """Key, fill and back light around the scene."""
    plotter.remove_all_lights()
    for direction, intensity in [((0.3, -1.0, 1.3), 0.75), ((-1.0, -0.6, 0.4), 0.35), ((0.2, 1.0, 0.6), 0.30)]:
        position = centre + reach * np.array(direction)
        plotter.add_light(pv.Light(position=position, focal_point=centre, intensity=intensity))


def distance(shown, centre, size):
    """Of a camera that has all corners of the box of a mesh in its picture."""
    right = np.cross((0.0, 0.0, 1.0), DIRECTION)
    right /= np.linalg.norm(right)
    up = np.cross(DIRECTION, right)
    low, high = np.array(shown.bounds[0::2]), np.array(shown.bounds[1::2])
    corners = np.where(np.indices((2, 2, 2)).reshape(3, 8).T, high, low) - centre
    x, y, z = corners @ right, corners @ up, corners @ DIRECTION
    half = np.tan(np.radians(ANGLE / 2))
    return 1.05 * (z + np.maximum(abs(x) * size[1] / size[0], abs(y)) / half).max()


def picture(run, path, time, size, forces, solid):
    spheres, contacts, boundaries = (frame(run, series, time) for series in ("spheres", "contacts", "boundaries"))
    plotter = pv.Plotter(off_screen=True, window_size=size)
    plotter.set_background("white")
    shown = boundaries if boundaries is not None else spheres
    centre, length = np.array(shown.center), shown.length
    # Spheres that have fallen far away would only take the colours from those in view.
    near = np.linalg.norm(spheres.points - centre, axis=1) < 0.6 * length
    spheres = spheres.extract_points(near, adjacent_cells=False) if near.any() else spheres
    limit = max(float(np.linalg.norm(spheres["velocity"], axis=1).max()), 1e-3)
    plotter.add_mesh(
        balls(spheres), scalars="speed [m/s]", cmap="Spectral_r", clim=[0.0, limit], smooth_shading=True,
        opacity=0.45 if forces else 1.0, ambient=0.3, diffuse=0.85, specular=0.35, specular_power=25,
        scalar_bar_args={
            "color": "#333333", "vertical": True, "position_x": 0.88, "position_y": 0.3, "height": 0.34, "width": 0.045,
            "n_labels": 3, "fmt": "%.0f" if limit > 5 else "%.2g", "title_font_size": 22, "label_font_size": 20,
        },
    )
    tubes = chains(contacts) if forces else None
    if tubes is not None:
        plotter.add_mesh(tubes, color="midnightblue")
    if boundaries is not None:
        surface = boundaries.extract_surface(algorithm="dataset_surface")
        look = {"color": "#c3b299", "split_sharp_edges": True} if solid else {"color": "#9db8d2", "opacity": 0.25}
        plotter.add_mesh(surface, smooth_shading=True, ambient=0.35, show_scalar_bar=False, **look)
        plotter.add_mesh(surface.extract_feature_edges(40), color="#5b7083", line_width=3)
    plotter.enable_anti_aliasing("ssaa")
    plotter.enable_depth_peeling(8)
    reach = distance(shown, centre, size)
    light(plotter, centre, reach)
    plotter.camera_position = [centre + reach * DIRECTION, centre, (0, 0, 1)]
    plotter.camera.view_angle = ANGLE
    path.parent.mkdir(parents=True, exist_ok=True)
    plotter.screenshot(path)
    plotter.close()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("run", type=Path, help="directory written by a run")
    parser.add_argument("picture", type=Path, help="PNG to write")
    parser.add_argument("--time", type=float, help="seconds; the last frame if left out")
    parser.add_argument("--size", default="1280x960", help="pixels, WIDTHxHEIGHT")
    parser.add_argument("--forces", action="store_true", help="show the contact forces through glassy spheres")
    parser.add_argument("--solid", action="store_true", help="show the boundaries opaque, as the ground")
    arguments = parser.parse_args()
    size = [int(n) for n in arguments.size.split("x")]
    picture(arguments.run, arguments.picture, arguments.time, size, arguments.forces, arguments.solid)


if __name__ == "__main__":
    main()
