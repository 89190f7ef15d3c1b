#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Times the skin of 100 x 100 x 100 hexahedra in VTK's two surface filters and in contactsim, in one run.

    skin_vs_vtk.py build/bench/tests/bench/contactsim_bench
"""
import json
import subprocess
import sys
import time

import numpy as np
import vtk
from vtk.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray


def make_grid(n):
    k, j, i = np.meshgrid(np.arange(n), np.arange(n), np.arange(n), indexing="ij")
    first = (i + (n + 1) * (j + (n + 1) * k)).ravel()
    up, layer = n + 1, (n + 1) ** 2
    offsets = np.array([0, 1, 1 + up, up, layer, layer + 1, layer + 1 + up, layer + up])
    nodes = first[:, None] + offsets[None, :]
    cells = np.hstack([np.full((n**3, 1), 8), nodes]).ravel().astype(np.int64)
    z, y, x = np.meshgrid(*[np.arange(n + 1.0)] * 3, indexing="ij")
    points = vtk.vtkPoints()
    points.SetData(numpy_to_vtk(np.column_stack([x.ravel(), y.ravel(), z.ravel()]), deep=True))
    array = vtk.vtkCellArray()
    array.SetCells(n**3, numpy_to_vtkIdTypeArray(cells, deep=True))
    grid = vtk.vtkUnstructuredGrid()
    grid.SetPoints(points)
    grid.SetCells(vtk.VTK_HEXAHEDRON, array)
    return grid


def time_filter(make, grid, repeats=5):
    times = []
    for _ in range(repeats):
        surface = make()
        surface.SetInputData(grid)
        start = time.perf_counter()
        surface.Update()
        times.append(time.perf_counter() - start)
        assert surface.GetOutput().GetNumberOfCells() == 60000
    return sorted(times)[repeats // 2] * 1e3


def time_contactsim(program):
    out = subprocess.run([program, "--benchmark_filter=skin_of_million_hexes", "--benchmark_format=json",
                          "--benchmark_repetitions=5"], capture_output=True, text=True, check=True).stdout
    rows = json.loads(out)["benchmarks"]
    return {row["run_name"]: row["real_time"] for row in rows if row.get("aggregate_name") == "median"}


def main():
    vtk.vtkSMPTools.Initialize(1)
    grid = make_grid(100)
    filters = {"vtkDataSetSurfaceFilter": time_filter(vtk.vtkDataSetSurfaceFilter, grid),
               "vtkGeometryFilter": time_filter(vtk.vtkGeometryFilter, grid)}
    ours = time_contactsim(sys.argv[1])
    one_thread = next(t for name, t in ours.items() if "shuffled:0/threads:1" in name)
    for name, t in ours.items():
        print(f"{name:60s} {t:8.1f} ms")
    for name, t in filters.items():
        print(f"{name:60s} {t:8.1f} ms   {t / one_thread:5.2f} times contactsim on one thread")


if __name__ == "__main__":
    main()
