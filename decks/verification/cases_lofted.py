# SPDX-License-Identifier: BSD-3-Clause
"""Shells, beams and particles in contact, which have their bodies by lofts."""
import math

import numpy as np

from cases import balances, case
from cases_rods import moved_along, rod_checks, turned
from mesh_maker import MeshMaker
from runs import Check, at_most
from shapes import add_ball, add_quarter_ball, near_zero

BOTH = ("face_face", "node_face")


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
    for is_turned, form, block in ((False, "face_face", (1.5, 6)), (True, "face_face", (1.5, 6)), (False, "node_face", (1, 5))):
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
    for form in BOTH:
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
        missed = 1e-3 if label == "face_face, on a block" else None
        checks += [at_most(f"{label}: change of the distance of the middles over the thickness", np.max(np.abs(apart - apart[0])) / 0.02, 1e-3),
                   at_most(f"{label}: largest energy of contact over kinetic energy",
                           np.max(np.abs(run["contact_energy"])) / run["kinetic_energy"][0], 1e-5, known_miss=missed),
                   at_most(f"{label}: change of angular momentum", change, 1e-10)]
    return checks + balances(runs, is_free=True)


def on_planes(mesh, prefix, nodes):
    """Node sets of the given nodes (from 0) on the symmetry planes x = 0 and y = 0."""
    points = np.array(mesh.points)
    for name, axis in (("on_x", 0), ("on_y", 1)):
        mesh.node_sets.append((prefix + name, [n + 1 for n in nodes if abs(points[n, axis]) < 1e-9]))


def ball_over_plate(side, thickness, n, slope, n_plate):
    """The quarter x, y > 0 of a ball over that of a plate, small elements where they meet."""
    mesh = MeshMaker(lambda x, y, z: (0.5 * side * near_zero(x, 0.5), 0.5 * side * near_zero(y, 0.5), z))
    mesh.shells("plate", (0, 0, 0), (1, 1), (n_plate, n_plate), thickness)
    mesh.node_set("rim", lambda x, y, z: max(x, y) > 1 - 1e-9)
    on_planes(mesh, "plate_", range(len(mesh.points)))
    add_quarter_ball(mesh, "ball", 0.01 + 0.5 * thickness + 1e-9, 0.01, False, n, slope)
    on_planes(mesh, "", range(len(mesh.points)))
    return mesh


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
    """Thrown at, and flying; at the higher speed it moves by more than half its thickness in a step."""
    checks, runs = [], []
    for form in BOTH:
        for label, t, kind in (("thrown at", 5e-4, {}), ("flying", 5e-4, dict(flier="plate", target="block", speed=300)),
                               ("faster", 2.5e-4, dict(flier="plate", target="block", speed=900))):
            run = bench.run("fast_block", block_over_sheet(t), form=form, thickness=t, **kind)
            runs.append(run)
            place, under = run.nodal("coordinates")[..., 2], run.nodes_of(2)
            under = under[np.all(np.abs(run.start[under, :2] - 2.5e-3) < 2.5e-3, axis=1)]
            gap = np.min(place[:, run.nodes_of(1)], axis=1) - np.max(place[:, under], axis=1)
            checks.append(at_most(f"{form}, {label}: depth over the plate's thickness", max(0.0, 0.5 - np.min(gap) / t), 0.5))
    return checks + balances(runs)


def contacts(run):
    """First and last times of contacts that nothing of less than 5 us parts."""
    on = run["Time"][run["force"] > 0]
    parted = np.flatnonzero(np.diff(on) > 5e-6)
    return list(zip(on[np.concatenate([[0], parted + 1])], on[np.concatenate([parted, [-1]])]))


