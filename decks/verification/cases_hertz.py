# SPDX-License-Identifier: BSD-3-Clause
"""Balls and cylinders in contact."""
import math

import numpy as np

from cases import balances, case
from mesh_maker import MeshMaker
from runs import Check
from shapes import add_quarter_ball


def graded(step, n_even, n, end=1.0):
    """n + 1 places from 0 to the end: n_even equal steps, then ones that grow."""
    left = end - n_even * step
    low, high = 1.0, 10.0
    for _ in range(80):
        ratio = 0.5 * (low + high)
        total = step * sum(ratio ** i for i in range(1, n - n_even + 1))
        low, high = (ratio, high) if total < left else (low, ratio)
    steps = [step] * n_even + [step * ratio ** i for i in range(1, n - n_even + 1)]
    places = np.concatenate([[0.0], np.cumsum(steps)])
    return places * end / places[-1]


def column_mesh(radius, step, n, layers, looks_up=False, is_flat=False):
    """Maps a grid to a quarter of a block of 0.65 R each way under (or over) the plane of the middle of a ball, whose other
    end is the ball's pole at the origin: along the columns n cells, graded to the pole; of a cylinder along y, with one
    cell along it."""
    width = 0.65 * radius
    across, along = graded(step, 10, n, width), graded(step / radius, 6, layers)

    def place(i, j, k):
        x, y = across[round(i)], j * step if is_flat else across[round(j)]
        surface = radius - math.sqrt(radius ** 2 - x ** 2 - (0.0 if is_flat else y ** 2))
        share = along[layers - round(k) if looks_up else round(k)]
        z = surface + share * (radius - surface)
        return x, y, -z if looks_up else z
    return place


def add_columns(mesh, name, radius, step, n, layers, **kind):
    """Returns the first element and how many there are in a layer."""
    rows = 1 if kind.get("is_flat") else n
    mesh.place = column_mesh(radius, step, n, layers, **kind)
    return mesh.hexes(name, (0, 0, 0), (n, rows, layers), (n, rows, layers)), n * rows


def add_sets(mesh, first, n_in_layer, layers):
    points = np.array(mesh.points)
    near = 1e-9 * np.max(np.abs(points))
    for name, axis, level in (("on_x", 0, 0.0), ("on_y", 1, 0.0), ("bottom", 2, np.min(points[:, 2]))):
        mesh.node_sets.append((name, [i + 1 for i, p in enumerate(points) if abs(p[axis] - level) < near]))
    mesh.side_set("top", [(first + n_in_layer * (layers - 1) + i, 6) for i in range(n_in_layer)])


def ball(radius, step, n=18, layers=14, **kind):
    mesh = MeshMaker()
    add_sets(mesh, *add_columns(mesh, "ball", radius, step, n, layers, **kind), layers)
    return mesh


def ball_on_ball(radius, step, n=18, layers=14):
    mesh = MeshMaker()
    top = add_columns(mesh, "ball", radius, step, n, layers)
    mesh.new_body()
    add_columns(mesh, "base", radius, step, n, layers, looks_up=True)
    add_sets(mesh, *top, layers)
    return mesh


def cylinder_on_block(radius, step, n, layers, width):
    """Half of a cylinder's lower half over half of a block, one cell thick."""
    mesh = MeshMaker()
    top = add_columns(mesh, "ball", radius, step, n, layers, is_flat=True)
    along, down = graded(step, 10, n, width), graded(step, 10, n, 2 * width)
    mesh.new_body()
    mesh.place = lambda i, j, k: (along[round(i)], j * step, -down[n - round(k)])
    mesh.hexes("base", (0, 0, 0), (n, 1, n), (n, 1, n))
    add_sets(mesh, *top, layers)
    return mesh


def contact_size(run):
    """Where the outermost node with a force is [length]."""
    force = np.abs(run.nodal("force_contact")[-1, :, 2])
    touching = (force > 1e-3 * np.max(force)) & (run.start[:, 1] < 1e-9)
    return np.max(run.start[touching, 0])


def late(run, values):
    return np.mean(values[run["Time"] > 0.8 * run["Time"][-1]])


def pole_pressure(run, layer):
    """Pressure in the ball's element at the pole."""
    stress = run.element("stress_zz", 1)
    return -np.mean(stress[-4:, layer])


def ball_checks(label, run, step, radius, modulus, depth, missed_force=None):
    """radius, modulus: those of the pair; depth: approach of the pair."""
    size = math.sqrt(radius * depth)
    force = 4 / 3 * modulus * math.sqrt(radius) * depth ** 1.5
    return [Check(f"{label}: force", force, 4 * late(run, run["force"]), 0.03, known_miss=missed_force),
            Check(f"{label}: largest pressure", 1.5 * force / (math.pi * size ** 2), pole_pressure(run, 0), 0.05),
            Check(f"{label}: radius of contact", size, contact_size(run), step, 1.0)]


