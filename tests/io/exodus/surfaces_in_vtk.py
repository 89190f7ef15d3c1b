#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What VTK's Exodus reader makes of the file that surface_writer_test.cpp writes for it.

usage: surfaces_in_vtk.py FILE
"""
import sys

from vtkmodules.vtkCommonDataModel import VTK_QUAD, VTK_TRIANGLE, VTK_VERTEX, vtkCompositeDataSet
from vtkmodules.vtkIOExodus import vtkExodusIIReader

LONG_NAME = "the_surface_of_the_third_bolt_of_the_second_flange"

# Name of each block that has cells, with the types of its cells in order.
EXPECTED = {
    "square": [VTK_QUAD],
    "triangles": [VTK_TRIANGLE, VTK_TRIANGLE],
    LONG_NAME: [VTK_QUAD, VTK_QUAD],
    "two points": [VTK_VERTEX, VTK_VERTEX],
}
EXPECTED_NAMES = ["square", "triangles", "nothing", LONG_NAME, "two points"]


def open_file(path):
    reader = vtkExodusIIReader()
    reader.SetFileName(path)
    reader.UpdateInformation()
    for i in range(reader.GetNumberOfElementBlockArrays()):
        reader.SetElementBlockArrayStatus(reader.GetElementBlockArrayName(i), 1)
    reader.Update()
    return reader


def cells_by_name(reader):
    blocks = reader.GetOutput().GetBlock(0)
    found = {}
    for i in range(blocks.GetNumberOfBlocks()):
        grid = blocks.GetBlock(i)
        if grid is None or grid.GetNumberOfCells() == 0:
            continue
        name = blocks.GetMetaData(i).Get(vtkCompositeDataSet.NAME())
        found[name] = [grid.GetCellType(c) for c in range(grid.GetNumberOfCells())]
    return found


def main():
    reader = open_file(sys.argv[1])
    count = reader.GetNumberOfElementBlockArrays()
    names = [reader.GetElementBlockArrayName(i) for i in range(count)]
    print("blocks:", names)
    found = cells_by_name(reader)
    print("cells: ", found)
    problems = []
    if names != EXPECTED_NAMES:
        problems.append(f"expected the blocks {EXPECTED_NAMES}")
    if found != EXPECTED:
        problems.append(f"expected the cells {EXPECTED}")
    print("\n".join(problems))
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