def impact_checks(label, run, expected, tolerance):
    """expected: impulse, largest force, velocity of the rebound of the whole ball."""
    times, force, ball = run["Time"], 4 * run["force"], run.nodes_of(2)
    impulse = np.sum(0.5 * (force[1:] + force[:-1]) * np.diff(times))
    back = np.average(run.nodal("velocity")[-1, ball, 2], weights=run.nodal("mass")[0, ball])
    return [Check(f"{label}: impulse [N s]", expected[0], impulse, tolerance),
            Check(f"{label}: largest force [N]", expected[1], np.max(force), 0.1),
            Check(f"{label}: speed of the rebound [m/s]", expected[2], back, 0.05, 1.0)]


@case(refined=[8, 12])
def ball_on_plate(bench, n=8):
    run = bench.run("ball_on_plate", ball_over_plate(0.2, 0.008, n, 2 / n, 20))
    on = contacts(run)
    return [*impact_checks("8 mm", run, (0.054730, 1385.5, 0.6644), 0.03),
            Check("8 mm: contacts", 1, len(on), 0.0), Check("8 mm: duration [s]", 73.2e-6, on[-1][1] - on[0][0], 0.1),
            *balances([run])]


@case(is_long=True)
def ball_on_thin_plate(bench):
    thick = bench.run("ball_on_plate", ball_over_plate(0.2, 0.008, 12, 0.17, 20), end_time=300e-6)
    thin = bench.run("ball_on_plate", ball_over_plate(0.3, 0.002, 12, 0.17, 30), side=0.3, thickness=0.002, end_time=460e-6)
    on = contacts(thin)
    checks = [*impact_checks("8 mm", thick, (0.054730, 1385.5, 0.6644), 0.03),
              Check("8 mm: way of the plate's middle [m]", 22.09e-6, -np.min(thick["middle"]), 0.1),
              *impact_checks("2 mm", thin, (0.0335, 333.2, 0.020), 0.05), Check("2 mm: contacts", 2, len(on), 0.0)]
    for name, expected, reached in zip(("end of the first", "start of the second", "end of the second"),
                                       (332e-6, 386e-6, 441e-6), (on[0][1], on[-1][0], on[-1][1])):
        checks.append(Check(f"2 mm: {name} contact [s]", expected, reached, 0.05))
    return checks + balances([thick, thin])


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
        left, moment = [np.max(np.linalg.norm(run.nodal(name)[-1, sheet], axis=1)) for name in ("force_contact", "moment_contact")]
        moved = np.max(np.abs(run.nodal("displacement")[-1, sheet]))
        checks += [Check(f"{form}: force above [N]", force, np.mean(run["force"][late]), 0.001),
                   Check(f"{form}: force below [N]", -force, np.mean(run["force_below"][late]), 0.001),
                   at_most(f"{form}: largest force on a node of the shell over that", left / force, 1e-3),
                   at_most(f"{form}: largest moment on a node of the shell over force times thickness", moment / force / 0.02, 1e-3),
                   at_most(f"{form}: displacement of the shell over that of the ends", moved / 1e-5, 1e-3)]
    return checks + balances(runs)


def add_box(mesh, name, side, n, thickness, place=lambda p: p, has_lid=True):
    """The walls of a cube around the origin; `place` maps its coordinates."""
    mesh.new_body()
    for axis in range(3):
        for sign in (-1, 1):
            if (axis, sign) == (2, 1) and not has_lid:
                continue

            def wall(u, v, _, axis=axis, sign=sign):
                spot = np.zeros(3)
                spot[axis], spot[(axis + 1) % 3], spot[(axis + 2) % 3] = sign, *((u, v) if sign > 0 else (v, u))
                return tuple(place(0.5 * side * spot))
            mesh.place = wall
            mesh.shells(name, (-1, -1, 0), (2, 2), (n, n), thickness)


