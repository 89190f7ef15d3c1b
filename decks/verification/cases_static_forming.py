# SPDX-License-Identifier: BSD-3-Clause
"""Load steps in which contact moves over many faces: indentation and ironing."""
import math

import numpy as np

from cases import balances, case
from cases_hertz import graded
from cases_static_bodies import SECTOR, near, on_sector
from mesh_maker import MeshMaker
from runs import Check, at_most

TIP = 0.02  # of the sector's radius there [mm]


def cone_on_block(size):
    """Even elements up to 1.6 mm from the axis and 0.8 mm below, larger ones behind."""
    across = TIP + graded(size, round(1.6 / size), round(1.6 / size) + 20, 12.0 - TIP)
    down = graded(size, round(0.8 / size), round(0.8 / size) + 22, 12.0)
    slope = math.tan(math.radians(90 - 70.3))
    mesh = MeshMaker(lambda i, j, k: on_sector(TIP + 0.2 * i, j, 0.2 * i * slope + 0.3 * k))
    mesh.hexes("cone", (0, 0, 0), (12, 1, 1), (12, 1, 1))
    mesh.new_body()
    mesh.place = lambda i, j, k: on_sector(across[round(i)], j, -down[len(down) - 1 - round(k)])
    cells = (len(across) - 1, 1, len(down) - 1)
    mesh.hexes("base", (0, 0, 0), cells, cells)
    of_base = np.arange(len(mesh.points)) >= 52

    def mark(name, is_in):
        mesh.node_set_where(name, lambda x, y, z: of_base & is_in(x, y, z))
    mark("first_plane", lambda x, y, z: near(y, 0))
    mark("second_plane", lambda x, y, z: near(np.arctan2(y, x), SECTOR))
    mark("axis", lambda x, y, z: near(np.hypot(x, y), TIP))
    mark("bottom", lambda x, y, z: near(z, -12))
    mesh.side_set("seat", mesh.sides_where("base", lambda x, y, z: near(z, 0)))
    return mesh


@case()
def static_cone(bench):
    """code_aster SSNA111."""
    run = bench.run("static_cone", cone_on_block(0.05))
    base, pressed = run.nodes_of(2), run.nodal("force_contact")
    moved = run.nodal("displacement")
    tip = base[np.argmin(np.sum((run.start[base] - (TIP, 0, 0)) ** 2, axis=1))]
    force = np.sum(pressed[:, run.nodes_of(1), 2], axis=1) * 2 * math.pi / SECTOR

    def at(values, time):
        return np.interp(time, run.times, values)
    deepest = np.argmax(force)
    touching = base[np.linalg.norm(pressed[deepest, base], axis=1) > 1e-3 * np.max(pressed[deepest])]
    radius = np.max(np.linalg.norm((run.start + moved[deepest])[touching, :2], axis=1))
    stiffness = 2 * 200e3 / (1 - 0.3 ** 2) * radius
    return [Check("way of the tip at half of the time [mm]", -0.25, at(moved[:, tip, 2], 0.5), 0.01),
            Check("way of the tip at the end [mm]", -0.392, at(moved[:, tip, 2], 1.0), 0.01),
            Check("force at 0.4 mm over that at 0.25 mm", (0.4 / 0.25) ** 2, at(force, 0.8) / at(force, 0.5), 0.03),
            Check("fall of the force by 0.008 mm, over that of an elastic one", 1.05,
                  (at(force, 0.8) - at(force, 1.0)) / (0.008 * stiffness), 0.06), *balances([run])]


def on_slab(n, cells, size, place, top):
    """Half of the slab, n elements high and wide, and of a die, both from the middle plane y = 0."""
    mesh = MeshMaker()
    mesh.hexes("slab", (0, 0, -2), (7, 2, 2), (round(7 * n / 2), n, n))
    mesh.new_body()
    mesh.place = place
    mesh.hexes("die", (-0.5 * size[0], 0, 0), (*size, 1), cells)
    mesh.node_set_where("middle", lambda x, y, z: near(y, 0))
    mesh.node_set_where("bottom", lambda x, y, z: near(z, -2))
    mesh.node_set_where("top", lambda x, y, z: near(z, top))
    return mesh


def die_on_slab(n, width=2.3):
    """A segment of a cylinder."""
    radius, half = 3.0, math.radians(30)

    def place(turn, y, share):
        low = radius * (1 - math.cos(turn))
        return 2.25 + radius * math.sin(turn), y, low + share * (1.2 - low)
    cells = (round(1.6 * n), round(0.9 * n * width / 2.3), max(2, n // 2))
    return on_slab(n, cells, (2 * half, width), place, 1.2)


def wedge_on_slab(n, degrees):
    """A wedge whose flanks rise by so many degrees."""
    slope = math.tan(math.radians(degrees))

    def place(along, y, share):
        low = abs(along) * slope
        return 2.25 + along, y, low + share * (1.6 - low)
    return on_slab(n, (4, round(0.9 * n), 3), (2 / slope, 2.3), place, 1.6)


@case(is_long=True)
def static_ironing(bench):
    """Forces by mesh and step."""
    def slide(n, steps):
        run = bench.run("static_ironing", die_on_slab(n), steps=steps)
        late = run["Time"] > 1.5
        return run, {"z": run["pressed"][late], "x": run["drawn"][late]}
    (fine_run, fine), (run, forces), (small_run, small) = (slide(*key) for key in ((6, 10), (5, 10), (5, 20)))
    checks = []
    for name, values in forces.items():
        mean = np.mean(fine[name])
        checks += [Check(f"force along {name}, of a mesh of 5 for 6", mean, np.mean(values), 0.03),
                   Check(f"force along {name}, of steps half as large", np.mean(values), np.mean(small[name]), 0.03),
                   at_most(f"force along {name}, change from face to face", np.ptp(fine[name]) / abs(mean), 0.03)]
    return checks + balances([fine_run, run, small_run], has_friction=True)


@case()
def static_sharp_die(bench):
    """A die with a sharp edge along a line of nodes of the slab, and half an element beside it."""
    checks, runs = [], []
    for steps, width in ((10, 1.0), (20, 1.0), (10, 1.25)):
        runs.append(bench.run("static_ironing", die_on_slab(4, width), steps=steps))
    late = [run["pressed"][run["Time"] > 1.5] for run in runs]
    mean = np.mean(late[0])
    checks += [Check("force along z, of steps half as large", mean, np.mean(late[1]), 0.03),
               at_most("force along z, change from face to face", np.ptp(late[0]) / mean, 0.05),
               Check("force along z over the width, of an edge between nodes", mean, np.mean(late[2]) / 1.25, 0.2)]
    for degrees in (45, 60):
        wedge, small = (bench.run("static_ironing", wedge_on_slab(4, degrees), steps=steps, way=0) for steps in (10, 20))
        runs += [wedge, small]
        checks.append(Check(f"force on a wedge of {degrees} degrees, of steps half as large", wedge["pressed"][-1],
                            small["pressed"][-1], 0.03))
    return checks + balances(runs, has_friction=True)
