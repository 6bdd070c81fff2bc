"""Shows this run in ParaView 5.11 or newer, with the files of its own folder.

    paraview --script=DIR/view.py                           in the window: press play
    pvbatch DIR/view.py picture.png [TIME] [--forces]       a picture, of the frame at TIME [s]

Without a display: `xvfb-run -a pvbatch ...`. If ParaView does not find the files: `cd DIR`, then
`paraview --script=view.py`.

Grains have their true size and are coloured by speed; boundaries are translucent. The contact forces are the hidden
entry "force tubes": show it by its eye and lower the opacity of the grains; `--forces` does so in a picture. Without
TIME the picture shows the last frame in which half of the grains are near the boundaries.
"""

import argparse
import inspect
import os
import re
import sys
import xml.etree.ElementTree as ElementTree

import numpy
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

SIZE = [1280, 960]
DARK = [0.2, 0.2, 0.2]
# From slow or weak to fast or strong: bright enough at its lower end for grains at rest.
COLOURS = [(0.25, 0.55, 0.80), (0.47, 0.79, 0.65), (0.98, 0.94, 0.60), (0.96, 0.50, 0.27), (0.72, 0.09, 0.22)]
# From the focus to the camera, and its distance in diagonals of what is to be seen.
DIRECTION, DISTANCE = numpy.array([0.52, -0.78, 0.35]), 1.9


def folder():
    """The folder of this script: in `__file__` or in the code, or for the window of 5.11 in the command line alone."""
    paths = [globals().get("__file__"), inspect.getsourcefile(folder)]
    if os.path.exists("/proc/self/cmdline"):
        with open("/proc/self/cmdline") as file:
            words = file.read().split("\0")
        paths += [word.replace("--script=", "") for word in words if word.endswith("view.py")]
    for path in filter(None, [*paths, "view.py"]):
        place = os.path.dirname(os.path.abspath(path))
        if os.path.exists(os.path.join(place, "spheres.pvd")):
            return place
    raise FileNotFoundError("no spheres.pvd beside view.py, or start ParaView in the folder of both")


HERE = folder()


def read(series):
    """The reader of a series, or None where the run has none."""
    path = os.path.join(HERE, series + ".pvd")
    if not os.path.exists(path):
        return None
    reader = simple.PVDReader(registrationName=series, FileName=path)
    reader.UpdatePipeline()
    return reader


def frames():
    """(time, number of points) of each frame of spheres, from the heads of the files."""
    for entry in ElementTree.parse(os.path.join(HERE, "spheres.pvd")).iter("DataSet"):
        with open(os.path.join(HERE, entry.get("file")), "rb") as file:
            points = re.search(rb'NumberOfPoints="(\d+)"', file.read(1024)).group(1)
        yield float(entry.get("timestep")), int(points)


def bounds(source, time):
    """Lowest and highest corner at a time."""
    source.UpdatePipeline(time)
    box = numpy.reshape(source.GetDataInformation().GetBounds(), (3, 2))
    return box[:, 0], box[:, 1]


def grains(spheres, time, box):
    """Centres, radii and speeds of the grains near a box."""
    spheres.UpdatePipeline(time)
    grid = servermanager.Fetch(spheres)
    data = grid.GetPointData()
    centres = vtk_to_numpy(grid.GetPoints().GetData())
    radii = vtk_to_numpy(data.GetArray("radius"))
    speeds = numpy.linalg.norm(vtk_to_numpy(data.GetArray("velocity")), axis=1)
    low, high = box
    margin = 0.1 * numpy.linalg.norm(high - low)
    near = ((centres > low - margin) & (centres < high + margin)).all(axis=1) & (radii > 0)
    return centres[near], radii[near], speeds[near]


def moment(spheres, around):
    """The time of the last frame in which half of the grains of the fullest frame are near."""
    listed = list(frames())
    most = max(points for _, points in listed)
    for time, points in reversed(listed):
        if 2 * points >= most and 2 * len(grains(spheres, time, bounds(around, time))[0]) >= most:
            return time
    return listed[0][0]


