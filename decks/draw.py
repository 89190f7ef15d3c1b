#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Draws the last state of a results file, or a mesh, as a picture. Needs VTK for Python and, where
there is no display, xvfb-run (Debian: python3-vtk9, xvfb, xauth).

usage: draw.py RESULTS.e PICTURE.png [--colour VARIABLE] [--from X Y Z] [--time T] [--half X Y Z]

  --colour  variable of nodes or elements; vectors and tensors by their length. Without one: blocks
  --from    where the eye is, seen from the middle [1 1 1]
  --half    shows only what lies on the side of this direction from the middle
"""
import argparse
import os
import shutil
import sys

import vtkmodules.vtkInteractionStyle  # noqa: F401
import vtkmodules.vtkRenderingFreeType  # noqa: F401
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from vtkmodules.vtkCommonDataModel import vtkPlane
from vtkmodules.vtkFiltersExtraction import vtkExtractGeometry
from vtkmodules.vtkFiltersGeometry import vtkGeometryFilter
from vtkmodules.vtkIOExodus import vtkExodusIIReader
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingAnnotation import vtkScalarBarActor
from vtkmodules.vtkRenderingCore import (vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow,
                                         vtkWindowToImageFilter)

SIZE = (1000, 640)
BLOCK_COLOURS = [(0.55, 0.63, 0.72), (0.80, 0.47, 0.25), (0.45, 0.60, 0.35), (0.75, 0.65, 0.30), (0.60, 0.42, 0.62)]


def open_results(path, time):
    """A reader at a time, the last one for None; the mesh moved by its displacements."""
    reader = vtkExodusIIReader()
    reader.SetFileName(path)
    reader.UpdateInformation()
    reader.SetApplyDisplacements(True)
    for kind in (vtkExodusIIReader.NODAL, vtkExodusIIReader.ELEM_BLOCK):
        reader.SetAllArrayStatus(kind, 1)
    information, key = reader.GetExecutive().GetOutputInformation(0), reader.GetExecutive().TIME_STEPS()
    times = [information.Get(key, i) for i in range(information.Length(key) or 0)]
    if times:
        reader.UpdateTimeStep(times[-1] if time is None else time)
    else:
        reader.Update()
    return reader


def grids_of(data):
    """All grids that have cells: one per block."""
    iterator = data.NewIterator()
    iterator.InitTraversal()
    while not iterator.IsDoneWithTraversal():
        grid = iterator.GetCurrentDataObject()
        if grid is not None and grid.GetNumberOfCells() > 0:
            yield grid
        iterator.GoToNextItem()


def bounds_of(grids):
    boxes = [grid.GetBounds() for grid in grids]
    return [(min if i % 2 == 0 else max)(box[i] for box in boxes) for i in range(6)]


def surface_of(grid, half, middle):
    """The skin of a grid, or of the elements on one side of the middle."""
    skin = vtkGeometryFilter()
    if half is None:
        skin.SetInputData(grid)
    else:
        plane = vtkPlane()
        plane.SetOrigin(middle)
        plane.SetNormal([-x for x in half])
        cut = vtkExtractGeometry()
        cut.SetImplicitFunction(plane)
        cut.SetInputData(grid)
        skin.SetInputConnection(cut.GetOutputPort())
    skin.Update()
    return skin.GetOutput()


def choose_array(grid, name):
    """The array of a variable and whether it belongs to nodes; names may end in the reader's underscore."""
    for attributes, is_nodal in ((grid.GetPointData(), True), (grid.GetCellData(), False)):
        for own in (name, name + "_"):
            if attributes.GetArray(own) is not None:
                return attributes.GetArray(own), is_nodal
    return None, False


def range_of(grids, name):
    ranges = [choose_array(grid, name)[0].GetRange(-1) for grid in grids if choose_array(grid, name)[0] is not None]
    if not ranges:
        names = {data.GetArrayName(i).rstrip("_") for grid in grids for data in (grid.GetPointData(), grid.GetCellData())
                 for i in range(data.GetNumberOfArrays())} - {"ObjectId", "GlobalNodeId", "GlobalElementId", "PedigreeNodeId",
                                                              "PedigreeElementId"}
        raise SystemExit(f"draw.py: no block has a variable '{name}'; there are {', '.join(sorted(names))}")
    return min(r[0] for r in ranges), max(r[1] for r in ranges)


