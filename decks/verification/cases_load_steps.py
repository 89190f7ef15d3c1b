# SPDX-License-Identifier: BSD-3-Clause
"""Quasi-static procedures: equilibrium step by step."""
import math

import numpy as np

from cases import case
from cases_shells import frequency_of
from cases_solids import brick, cantilever_mesh, energy_check, thick_cylinder_mesh
from mesh_maker import MeshMaker
from runs import Check, at_most


@case()
def static_cylinder(bench, n=16):
    run = bench.run("static_cylinder", thick_cylinder_mesh(n))
    a, b, p, nu, modulus = 1.0, 2.0, 1e6, 0.3, 200e9
    displacement = p * a * (1 + nu) / modulus * (a * a * (1 - 2 * nu) + b * b) / (b * b - a * a)
    explicit = bench.run("thick_cylinder", thick_cylinder_mesh(n))
    late = explicit["Time"] > 0.012
    solved = {solver: bench.run("static_cylinder", thick_cylinder_mesh(n), solver=solver)["inner"][-1]
              for solver in ("amg", "direct")}
    return [Check("displacement of the inner wall", displacement, run["inner"][-1], 0.01),
            Check("the same by multigrid as by a factor", solved["direct"], solved["amg"], 1e-6),
            Check("the same by nodal blocks", solved["direct"], run["inner"][-1], 1e-5),
            Check("the same by explicit dynamics", np.mean(explicit["inner"][late]), run["inner"][-1], 1e-3),
            Check("hoop stress by explicit dynamics", np.mean(explicit["hoop"][late]), run["hoop"][-1], 1e-3),
            Check("a third of the pressure", run["inner"][-1] / 3, run["inner"][1], 1e-4),
            energy_check(run, ["external_energy"])]


def strip_mesh(n):
    mesh = MeshMaker()
    mesh.shells("strip", (0, 0, 0), (10, 1), (n, 1), 0.1)
    mesh.node_set("clamped", lambda x, y, z: x == 0)
    mesh.node_set("tip", lambda x, y, z: x == 10)
    return mesh


@case()
def static_rollup(bench, n=20):
    run = bench.run("static_rollup", strip_mesh(n))
    half = int(np.argmin(np.abs(run["Time"] - 0.5)))
    return [Check("tip along the strip, full circle", -10.0, run["tip_x"][-1], 0.01),
            Check("tip across the strip, full circle", 0.0, run["tip_z"][-1], 0.1, 1.0),
            Check("tip across the strip, half circle", 20 / math.pi, abs(run["tip_z"][half]), 0.01),
            Check("bending energy", 0.5 * 1e4 * 10 * (2 * math.pi / 10)**2, run["internal_energy"][-1], 0.01),
            energy_check(run, ["internal_energy"])]


@case()
def static_plastic_bar(bench):
    mesh = brick("bar", (1, 0.2, 0.2), (5, 1, 1), {
        "on_x": lambda x, y, z: x == 0, "on_y": lambda x, y, z: y == 0, "on_z": lambda x, y, z: z == 0,
        "pulled": lambda x, y, z: x == 1})
    run = bench.run("static_plastic_bar", mesh)
    modulus, hardening, yield_stress = 200e9, 2e9, 400e6
    pulled = (yield_stress + hardening * 0.01) / (1 + hardening / modulus)
    return [Check("stress at 1 %", pulled, run["stress"][10], 1e-3),
            Check("stress at 0.9 % on the way back", pulled - 0.001 * modulus, run["stress"][20], 1e-3, pulled),
            energy_check(run, ["external_energy"])]


def arch_mesh(n):
    """A quarter of a circle of shells, from its foot on the x axis to its tip on the z axis."""
    mesh = MeshMaker(lambda angle, y, z: (math.cos(angle), y, math.sin(angle)))
    mesh.shells("beam", (0, 0, 0), (math.pi / 2, 0.1), (n, 2), 0.02)
    mesh.node_set("clamped", lambda angle, y, z: angle == 0)
    return mesh


@case()
def preload(bench, n=4):
    checks = []
    for section in ("solid", "plastic", "shell"):
        run = bench.run("preload", arch_mesh(4 * n) if section == "shell" else cantilever_mesh(n), section=section)
        time, kinetic = run["Time"], run["kinetic_energy"]
        held = (time >= 1) & (time <= 1.001)
        checks += [at_most(f"{section}: kinetic over strain energy after the preload",
                           np.max(kinetic[held]) / run["internal_energy"][held][0], 1e-8),
                   Check(f"{section}: energy balance", 0.0, np.max(np.abs(run["energy_error"][time > 1])), 1e-4,
                         np.max(run["internal_energy"]))]
        if section == "solid":
            exact = 1.875104 ** 2 / (2 * math.pi) * math.sqrt(200e9 / 7800 * 0.05 ** 2 / 12)
            swings = time > 1.001
            checks += [Check("steps at rest, 100 at least", 100, min(np.sum(held), 100), 0.0),
                       Check("frequency after the release [Hz]", exact, frequency_of(time[swings], run["tip"][swings]),
                             0.03),
                       Check("kinetic energy there, over the strain energy before", 1.0,
                             np.max(kinetic[swings]) / run["internal_energy"][held][0], 0.02)]
    return checks


def breaking_mesh():
    mesh = MeshMaker()
    for name in ("first", "second", "third"):
        mesh.lines(name, (0, 0, 0), (1, 0, 0), 1)
    mesh.lines("grip", (1, 0, 0), (2, 0, 0), 1)
    mesh.lines("bar", (0, 1, 0), (1, 1, 0), 1)
    mesh.lines("neck", (1, 1, 0), (2, 1, 0), 1)
    mesh.node_set("held", lambda x, y, z: x == 0)
    mesh.node_set("pulled", lambda x, y, z: x == 2 and y == 0)
    mesh.node_set("end_of_chain", lambda x, y, z: x == 2 and y == 1)
    return mesh


@case()
def static_breaking(bench):
    checks = []
    stiffness = 1e9 * 1e-4
    for control, living in ((1, [3, 3, 3, 3, 1, 1, 1]), (0, [3, 3, 3, 3, 3, 2, 1])):
        run = bench.run("static_breaking", breaking_mesh(), control=control)
        word = "with" if control else "without"
        for step, n in enumerate(living[3:], 4):
            force = stiffness * run["Time"][step] * 1e-3 * n / (n + 1)
            checks.append(Check(f"{word} CONTROL FAILURE, force in step {step} [N]", force, run["force"][step], 1e-3))
        checks += [Check(f"{word} CONTROL FAILURE, dead elements", 3 if control else 4, run["dead_elements"][-1], 0),
                   at_most(f"{word} CONTROL FAILURE, force of the broken chain [N]", abs(run["chain_force"][-1]), 1e-6),
                   Check(f"{word} CONTROL FAILURE, energy balance", 0.0, np.max(np.abs(run["energy_error"])), 1e-6,
                         np.max(run["internal_energy"]))]
    return checks
