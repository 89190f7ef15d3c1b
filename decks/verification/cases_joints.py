# SPDX-License-Identifier: BSD-3-Clause
"""Sliding over joints of parts that share no nodes."""
import numpy as np

from cases import FORMULATIONS, balances, case
from mesh_maker import MeshMaker
from runs import Check, at_most


def joint(gap=0.0, step=0.0, skew=0.0, shell=False, tee=False):
    """Two parts beside each other along x = 0 and a slider on the first.

    gap: by which the joint is open; step: by which the second part is higher; skew: slope of the joint in the plane;
    tee: the second part is two, joined along y = 0.
    """
    mesh = MeshMaker(lambda x, y, z: (x + skew * y, y, z))
    if shell:
        mesh.shells("near", (-0.4, -0.4, 0), (0.4, 0.8), (4, 4), 0.02)
        mesh.new_body()
        mesh.shells("far", (gap, -0.4, step), (0.6, 0.8), (6, 5), 0.02)
    else:
        mesh.hexes("near", (-0.4, -0.4, -0.2), (0.4, 0.8, 0.2), (4, 4, 2))
        mesh.new_body()
        for y, width, n in ((-0.4, 0.37, 3), (-0.03, 0.43, 2)) if tee else ((-0.4, 0.8, 5),):
            mesh.hexes("far", (gap, y, step - 0.2), (0.6, width, 0.2), (6, n, 2))
            mesh.new_body()
    top = 0.01 if shell else 0.0
    mesh.new_body()
    mesh.place = lambda x, y, z: (x, y, z)
    mesh.hexes("slider", (-0.25, -0.1, top), (0.2, 0.2, 0.1), (3, 3, 3))
    mesh.node_set("bottom", lambda x, y, z: z <= min(0.0, step - 0.2) + 1e-9 if not shell else z <= step)
    return mesh


# What stands on its bottom gives way under the slider and leaves the next part's edge higher: a step that is there. A
# node that drops into an open joint meets its far side.
def speed_of_slider(run):
    return run.momentum(3)[:, 0] / run.mass(3)


def speed_check(label, run, tolerance=1e-3):
    speed = speed_of_slider(run)
    return Check(f"{label}: speed", 5.0, speed[np.argmax(np.abs(speed - 5.0))], tolerance)


@case()
def flush_joint(bench):
    kinds = {"solids": ({}, {}), "solids at 1 g": ({}, {"weight": 9.81}), "sheets": ({"shell": True}, {"shell": 1}),
             "sheets at 1 g": ({"shell": True}, {"shell": 1, "weight": 9.81}), "askew by 45 degrees": ({"skew": 1.0}, {}),
             "open by 1e-6": ({"gap": 1e-6}, {}), "open by 2e-2": ({"gap": 2e-2}, {}),
             "on their bottoms": ({}, {"held": 0}), "T joint": ({"tee": True}, {}),
             "askew by 20 degrees": ({"skew": 0.36}, {}),
             "3 % down": ({"step": -3e-3}, {"weight": 9.81}), "one surface": ({}, {"surfaces": "one", "selves": "on"})}
    checks, runs = [], []
    for form in FORMULATIONS:
        for kind, (shape, variables) in kinds.items():
            runs.append(bench.run("joint", joint(**shape), form=form, **variables))
            checks.append(speed_check(f"{form}, {kind}", runs[-1]))
    return checks + balances(runs)


@case()
def step_in_joint(bench):
    """A step up of 3 % of an element is an obstacle."""
    runs = [bench.run("joint", joint(step=3e-3), form=form) for form in FORMULATIONS]
    return [at_most(f"{form}: largest speed after the step", max(0.0, *speed_of_slider(run)[-5:]), 0.5)
            for form, run in zip(FORMULATIONS, runs)]
