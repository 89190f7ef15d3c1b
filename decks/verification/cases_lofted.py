# SPDX-License-Identifier: BSD-3-Clause
"""Shells in contact, by the bricks that are lofted around them."""
import math

import numpy as np

from cases import FORMULATIONS, angular_momentum, balances, case
from cases_rods import rod_checks, turned
from mesh_maker import MeshMaker
from runs import Check, at_most
from shapes import add_box


def sheet_over_block(is_turned, side, n):
    mesh = MeshMaker(lambda x, y, z: (-x, y, z)) if is_turned else MeshMaker()
    mesh.shells("sheet", (-0.5, -0.5, 0.05), (1, 1), (5, 5), 0.1)
    mesh.new_body()
    mesh.place = lambda x, y, z: (x, y, z)
    mesh.hexes("block", (-0.5 * side, -0.5 * side, -0.5), (side, side, 0.5), (n, n, 1))
    return mesh


@case()
def shell_on_block(bench):
    checks, runs = [], []
    weight = 7800 * 0.1 * 9.81
    wide, alike = (1.5, 6), (1, 5)
    for is_turned, form, block in ((False, "face_face", wide), (True, "face_face", wide), (False, "node_face", alike)):
        run = bench.run("shell_on_block", sheet_over_block(is_turned, *block), form=form)
        runs.append(run)
        late = run["Time"] > 0.12
        height = np.mean(run["height"][late])
        label = f"{form}, upside down" if is_turned else form
        checks += [Check(f"{label}: height of the middle [m]", 0.05, height, 1e-3, 1.0),
                   Check(f"{label}: depth [m]", weight / 3e7, 0.05 - height, 0.01),
                   Check(f"{label}: weight [N]", weight, np.mean(run["force"][late]), 0.001)]
    return checks + balances(runs)


@case()
def sliding_shell(bench):
    checks, runs = [], []
    for form in FORMULATIONS:
        run = bench.run("shell_on_block", sheet_over_block(False, 1.5, 6), form=form, speed=1, end_time=0.3)
        runs.append(run)
        checks += [Check(f"{form}: way to the stop [m]", 1 / 9.81, run["way"][-1], 0.01),
                   Check(f"{form}: energy lost to friction [J]", 390, run["friction_energy"][-1], 0.01)]
    return checks + balances(runs, has_friction=True)


def sheet_on(base):
    mesh = MeshMaker()
    mesh.shells("sheet", (-0.5, -0.5, 0.02), (1, 1), (5, 5), 0.02)
    mesh.new_body()
    if base == "sheet":
        mesh.shells("base", (-0.5, -0.5, 0), (1, 1), (4, 4), 0.02)
    else:
        mesh.hexes("base", (-0.5, -0.5, -0.19), (1, 1, 0.2), (4, 4, 2))
    return mesh


@case()
def tied_shell(bench):
    checks, runs = [], []
    for form, base in (("face_face", "block"), ("face_face", "sheet"), ("node_face", "block")):
        run = bench.run("tied_shell", sheet_on(base), form=form, base=base)
        runs.append(run)
        place, mass = run.nodal("coordinates"), run.nodal("mass")[0]
        middles = [np.average(place[:, n], axis=1, weights=mass[n]) for n in map(run.nodes_of, (1, 2))]
        apart = np.linalg.norm(middles[0] - middles[1], axis=1)
        momentum = angular_momentum(run)
        change = np.max(np.linalg.norm(momentum - momentum[0], axis=1)) / np.linalg.norm(momentum[0])
        label = f"{form}, on a {base}"
        checks += [at_most(f"{label}: change of the distance of the middles over the thickness",
                           np.max(np.abs(apart - apart[0])) / 0.02, 1e-3),
                   at_most(f"{label}: largest energy of contact over kinetic energy",
                           np.max(np.abs(run["contact_energy"])) / run["kinetic_energy"][0], 1e-5),
                   at_most(f"{label}: change of angular momentum", change, 1e-10)]
    return checks + balances(runs, is_free=True)