@case(is_long=True)
def hertz_ball(bench):
    """ANSYS VM63."""
    checks, runs = [], []
    for approach, step, missed in ((0.05, 0.08, None), (0.12742, 0.126, 0.045)):
        runs.append(bench.run("hertz", ball(8, step), amount=approach))
        checks += ball_checks(f"approach of {approach} mm", runs[-1], step, 8, 1000 / 0.91, approach, missed)
    return checks + balances(runs, has_plane=True)


@case(is_long=True)
def hertz_rigid_ball(bench):
    """MOOSE: a rigid ball on an elastic one."""
    run = bench.run("hertz", ball_on_ball(2, 0.0125), youngs=1.40625e7, nu=0.25, density=1e-3, base="held",
                    amount=0.01, rise=4e-4)
    return ball_checks("rigid on elastic", run, 0.0125, 1, 1.5e7, 0.01) + balances([run])


@case(is_long=True)
def hertz_two_balls(bench):
    """code_aster SSNV104."""
    checks, runs = [], []
    for approach, step, missed in ((0.1, 0.2, None), (4.0, 1.25, 0.08)):
        runs.append(bench.run("hertz", ball_on_ball(50, step, 16, 12), youngs=20e3, nu=0.3, density=2e-9, base="body",
                              amount=approach, rise=3e-4))
        checks += ball_checks(f"approach of {approach} mm", runs[-1], step, 25, 10e3 / 0.91, approach, missed)
    return checks + balances(runs)


@case(is_long=True)
def hertz_cylinders(bench):
    """NAFEMS CGS-1, and a cylinder on a rigid plane."""
    step = 0.78
    nafems = bench.run("hertz", cylinder_on_block(50, step, 28, 24, 100), youngs=210e3, nu=0.3, density=7.8e-9, base="body",
                       base_youngs=70e3, drive="pressure", amount=17.5e3 / 32.5, plane_strain=1, rise=1e-3)
    plane = bench.run("hertz", ball(8, 0.1, 24, 20, is_flat=True), plane_strain=1, rise=2e-4)
    return [Check("CGS-1: largest pressure [MPa]", 3585.37, pole_pressure(nafems, 0), 0.05),
            Check("CGS-1: half width [mm]", 6.21, contact_size(nafems), step, 1.0),
            Check("on a plane: force over length [N/mm]", 68.9, 2 * late(plane, plane["force"]) / 0.1, 0.03),
            Check("on a plane: largest pressure [MPa]", 54.9, pole_pressure(plane, 0), 0.05),
            *balances([nafems]), *balances([plane], has_plane=True)]


def two_quarter_balls(radius):
    mesh = MeshMaker()
    add_quarter_ball(mesh, "lower", -radius, radius, True)
    add_quarter_ball(mesh, "upper", radius, radius, False)
    points = np.array(mesh.points)
    for name, axis in (("on_x", 0), ("on_y", 1)):
        mesh.node_sets.append((name, [i + 1 for i, p in enumerate(points) if abs(p[axis]) < 1e-9 * radius]))
    return mesh


@case(is_long=True)
def glass_spheres(bench):
    checks, runs = [], []
    for form in ("face_face", "node_face"):
        run = bench.run("glass_spheres", two_quarter_balls(0.01), form=form)
        runs.append(run)
        force, times = 4 * run["force"], run["Time"]
        lower, upper = run.nodes_of(1), run.nodes_of(2)
        mass, moved = run.nodal("mass")[0], run.nodal("displacement")[:, :, 2]
        centre = [np.average(moved[:, nodes], axis=1, weights=mass[nodes]) for nodes in (lower, upper)]
        back = np.average(run.nodal("velocity")[-1, upper, 2], weights=mass[upper])
        peak = np.argmax(np.sum(run.nodal("force_contact")[:, upper, 2], axis=1))
        pushes = np.linalg.norm(run.nodal("force_contact")[peak, upper], axis=1)
        pushed = upper[(pushes > 1e-3 * np.max(pushes)) & (run.start[upper, 1] < 1e-9)]
        checks += [Check(f"{form}: largest force [N]", 10697, np.max(force), 0.08),
                   Check(f"{form}: largest approach [m]", 0.27411e-3, np.max(centre[0] - centre[1]), 0.08),
                   Check(f"{form}: duration [s]", 40.339e-6, times[force > 0][-1] - times[force > 0][0], 0.08),
                   Check(f"{form}: radius of contact [m]", 1.1707e-3, np.max(run.start[pushed, 0]), 0.3e-3, 1.0),
                   Check(f"{form}: speed of the rebound [m/s]", 10, back, 0.03)]
    return checks + balances(runs)
