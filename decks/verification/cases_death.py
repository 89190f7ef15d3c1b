# SPDX-License-Identifier: BSD-3-Clause
"""Elements that die, and surfaces that follow."""
import numpy as np

from cases import balances, case, energy_share
from mesh_maker import MeshMaker
from runs import Check, at_most


def layered_plate():
    mesh = MeshMaker()
    for i, name in enumerate(("plate", "layer_2", "layer_1")):
        mesh.hexes(name, (0, 0, 0.1 * i), (0.6, 0.6, 0.1), (6, 6, 1))
    mesh.node_set("rim", lambda x, y, z: z == 0)
    mesh.new_body()
    mesh.hexes("weight", (0.15, 0.15, 0.3), (0.3, 0.3, 0.2), (2, 2, 1))
    return mesh


@case()
def eroded_layers(bench):
    run = bench.run("eroded_layers", layered_plate(), erosion="on", frame=0.02)
    times, level = run["Time"], run["level"]
    first, second = (times > 0.05) & (times < 0.3), times > 0.3
    return [Check("lowest on the second layer [m]", -0.1, np.min(level[first]), 0.1),
            Check("lowest on the plate [m]", -0.2, np.min(level[second]), 0.1),
            *balances([run])]


def rod_and_plate():
    mesh = MeshMaker()
    mesh.hexes("plate", (-0.02, -0.02, -0.004), (0.04, 0.04, 0.004), (20, 20, 2))
    mesh.new_body()
    mesh.hexes("rod", (-0.004, -0.0041, 0), (0.008, 0.008, 0.02), (4, 4, 8))
    return mesh


@case()
def perforated_plate(bench):
    settings = dict(speed=500, limit=0.4, frame=5e-6)
    runs = [bench.run("perforated_plate", rod_and_plate(), erosion=erosion, death_steps=steps, **settings)
            for erosion, steps in (("off", 1), ("on", 1), ("off", 10))]
    slowest = max(run["rod_speed"][-1] for run in runs)
    return [Check("speed of the rod behind the plate [m/s]", -430, slowest, 0.05),
            at_most("share of the plate that lives", max(run["living"][-1] for run in runs) / 800, 0.95),
            *balances(runs, is_free=True, has_friction=True, tolerance=0.02)]
