# SPDX-License-Identifier: BSD-3-Clause
"""Impacts on shells: balls, pipes, a strip, a box full of balls."""
import math

import numpy as np

from cases import FORMULATIONS, balances, case
from mesh_maker import MeshMaker
from runs import Check, at_most
from shapes import add_ball, add_box, add_quarter_ball, near_zero


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
            Check(f"{label}: largest force [N]", expected[1], np.max(force), 0.1, known_miss=0.12),
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


def crossed_pipes(n_around, n_along):
    """Half x > 0 of a pipe along x and of one along y over it; smaller cells where they meet."""
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
    for form in FORMULATIONS:
        run = bench.run("pipe_whip", crossed_pipes(24, 20), form=form)
        runs.append(run)
        checks += [Check(f"{form}: kinetic energy at the start [in lbf]", energy, run["kinetic_energy"][0], 0.01),
                   at_most(f"{form}: depth over the wall", -np.min(run.nodal("contact_normal_gap")) / 0.432, 0.1),
                   at_most(f"{form}: pipes that are not flattened", sum(flattening(run, b, b - 1) < 0.1 for b in (1, 2)), 0)]
    for name, block in (("held", 1), ("whip", 2)):
        one, other = [flattening(run, block, block - 1) for run in runs]
        checks.append(Check(f"node_face: flattening of the {name} pipe, as with face_face", one, other, 0.05))
    return checks + balances(runs, tolerance=0.03)


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
    for form in FORMULATIONS:
        run = bench.run("strip_on_cylinder", strip_over_cylinder(8), form=form)
        runs.append(run)
        nodes = run.nodes_of(1)
        at, moved = run.start[nodes], run.nodal("displacement")[:, nodes]
        image = np.lexsort(np.round(at * (1, -1, 1), 6).T)[np.argsort(np.lexsort(np.round(at, 6).T))]
        change = moved - moved[:, image] * (1, -1, 1)
        checks += [at_most(f"{form}: one half of the width less the other's image",
                           np.max(np.abs(change)) / np.max(np.abs(moved)), 1e-6),
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
    return [at_most("way of the farthest node past the inner side of walls, which give way, over 2 mm", outside / 2.0, 1.0),
            at_most("room below the press that is not filled", 1 - filled, 0.35),
            at_most("depth over an element's size", -np.min(run.nodal("contact_normal_gap")) / 2.0, 0.5),
            *balances([run], has_friction=True, tolerance=0.05)]


def tube_between_plates(n_side, n_along):
    """A square tube with a dent of half a wall in two of its sides near the upper end, a plate at either end."""
    def place(u, z, _):
        side, along = int(u) % 4, 50 * (u - int(u)) - 25
        dent = 0.75 * math.cos(math.pi * along / 50) * math.exp(-((z - 135) / 10) ** 2)
        dent *= -1 if side % 2 == 0 else 1
        return [(along, -25 - dent, z), (25 + dent, along, z), (-along, 25 + dent, z), (-25 - dent, -along, z)][side]

    mesh = MeshMaker(place)
    mesh.shells("tube", (0, 0, 0), (4, 150), (4 * n_side, n_along), 1.5)
    for name, level in (("floor", -0.76), ("press", 150.76)):
        mesh.new_body()
        mesh.place = lambda x, y, z: (x, y, z)
        mesh.shells(name, (-50, -50, level), (100, 100), (8, 8), 1.5)
    return mesh


@case(is_long=True)
def shell_tube(bench):
    run = bench.run("shell_tube", tube_between_plates(10, 30))
    force, times = run["force"], run["Time"]
    crushing = times > 2e-4
    mean = np.sum(force[crushing][1:] * np.diff(times[crushing])) / (times[-1] - 2e-4)
    return [Check("mean force [N]", 13.06 * 300 * 1.5 ** (5 / 3) * 50 ** (1 / 3), mean, 0.15),
            at_most("depth over the wall", -np.min(run.nodal("contact_normal_gap")) / 1.5, 0.75),
            *balances([run], has_friction=True)]
