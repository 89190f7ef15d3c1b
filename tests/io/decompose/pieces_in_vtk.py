#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What VTK's readers make of the pieces that split_file_test.cpp writes: together the cells, ids and values of the whole file,
which is beside them.

usage: pieces_in_vtk.py FILE
"""
import sys

from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet, vtkDataSet
from vtkmodules.vtkIOExodus import vtkExodusIIReader
from vtkmodules.vtkIOIOSS import vtkIOSSReader

N_PIECES = 3


def cells(grid):
    """Each cell by its type and the places of its points, with the point values named mass."""
    mass = grid.GetPointData().GetArray("mass")
    for c in range(grid.GetNumberOfCells()):
        points = grid.GetCell(c).GetPointIds()
        points = [points.GetId(i) for i in range(points.GetNumberOfIds())]
        yield (grid.GetCellType(c), tuple(grid.GetPoint(p) for p in points),
               tuple(mass.GetValue(p) for p in points) if mass else None)


def read_exodus(path):
    """Blocks of one file: their cells."""
    reader = vtkExodusIIReader()
    reader.SetFileName(path)
    reader.UpdateInformation()
    for kind in (reader.NODAL, reader.ELEM_BLOCK):
        for i in range(reader.GetNumberOfObjectArrays(kind)):
            reader.SetObjectArrayStatus(kind, reader.GetObjectArrayName(kind, i), 1)
    for i in range(reader.GetNumberOfElementBlockArrays()):
        reader.SetElementBlockArrayStatus(reader.GetElementBlockArrayName(i), 1)
    reader.Update()
    blocks = reader.GetOutput().GetBlock(0)
    found = {}
    for i in range(blocks.GetNumberOfBlocks()):
        grid = blocks.GetBlock(i)
        if isinstance(grid, vtkDataSet) and grid.GetNumberOfCells():
            found[blocks.GetMetaData(i).Get(vtkCompositeDataSet.NAME())] = list(cells(grid))
    return found


def read_ioss(paths):
    """All cells of files that belong together, and the ids of their points."""
    reader = vtkIOSSReader()
    for path in paths:
        reader.AddFileName(path)
    reader.UpdateInformation()
    for kind in range(reader.NUMBER_OF_ENTITY_TYPES):
        selection = reader.GetEntitySelection(kind)
        for i in range(selection.GetNumberOfArrays()):
            selection.SetArraySetting(selection.GetArrayName(i), kind == reader.ELEMENTBLOCK)
    reader.Update()
    all_cells, ids = [], set()
    output = reader.GetOutputDataObject(0)
    for i in range(output.GetNumberOfPartitionedDataSets()):
        partitions = output.GetPartitionedDataSet(i)
        for j in range(partitions.GetNumberOfPartitions()):
            grid = partitions.GetPartition(j)
            if grid is None:
                continue
            all_cells += cells(grid)
            of_points = grid.GetPointData().GetArray("ids")
            ids |= {(of_points.GetValue(p), grid.GetPoint(p)) for p in range(grid.GetNumberOfPoints())}
    return sorted(all_cells), sorted(ids)


def main():
    whole = sys.argv[1]
    pieces = [f"{whole}.{N_PIECES}.{r}" for r in range(N_PIECES)]
    problems = []
    expected, found = read_exodus(whole), {}
    for piece in pieces:
        for block, of_piece in read_exodus(piece).items():
            found.setdefault(block, []).extend(of_piece)
    if {block: sorted(of_block) for block, of_block in found.items()} != \
            {block: sorted(of_block) for block, of_block in expected.items()}:
        problems.append(f"vtkExodusIIReader: the pieces have other cells than the file: {found} {expected}")
    if sum(map(len, expected.values())) < 10 or not any(cell[2] for of_block in expected.values() for cell in of_block):
        problems.append("vtkExodusIIReader finds no cells or no values in the file")
    cells_of_whole, ids_of_whole = read_ioss([whole])
    cells_of_pieces, ids_of_pieces = read_ioss(pieces)
    if cells_of_pieces != cells_of_whole:
        problems.append("IOSS: the pieces have other cells than the file")
    if ids_of_pieces != ids_of_whole:
        problems.append(f"IOSS: the pieces have other ids than the file: {ids_of_pieces} {ids_of_whole}")
    print("\n".join(problems) or f"{len(cells_of_whole)} cells, {len(ids_of_whole)} nodes")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
