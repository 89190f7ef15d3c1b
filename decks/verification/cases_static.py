# SPDX-License-Identifier: BSD-3-Clause
"""Blocks that are pressed together slowly."""
import math

import numpy as np

from cases import balances, case
from mesh_maker import MeshMaker
from runs import Check, at_most


def blocks(lower, upper, height=0.5, layers=2):
    """Two blocks on each other, with so many elements along each side of their squares."""
    mesh = MeshMaker()
    mesh.hexes("lower", (0, 0, 0), (1, 1, height), (lower, lower, layers))
    mesh.new_body()
    first = mesh.hexes("upper", (0, 0, height), (1, 1, height), (upper, upper, layers))
    mesh.node_set("on_x", lambda x, y, z: x == 0)
    mesh.node_set("on_y", lambda x, y, z: y == 0)
    mesh.node_set("bottom", lambda x, y, z: z == 0)
    mesh.side_set("top", [(first + upper * upper * (layers - 1) + i, 6) for i in range(upper * upper)])
    return mesh


def late_mean(run, values):
    return np.mean(values[run.times > 4.0], axis=0)


def stress_error(run, stress):
    """The largest error of the mean stress of an element."""
    errors = [np.abs(late_mean(run, run.element("stress_zz", block)) / stress - 1) for block in (1, 2)]
    return max(np.max(e) for e in errors)


@case()
def patch_test(bench):
    checks, runs = [], []
    for nu in (0.0, 0.3):
        for lower, upper in ((2, 2), (3, 2), (4, 2), (2, 3)):
            for form in ("face_face", "node_face"):
                runs.append(bench.run("patch", blocks(lower, upper), form=form, nu=nu))
                label = f"{form}, {upper}x{upper} on {lower}x{lower}, nu = {nu}: error of stress"
                bar = 0.001 if form == "face_face" or lower == upper else 0.03
                checks.append(at_most(label, stress_error(runs[-1], -100), bar))
    return checks + balances(runs)


@case()
def tied_patch_test(bench):
    checks, runs = [], []
    for form in ("face_face", "node_face"):
        runs.append(bench.run("patch", blocks(3, 2), form=form, tied=1, amount=-100, penalty=1e10))
        top = runs[-1].start[:, 2] == 1.0
        stretch = np.mean(late_mean(runs[-1], runs[-1].nodal("displacement"))[top, 2])
        bar = 0.001 if form == "face_face" else 0.69
        checks += [at_most(f"{form}: error of stress", stress_error(runs[-1], 100), bar),
                   Check(f"{form}: stretch", 1e-4, stretch, 0.001 if form == "face_face" else 0.02)]
    return checks + balances(runs)


@case()
def patch_brick(bench):
    """MOOSE's brick1: one element on one other."""
    run = bench.run("patch", blocks(1, 1, 1.0, 1), amount=109.89, nu=0.3)
    side = 1 + late_mean(run, run.nodal("displacement"))[run.nodes_of(1), 0].max()
    return [at_most("error of stress", stress_error(run, -109.89), 1e-4),
            Check("contact pressure", 109.897246, -late_mean(run, run.contact_force(1))[2] / side ** 2, 1e-4),
            *balances([run])]


@case()
def lowered_blocks(bench):
    """Unit cubes, and code_aster's SSNP121."""
    cubes = bench.run("patch", blocks(1, 1, 1.0, 1), load="depth", amount=1e-3, nu=0, penalty=1e9)
    force = 1e-3 / (2e-6 + 1e-9)
    late = cubes["Time"] > 4.0
    depth = -np.mean(cubes["force"][late]) / 1e9
    blocks_2 = bench.run("patch", blocks(3, 2, 1.0, 2), load="depth", amount=0.1, nu=0, youngs=2e6, penalty=1e10)
    low = blocks_2.nodes_of(1)[blocks_2.start[blocks_2.nodes_of(1), 2] == 1.0]
    level = np.mean(late_mean(blocks_2, blocks_2.nodal("displacement"))[low, 2])
    return [Check("unit cubes: force", force, -np.mean(cubes["force"][late]), 0.001),
            Check("unit cubes: penetration", force / 1e9, depth, 0.001),
            at_most("SSNP121: error of stress", stress_error(blocks_2, 2e6 * math.log(0.95)), 0.001),
            Check("SSNP121: interface", -0.05, level, 0.001), *balances([cubes, blocks_2])]