def lowered(base, top):
    """Something whose half height is 0.05 lies 0.02 deep in a block, or a sheet 0.1 thick, whose top is at z = 0."""
    mesh = MeshMaker()
    if base == "sheet":
        mesh.shells("base", (0, 0, -0.05), (1, 1), (4, 4), None)
    else:
        mesh.hexes("base", (0, 0, -1), (1, 1, 1), (4, 4, 2))
    mesh.new_body()
    if top == "sheet":
        mesh.shells("top", (0, 0, 0.03), (1, 1), (4, 4), None)
    elif top == "rod":
        mesh.lines("top", (0.1, 0.4, 0.03), (0.9, 0.6, 0.03), 3)
    else:
        mesh.particles("top", [(0.3, 0.4, 0.03), (0.7, 0.6, 0.03)])
    return mesh


@case()
def overlap_of_lofts(bench):
    checks = []
    for base, top, way in (("solid", "sheet", 0.01), ("sheet", "sheet", 0.01), ("solid", "rod", 0.02),
                           ("sheet", "rod", 0.02), ("solid", "ball", 0.02), ("sheet", "ball", 0.02)):
        mesh = lowered(base, top)
        at = np.array(mesh.points)
        runs = [bench.run("overlap_of_lofts", mesh, base=base, top=top, form=form) for form in FORMULATIONS]
        expected = at.copy()
        expected[runs[0].nodes_of(2), 2] += way
        under = runs[0].nodes_of(1)
        expected[under[at[under, 2] > -0.1], 2] -= 0.02 - way
        astray = max(np.max(np.abs(run.nodal("coordinates") - expected)) for run in runs)
        energy = max(np.max(np.abs(run["contact_energy"])) for run in runs)
        force = max(np.max(np.abs(run.nodal("force_contact"))) for run in runs)
        checks += [at_most(f"{top} in {base}: farthest from where it should be [m]", astray, 1e-8),
                   at_most(f"{top} in {base}: largest contact energy [J]", energy, 1e-9),
                   at_most(f"{top} in {base}: largest force [N]", force, 1e-6)]
    return checks


def sheets_in_line(n_a, n_b, across_a, across_b, gap=0.0):
    """Two strips of shells, each 0.1 x 0.01, one end against the other's."""
    mesh = MeshMaker()
    mesh.shells("rod_a", (0, 0, 0), (0.1, 0.01), (n_a, across_a), 0.01)
    mesh.new_body()
    mesh.shells("rod_b", (0.1 + gap, 0, 0), (0.1, 0.01), (n_b, across_b), 0.01)
    return mesh


@case()
def shells_edge_on_edge(bench):
    checks, runs = [], []
    for label, cells, form in (("alike", (50, 50, 1, 1), "face_face"), ("unmatched", (50, 77, 2, 3), "face_face"),
                               ("alike, node_face", (50, 50, 1, 1), "node_face")):
        runs.append(bench.run("two_rods", sheets_in_line(*cells), form=form, thickness=0.01))
        checks += rod_checks(label, runs[-1])
    return checks + balances(runs, is_free=True)


def block_over_sheet(thickness):
    mesh = MeshMaker()
    mesh.hexes("block", (0, 0, 1e-4), (5e-3, 5e-3, 5e-3), (4, 4, 4))
    mesh.new_body()
    mesh.shells("plate", (-2e-3, -2e-3, -0.5 * thickness), (9e-3, 9e-3), (9, 9), thickness)
    return mesh


