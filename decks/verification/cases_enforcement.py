# SPDX-License-Identifier: BSD-3-Clause
"""Interfaces that must be neither soft nor lost."""
import numpy as np

from cases import FORMULATIONS, balances, case
from mesh_maker import MeshMaker
from runs import Check, at_most


def two_columns(below, above, across=(2, 2)):
    """Columns of one square metre with the given numbers of elements along and across."""
    mesh = MeshMaker()
    mesh.hexes("below", (0, 0, 0), (1, 1, 1), (across[0], across[0], below))
    mesh.new_body()
    mesh.hexes("above", (0, 0, 1), (1, 1, 1), (across[1], across[1], above))
    mesh.node_set("bottom", lambda x, y, z: z < 1e-9)
    mesh.node_set("top", lambda x, y, z: z > 2 - 1e-9)
    return mesh


def held_force(run):
    """Mean over the end, in which what waves are left goes to and fro."""
    return np.mean(np.abs(run["force"][run["Time"] > 0.6]))


def contact_work(label, run):
    return at_most(f"{label}: work of contact over the strain energy",
                   np.max(np.abs(run["contact_energy"])) / np.max(run["internal_energy"]), 1e-4)


@case()
def columns(bench):
    checks, runs = [], []
    for form in FORMULATIONS:
        for law, tolerance in (("frictionless", 0.02), ("tied", 0.01)):
            for n in (1, 2, 4, 8):
                run = bench.run("columns", two_columns(n, n), form=form, law=law)
                runs.append(run)
                label = f"{form}, {law}, {n} + {n} elements"
                checks += [Check(f"{label}: force over E A strain", 1.0, held_force(run) / 1e5, tolerance),
                           contact_work(label, run)]
        run = bench.run("columns", two_columns(2, 3, (2, 3)), form=form)
        runs.append(run)
        checks.append(Check(f"{form}, unlike meshes: force over E A strain", 1.0, held_force(run) / 1e5, 0.02))
        run = bench.run("columns", two_columns(4, 4), form=form, law="tied", way=0.02)
        runs.append(run)
        checks.append(Check(f"{form}, tied and pulled: force over E A strain", 1.0, held_force(run) / 1e5, 0.01))
    return checks + balances(runs)


@case()
def pressed_columns(bench):
    """By 30 % of their length, with friction, which keeps them from buckling; and a rigid block presses one by 1 %, whatever its modulus is."""
    checks, runs = [], []
    for form in FORMULATIONS:
        deep = bench.run("columns", two_columns(4, 4, (4, 4)), form=form, law="rub", way=-0.6)
        checks.append(at_most(f"{form}, 30 %: penetration over an element", np.max(deep["penetration"]) / 0.25, 0.02))
        for stiffer in (1e-4, 1.0, 1e4):
            run = bench.run("columns", two_columns(4, 1), form=form, rigid=1, way=-0.01, stiffer=stiffer)
            runs.append(run)
            checks.append(Check(f"{form}, rigid, modulus x {stiffer:g}: force over E A strain", 1.0, held_force(run) / 1e5,
                                0.02))
    return checks + balances(runs)
