# SPDX-License-Identifier: BSD-3-Clause
"""Bodies that hit each other hard."""
import math

import numpy as np

import make_meshes
from cases import balances, case
from mesh_maker import MeshMaker
from runs import Check, at_most


def cut_cube():
    mesh = MeshMaker()
    for half, z, meshes in (("lower", -4, (2, 4, 3, 6)), ("upper", 0, (5, 2, 4, 3))):
        for i, n in enumerate(meshes):
            mesh.new_body()
            mesh.hexes(f"{half}_{i + 1}", (-4 + 4 * (i % 2), -4 + 4 * (i // 2), z), (4, 4, 4), (n, n, 2 * n))
    return mesh


@case()
def squeezed_cubes(bench):
    run = bench.run("squeezed_cubes", cut_cube())
    times = run["Time"]
    force = -np.mean(run["force"][(times > 0.2e-3) & (times < 1e-3)])
    return [Check("mean force [N]", 1.45942e9, force, 0.15), *balances([run], is_free=True)]


def taylor_checks(label, run, length, radius, bounds):
    reached = 0.0324 + run["end_displacement"][-1] - run["foot_level"][-1]
    checks = [Check(f"{label}: length [m]", length, reached, bounds[0])]
    if radius is not None:
        checks.append(Check(f"{label}: radius of the foot [m]", radius, run["foot_radius"][-1], bounds[1]))
    return checks


@case()
def taylor_wall(bench):
    run = bench.run("taylor_wall", make_meshes.taylor_bar(4))
    return [*taylor_checks("227 m/s", run, 21.5e-3, 7.15e-3, (0.014, 0.035)), *balances([run], has_plane=True)]


@case(is_long=True)
def taylor_walls(bench):
    mesh = make_meshes.taylor_bar(6)
    runs = [bench.run("taylor_wall", mesh, speed=speed) for speed in (227, 130, 146)]
    plastic = dict(density=8970, youngs=110e9, nu=0.3, hardening=0.0)
    runs.append(bench.run("taylor_wall", mesh, **{"yield": 314e6}, **plastic))
    return [*taylor_checks("227 m/s", runs[0], 21.5e-3, 7.15e-3, (0.014, 0.035)),
            *taylor_checks("130 m/s", runs[1], 27.904e-3, 4.906e-3, (0.01, 0.03)),
            *taylor_checks("146 m/s", runs[2], 26.973e-3, 5.234e-3, (0.01, 0.03)),
            *taylor_checks("perfectly plastic", runs[3], 19.36e-3, None, (0.02,)), *balances(runs, has_plane=True)]
