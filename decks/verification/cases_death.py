# SPDX-License-Identifier: BSD-3-Clause
"""Elements that die, and surfaces that follow."""
import numpy as np

from cases import balances, case, energy_share
from mesh_maker import MeshMaker
from runs import Check, at_most


def joined_bar():
    """Two blocks of 3 x 2 x 2 cells that meet at x = 3; joint: the tops beside the joint."""
    mesh = MeshMaker()
    mesh.hexes("block_1", (0, 0, 0), (3, 2, 2), (3, 2, 2))
    mesh.hexes("block_2", (3, 0, 0), (3, 2, 2), (3, 2, 2))
    mesh.side_set("joint", [(9, 6), (12, 6), (19, 6), (22, 6)])
    return mesh


def holed_plate():
    """7 x 3 x 1 cells; the second block, apart, has one."""
    mesh = MeshMaker()
    mesh.hexes("block_1", (0, 0, 0), (7, 3, 1), (7, 3, 1))
    mesh.new_body()
    mesh.hexes("block_2", (0, 0, 9), (1, 1, 1), (1, 1, 1))
    mesh.side_set("joint", [(22, 6)])
    return mesh


def clad_brick():
    """4 x 2 x 2 cells, 2 x 2 shells on the half of the top with x < 2."""
    mesh = MeshMaker()
    mesh.hexes("block_1", (0, 0, 0), (4, 2, 2), (4, 2, 2))
    mesh.shells("block_2", (0, 0, 2), (2, 2), (2, 2), None)
    return mesh


def owned(log, surface, column=0):
    """Faces owned by a surface in the last table of its log, or another column: 3 is lofted elements."""
    rows = [line.split() for line in log.splitlines()]
    rows = [row for row in rows if len(row) > 9 and row[1] == surface and row[2:4] == ["CONTACT", "SURFACE"]]
    return int(rows[-1][6 + column])


def count_checks(label, log, expected):
    return [Check(f"{label}: faces of {name}", n, owned(log, name), 1e-12, max(n, 1)) for name, n in expected.items()]


@case()
def figure_deaths(bench):
    checks, runs = [], []
    for label, mesh, order, dead, before, after in (
            ("side set first", joined_bar, 1, "9", dict(c3=4, c1=26, c2=26), dict(c3=3, c1=28, c2=27)),
            ("side set between", joined_bar, 2, "9", dict(c1=28, c3=2, c2=26), dict(c1=29, c3=2, c2=27)),
            ("side set peeled", joined_bar, 1, "9 12 19 22", dict(c3=4, c1=26, c2=26), dict(c3=0, c1=28, c2=28)),
            ("side set alone", joined_bar, 3, "9", dict(c3=4), dict(c3=3)),
            ("hole", holed_plate, 1, "11", dict(c1=62, c2=5), dict(c1=64, c2=5))):
        run = bench.run("figure_deaths", mesh(), order=order, dead=dead, frame=1e-4)
        start, end = run.log.split("Element death at step", 1)
        checks += count_checks(f"{label}, before", start, before) + count_checks(f"{label}, after", end, after)
        runs.append(run)
    forces = max(np.max(np.abs(run.nodal("force_contact"))) for run in runs)
    return checks + [at_most("contact force [N]", forces, 1e-300)]


@case()
def figure_shells(bench):
    checks = []
    for order in (1, 2):
        for label, dead, before, after in (("dead shell", "17", (36, 4), (37, 3)), ("dead solid", "9", (36, 4), (37, 4))):
            run = bench.run("figure_shells", clad_brick(), order=order, dead=dead, frame=1e-4)
            start, end = run.log.split("Element death at step", 1)
            for when, log, (n_faces, n_lofted) in (("before", start, before), ("after", end, after)):
                checks += count_checks(f"{label}, order {order}, {when}", log, dict(c1=n_faces))
                checks.append(Check(f"{label}, order {order}, {when}: lofted", n_lofted, owned(log, "c2", 3), 1e-12))
    return checks


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