@case()
def fast_plate(bench):
    """Thrown at, and flying; at the higher speed it moves by more than half its thickness in a step, which a node
    may be deep before it is noticed: by chance of where the steps end."""
    checks, runs = [], []
    for form in FORMULATIONS:
        for label, t, kind in (("thrown at", 5e-4, {}), ("flying", 5e-4, dict(flier="plate", target="block", speed=300)),
                               ("faster", 2.5e-4, dict(flier="plate", target="block", speed=900))):
            run = bench.run("fast_block", block_over_sheet(t), form=form, thickness=t, **kind)
            runs.append(run)
            place, under = run.nodal("coordinates")[..., 2], run.nodes_of(2)
            under = under[np.all(np.abs(run.start[under, :2] - 2.5e-3) < 2.5e-3, axis=1)]
            gap = np.min(place[:, run.nodes_of(1)], axis=1) - np.max(place[:, under], axis=1)
            depth = 0.5 - np.min(gap) / t
            checks.append(at_most(f"{form}, {label}: depth over the plate's thickness", max(0.0, depth), 0.9 if label == "faster" else 0.5))
    return checks + balances(runs)


def stack(n_lower, n_sheet, n_upper, overhang=0.1):
    """Blocks of 0.2 x 0.2 x 0.1 and a sheet of 0.02 between them that sticks out."""
    mesh = MeshMaker()
    mesh.hexes("lower", (-0.1, -0.1, -0.11), (0.2, 0.2, 0.1), (n_lower, n_lower, 4))
    mesh.new_body()
    side = 0.2 + 2 * overhang
    mesh.shells("sheet", (-0.5 * side, -0.5 * side, 0), (side, side), (n_sheet, n_sheet), 0.02)
    mesh.new_body()
    mesh.hexes("upper", (-0.1, -0.1, 0.01), (0.2, 0.2, 0.1), (n_upper, n_upper, 4))
    mesh.node_set("bottom", lambda x, y, z: z < -0.109)
    mesh.node_set("top", lambda x, y, z: z > 0.109)
    return mesh


@case()
def pinched_shell(bench):
    checks, runs = [], []
    for form, mesh in (("face_face", stack(4, 7, 5)), ("node_face", stack(4, 4, 4, 0.0))):
        run = bench.run("pinched_shell", mesh, form=form)
        runs.append(run)
        late, force = run["Time"] > 2e-3, 0.04 * 2e-5 / (0.2 / 200e9 + 2 / 1e13)
        sheet = run.nodes_of(2)
        left, moment = [np.max(np.linalg.norm(run.nodal(name)[-1, sheet], axis=1))
                        for name in ("force_contact", "moment_contact")]
        moved = np.max(np.abs(run.nodal("displacement")[-1, sheet]))
        checks += [Check(f"{form}: force above [N]", force, np.mean(run["force"][late]), 0.001),
                   Check(f"{form}: force below [N]", -force, np.mean(run["force_below"][late]), 0.001),
                   at_most(f"{form}: largest force on a node of the shell over that", left / force, 1e-3),
                   at_most(f"{form}: largest moment on one over force times thickness", moment / force / 0.02, 1e-3),
                   at_most(f"{form}: displacement of the shell over that of the ends", moved / 1e-5, 1e-3)]
    return checks + balances(runs)


def hairpin_sheet(n_leg, n_bend, thickness):
    """Two legs of length 4, their middles apart by 2, and the half circle that joins them."""
    def place(s, z, _):
        if s < 4:
            return s, -1.0, z
        if s > 4 + math.pi:
            return 8 + math.pi - s, 1.0, z
        return 4 + math.cos(s - 4 - math.pi / 2), math.sin(s - 4 - math.pi / 2), z

    mesh = MeshMaker(place)
    mesh.shells("strip", (0, 0, 0), (4, 1), (n_leg, 2), thickness)
    mesh.shells("strip", (4, 0, 0), (math.pi, 1), (n_bend, 2), thickness)
    mesh.shells("strip", (4 + math.pi, 0, 0), (4, 1), (n_leg, 2), thickness)
    mesh.node_set("lower", lambda s, z, _: s < 4)
    mesh.node_set("upper", lambda s, z, _: s > 4 + math.pi)
    return mesh


