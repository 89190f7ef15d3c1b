# SPDX-License-Identifier: BSD-3-Clause
"""Springs, dampers, point masses and trusses that are pulled before they move."""
import math

import numpy as np

from cases import case
from cases_shells import frequency_of
from cases_solids import energy_check
from mesh_maker import MeshMaker
from runs import Check


def spring_mesh():
    mesh = MeshMaker()
    for y, name in [(0, "plain"), (1, "kinked")]:
        mesh.lines(name, (0, y, 0), (0.1, y, 0), 1, "BAR2")
    mesh.lines("damper", (0, 2, 0), (0.1, 2, 0), 1, "BAR2")
    mesh.lines("damped", (0, 2, 0), (0.1, 2, 0), 1, "BAR2")
    mesh.particles("mass", [(0.1, y, 0) for y in range(3)])
    mesh.node_set("ground", lambda x, y, z: x == 0)
    mesh.node_set("masses", lambda x, y, z: x == 0.1)
    return mesh


def peaks(values):
    """The largest value of each swing to the positive side."""
    starts = [i for i in range(1, len(values)) if values[i - 1] < 0 <= values[i]]
    return np.array([np.max(values[a:b]) for a, b in zip(starts, starts[1:])])


@case()
def springs(bench):
    run = bench.run("springs", spring_mesh())
    rate = math.sqrt(100 ** 2 - 5 ** 2) / (2 * math.pi)
    swings = peaks(run["damped"])
    fall = math.log(swings[0] / swings[-1]) / (len(swings) - 1) * rate
    return [Check("plain: frequency [Hz]", 100 / (2 * math.pi), frequency_of(run["Time"], run["plain"]), 0.001),
            Check("plain: amplitude [m]", 1e-3, np.max(run["plain"]), 0.001),
            Check("kinked: frequency [Hz]", 1 / (math.pi * (1 / 100 + 1 / 200)), frequency_of(run["Time"], run["kinked"]), 0.001),
            Check("damped: frequency [Hz]", rate, frequency_of(run["Time"], run["damped"]), 0.001),
            Check("damped: rate of fall [1/s]", 5, fall, 0.005),
            energy_check(run, ["kinetic_energy"])]


def string_mesh(n):
    mesh = MeshMaker()
    mesh.lines("at_once", (0, 0, 0), (1, 0, 0), n, "BAR2")
    mesh.lines("soon", (0, 1, 0), (1, 1, 0), n, "BAR2")
    mesh.node_set("ends", lambda x, y, z: x in (0, 1))
    return mesh


@case(refined=[5, 10, 20])
def string(bench, n=20):
    run = bench.run("string", string_mesh(n))
    exact = math.sqrt(200 / (7800 * 1e-6)) / 2
    checks = [Check(f"{name}: frequency [Hz]", exact, frequency_of(run["Time"], run[name]), 0.002) for name in ("at_once", "soon")]
    stress = [Check(f"{name}: stress [Pa]", 200e6, run[f"stress_{name}"][-1], 0.005) for name in ("at_once", "soon")]
    return checks + stress + [energy_check(run, ["kinetic_energy"])]