def colour(display, view, name, title, limit, place):
    """Colours by the magnitude of an array over the points, from zero to a limit, with a bar at the right edge."""
    simple.ColorBy(display, ("POINTS", name, "Magnitude") if name == "velocity" else ("POINTS", name))
    table = simple.GetColorTransferFunction(name)
    table.AutomaticRescaleRangeMode = "Never"
    table.ColorSpace = "RGB"
    step = limit / (len(COLOURS) - 1)
    table.RGBPoints = [number for k, rgb in enumerate(COLOURS) for number in (k * step, *rgb)]
    bar = simple.GetScalarBar(table, view)
    bar.Title, bar.ComponentTitle = title, ""
    bar.AutoOrient, bar.Orientation, bar.WindowLocation = 0, "Vertical", "Any Location"
    bar.Position, bar.ScalarBarLength = [0.88, place], 0.3
    bar.TitleColor, bar.LabelColor = DARK, DARK
    bar.TitleFontSize, bar.LabelFontSize = 16, 14
    bar.AutomaticLabelFormat, bar.LabelFormat, bar.RangeLabelFormat = 0, "%.3g", "%.3g"
    bar.AddRangeLabels = 1


def plain(display, rgb):
    # `ColorBy(display, None)` raises in 5.11.
    display.ColorArrayName = ["POINTS", ""]
    display.AmbientColor = display.DiffuseColor = rgb


def show_spheres(view, spheres, limit):
    display = simple.Show(spheres, view)
    display.SetRepresentationType("Point Gaussian")
    display.ShaderPreset = "Sphere"
    # Scaled by the array `radius` times 1: true size.
    display.ScaleByArray = 1
    display.SetScaleArray = ["POINTS", "radius"]
    display.UseScaleFunction = 0
    display.GaussianRadius = 1.0
    display.Ambient, display.Diffuse = 0.3, 0.8
    colour(display, view, "velocity", "speed [m/s]", limit, 0.55)
    return display


def alone(spheres):
    # A frame without such clumps has no array.
    single = simple.Threshold(registrationName="grains without a mesh", Input=spheres)
    single.Scalars = ["POINTS", "meshed"]
    single.LowerThreshold, single.UpperThreshold = 0, 0
    return single


def show_forces(view, contacts, radius):
    # A frame without contacts has one vertex of kind -1 and points without cells, to which 5.11 would give any force.
    loaded = simple.Threshold(registrationName="contacts alone", Input=contacts)
    loaded.Scalars = ["CELLS", "kind"]
    loaded.LowerThreshold, loaded.UpperThreshold = 0, 1
    # Tubes take lines with data over points; the files have it over the cells of a grid.
    lines = simple.ExtractSurface(registrationName="contact lines", Input=loaded)
    points = simple.CellDatatoPointData(registrationName="forces over points", Input=lines)
    tubes = simple.Tube(registrationName="force tubes", Input=points)
    tubes.Scalars = ["POINTS", "normal_force"]
    tubes.VaryRadius = "By Scalar"
    tubes.Radius = 0.05 * radius
    tubes.RadiusFactor = 8.0
    display = simple.Show(tubes, view)
    tubes.UpdatePipeline(view.ViewTime)
    force = tubes.PointData.GetArray("normal_force")
    limit = force.GetRange()[1] if force else 0.0
    colour(display, view, "normal_force", "normal force [N]", limit or 1.0, 0.12)
    return tubes, display


def show_clumps(view, clumps, limit):
    display = simple.Show(clumps, view)
    display.SetRepresentationType("Surface")
    display.Ambient, display.Diffuse = 0.3, 0.8
    colour(display, view, "velocity", "speed [m/s]", limit, 0.55)
    return display


