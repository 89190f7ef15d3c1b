# SPDX-License-Identifier: BSD-3-Clause
"""Rigid bodies without contact."""
from cases import case
from cases_solids import energy_check
from mesh_maker import MeshMaker
from runs import Check


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