def make_actor(surface, name, limits, colour):
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(surface)
    array, is_nodal = choose_array(surface, name) if name else (None, False)
    mapper.SetScalarVisibility(array is not None)
    if array is not None:
        (mapper.SetScalarModeToUsePointFieldData if is_nodal else mapper.SetScalarModeToUseCellFieldData)()
        mapper.SelectColorArray(array.GetName())
        if array.GetNumberOfComponents() > 1:
            mapper.GetLookupTable().SetVectorModeToMagnitude()
        mapper.GetLookupTable().SetHueRange(0.62, 0.0)
        mapper.SetScalarRange(limits)
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(colour)
    actor.GetProperty().SetAmbient(0.25)
    actor.GetProperty().EdgeVisibilityOn()
    actor.GetProperty().SetEdgeColor(0.15, 0.15, 0.15)
    actor.GetProperty().SetLineWidth(0.6)
    if surface.GetNumberOfVerts() == surface.GetNumberOfCells():  # particles, whose radius no results hold
        actor.GetProperty().RenderPointsAsSpheresOn()
        actor.GetProperty().SetPointSize(9)
        actor.GetProperty().EdgeVisibilityOff()
    return actor


def make_bar(mapper, name):
    bar = vtkScalarBarActor()
    bar.SetLookupTable(mapper.GetLookupTable())
    bar.SetTitle(name)
    bar.UnconstrainedFontSizeOn()
    for text in (bar.GetTitleTextProperty(), bar.GetLabelTextProperty()):
        text.SetFontSize(16)
        text.SetColor(0, 0, 0)
        text.ShadowOff()
        text.ItalicOff()
    bar.SetPosition(0.89, 0.15)
    bar.SetWidth(0.08)
    bar.SetHeight(0.6)
    return bar


def make_window(renderer):
    window = vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetSize(*SIZE)
    window.SetMultiSamples(4)
    window.AddRenderer(renderer)
    return window


def write_picture(window, path):
    window.Render()
    image = vtkWindowToImageFilter()
    image.SetInput(window)
    writer = vtkPNGWriter()
    writer.SetFileName(path)
    writer.SetInputConnection(image.GetOutputPort())
    writer.Write()


def draw(results, picture, colour=None, eye=(1.0, 1.0, 1.0), time=None, half=None):
    reader = open_results(results, time)
    grids = list(grids_of(reader.GetOutput()))
    if not grids:
        raise SystemExit(f"draw.py: {results} has no elements")
    box = bounds_of(grids)
    middle = [(box[i] + box[i + 1]) / 2 for i in (0, 2, 4)]
    limits = range_of(grids, colour) if colour else None
    renderer = vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    barred = None
    for i, grid in enumerate(grids):
        actor = make_actor(surface_of(grid, half, middle), colour, limits, BLOCK_COLOURS[i % len(BLOCK_COLOURS)])
        if barred is None and actor.GetMapper().GetScalarVisibility():
            barred = actor.GetMapper()
        renderer.AddActor(actor)
    if barred is not None:
        renderer.AddActor2D(make_bar(barred, colour))
    camera = renderer.GetActiveCamera()
    camera.SetFocalPoint(middle)
    camera.SetPosition([m + x for m, x in zip(middle, eye)])
    camera.SetViewUp(0, 0, 1)
    window = make_window(renderer)
    renderer.ResetCamera()
    write_picture(window, picture)


def ensure_display():
    """VTK ends the process where it finds none."""
    if "DISPLAY" in os.environ:
        return
    if shutil.which("xvfb-run") is None:
        sys.exit("draw.py: there is no display, and no xvfb-run in its place (Debian: apt-get install xvfb xauth)")
    os.execvp("xvfb-run", ["xvfb-run", "-a", sys.executable, *sys.argv])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("results")
    parser.add_argument("picture")
    parser.add_argument("--colour")
    parser.add_argument("--from", dest="eye", nargs=3, type=float, default=(1.0, 1.0, 1.0))
    parser.add_argument("--time", type=float)
    parser.add_argument("--half", nargs=3, type=float)
    given = parser.parse_args()
    ensure_display()
    draw(given.results, given.picture, given.colour, given.eye, given.time, given.half)


if __name__ == "__main__":
    main()
