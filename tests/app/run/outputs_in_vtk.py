#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What VTK and netCDF make of the results that output_files_test.cpp writes for them.

usage: outputs_in_vtk.py FILE

The run stretches the mesh by 1 + t at the times 0, 1, 2, 3; block "soft" has stress xy = 7 in its first element.
"""
import math
import sys

from vtkmodules.vtkIOExodus import vtkExodusIIReader
from vtkmodules.vtkIOIOSS import vtkIOSSReader

TIMES = [0.0, 1.0, 2.0, 3.0]


def leaves(data):
    """All grids that have cells, in order."""
    iterator = data.NewIterator()
    iterator.InitTraversal()
    while not iterator.IsDoneWithTraversal():
        grid = iterator.GetCurrentDataObject()
        if grid is not None and grid.GetNumberOfCells() > 0:
            yield grid
        iterator.GoToNextItem()


def times_of(reader):
    information = reader.GetExecutive().GetOutputInformation(0)
    key = reader.GetExecutive().TIME_STEPS()
    return [information.Get(key, i) for i in range(information.Length(key))]


def read(reader, path, time):
    reader.SetFileName(path)
    reader.UpdateInformation()
    if isinstance(reader, vtkExodusIIReader):
        reader.SetAllArrayStatus(vtkExodusIIReader.NODAL, 1)
        reader.SetAllArrayStatus(vtkExodusIIReader.ELEM_BLOCK, 1)
    times = times_of(reader)
    reader.UpdateTimeStep(time)
    return times, list(leaves(reader.GetOutputDataObject(0)))


def find(attributes, name, n_components):
    """The array of a name, perhaps with the separator at its end."""
    for own in (name, name + "_"):
        array = attributes.GetArray(own)
        if array is not None and array.GetNumberOfComponents() == n_components:
            return array
    return None


def check(what, reader, path, tensors, problems):
    times, grids = read(reader, path, 3.0)
    if times != TIMES:
        problems.append(f"{what}: expected the times {TIMES}, found {times}")
    if [g.GetNumberOfCells() for g in grids] != [9, 2]:
        problems.append(f"{what}: expected 9 and 2 cells, found {[g.GetNumberOfCells() for g in grids]}")
        return
    soft, hard = grids
    for name in ("displ", "velocity"):
        if find(soft.GetPointData(), name, 3) is None:
            problems.append(f"{what}: {name} is no vector")
    # Both readers move the mesh by displ: 9 long at the start, 36 at the end.
    if not math.isclose(soft.GetBounds()[1], 36.0):
        problems.append(f"{what}: expected the mesh to reach x = 36, found {soft.GetBounds()}")
    for name in ("stress", "log_strain") if tensors else ():
        if find(soft.GetCellData(), name, 6) is None:
            problems.append(f"{what}: {name} is no tensor")
    if tensors and find(soft.GetCellData(), "stress", 6).GetTuple(0)[3] != 7.0:
        problems.append(f"{what}: expected stress xy = 7 in the first element")
    if find(soft.GetCellData(), "eqps", 1) is not None or find(hard.GetCellData(), "eqps", 1) is None:
        problems.append(f"{what}: eqps belongs to the second block alone")


def check_with_netcdf(path, problems):
    try:
        from netCDF4 import Dataset, chartostring
    except ImportError:
        return
    with Dataset(path) as data:
        names = [str(n) for n in chartostring(data["name_glo_var"][:])]
        if "momentum_z" not in names or "internal_energy" not in names:
            problems.append(f"netCDF4: energies and momentum are missing in {names}")
        if list(data["time_whole"][:]) != TIMES:
            problems.append("netCDF4: wrong times")
        strain = data["vals_elem_var7eb1"][3]
        if not all(math.isclose(value, math.log(4.0)) for value in strain):
            problems.append(f"netCDF4: expected log_strain_xx = ln 4, found {strain}")


def main():
    path, problems = sys.argv[1], []
    check("vtkExodusIIReader", vtkExodusIIReader(), path, False, problems)
    check("vtkIOSSReader", vtkIOSSReader(), path, True, problems)
    check_with_netcdf(path, problems)
    print("\n".join(problems))
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
