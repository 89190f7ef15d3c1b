# SPDX-License-Identifier: BSD-3-Clause
"""Bodies that hit each other hard."""
import math

import numpy as np

import make_meshes
from cases import balances, case
from mesh_maker import MeshMaker
from runs import Check, at_most
from shapes import add_ball, add_ring, hairpin


def cut_cube():
    mesh = MeshMaker()
    for half, z, meshes in (("lower", -4, (2, 4, 3, 6)), ("upper", 0, (5, 2, 4, 3))):
        for i, n in enumerate(meshes):
            mesh.new_body()
            mesh.hexes(f"{half}_{i + 1}", (-4 + 4 * (i % 2), -4 + 4 * (i // 2), z), (4, 4, 4), (n, n, 2 * n))
    return mesh


@case()
def squeezed_cubes(bench):
    run = bench.run("squeezed_cubes", cut_cube())
    times = run["Time"]
    force = -np.mean(run["force"][(times > 0.2e-3) & (times < 1e-3)])
    return [Check("mean force [N]", 1.45942e9, force, 0.15), *balances([run], is_free=True)]


def taylor_checks(label, run, length, radius, bounds):
    reached = 0.0324 + run["end_displacement"][-1] - run["foot_level"][-1]
    checks = [Check(f"{label}: length [m]", length, reached, bounds[0])]
    if radius is not None:
        checks.append(Check(f"{label}: radius of the foot [m]", radius, run["foot_radius"][-1], bounds[1]))
    return checks


@case()
def taylor_wall(bench):
    run = bench.run("taylor_wall", make_meshes.taylor_bar(4))
    return [*taylor_checks("227 m/s", run, 21.5e-3, 7.15e-3, (0.014, 0.035)), *balances([run], has_plane=True)]


@case(is_long=True)
def taylor_walls(bench):
    mesh = make_meshes.taylor_bar(6)
    runs = [bench.run("taylor_wall", mesh, speed=speed) for speed in (227, 130, 146)]
    plastic = dict(density=8970, youngs=110e9, nu=0.3, hardening=0.0)
    runs.append(bench.run("taylor_wall", mesh, **{"yield": 314e6}, **plastic))
    return [*taylor_checks("227 m/s", runs[0], 21.5e-3, 7.15e-3, (0.014, 0.035)),
            *taylor_checks("130 m/s", runs[1], 27.904e-3, 4.906e-3, (0.01, 0.03)),
            *taylor_checks("146 m/s", runs[2], 26.973e-3, 5.234e-3, (0.01, 0.03)),
            *taylor_checks("perfectly plastic", runs[3], 19.36e-3, None, (0.02,)), *balances(runs, has_plane=True)]


def ball_before_plate(n=6):
    mesh = MeshMaker()
    mesh.hexes("plate", (-0.05, -0.25, -0.25), (0.1, 0.5, 0.5), (4, 20, 20))
    add_ball(mesh, (-0.26, 0, 0), 0.2, n)
    return mesh


@case(is_long=True)
def sphere_and_plate(bench):
    checks, runs = [], []
    for form in ("face_face", "node_face"):
        run = bench.run("sphere_and_plate", ball_before_plate(), form=form)
        runs.append(run)
        mass, moved = run.nodal("mass")[0], run.nodal("displacement")[-1]
        plate = run.nodes_of(1)
        ball = np.setdiff1d(np.arange(len(mass)), plate)
        for name, nodes, expected in (("plate", plate, 7.392e-3), ("sphere", ball, 7.3371e-2)):
            mean = np.average(moved[nodes], axis=0, weights=mass[nodes])
            checks += [Check(f"{form}: mean displacement of the {name} [m]", expected, mean[0], 0.1),
                       at_most(f"{form}: the same aside", max(abs(mean[1]), abs(mean[2])) / expected, 1e-6)]
    bench.threads = 2
    again = bench.run("sphere_and_plate", ball_before_plate())
    change = np.max(np.abs(again.nodal("displacement") - runs[0].nodal("displacement")))
    checks.append(at_most("change with two threads in place of one", change, 0.0))
    return checks + balances(runs, is_free=True)


def block_over_plate():
    mesh = MeshMaker()
    mesh.hexes("block", (0, 0, 1e-4), (5e-3, 5e-3, 5e-3), (4, 4, 4))
    mesh.new_body()
    mesh.hexes("plate", (-2e-3, -2e-3, -5e-4), (9e-3, 9e-3, 5e-4), (9, 9, 1))
    return mesh


@case()
def fast_block(bench):
    checks, runs = [], []
    for form in ("face_face", "node_face"):
        run = bench.run("fast_block", block_over_plate(), form=form)
        runs.append(run)
        nodes = run.nodes_of(1)
        lowest = np.min(run.nodal("coordinates")[:, nodes, 2])
        checks += [at_most(f"{form}: depth over the plate's thickness", max(0.0, -lowest / 5e-4), 0.5),
                   at_most(f"{form}: nodes that got through", np.sum(run.nodal("coordinates")[-1, nodes, 2] < 0), 0)]
    return checks + balances(runs)


def two_rings(aside):
    mesh = MeshMaker()
    add_ring(mesh, "ring_a", (-10.05, 0), 8, 10, 1, (2, 64, 1))
    add_ring(mesh, "ring_b", (10.05, aside), 8, 10, 1, (2, 64, 1))
    return mesh


def mirror_error(run):
    """How far the two bodies, as they first part, are from being each other's image in x, over the largest displacement."""
    at, moved = run.start, run.nodal("displacement")[np.argmin(np.abs(run.times - 0.4))]
    one, other = run.nodes_of(1), run.nodes_of(2)
    one = one[np.lexsort(np.round(at[one] * (-1, 1, 1), 6).T)]
    other = other[np.lexsort(np.round(at[other], 6).T)]
    change = moved[one] * (-1, 1, 1) - moved[other]
    return np.max(np.abs(change)) / np.max(np.abs(moved))


@case()
def rings(bench):
    checks, runs = [], []
    for form in ("face_face", "node_face"):
        head_on, offset = [bench.run("rings", two_rings(aside), form=form) for aside in (0, 5)]
        runs += [head_on, offset]
        deepest = max(np.max(run["penetration"]) for run in (head_on, offset))  # an element is 1 thick
        checks += [at_most(f"{form}: asymmetry of the head-on hit", mirror_error(head_on), 1e-8,
                           known_miss=2e-7 if form == "face_face" else None),
                   at_most(f"{form}: depth over an element", deepest, 0.1)]
    return checks + balances(runs, is_free=True)


def crossing_depth(run):
    """How far below the lower leg's inner side the upper leg's inner side gets at the free ends, at worst."""
    at, place = run.start, run.nodal("coordinates")
    end = at[:, 0] == 0
    upper, lower = end & (np.abs(at[:, 1] - 1) < 1e-9), end & (np.abs(at[:, 1] + 1) < 1e-9)
    return np.max(np.max(place[:, lower, 1], axis=1) - np.min(place[:, upper, 1], axis=1))


@case()
def folding_strip(bench):
    mesh = hairpin(24, 18, 0.3)
    runs = [bench.run("folding_strip", mesh, form=form) for form in ("face_face", "node_face")]
    off = bench.run("folding_strip", mesh, self="off")
    checks = [at_most(f"{form}: depth over an element", max(0.0, crossing_depth(run)) / 0.15, 0.5)
              for form, run in zip(("face_face", "node_face"), runs)]
    checks.append(at_most("legs that do not cross without contact", float(crossing_depth(off) < 0.3), 0))
    return checks + balances(runs, is_free=True)


def cubes_in_box():
    """Cubes of 10 mm with one element per half edge, a bit apart and turned, nowhere touching."""
    mesh, chance = MeshMaker(), np.random.default_rng(4)
    for i in range(64):
        cell = np.array([i % 4, i // 4 % 4, i // 16])
        middle = 0.0065 + 0.0122 * cell + (0, 0, 0.003 * cell[2]) + chance.uniform(-3e-4, 3e-4, 3)
        angle = chance.uniform(-0.1, 0.1)
        turn = np.array([[math.cos(angle), -math.sin(angle), 0], [math.sin(angle), math.cos(angle), 0], [0, 0, 1]])
        mesh.new_body()
        mesh.place = lambda *p, m=middle, t=turn: tuple(m + t @ p)
        mesh.hexes(f"cube_{i + 1}", (-0.005, -0.005, -0.005), (0.01, 0.01, 0.01), (2, 2, 2))
    return mesh


@case(is_long=True)
def box_of_cubes(bench):
    checks, runs = [], []
    weight = 64 * 1e-3 * 9810
    for form in ("face_face", "node_face"):
        run = bench.run("box_of_cubes", cubes_in_box(), form=form)
        runs.append(run)
        place, late = run.nodal("coordinates"), run.times > 25e-3
        inside = [np.max(-place[..., 2]), np.max(-place[..., :2]), np.max(place[..., :2]) - 0.05]
        carried = np.mean(np.sum(run.nodal("force_contact")[late, :, 2], axis=1))
        potential = 9810 * np.sum(run.nodal("mass") * place[..., 2], axis=1)
        columns = [np.interp(run.times, run["Time"], run[c]) for c in ("kinetic_energy", "internal_energy", "contact_energy",
                                                                      "friction_energy", "contact_damping_energy")]
        stored = potential + columns[0] + columns[1] + columns[2] - columns[3] - columns[4]
        checks += [at_most(f"{form}: depth in floor and walls over an element", max(0.0, *inside) / 5e-3, 0.1),
                   at_most(f"{form}: largest rise of the energy over all", np.max(np.diff(stored)) / potential[0], 1e-3),
                   Check(f"{form}: weight on the floor [N]", weight, carried, 0.02)]
    return checks + balances(runs, has_plane=True)
