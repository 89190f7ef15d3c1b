# SPDX-License-Identifier: BSD-3-Clause
"""Ten-node tetrahedra and cohesive elements."""
import numpy as np

from cases import FORMULATIONS, balances, case
from cases_enforcement import held_force, two_columns
from cases_solids import cantilever_mesh, energy_check, frequency
from mesh_maker import MeshMaker
from runs import Check, at_most


def split(mesh, n_nodes=10):
    mesh.split_hexes(n_nodes)
    return mesh


@case(refined=[1, 2, 4])
def ten_node_cantilever(bench, n=2):
    """As stiff when nearly incompressible."""
    exact = 1.875104 ** 2 / (2 * np.pi) * np.sqrt(200e9 / 7800 * 0.05 ** 2 / 12)
    checks, runs = [], []
    for nu in (0.0, 0.499):
        runs.append(bench.run("cantilever", split(cantilever_mesh(n)), formulation="composite_tet", nu=nu))
        checks.append(Check(f"Poisson's ratio {nu}: frequency [Hz]", exact, frequency(runs[-1]), 0.03))
    return checks + [energy_check(run, ["kinetic_energy"]) for run in runs]


@case()
def ten_node_columns(bench):
    """Contact and ties by the facets of six-node faces."""
    checks, runs = [], []
    for form in FORMULATIONS:
        for law, below, above, across in (("frictionless", 1, 1, (1, 1)), ("frictionless", 2, 3, (1, 2)), ("tied", 1, 2, (2, 1))):
            runs.append(bench.run("columns", split(two_columns(below, above, across)), form=form, law=law))
            checks.append(Check(f"{form}, {law}, {below} and {above} layers: force over E A strain", 1.0,
                                held_force(runs[-1]) / 1e5, 0.02))
        runs.append(bench.run("columns", split(two_columns(1, 1, (1, 1))), form=form, enforcement="penalty"))
        checks.append(Check(f"{form}, penalty: force over E A strain", 1.0, held_force(runs[-1]) / 1e5, 0.1, known_miss=0.22))
    return checks + balances(runs)


def cubes_with_joint():
    mesh = MeshMaker()
    mesh.hexes("below", (0, 0, 0), (0.1, 0.1, 0.1), (1, 1, 1))
    lower = mesh.blocks[-1][2][0]
    mesh.new_body()
    mesh.hexes("above", (0, 0, 0.1), (0.1, 0.1, 0.1), (1, 1, 1))
    mesh.joint("joint", lower, mesh.blocks[-1][2][0])
    mesh.node_set("bottom", lambda x, y, z: z < 1e-9)
    mesh.node_set("top", lambda x, y, z: z > 0.2 - 1e-9)
    return mesh


@case()
def cohesive_pull(bench):
    checks, runs = [], []
    for mode, traction, peak in (("open", "normal", 1e6), ("slide", "tangential", 0.5e6)):
        run = bench.run("cohesive_pull", cubes_with_joint(), mode=mode)
        runs.append(run)
        checks += [Check(f"{mode}: largest traction [Pa]", peak, np.max(run[traction]), 0.01),
                   Check(f"{mode}: energy of the failed joint [J]", 0.725, np.max(run["dissipated"]), 0.01),
                   Check(f"{mode}: life of the joint at the end", 0.0, run["life"][-1], 1e-12, 1.0)]
    checks.append(Check("open: stress of the press [Pa]", -200e9 * 2e-5 / 0.2,
                        np.mean(runs[0]["stress"][runs[0]["Time"] > 8.2e-3]), 0.02))
    return checks + balances(runs)


def two_cubes_of_one_block(is_split):
    mesh = MeshMaker()
    mesh.hexes("bar", (0, 0, 0), (1, 1, 1), (2, 2, 2))
    mesh.new_body()
    mesh.hexes("bar", (1.05, 0.1, 0.13), (1, 1, 1), (3, 3, 3))
    if is_split:
        mesh.split_hexes(10)
    mesh.node_set("left", lambda x, y, z: x < 1.02)
    mesh.node_set("right", lambda x, y, z: x > 1.02)
    return mesh


@case()
def self_contact(bench):
    checks = []
    for form in ("face_face", "node_face"):
        for enforcement in ("momentum_balance", "penalty"):
            for is_split in (False, True):
                run = bench.run("self_contact", two_cubes_of_one_block(is_split), form=form, enforcement=enforcement)
                label = f"{form}, {enforcement}, {'TET10' if is_split else 'HEX8'}"
                checks += [at_most(f"{label}: deepest penetration", np.max(run["contact_penetration_max"]), 0.005),
                           at_most(f"{label}: momentum", np.max(np.abs(run["momentum_x"])), 1e-9 * 500),
                           Check(f"{label}: they part", 1.0, float(run["vr"][-1] > 0.2 and run["vl"][-1] < -0.2), 0)]
    return checks
