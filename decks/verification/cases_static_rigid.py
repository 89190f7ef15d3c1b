# SPDX-License-Identifier: BSD-3-Clause
"""Rigid bodies and analytic planes in load steps."""
import itertools
import math

from cases import balances, case
from mesh_maker import MeshMaker
from runs import Check, at_most


def punched(lower=2, size=1.0, tilt=0.0, shares_nodes=False):
    """A punch on a block, turned about y by an angle, which one edge of it touches."""
    mesh = MeshMaker()
    mesh.hexes("lower", (0, 0, 0), (1, 1, 0.5), (lower, lower, 2))
    if not shares_nodes:
        mesh.new_body()
    cosine, sine = math.cos(tilt), math.sin(tilt)

    def place(x, y, z):
        along, up = x - 0.5, z - 0.5
        return 0.5 + cosine * along + sine * up, y, 0.5 + 0.5 * size * abs(sine) - sine * along + cosine * up

    if tilt:
        mesh.place = place
    mesh.hexes("punch", (0.5 - 0.5 * size, 0.5 - 0.5 * size, 0.5), (size, size, 0.5), (2, 2, 2))
    mesh.node_set("on_x", lambda x, y, z: x == 0 and z < 0.5)
    mesh.node_set("on_y", lambda x, y, z: y == 0 and z < 0.5)
    mesh.node_set("bottom", lambda x, y, z: z == 0)
    return mesh


@case()
def static_rigid(bench):
    checks, runs = [], []
    force = -1e6 * math.log(1 - 0.02)
    # Ties are springs, which give way by 1.5 % of what the block does.
    give, at_nodes = 1.6e-2, 1e-4
    for join, search in itertools.product(("nodes", "tied", "contact"), ("newton", "cg")):
        mesh = punched(shares_nodes=join == "nodes")
        driven = bench.run("static_rigid", mesh, join=join, search=search)
        bar = give if join == "tied" else at_nodes
        checks += [Check(f"{join}, {search}, lowered: force", force, driven["force"][-1], bar),
                   Check(f"{join}, {search}, lowered: reaction on the body", -force, driven["reactz_punch_body"][-1], bar)]
        if join == "nodes":  # whose masses are the body's too
            continue
        pressed = bench.run("static_rigid", mesh, join=join, search=search, load="weight")
        checks += [Check(f"{join}, {search}, pressed: force", force, pressed["force"][-1], at_nodes),
                   Check(f"{join}, {search}, pressed: way", -0.01, pressed["displz_punch_body"][-1], bar)]
        runs += [driven, pressed]
    return checks + balances(runs)


@case()
def static_tilted_punch(bench):
    """Tilted, a punch comes to rest as the same one does that lies flat at the start."""
    checks, runs = [], []
    flat = bench.run("static_rigid", punched(4, 0.6), load="free")
    weight = 0.36 * 20202.7073175
    for tilt in (0.02, 0.1):
        run = bench.run("static_rigid", punched(4, 0.6, tilt), load="free")
        runs.append(run)
        checks += [Check(f"tilt of {tilt}: force", weight, run["force"][-1], 1e-4),
                   Check(f"tilt of {tilt}: way of turning", -tilt, run["rotdy_punch_body"][-1] - flat["rotdy_punch_body"][-1],
                         1e-3)]
    return checks + balances(runs, has_friction=True, tolerance=0.1)


def cube(n):
    mesh = MeshMaker()
    mesh.hexes("cube", (0, 0, 0), (1, 1, 1), (n, n, n))
    mesh.node_set("bottom", lambda x, y, z: z == 0)
    return mesh


@case()
def static_plane(bench):
    checks, runs = [], []
    for search in ("newton", "cg"):
        runs.append(bench.run("static_plane", cube(3), search=search))
        checks.append(Check(f"{search}: force on the cube", 1e6 * math.log(1 - 0.01), runs[-1]["force"][-1], 1e-4))
    for slope in (0.0, 0.02):
        run = bench.run("static_plane", cube(2), body="rigid", slope=slope, gap=0.1)
        checks += [Check(f"slope of {slope}: force on the rigid cube", 1e4, run["force"][-1], 1e-4),
                   Check(f"slope of {slope}: turn of the rigid cube", slope, run["rotdy_brick"][-1], 1e-3, 1.0)]
        if slope == 0.0:
            checks.append(Check("way over the gap", -0.1, run["displz_brick"][-1], 1e-4))
    return checks + [at_most("energy that appears over the work", max(abs(run["energy_error"][-1]) / 100 for run in runs), 1e-3)]