def least_way_between_ends(run):
    end = run.start[:, 0] == 0
    upper, lower = [end & (np.sign(run.start[:, 1]) == side) for side in (1, -1)]
    place = run.nodal("coordinates")[..., 1]
    return np.min(np.min(place[:, upper], axis=1) - np.max(place[:, lower], axis=1))


@case()
def folding_sheet(bench):
    runs = [bench.run("folding_strip", hairpin_sheet(24, 12, 0.3), form=form, thickness=0.3) for form in FORMULATIONS]
    off = bench.run("folding_strip", hairpin_sheet(24, 12, 0.3), self="off", thickness=0.3)
    checks = [at_most(f"{form}: depth over the thickness", 1 - least_way_between_ends(run) / 0.3, 0.33)
              for form, run in zip(FORMULATIONS, runs)]
    checks.append(at_most("legs that do not cross without contact", float(least_way_between_ends(off) > 0), 0))
    return checks + balances(runs, is_free=True)


def over_block(turn, add):
    """A block and above it what add(mesh, place) adds: a body of 0.1 m around the origin, turned, its lowest corner
    3 mm over the block."""
    mesh = MeshMaker()
    mesh.hexes("block", (-0.08, -0.08, -0.04), (0.16, 0.16, 0.04), (7, 7, 2))
    lowest = np.sum(np.abs(turn[2])) * 0.05
    add(mesh, lambda *point: tuple(turn @ point + (0.005, 0.003, lowest + 3e-3)))
    return mesh


def tilted_box_over_block(n):
    return over_block(turned(20, 40) @ turned(40, 25),
                      lambda mesh, place: add_box(mesh, "box", 0.1, n, 2e-3, lambda p: place(*p)))


@case()
def shell_box(bench):
    checks, runs = [], []
    matrix = turned(30, 20)
    for form in FORMULATIONS:
        run = bench.run("shell_box", tilted_box_over_block(6), form=form)
        mesh = tilted_box_over_block(6)
        mesh.transform(matrix)
        again = bench.run("shell_box", mesh, form=form, **{f"v{c}": float(v) for c, v in zip("xyz", matrix @ (0, 0, -20))})
        change = again.nodal("displacement")[-1] - run.nodal("displacement")[-1] @ matrix.T
        momentum, box = angular_momentum(run), run.nodes_of(2)
        scale = np.sum(run.nodal("mass")[0, box]) * 20 * 0.05
        runs += [run, again]
        checks += [at_most(f"{form}: change of angular momentum over that of the flight about the edge of the box",
                           np.max(np.linalg.norm(momentum - momentum[0], axis=1)) / scale, 1e-10),
                   at_most(f"{form}: turned by 30 and 20 degrees: change of displacements",
                           np.max(np.abs(change)) / np.max(np.abs(run.nodal("displacement")[-1])), 1e-6),
                   kept_energy(form, run, known_miss=0.1)]
    return checks + balances(runs, is_free=True)


def kept_energy(label, run, **known):
    """What contact still has after the bodies have parted, or has given out."""
    return at_most(f"{label}: energy of contact afterwards over that of the flight",
                   abs(run["contact_energy"][-1]) / run["kinetic_energy"][0], 0.01, **known)


def tilted_cube_over_block(n, turn):
    def add_cube(mesh, place):
        mesh.new_body()
        mesh.place = place
        mesh.hexes("box", (-0.05, -0.05, -0.05), (0.1, 0.1, 0.1), (n, n, n))
    return over_block(turn, add_cube)


@case()
def solid_corners(bench):
    checks, runs = [], []
    for form in FORMULATIONS:
        for label, turn in (("edge", turned(0, 30)), ("corner", turned(20, 40) @ turned(40, 25))):
            runs.append(bench.run("shell_box", tilted_cube_over_block(6, turn), form=form, solid=1))
            checks.append(kept_energy(f"{form}, {label}", runs[-1], known_miss=0.12))
    return checks + balances(runs)
