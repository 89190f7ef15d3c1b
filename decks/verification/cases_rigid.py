# SPDX-License-Identifier: BSD-3-Clause
"""Rigid bodies without contact."""
import math

import numpy as np

from cases import case
from cases_solids import energy_check
from mesh_maker import MeshMaker
from runs import Check, at_most


def two_bricks():
    mesh = MeshMaker()
    mesh.hexes("flier", (0, 0, 0), (1, 2, 3), (2, 2, 2))
    mesh.hexes("turner", (10, 0, 0), (1, 2, 3), (1, 1, 1))
    mesh.node_set("end", lambda x, y, z: x >= 10 and y == 2)
    return mesh


@case()
def rigid_motion(bench):
    run = bench.run("rigid_motion", two_bricks())
    angle = 0.5 * 40 / (6000 * 5 / 12)  # four nodes, each 1 m beside the axle; turned by little
    return [Check("fall of the centre [m]", -0.5 * 9.81, run["height"][-1], 1e-9),
            Check("angle [1]", angle, run["angle"][-1], 1e-4),
            Check("kinetic energy of the spin [J]", run["kinetic_energy"][0],
                  run["kinetic_energy"][-1] - run["external_energy"][-1], 1e-3),
            energy_check(run, ["kinetic_energy"])]


def leaning_tops():
    side, up = 0.5, math.sqrt(0.75)

    def place(x, y, z):
        shift = 2 if x > 1 else 0
        return ((x - shift) * up + z * side + shift, y, z * up - (x - shift) * side)

    mesh = MeshMaker(place)
    mesh.hexes("heavy", (-0.1, -0.1, -0.2), (0.2, 0.2, 0.4), (2, 2, 2))
    mesh.hexes("free", (1.9, -0.1, -0.2), (0.2, 0.2, 0.4), (2, 2, 2))
    mesh.node_set("tip", lambda x, y, z: abs(x) < 1e-9 and y == 0 and z == 0.2)
    return mesh


@case()
def tops(bench):
    run = bench.run("tops", leaning_tops())
    about, across = 16 * 0.04 / 6, 16 * 0.2 / 12
    rates = {"heavy": 2, "free": about * 10 / ((across - about) * math.sqrt(0.75))}
    checks = []
    for name, centre in [("heavy", 0), ("free", 2)]:
        azimuth = np.unwrap(np.arctan2(run[f"{name}_y"], run[f"{name}_x"] - centre))
        lean = np.arccos(run[f"{name}_z"] / 0.2)
        checks += [Check(f"{name}: rate of precession [1/s]", rates[name], np.polyfit(run["Time"], azimuth, 1)[0], 0.001),
                   at_most(f"{name}: nutation over the lean", np.ptp(lean) / (math.pi / 6), 1e-3)]
    return checks + [energy_check(run, ["kinetic_energy"])]


def stacked_bricks(n=10):
    mesh = MeshMaker()
    for i in range(n):
        size = (0.2, 0.1, 0.1) if i % 2 == 0 else (0.1, 0.2, 0.1)
        mesh.new_body()
        mesh.hexes(f"brick_{i + 1}", (-0.5 * size[0], -0.5 * size[1], 0.1 * i), size, (1, 1, 1))
    return mesh


@case()
def rigid_stack(bench):
    run = bench.run("rigid_stack", stacked_bricks())
    weight, late = 10 * 2000 * 0.002 * 9.81, run["Time"] > 0.1
    # The lowest brick bears what the plane does less the nine above: its own weight.
    return [Check("force of the plane and of the second brick on the lowest [N]", 0.1 * weight, np.mean(run["force"][late]), 1e-3),
            at_most("largest way [m]", np.max(np.abs(run.nodal("displacement"))), 1e-4),
            at_most("largest speed [m/s]", np.max(np.abs(run.nodal("velocity"))), 1e-2),
            at_most("energy that appears over the fall of a brick's height",
                    np.max(np.abs(run["energy_error"])) / (0.1 * weight), 1e-3)]
