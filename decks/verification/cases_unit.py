# SPDX-License-Identifier: BSD-3-Clause
"""Contact of unit size, to be checked by hand."""
import math

import numpy as np

from cases import balances, case
from mesh_maker import MeshMaker
from runs import Check, at_most


def cube_on_base(side):
    mesh = MeshMaker()
    mesh.hexes("cube", (0, 0, 0), (side, side, side), (1, 1, 1))
    mesh.new_body()
    mesh.hexes("base", (-side, -side, -side), (3 * side, 3 * side, side), (1, 1, 1))
    return mesh


@case()
def bounce(bench):
    run = bench.run("bounce", cube_on_base(0.1))
    times, force = run["Time"], run["force"]
    on = times[force > 0]
    return [Check("time in contact [s]", math.pi * 1e-4, on[-1] - on[0], 0.01), Check("largest force [N]", 1e4, np.max(force), 0.01),
            Check("largest depth [m]", 1e-4, -np.min(run["level"]), 0.01), Check("velocity after [m/s]", 1.0, run["v"][-1], 0.01),
            *balances([run])]


@case()
def settled_cube(bench):
    run = bench.run("bounce", cube_on_base(0.01), speed=0, gravity=9.81, damping=0.3, density=8000, youngs=2e13,
                    penalty=1e12, end_time=4e-4)
    late = run["Time"] > 2e-4
    return [Check("force [N]", 0.07848, np.mean(run["force"][late]), 0.001),
            Check("depth [m]", 7.848e-10, -np.mean(run["level"][late]), 0.01), *balances([run])]


def node_above(x, y):
    mesh = MeshMaker()
    mesh.hexes("base", (-1, -1, -1), (2, 2, 1), (2, 2, 1))
    mesh.new_body()
    mesh.hexes("cube", (x, y, 0.01), (0.5, 0.5, 0.5), (1, 1, 1))
    mesh.node_set("tip", lambda a, b, c: (a, b, c) == (x, y, 0.01))
    return mesh


@case()
def one_node(bench):
    forces, runs = [], []
    for x, y in ((0.3, 0.4), (0, 0.4), (0.3, 0), (0, 0)):
        runs.append(bench.run("one_node", node_above(x, y)))
        forces.append(runs[-1].contact_force(2)[-1, 2])
    where = ["", "edge along y", "edge along x", "corner"]
    return [Check(f"force on the {w} [N]", forces[0], f, 1e-12) for w, f in zip(where[1:], forces[1:])] + balances(runs)


def plate():
    mesh = MeshMaker()
    mesh.hexes("plate", (0, 0, 0), (1, 1, 0.05), (10, 10, 1))
    return mesh


def cubes_at_edge():
    mesh = MeshMaker()
    mesh.hexes("one", (0, 0, 0), (1, 1, 1), (2, 2, 2))
    mesh.hexes("other", (1, 1, 0), (1, 1, 1), (2, 2, 2))
    return mesh


def blocks_apart():
    mesh = MeshMaker()
    mesh.hexes("one", (0, 0, 0), (1, 1, 1), (2, 2, 2))
    mesh.new_body()
    mesh.hexes("other", (1 + 0.5e-9, 0.1, 0), (1, 1, 1), (3, 3, 3))
    return mesh


@case()
def no_touch(bench):
    checks = []
    for label, mesh, spin in (("plate one element thick", plate(), 0), ("cubes that share an edge", cubes_at_edge(), 0),
                              ("blocks 1e-9 of an element apart", blocks_apart(), 0),
                              ("plate and itself, turning", plate(), 100), ("cubes at an edge, turning", cubes_at_edge(), 100)):
        for form in ("face_face", "node_face"):
            run = bench.run("no_touch", mesh, form=form, spin=spin)
            checks.append(at_most(f"{label}, {form}: largest force", np.max(np.abs(run.nodal("force_contact"))), 0.0))
    return checks