def show_boundaries(view, boundaries):
    display = simple.Show(boundaries, view)
    display.SetRepresentationType("Surface")
    plain(display, [0.55, 0.68, 0.8])
    display.Opacity = 0.25
    surface = simple.ExtractSurface(registrationName="boundary surface", Input=boundaries)
    # Triangles side by side may have points of their own.
    joined = simple.Clean(registrationName="joined boundaries", Input=surface)
    edges = simple.FeatureEdges(registrationName="boundary edges", Input=joined)
    edges.FeatureAngle, edges.Coloring = 40.0, 0
    display = simple.Show(edges, view)
    plain(display, [0.35, 0.44, 0.51])
    display.LineWidth = 2.0


def aim(view, box):
    low, high = box
    # The bars take the right edge: the scene is moved to the left.
    right = numpy.cross([0.0, 0.0, 1.0], DIRECTION)
    centre = (low + high) / 2 + 0.06 * numpy.linalg.norm(high - low) * right
    view.CameraFocalPoint = list(centre)
    view.CenterOfRotation = list(centre)
    view.CameraPosition = list(centre + DISTANCE * numpy.linalg.norm(high - low) * DIRECTION)
    view.CameraViewUp = [0.0, 0.0, 1.0]
    view.CameraViewAngle = 30.0
    view.CameraParallelProjection = 0


def main(picture, time, forces):
    view = simple.GetActiveViewOrCreate("RenderView")
    spheres, contacts, boundaries, clumps = map(read, ["spheres", "contacts", "boundaries", "clumps"])
    around = boundaries or spheres
    scene = simple.GetAnimationScene()
    scene.UpdateAnimationUsingDataTimeSteps()
    if time is None:
        time = moment(spheres, around)
    else:
        time = min((listed for listed, _ in frames()), key=lambda listed: abs(listed - time))
    scene.AnimationTime = time
    box = bounds(around, time)
    centres, radii, speeds = grains(spheres, time, box)
    if picture and len(radii):
        # A speck between boundaries is looked at from nearer.
        low, high = centres.min(axis=0) - 4 * radii.max(), centres.max(axis=0) + 4 * radii.max()
        if numpy.linalg.norm(high - low) < 0.2 * numpy.linalg.norm(box[1] - box[0]):
            box = low, high

    view.UseColorPaletteForBackground, view.BackgroundColorMode = 0, "Single Color"
    view.Background = [1.0, 1.0, 1.0]
    view.OrientationAxesLabelColor = DARK
    fastest = max(speeds, default=0.0) or 1.0
    # Members of clumps lie within the meshes that are shown.
    shown = [show_spheres(view, alone(spheres) if clumps else spheres, fastest)]
    if clumps:
        shown.append(show_clumps(view, clumps, fastest))
    shown[0].SetScalarBarVisibility(view, not forces)
    if contacts:
        tubes, display = show_forces(view, contacts, max(radii, default=1.0))
        display.SetScalarBarVisibility(view, forces)
        if forces:
            for display in shown:
                plain(display, [0.7, 0.7, 0.7])
                display.Opacity = 0.3
        else:
            simple.Hide(tubes, view)
    if boundaries:
        show_boundaries(view, boundaries)
    clock = simple.AnnotateTimeFilter(registrationName="time", Input=spheres)
    clock.Format = "t = {time:.3f} s"
    display = simple.Show(clock, view)
    display.Color, display.FontSize = DARK, 16
    # The first rendering moves the camera.
    simple.Render(view)
    aim(view, box)
    simple.SetActiveSource(spheres)
    if picture:
        view.ViewSize = SIZE
        simple.Render(view)
        simple.SaveScreenshot(picture, view, ImageResolution=SIZE)
    else:
        scene.GoToFirst()
        simple.Render(view)


def arguments(given):
    parser = argparse.ArgumentParser(prog="pvbatch view.py")
    parser.add_argument("picture", nargs="?", help="PNG to write")
    parser.add_argument("time", nargs="?", type=float, help="seconds")
    parser.add_argument("--forces", action="store_true", help="glassy grains and force tubes")
    return parser.parse_args(given)


# The window runs the script with arguments of its own.
asked = arguments(sys.argv[1:] if any(word.endswith(".png") for word in sys.argv[1:]) else [])
main(asked.picture, asked.time, asked.forces)