def tilted_box_over_block(n):
    mesh = MeshMaker()
    mesh.hexes("block", (-0.08, -0.08, -0.04), (0.16, 0.16, 0.04), (7, 7, 2))
    turn = turned(20, 0) @ np.array([[1, 0, 0], [0, *turned(35, 0)[0, :2]], [0, *turned(35, 0)[1, :2]]]) @ turned(0, 40)
    lowest = np.max(np.abs(turn[2]).sum()) * 0.05
    add_box(mesh, "box", 0.1, n, 2e-3, lambda p: turn @ p + (0.005, 0.003, lowest + 3e-3))
    return mesh


def angular_momentum(run):
    """[steps x 3], the turning of the nodes included."""
    orbit = run.nodal("mass")[..., None] * np.cross(run.nodal("coordinates"), run.nodal("velocity"))
    spin = run.nodal("rotational_mass")[..., None] * run.nodal("rotational_velocity")
    return np.sum(orbit + spin, axis=1)


@case()
def shell_box(bench):
    checks, runs = [], []
    matrix = turned(30, 20)
    for form in BOTH:
        run = bench.run("shell_box", tilted_box_over_block(6), form=form)
        mesh = tilted_box_over_block(6)
        mesh.transform(matrix)
        again = bench.run("shell_box", mesh, form=form, **{f"v{c}": float(v) for c, v in zip("xyz", matrix @ (0, 0, -20))})
        change = again.nodal("displacement")[-1] - run.nodal("displacement")[-1] @ matrix.T
        momentum, box = angular_momentum(run), run.nodes_of(2)
        scale = np.sum(run.nodal("mass")[0, box]) * 20 * 0.05
        runs += [run, again]
        checks += [at_most(f"{form}: change of angular momentum", np.max(np.linalg.norm(momentum - momentum[0], axis=1)) / scale, 1e-10),
                   at_most(f"{form}: turned by 30 and 20 degrees: change of displacements",
                           np.max(np.abs(change)) / np.max(np.abs(run.nodal("displacement")[-1])), 1e-6)]
    return checks + balances(runs, is_free=True)


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
    runs = [bench.run("folding_strip", hairpin_sheet(24, 12, 0.3), form=form, thickness=0.3) for form in BOTH]
    off = bench.run("folding_strip", hairpin_sheet(24, 12, 0.3), self="off", thickness=0.3)
    checks = [at_most(f"{form}: depth over the thickness", 1 - least_way_between_ends(run) / 0.3, 0.33)
              for form, run in zip(BOTH, runs)]
    checks.append(at_most("legs that do not cross without contact", float(least_way_between_ends(off) > 0), 0))
    return checks + balances(runs, is_free=True)


