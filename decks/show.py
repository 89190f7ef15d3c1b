#!/usr/bin/env pvpython
# SPDX-License-Identifier: BSD-3-Clause
"""Shows a run in ParaView (5.11): moved by its displacement, coloured, at its last time, with the contact facets.

usage: pvpython show.py RESULTS.e [--colour VARIABLE] [--facets FILE.exo] [--sides] [--picture FILE.png]
                        [--state FILE.pvsm]

  --colour   variable of nodes or elements; without one von_mises, eqps or displacement, the first that there is
  --facets   the file of VISUALIZE CONTACT FACETS; without one <base>_contact_facets.exo, if it is there
  --sides    the side sets contact_<surface> in place of the elements, each in a colour of its own
  --picture  writes a picture of the last time
  --state    writes a state, which `paraview --state FILE.pvsm` opens. Without picture and state: show_<base>.pvsm
"""
import argparse
import os

from paraview import simple

FAVOURITES = ["von_mises", "eqps", "displacement", "displ"]


def open_file(path):
    if not os.path.exists(path):
        raise SystemExit(f"show.py: {path}: there is no such file")
    reader = simple.IOSSReader(FileName=[os.path.abspath(path)])
    reader.ElementBlocks.SelectAll()
    reader.UpdatePipeline()
    return reader


def find_array(reader, names):
    """The location and the name of the first variable that is there; ParaView's may end in an underscore."""
    for name in names:
        for location, information in (("POINTS", reader.PointData), ("CELLS", reader.CellData)):
            for own in (name, name + "_"):
                if own in information.keys():
                    return location, own
    return None


def show_results(path, colour, view):
    reader = open_file(path)
    times = list(reader.TimestepValues) if reader.TimestepValues is not None else []
    if times:
        view.ViewTime = times[-1]
        simple.GetAnimationScene().UpdateAnimationUsingDataTimeSteps()
        simple.GetAnimationScene().AnimationTime = times[-1]
        reader.UpdatePipeline(times[-1])
    display = simple.Show(reader, view)
    display.Representation = "Surface With Edges"
    array = find_array(reader, [colour] if colour else FAVOURITES)
    if array is None and colour:
        raise SystemExit(f"show.py: {path} has no variable '{colour}'")
    if array is not None:
        simple.ColorBy(display, array)
        display.RescaleTransferFunctionToDataRange(False, True)
        display.SetScalarBarVisibility(view, True)
    return reader


def show_facets(path, view):
    """Contact surfaces at the start with the thickness of what they loft, see-through."""
    reader = open_file(path)
    display = simple.Show(reader, view)
    display.Representation = "Surface"
    display.Opacity = 0.25
    display.ColorArrayName = ["POINTS", ""]
    return reader


def show_sides(path, view):
    reader = open_file(path)
    names = [name for name in reader.SideSets.Available if name.lower().startswith("contact_")]
    if not names:
        print(f"show.py: {path} has no side sets contact_<surface>")
    reader.ElementBlocks.DeselectAll()
    reader.SideSets = names
    display = simple.Show(reader, view)
    display.Representation = "Surface"
    simple.ColorBy(display, ("FIELD", "vtkBlockColors"))
    return names


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("results")
    parser.add_argument("--colour")
    parser.add_argument("--facets")
    parser.add_argument("--sides", action="store_true")
    parser.add_argument("--picture")
    parser.add_argument("--state")
    given = parser.parse_args()
    base = os.path.splitext(given.results)[0]
    view = simple.GetActiveViewOrCreate("RenderView")
    view.ViewSize = [1000, 640]
    reader = show_results(given.results, given.colour, view)
    print(f"{given.results}: {len(reader.ElementBlocks.Available)} blocks, {len(reader.TimestepValues or [])} times")
    facets = given.facets or f"{base}_contact_facets.exo"
    if given.facets or os.path.exists(facets):
        print(f"{facets}: surfaces {', '.join(show_facets(facets, view).ElementBlocks.Available)}")
    if given.sides:
        print(f"side sets {', '.join(show_sides(given.results, view))}")
        simple.Hide(reader, view)
    view.ResetActiveCameraToPositiveX()
    camera = simple.GetActiveCamera()
    camera.Elevation(20)
    camera.Azimuth(35)
    simple.ResetCamera(view)
    simple.Render(view)
    if given.picture:
        simple.SaveScreenshot(given.picture, view)
    if given.state or not given.picture:
        state = given.state or f"show_{os.path.basename(base)}.pvsm"
        simple.SaveState(state)
        print(f"paraview --state {state}")


if __name__ == "__main__":
    main()
