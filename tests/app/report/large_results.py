#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes Exodus results of two plates of hexahedra, one layer each, that swing against each other.

    large_results.py RESULTS [CELLS [TIMES]]

Of 160 cells along each edge they have 103,680 faces. Displacements are waves with 1 % of noise, von Mises stress has
10 %: no smoother than what runs write.
"""
import sys

import netCDF4
import numpy

COLUMNS = {"displacement_x": 0, "displacement_y": 1, "displacement_z": 2}


def plate(n, height):
    """Coordinates and connectivity, from 1, of n x n cells between z = height and height + 0.01."""
    line = numpy.linspace(0.0, 1.0, n + 1)
    z, y, x = numpy.meshgrid([height, height + 0.01], line, line, indexing="ij")
    node = numpy.arange(2 * (n + 1) ** 2).reshape(2, n + 1, n + 1) + 1
    corners = [node[k, j:j + n, i:i + n] for k in (0, 1) for j, i in ((0, 0), (0, 1), (1, 1), (1, 0))]
    return numpy.stack([x, y, z]).reshape(3, -1), numpy.stack(corners, axis=-1).reshape(-1, 8)


def make_file(path, coordinates, connectivity):
    file = netCDF4.Dataset(path, "w", format="NETCDF3_64BIT_OFFSET")
    file.setncatts({"api_version": numpy.float32(8.03), "version": numpy.float32(8.03),
                    "floating_point_word_size": numpy.int32(8), "file_size": numpy.int32(1), "title": "two plates"})
    sizes = {"len_name": 33, "num_dim": 3, "num_nodes": coordinates.shape[1], "num_el_blk": len(connectivity),
             "num_elem": sum(map(len, connectivity)), "time_step": None, "num_nod_var": 4, "num_elem_var": 1}
    for name, size in sizes.items():
        file.createDimension(name, size)
    for name, row in zip(("coordx", "coordy", "coordz"), coordinates):
        file.createVariable(name, "f8", ("num_nodes",))[:] = row
    file.createVariable("eb_prop1", "i4", ("num_el_blk",)).setncattr("name", "ID")
    file["eb_prop1"][:] = numpy.arange(len(connectivity)) + 1
    for i, rows in enumerate(connectivity, 1):
        file.createDimension(f"num_el_in_blk{i}", len(rows))
        file.createDimension(f"num_nod_per_el{i}", 8)
        variable = file.createVariable(f"connect{i}", "i4", (f"num_el_in_blk{i}", f"num_nod_per_el{i}"))
        variable.setncattr("elem_type", "HEX8")
        variable[:] = rows
    return file


def add_variables(file, n_blocks):
    file.createVariable("time_whole", "f8", ("time_step",))
    for kind, names in (("nod", [*COLUMNS, "pressure"]), ("elem", ["von_mises"])):
        variable = file.createVariable(f"name_{kind}_var", "S1", (f"num_{kind}_var", "len_name"))
        variable[:] = netCDF4.stringtochar(numpy.array(names, "S33"))
    for i in range(4):
        file.createVariable(f"vals_nod_var{i + 1}", "f8", ("time_step", "num_nodes"))
    for i in range(n_blocks):
        file.createVariable(f"vals_elem_var1eb{i + 1}", "f8", ("time_step", f"num_el_in_blk{i + 1}"))


def add_time(file, step, time, coordinates, random):
    x, y, z = coordinates
    wave = 0.05 * numpy.sin(7.0 * x + 9.0 * time) * numpy.cos(5.0 * y - 4.0 * time)
    noise = 0.0005 * random.standard_normal((3, len(x)))
    moved = numpy.stack([0.1 * wave, 0.2 * wave, numpy.where(z < 0.015, wave, -wave)]) + noise
    file["time_whole"][step] = time
    for i in range(3):
        file[f"vals_nod_var{i + 1}"][step] = moved[i]
    file["vals_nod_var4"][step] = numpy.maximum(0.0, 1e9 * wave * numpy.sin(20.0 * x * y + 5.0 * time))
    for i in (1, 2):
        at = file[f"connect{i}"][:, 0] - 1
        stress = 1e9 * numpy.abs(wave[at]) * (1.0 + 0.1 * random.standard_normal(len(at)))
        file[f"vals_elem_var1eb{i}"][step] = stress


def main():
    path, n = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 160
    n_times = int(sys.argv[3]) if len(sys.argv) > 3 else 21
    lower, below = plate(n, 0.0)
    upper, above = plate(n, 0.02)
    coordinates = numpy.hstack([lower, upper])
    random = numpy.random.default_rng(1)
    with make_file(path, coordinates, [below, above + lower.shape[1]]) as file:
        add_variables(file, 2)
        for step in range(n_times):
            add_time(file, step, step / (n_times - 1), coordinates, random)


if __name__ == "__main__":
    main()
