"""Shows this run in ParaView: File > Load State, Macros > Import new macro, `paraview --script=view.py`,
or `pvbatch view.py picture.png` for a picture of the last frame.

Spheres in true size by speed, contacts as tubes by normal force, boundaries translucent.
The script reads the files of its own folder.
"""

import inspect
import os
import sys

from paraview import simple

# A macro is run without `__file__`; the code object still knows where it came from.
HERE = os.path.dirname(os.path.abspath(inspect.getsourcefile(lambda: None) or ""))


def read(series):
    """The reader of a series, or None where the run has none."""
    path = os.path.join(HERE, series + ".pvd")
    if not os.path.exists(path):
        return None
    reader = simple.PVDReader(registrationName=series, FileName=path)
    reader.UpdatePipeline()
    return reader


def colour(display, view, array, components, title):
    """Colours by an array over the points, a vector by its magnitude."""
    simple.ColorBy(display, ("POINTS", array, "Magnitude") if components == 3 else ("POINTS", array))
    display.SetScalarBarVisibility(view, True)
    bar = simple.GetScalarBar(simple.GetColorTransferFunction(array), view)
    bar.Title, bar.ComponentTitle = title, ""


def show_spheres(view):
    spheres = read("spheres")
    if spheres is None:
        return None
    display = simple.Show(spheres, view)
    display.SetRepresentationType("Point Gaussian")
    display.ShaderPreset = "Sphere"
    # Scaled by the array `radius` times 1: true size.
    display.ScaleByArray = 1
    display.SetScaleArray = ["POINTS", "radius"]
    display.UseScaleFunction = 0
    display.GaussianRadius = 1.0
    colour(display, view, "velocity", 3, "speed [m/s]")
    return display


def show_contacts(view):
    contacts = read("contacts")
    spheres = simple.FindSource("spheres")
    if contacts is None or spheres is None:
        return None
    radius = spheres.PointData["radius"].GetRange()[1]
    # Tubes vary with data over points; the files have it over the lines.
    points = simple.CellDatatoPointData(registrationName="contact forces", Input=contacts)
    tubes = simple.Tube(registrationName="force tubes", Input=points)
    tubes.Scalars = ["POINTS", "normal_force"]
    tubes.VaryRadius = "By Scalar"
    tubes.Radius = 0.03 * radius
    tubes.RadiusFactor = 10.0
    display = simple.Show(tubes, view)
    colour(display, view, "normal_force", 1, "normal force [N]")
    simple.Hide(contacts, view)
    return display


def show_boundaries(view):
    boundaries = read("boundaries")
    if boundaries is None:
        return
    display = simple.Show(boundaries, view)
    display.SetRepresentationType("Surface")
    simple.ColorBy(display, None)
    display.Opacity = 0.25


def main():
    view = simple.GetActiveViewOrCreate("RenderView")
    coloured = [show_spheres(view), show_contacts(view)]
    show_boundaries(view)
    simple.GetAnimationScene().UpdateAnimationUsingDataTimeSteps()
    simple.GetAnimationScene().GoToLast()
    # The ranges are those of the last frame.
    for display in filter(None, coloured):
        display.RescaleTransferFunctionToDataRange(False, True)
    view.ResetCamera()
    simple.Render(view)
    if len(sys.argv) > 1 and sys.argv[1].endswith(".png"):
        simple.SaveScreenshot(sys.argv[1], view)


main()
