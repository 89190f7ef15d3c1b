#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What VTK's two Exodus readers make of the file that results_writer_test.cpp writes for it.

usage: results_in_vtk.py FILE
"""
import sys

from vtkmodules.vtkIOExodus import vtkExodusIIReader
from vtkmodules.vtkIOIOSS import vtkIOSSReader

TENSOR = ["xx", "yy", "zz", "xy", "yz", "zx"]


def leaves(data):
    """All grids that have cells, in order."""
    iterator = data.NewIterator()
    iterator.InitTraversal()
    while not iterator.IsDoneWithTraversal():
        grid = iterator.GetCurrentDataObject()
        if grid is not None and grid.GetNumberOfCells() > 0:
            yield grid
        iterator.GoToNextItem()


def components(attributes):
    arrays = [attributes.GetArray(i) for i in range(attributes.GetNumberOfArrays())]
    return {a.GetName(): a.GetNumberOfComponents() for a in arrays}


def value(step, field, position):
    """The rule of sample_results.cpp."""
    return field + 1e-6 * position + 100.0 * step


def read_exodus(path, time):
    reader = vtkExodusIIReader()
    reader.SetFileName(path)
    reader.UpdateInformation()
    reader.SetApplyDisplacements(False)
    reader.SetAllArrayStatus(vtkExodusIIReader.NODAL, 1)
    reader.SetAllArrayStatus(vtkExodusIIReader.ELEM_BLOCK, 1)
    reader.UpdateTimeStep(time)
    return reader.GetOutput()


def read_ioss(path, time):
    reader = vtkIOSSReader()
    reader.SetFileName(path)
    reader.UpdateInformation()
    reader.SetApplyDisplacements(False)
    reader.UpdateTimeStep(time)
    return reader.GetOutputDataObject(0)


def check_values(grid, vector, step, problems):
    """The vector at the block's first node, which is the mesh's first."""
    array = grid.GetPointData().GetArray(vector)
    expected = tuple(value(step, 0, c) for c in range(3))
    if array is None or array.GetTuple(0) != expected:
        problems.append(f"expected {vector} {expected}, found {array and array.GetTuple(0)}")


def check(what, grids, vector, tensor, problems):
    if len(grids) != 2:
        problems.append(f"{what}: expected 2 blocks, found {len(grids)}")
        return
    for grid, has_eqps in zip(grids, [False, True]):
        nodal, element = components(grid.GetPointData()), components(grid.GetCellData())
        print(what, nodal, element)
        if nodal.get(vector) != 3 or nodal.get("mass") != 1:
            problems.append(f"{what}: {vector} is not a vector or mass no scalar")
        if any(element.get(name) != count for name, count in tensor.items()):
            problems.append(f"{what}: expected {tensor}")
        if ("eqps" in element) != has_eqps:
            problems.append(f"{what}: eqps belongs to the second block alone")
    check_values(grids[0], vector, 1, problems)


def main():
    path, problems = sys.argv[1], []
    check("vtkExodusIIReader", list(leaves(read_exodus(path, 0.5))), "displ_",
          {f"stress_{c}": 1 for c in TENSOR}, problems)
    check("vtkIOSSReader", list(leaves(read_ioss(path, 0.5))), "displ_", {"stress_": 6}, problems)
    print("\n".join(problems))
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
