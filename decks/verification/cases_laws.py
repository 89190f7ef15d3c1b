# SPDX-License-Identifier: BSD-3-Clause
"""Laws of materials along paths that have a formula."""
import math

import numpy as np

from cases import case
from cases_solids import energy_check
from mesh_maker import MeshMaker
from runs import Check


def bars(height, solid, n=1):
    """Bodies along x from 0 to 1, of a square of the height: a block, a sheet at z = 3, a cord at z = 5."""
    mesh = MeshMaker()
    mesh.hexes(solid, (0, 0, 0), (1, height, height), (n, n, n))
    mesh.shells("sheet", (0, 0, 3), (1, height), (n, n), None)
    return mesh


def hold(mesh, floor):
    mesh.node_set("held", lambda x, y, z: x == 0)
    mesh.node_set("pulled", lambda x, y, z: x == 1)
    mesh.node_set("side", lambda x, y, z: y == 0)
    mesh.node_set("floor", floor)
    return mesh


def rubber_mesh():
    mesh = bars(1, "block", 2)
    mesh.lines("cord", (0, 0, 5), (1, 0, 5), 2, "BAR2")
    mesh.lines("beam", (0, 0, 7), (1, 0, 7), 2)
    return hold(mesh, lambda x, y, z: z == 0 or z > 1)


def rubber_stress(stretch, c10, c01, bulk):
    """Stress along a stretch, and the squared stretch across at which the stress there vanishes."""
    def kirchhoff(q):
        volume = stretch * q
        first = 2 * c10 * volume ** (-2 / 3) * (stretch ** 2 - q) / 3
        second = 2 * c01 * volume ** (-4 / 3) * (stretch ** 2 * q - q * q) / 3
        deviator, pressure = first + second, bulk / 2 * (volume ** 2 - 1)
        return 2 * deviator + pressure, -deviator + pressure
    low, high = 0.1, 2.0
    for _ in range(100):
        middle = 0.5 * (low + high)
        low, high = (low, middle) if kirchhoff(middle)[1] > 0 else (middle, high)
    return kirchhoff(low)[0] / (stretch * low), low


@case()
def rubber_pull(bench):
    run = bench.run("rubber_pull", rubber_mesh())
    force, ends = run.nodal("force_internal")[-1, :, 0], run.start[:, 0] == 1
    checks = []
    for block, (name, area, c10, c01) in enumerate((("solids", 1, 0.3e6, 0.1e6), ("shells", 0.1, 0.3e6, 0.1e6),
                                                    ("trusses", 0.01, 0.4e6, 0.0), ("beams", 0.01, 0.4e6, 0.0)), 1):
        stress, across = rubber_stress(2.0, c10, c01, 1e8)
        nodes = [n for n in run.nodes_of(block) if ends[n]]
        reached = run.element("stress_xx", block)[-1]
        checks += [Check(f"{name}: stress [Pa]", stress, np.mean(reached), 1e-4),
                   Check(f"{name}: force [N]", area * across * stress, abs(np.sum(force[nodes])), 1e-4)]
    return checks + [energy_check(run, ["external_energy"])]




class Ply:
    e11, e22, e33, nu12, nu13, nu23, g12 = 140e9, 10e9, 9e9, 0.3, 0.25, 0.4, 5e9


@case()
def off_axis(bench):
    mesh = MeshMaker()
    mesh.shells("ply", (0, 0, 0), (1, 1), (1, 1), None)
    mesh.hexes("wound", (0, 4.5, 0), (1, 1, 1), (1, 1, 1))
    hold(mesh, lambda x, y, z: z == 0)
    run = bench.run("off_axis", mesh)
    scale = Ply.e11 / (Ply.e11 - Ply.nu12 ** 2 * Ply.e22)
    q11, q22, q12 = scale * Ply.e11, scale * Ply.e22, scale * Ply.nu12 * Ply.e22
    s, c, g = math.sin(math.radians(30)), math.cos(math.radians(30)), Ply.g12
    expected = {"xx": q11 * c ** 4 + 2 * (q12 + 2 * g) * s * s * c * c + q22 * s ** 4,
                "yy": (q11 + q22 - 4 * g) * s * s * c * c + q12 * (s ** 4 + c ** 4),
                "xy": (q11 - q12 - 2 * g) * s * c ** 3 + (q12 - q22 + 2 * g) * s ** 3 * c}
    checks = [Check(f"shell: stress {name} [Pa]", 1e-4 * value, np.mean(run.element(f"stress_{name}", 1)[-1]), 2e-4)
              for name, value in expected.items()]
    compliance = np.array([[1 / Ply.e11, -Ply.nu12 / Ply.e11, -Ply.nu13 / Ply.e11],
                           [-Ply.nu12 / Ply.e11, 1 / Ply.e22, -Ply.nu23 / Ply.e22],
                           [-Ply.nu13 / Ply.e11, -Ply.nu23 / Ply.e22, 1 / Ply.e33]])
    column = np.linalg.inv(compliance)[:, 1]
    return checks + [Check(f"brick: stress {name} [Pa]", 1e-4 * value, run.element(f"stress_{name}", 2)[-1, 0], 2e-4)
                     for name, value in zip(("yy", "xx", "zz"), column)]


def bar_sheet_and_wire():
    mesh = bars(0.1, "bar")
    mesh.lines("wire", (0, 0, 5), (1, 0, 5), 1, "BAR2")
    hold(mesh, lambda x, y, z: z == 0 or z > 1)
    return mesh


@case()
def breaking_bar(bench):
    run = bench.run("breaking_bar", bar_sheet_and_wire())
    strain = 0.05 + 0.3 * math.exp(-2 / 3)
    length = math.exp(strain + (300e6 + 400e6 * math.sqrt(strain)) / 200e9)
    checks = [Check(f"{name}: time of death [s]", (length - 1) / 10, run["Time"][np.argmax(run[name] < 1)], bound)
              for name, bound in (("bar", 0.002), ("sheet", 0.004), ("wire", 0.002))]  # a surface is viscous as it flows
    return checks + [Check("damage at death", 1.0, np.max(run["damage"]), 0.002), energy_check(run, ["external_energy"])]


@case()
def tearing_bar(bench):
    run = bench.run("tearing_bar", bar_sheet_and_wire())
    def flow_stress(strain):
        return 300e6 + np.interp(strain, (0, 0.05, 0.2, 1), (0, 60e6, 120e6, 200e6))
    def time_of(strain):
        return (math.exp(strain) - 1) / 10
    cracked = 0.15 + flow_stress(0.15) / 200e9
    half_open = 0.15 + 0.03 / (1 + 0.4e9 / 200e9)  # plastic strain then: hardening goes on in what is whole
    checks = []
    for name in ("bar", "sheet", "wire"):
        def stress_at(strain):
            return np.interp(time_of(strain), run["Time"], run[f"{name}_stress"])
        checks += [Check(f"{name}: stress at a plastic strain of 0.1 [Pa]", flow_stress(0.1),
                         stress_at(0.1 + flow_stress(0.1) / 200e9), 0.002),
                   Check(f"{name}: stress with the crack half open [Pa]", 0.5 * flow_stress(half_open),
                         stress_at(cracked + 0.03), 0.002),
                   Check(f"{name}: time of death [s]", time_of(cracked + 0.06), run["Time"][np.argmax(run[name] < 1)], 0.002)]
    at_tear = np.argmax(run["tearing"] >= 0.15)
    return checks + [Check("plastic strain at tearing", 0.15, run["eqps"][at_tear], 0.002),
                     Check("damage at death", 1.0, np.max(run["damage"]), 1e-12), energy_check(run, ["external_energy"])]