def crossed_pipes(n_around, n_along):
    """Halves x > 0 of a pipe along x, whole around, and of one along y over it, half around; smaller cells where they meet."""
    radius = 0.5 * (6.625 - 0.432)

    def along(s):
        return 25 * math.copysign(near_zero(abs(s), 0.5), s)
    mesh = MeshMaker(lambda a, s, _: (along(s), radius * math.cos(a), radius * math.sin(a)))
    mesh.shells("held", (0, 0, 0), (2 * math.pi, 1), (n_around, n_along), 0.432)
    mesh.node_set("ends", lambda a, s, _: s == 1)
    mesh.node_set("of_held", lambda a, s, _: s == 0)
    mesh.new_body()
    first = len(mesh.points)
    mesh.place = lambda a, s, _: (radius * math.sin(a), along(s), 6.675 - radius * math.cos(a))
    mesh.shells("whip", (0, -1, 0), (math.pi, 2), (n_around // 2, 2 * n_along), 0.432)
    points = np.array(mesh.points)
    mesh.node_sets.append(("pinned", [n + 1 for n in range(first, len(points)) if points[n, 1] == -25]))
    free = set(range(len(points))) - {n - 1 for n in mesh.node_sets[-1][1]}
    mesh.node_sets[1] = ("on_x", [n + 1 for n in sorted(free) if abs(points[n, 0]) < 1e-9])
    return mesh


def flattening(run, block, length_axis):
    """How much lower the cross-section of a pipe where the pipes meet has become, over its width."""
    nodes = run.nodes_of(block)
    ring = nodes[np.abs(run.start[nodes, length_axis]) < 1e-9]
    height = np.ptp(run.nodal("coordinates")[:, ring, 2], axis=1)
    return 1 - height[-1] / height[0]


@case(is_long=True)
def pipe_whip(bench):
    checks, runs = [], []
    mass, radius = 7.324e-4 * math.pi * 6.193 * 0.432 * 50, 3.0965
    energy = 0.5 * 75 ** 2 * mass * (50 ** 2 / 6 + radius ** 2 / 4)
    for form in BOTH:
        run = bench.run("pipe_whip", crossed_pipes(24, 20), form=form)
        runs.append(run)
        checks += [Check(f"{form}: kinetic energy at the start [in lbf]", energy, run["kinetic_energy"][0], 0.01),
                   at_most(f"{form}: depth over the wall", -np.min(run.nodal("contact_normal_gap")) / 0.432, 0.1),
                   at_most(f"{form}: pipes that are not flattened", sum(flattening(run, b, b - 1) < 0.1 for b in (1, 2)), 0)]
    for name, block in (("held", 1), ("whip", 2)):
        one, other = [flattening(run, block, block - 1) for run in runs]
        checks.append(Check(f"node_face: flattening of the {name} pipe, as with face_face", one, other, 0.05))
    return checks + balances(runs, tolerance=0.03)


def crossed_rods_mesh(radii, angle=90, gap=1e-4, cells=(11, 11), kind="BEAM2", shift=0.0):
    """Rods half a metre long, one above the other; an odd number of cells has them cross between nodes."""
    mesh = MeshMaker()
    level, way = sum(radii) + gap, 0.25 * np.array([math.cos(math.radians(angle)), math.sin(math.radians(angle)), 0])
    mesh.lines("flier", (shift - 0.25, 0, level), (shift + 0.25, 0, level), cells[0], kind)
    mesh.new_body()
    mesh.lines("target", tuple(-way), tuple(way), cells[1], kind)
    return mesh


def angular_change(run, scale):
    momentum = angular_momentum(run)
    return np.max(np.linalg.norm(momentum - momentum[0], axis=1)) / scale


@case()
def crossed_rods(bench):
    checks, runs = [], []
    for label, radii, mesh, variables in (
            ("at 90 degrees", (0.01, 0.015), {}, {}), ("at 60 degrees", (0.01, 0.015), dict(angle=60), {}),
            ("at a node", (0.01, 0.015), dict(cells=(10, 11)), {}), ("alike", (0.01, 0.01), {}, dict(va=-0.5, vb=0.5)),
            ("trusses", (0.01, 0.015), dict(kind="TRUSS"), dict(element="truss")),
            ("turning", (0.01, 0.015), {}, dict(vb=1, turning=500))):
        run = bench.run("crossed_rods", crossed_rods_mesh(radii, **mesh), ra=radii[0], rb=radii[1], **variables)
        runs.append(run)
        first = np.flatnonzero(run["force"])[0]
        apart = run["height"][first] - run["height_below"][first]
        left = run["contact_energy"][-1] - run["friction_energy"][-1]
        checks += [Check(f"{label}: distance of the axes at first touch [m]", sum(radii), apart, 0.01 * radii[0], 1.0),
                   at_most(f"{label}: energy left in contact", left / run["kinetic_energy"][0], 0.02)]
        if label == "alike":
            one, other = [run.nodal("displacement")[:, run.nodes_of(b)] for b in (1, 2)]
            image = other[..., [1, 0, 2]] * (1, 1, -1)
            checks.append(at_most(f"{label}: one less the other's image", np.max(np.abs(one - image)) / np.max(np.abs(one)), 1e-9))
        if label != "turning":
            scale = np.sum(run.nodal("mass")[0, run.nodes_of(1)]) * sum(radii)
            checks.append(at_most(f"{label}: change of angular momentum", angular_change(run, scale), 1e-9))
    return checks + balances(runs[:-1], is_free=True) + balances(runs[-1:], is_free=True, has_friction=True)


@case()
def rods_at_nodes(bench):
    checks, force = [], 1e9 * 0.02 ** 2 * 1e-4
    for label, cells, shift in (("between nodes", (11, 11), 0.0), ("one at a node", (10, 11), 0.0), ("both at nodes", (10, 10), 0.0),
                                ("the lower at a node", (10, 10), 0.02), ("both nearly at nodes", (10, 10), 1e-3)):
        mesh = crossed_rods_mesh((0.01, 0.015), gap=-1e-4, cells=cells, shift=shift)
        run = bench.run("crossed_rods", mesh, penalty=1e9, va=0, end_time=1e-5)
        checks.append(Check(f"{label}: force [N]", force, run["force"][0], 1e-9, known_miss=1.1))
    return checks


def two_balls(radius):
    mesh = MeshMaker()
    mesh.particles("flier", [(0, 0, 0)])
    mesh.particles("target", [(0.01 + radius + 1e-3, 0, 0)])
    return mesh


@case()
def two_particles(bench):
    checks, runs = [], []
    for radius in (0.01, 0.02):
        run = bench.run("two_particles", two_balls(radius), rb=radius)
        runs.append(run)
        one, other = [7800 * 4 / 3 * math.pi * r ** 3 for r in (0.01, radius)]
        times, on = run["Time"], np.flatnonzero(run["force"])
        label = f"radii of 10 and {1e3 * radius:.0f} mm"
        checks += [Check(f"{label}: mass [kg]", one + other, np.sum(run.nodal("mass")[0]), 1e-9),
                   Check(f"{label}: distance at first touch [m]", 0.01 + radius, (run["x_target"] - run["x_flier"])[on[0]], 1e-4, 1.0),
                   Check(f"{label}: time in contact [s]", math.pi * math.sqrt(one * other / (one + other) / (1e9 * 0.02 ** 2)),
                         times[on[-1]] - times[on[0]], 0.01),
                   Check(f"{label}: velocity of the striking one [m/s]", (one - other) / (one + other), run["v_flier"][-1], 0.01, 1.0),
                   Check(f"{label}: velocity of the struck one [m/s]", 2 * one / (one + other), run["v_target"][-1], 0.01)]
    return checks + balances(runs, is_free=True)


def balls_in_box():
    """Balls of 10 mm nowhere touching in a box of 50 mm inside, 80 mm wide outside of its middle planes by a wall of 2 mm."""
    mesh, chance = MeshMaker(), np.random.default_rng(4)
    cells = [np.array([i % 4, i // 4 % 4, i // 16]) for i in range(64)]
    mesh.particles("grains", [0.0065 + 0.0122 * cell + (0, 0, 0.003 * cell[2]) + chance.uniform(-3e-4, 3e-4, 3) for cell in cells])
    add_box(mesh, "box", 0.052, 6, 2e-3, lambda p: p + (0.025, 0.025, 0.025), has_lid=False)
    return mesh


@case()
def box_of_particles(bench):
    run = bench.run("box_of_particles", balls_in_box())
    grains = run.nodes_of(1)
    place, mass = run.nodal("coordinates")[:, grains], run.nodal("mass")[0, grains]
    inside = [np.max(0.005 - place[..., 2]), np.max(0.005 - place[..., :2]), np.max(place[..., :2]) - 0.045]
    potential = 9810 * np.sum(mass * place[..., 2], axis=1)
    columns = [np.interp(run.times, run["Time"], run[c]) for c in ("kinetic_energy", "internal_energy", "contact_energy",
                                                                  "friction_energy", "contact_damping_energy")]
    stored = potential + columns[0] + columns[1] + columns[2] - columns[3] - columns[4]
    weight, late = 9810 * 64 * 1000 * 4 / 3 * math.pi * 0.005 ** 3, run["Time"] > 15e-3
    bench.threads = 2
    again = bench.run("box_of_particles", balls_in_box())
    change = np.max(np.abs(again.nodal("displacement") - run.nodal("displacement")))
    return [at_most("change with two threads in place of one", change, 0.0),
            at_most("depth in floor and walls over the radius", max(inside) / 5e-3, 0.1),
            at_most("largest rise of the energy over all", np.max(np.diff(stored)) / potential[0], 1e-3),
            Check("weight on the floor [N]", weight, np.mean(run["force"][late]), 0.02), *balances([run], has_friction=True)]


def strip_over_cylinder(n):
    """A strip with 5 n x n cells over the upper two thirds of a cylinder across its middle."""
    mesh = MeshMaker()
    mesh.shells("strip", (0, -50, 0), (500, 100), (5 * n, n), 2.5)
    mesh.node_set("root", lambda x, y, z: x == 0)
    mesh.new_body()
    mesh.place = lambda a, y, _: (250 + 39.5 * math.sin(a), y, -41.25 + 39.5 * math.cos(a))
    mesh.shells("cylinder", (-2 * math.pi / 3, -60, 0), (4 * math.pi / 3, 120), (48, 7), 1.0)
    return mesh


@case(is_long=True)
def strip_on_cylinder(bench):
    checks, runs = [], []
    for form in BOTH:
        run = bench.run("strip_on_cylinder", strip_over_cylinder(8), form=form)
        runs.append(run)
        nodes = run.nodes_of(1)
        at, moved = run.start[nodes], run.nodal("displacement")[:, nodes]
        image = np.lexsort(np.round(at * (1, -1, 1), 6).T)[np.argsort(np.lexsort(np.round(at, 6).T))]
        change = moved - moved[:, image] * (1, -1, 1)
        checks += [at_most(f"{form}: one half of the width less the other's image", np.max(np.abs(change)) / np.max(np.abs(moved)), 1e-6),
                   at_most(f"{form}: depth over the thickness", -np.min(run.nodal("contact_normal_gap")) / 2.5, 0.1)]
    return checks + balances(runs)


def balls_under_press(n):
    """Five layers of 25 balls, one of them left out, in a box 51 mm wide inside, and a plate over them."""
    mesh = MeshMaker()
    for i in range(124):
        add_ball(mesh, (5.4 + 10.05 * (i % 5), 5.4 + 10.05 * (i // 5 % 5), 5.05 + 10.05 * (i // 25)), 5.0, n, "balls")
    add_box(mesh, "box", 53, 8, 2.0, lambda p: p + (25.5, 25.5, 25.5), has_lid=False)
    points = np.array(mesh.points)
    mesh.node_sets.append(("floor", [i + 1 for i, p in enumerate(points) if abs(p[2] + 1) < 1e-9]))
    mesh.new_body()
    mesh.place = lambda x, y, z: (x, y, z)
    mesh.shells("press", (0.5, 0.5, 51.5), (50, 50), (8, 8), 2.0)
    return mesh


@case(is_long=True)
def lead_balls(bench):
    run = bench.run("lead_balls", balls_under_press(2))
    balls = run.nodes_of(1)
    place = run.nodal("coordinates")[:, balls]
    outside = max(np.max(-place), np.max(place[..., :2]) - 51)
    filled = np.sum(run.nodal("mass")[0, balls]) / 11.34e-9 / (51 ** 2 * np.max(place[-1, :, 2]))
    return [at_most("way of the farthest node of a ball past the inner side of the walls, which give way, over 2 mm", outside / 2.0, 1.0),
            at_most("room below the press that is not filled", 1 - filled, 0.35),
            at_most("depth over an element's size", -np.min(run.nodal("contact_normal_gap")) / 2.0, 0.5),
            *balances([run], has_friction=True, tolerance=0.05)]
