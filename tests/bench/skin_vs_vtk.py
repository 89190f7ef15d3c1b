#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Times the skin of 100 x 100 x 100 hexahedra, read from one Exodus file, in VTK's two surface filters and in contactsim.

    skin_vs_vtk.py build/bench/tests/bench/contactsim_skin_of_file [--cells 100] [--rounds 5]

Reading is told apart. All take turns on one thread; told are the least seconds that each has computed, and the faces.
"""
import argparse
import subprocess
import sys
import tempfile
import time
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE.parents[1] / "decks")]
sys.dont_write_bytecode = True
import numpy as np  # noqa: E402
from mesh_maker import MeshMaker  # noqa: E402


def write_cube(path, n):
    """A cube of n x n x n hexahedra in one block."""
    k, j, i = np.meshgrid(np.arange(n), np.arange(n), np.arange(n), indexing="ij")
    up, layer = n + 1, (n + 1) ** 2
    first = (i + up * j + layer * k).ravel() + 1
    mesh = MeshMaker()
    mesh.blocks = [("cube", "HEX8", first[:, None] + [0, 1, 1 + up, up, layer, layer + 1, layer + 1 + up, layer + up], None)]
    z, y, x = np.meshgrid(*[np.arange(n + 1.0)] * 3, indexing="ij")
    mesh.points = np.column_stack([x.ravel(), y.ravel(), z.ravel()])
    mesh.write(path)


def read_with_vtk(vtk, path):
    """The mesh, and seconds."""
    start = time.thread_time()
    reader = vtk.vtkExodusIIReader()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput().GetBlock(0).GetBlock(0), time.thread_time() - start


def time_filter(make, grid):
    """Seconds and faces of a surface filter."""
    surface = make()
    surface.SetInputData(grid)
    start = time.thread_time()
    surface.Update()
    return time.thread_time() - start, surface.GetOutput().GetNumberOfCells()


def time_contactsim(program, path):
    words = subprocess.run([program, path, "3"], capture_output=True, text=True, check=True).stdout.split()
    found = dict(zip(words[1::2], map(float, words[2::2])))
    return found["seconds"], int(found["faces"]), found["read"]


def measure(program, cells=100, rounds=5):
    """By name: seconds of the skin, faces, seconds of reading. None without VTK."""
    try:
        import vtk
    except ImportError:
        return None
    vtk.vtkSMPTools.Initialize(1)
    vtk.vtkObject.GlobalWarningDisplayOff()  # a mesh without time steps
    found = {}

    def take(name, seconds, faces, reading):
        before = found.get(name, (seconds, faces, reading))
        found[name] = (min(seconds, before[0]), faces, min(reading, before[2]))

    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "cube.g"
        write_cube(path, cells)
        for _ in range(rounds):
            take("contactsim", *time_contactsim(program, path))
            grid, reading = read_with_vtk(vtk, path)
            for make in (vtk.vtkDataSetSurfaceFilter, vtk.vtkGeometryFilter):
                take(make.__name__, *time_filter(make, grid), reading)
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--cells", type=int, default=100)
    parser.add_argument("--rounds", type=int, default=5)
    arguments = parser.parse_args()
    found = measure(arguments.program, arguments.cells, arguments.rounds)
    if found is None:
        sys.exit("python3-vtk9 is not installed")
    own = found["contactsim"][0]
    for name, (seconds, faces, reading) in found.items():
        print(f"{name:26} {1e3 * seconds:8.1f} ms {faces:8} faces {seconds / own:7.2f} times contactsim; "
              f"reading {1e3 * reading:8.1f} ms")
    if len({faces for _, faces, _ in found.values()}) != 1:
        sys.exit("the numbers of faces differ")


if __name__ == "__main__":
    main()
