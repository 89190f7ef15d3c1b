# SPDX-License-Identifier: BSD-3-Clause
"""Shells, beams and particles in contact, which have their bodies by lofts."""
import math

import numpy as np

from cases import balances, case
from mesh_maker import MeshMaker
from runs import Check, at_most

BOTH = ("face_face", "node_face")


def sheet_over_block(is_turned, side, n):
    mesh = MeshMaker(lambda x, y, z: (-x, y, z)) if is_turned else MeshMaker()
    mesh.shells("sheet", (-0.5, -0.5, 0.05), (1, 1), (5, 5), 0.1)
    mesh.new_body()
    mesh.place = lambda x, y, z: (x, y, z)
    mesh.hexes("block", (-0.5 * side, -0.5 * side, -0.5), (side, side, 0.5), (n, n, 1))
    return mesh


@case()
def shell_on_block(bench):
    checks, runs = [], []
    weight = 7800 * 0.1 * 9.81
    for is_turned, form, block in ((False, "face_face", (1.5, 6)), (True, "face_face", (1.5, 6)), (False, "node_face", (1, 5))):
        run = bench.run("shell_on_block", sheet_over_block(is_turned, *block), form=form)
        runs.append(run)
        late = run["Time"] > 0.12
        height = np.mean(run["height"][late])
        label = f"{form}, upside down" if is_turned else form
        checks += [Check(f"{label}: height of the middle [m]", 0.05, height, 1e-3, 1.0),
                   Check(f"{label}: depth [m]", weight / 3e7, 0.05 - height, 0.01),
                   Check(f"{label}: weight [N]", weight, np.mean(run["force"][late]), 0.001)]
    return checks + balances(runs)
