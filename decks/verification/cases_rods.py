# SPDX-License-Identifier: BSD-3-Clause
"""Rods that strike one another or a wall."""
import math

import numpy as np

from cases import balances, case
from mesh_maker import MeshMaker
from runs import Check, at_most


def two_rods(n_a=100, n_b=100, across_a=1, across_b=1, length=0.1, side=0.01, scale=1.0, gap=0.0):
    mesh = MeshMaker()
    length, side = scale * length, scale * side
    mesh.hexes("rod_a", (0, 0, 0), (length, side, side), (n_a, across_a, across_a))
    mesh.new_body()
    mesh.hexes("rod_b", (length + gap, 0, 0), (length, side, side), (n_b, across_b, across_b))
    mesh.node_set("far_end", lambda x, y, z: x > 2 * length - 1e-9 * length)
    return mesh


def touching(times, force):
    """First and last time with a force."""
    on = times[force > 0]
    return on[0], on[-1]


def middle_mean(times, values, start, duration):
    return np.mean(values[(times > start + 0.25 * duration) & (times < start + 0.75 * duration)])


def rod_checks(label, run, axis=(1, 0, 0)):
    times, force = run["Time"], sum(a * run[f"force_{c}"] for a, c in zip(axis, "xyz"))
    first, last = touching(times, force)
    velocity = [run.momentum(block)[-1] @ axis / run.mass(block) for block in (1, 2)]
    # The two layers of nodes that meet lose their motion against each other: 0.8 % of the impulse with 50 elements.
    return [Check(f"{label}: duration [s]", 40e-6, last - first, 0.05),
            Check(f"{label}: mean force [N]", 20e3, middle_mean(times, force, 0, 40e-6), 0.01),
            Check(f"{label}: impulse [N s]", 0.8, velocity[1] * run.mass(2), 0.005, known_miss=0.01),
            Check(f"{label}: velocity of the struck rod [m/s]", 10.0, velocity[1], 0.005, known_miss=0.01),
            Check(f"{label}: velocity left in the other [m/s]", 0.0, velocity[0], 0.05, 1.0, known_miss=0.1)]


@case()
def rods(bench):
    checks, runs = [], []
    for form in ("face_face", "node_face"):
        runs.append(bench.run("two_rods", two_rods(), form=form))
        checks += rod_checks(form, runs[-1])
    return checks + balances(runs, is_free=True)


@case()
def rods_long_after(bench):
    """Rods of 0.1 m and 0.2 m fly on for 30 times the contact: no energy but what contact tells comes or goes."""
    checks, runs = [], []
    for enforcement in ("momentum_balance", "penalty"):
        for length in (0.1, 0.2):
            run = bench.run("two_rods", two_rods(50, 50, length=length), enforcement=enforcement,
                            end_time=1.2e-3 * length / 0.1)
            label, flight = f"{enforcement}, {length} m", run["kinetic_energy"][0]
            total = run["kinetic_energy"] + run["internal_energy"] + run["contact_energy"]
            after = np.abs(run["force_x"]) == 0
            after[:int(np.argmax(~after)) + 2] = False
            checks += [at_most(f"{label}: change of energy over that of the flight",
                               np.max(np.abs(total[after] - total[0])) / flight, 0.005),
                       at_most(f"{label}: energy given out by contact over the same",
                               max(0.0, -np.min(run["contact_energy"])) / flight, 0.001)]
            if enforcement == "penalty":
                checks.append(at_most(f"{label}: energy that contact keeps over the same",
                                      np.abs(run["contact_energy"][-1]) / flight, 0.005))
            runs.append(run)
    return checks + balances(runs, is_free=True, tolerance=0.005)


@case()
def rods_unmatched(bench):
    runs = [bench.run("two_rods", two_rods(50, 77, 2, 3), form=form) for form in ("face_face", "node_face")]
    frame = int(np.argmin(np.abs(runs[0].times - 20e-6)))
    stress = runs[0].element("stress_xx", 1)[frame].reshape(50, 4, order="F")[-10]
    spread = (np.max(stress) - np.min(stress)) / 200e6
    return [*rod_checks("face_face", runs[0]), *rod_checks("node_face", runs[1]),
            at_most("face_face: spread of stress in a section over the mean", spread, 0.02),
            *balances(runs, is_free=True)]


def turned(z, y):
    """About z, then about the new y, in degrees."""
    a, b = math.radians(z), math.radians(y)
    about_z = np.array([[math.cos(a), -math.sin(a), 0], [math.sin(a), math.cos(a), 0], [0, 0, 1]])
    about_y = np.array([[math.cos(b), 0, math.sin(b)], [0, 1, 0], [-math.sin(b), 0, math.cos(b)]])
    return about_z @ about_y


def moved_along(bench, matrix, mesh, is_reversed=False):
    if is_reversed:
        mesh.reverse_elements()
    mesh.transform(matrix)
    velocity = np.array(matrix) @ (10.0, 0, 0)
    return bench.run("two_rods", mesh, **{f"v{c}": float(v) for c, v in zip("xyz", velocity)})


@case()
def rods_in_space(bench):
    """The same rods turned, mirrored, with axes permuted, with the elements in another order."""
    def mesh():
        return two_rods(20, 15, 2, 3, gap=1e-8)  # a gap of nothing would touch or not by round-off

    same = np.eye(3)
    plain = moved_along(bench, same, mesh())
    size = np.max(np.abs(plain.nodal("displacement")[-1]))
    checks = []
    for label, matrix, is_reversed, tolerance in [
            ("turned by 30 and 20 degrees", turned(30, 20), False, 1e-6),
            ("mirrored", np.diag([1, -1, 1]), False, 1e-10), ("struck from the other side", np.diag([-1, 1, 1]), False, 1e-10),
            ("axes permuted", same[[1, 2, 0]], False, 1e-10), ("elements reversed", same, True, 1e-10)]:
        other = moved_along(bench, matrix, mesh(), is_reversed)
        change = other.nodal("displacement")[-1] - plain.nodal("displacement")[-1] @ np.array(matrix).T
        checks.append(at_most(f"{label}: change of displacements", np.max(np.abs(change)) / size, tolerance))
    return checks


@case()
def rods_in_units(bench):
    """m-kg-s, mm-t-s, cm-g-microsecond."""
    plain = bench.run("two_rods", two_rods(20, 15, 2, 3))
    checks = []
    for label, length, mass, time in [("mm-t-s", 1e3, 1e-3, 1.0), ("cm-g-us", 1e2, 1e3, 1e6)]:
        mesh = two_rods(20, 15, 2, 3, scale=length)
        other = bench.run("two_rods", mesh, density=8000 * mass / length ** 3, youngs=200e9 * mass / length / time ** 2,
                          end_time=60e-6 * time, vx=10 * length / time, vy=0, vz=0)
        change = other.nodal("displacement")[-1] / length - plain.nodal("displacement")[-1]
        size = np.max(np.abs(plain.nodal("displacement")[-1]))
        checks.append(at_most(f"{label}: change of displacements", np.max(np.abs(change)) / size, 1e-9))
    return checks


@case()
def beams(bench):
    mesh = two_rods(50, 50, length=1.0, side=0.02)
    run = bench.run("two_rods", mesh, density=7800, youngs=2e11, end_time=5e-4, held=1, vx=1, vy=0, vz=0)
    return [Check("force [N]", 7899.37, middle_mean(run["Time"], run["force_x"], 0, 0.39497e-3), 0.01), *balances([run])]


def rod(n, length=2.0, area=0.2, gap=0.001):
    mesh = MeshMaker()
    side = math.sqrt(area)
    mesh.hexes("rod", (gap, 0, 0), (length, side, side), (n, 1, 1))
    return mesh


def wall_checks(label, run, force, duration, speed, bounds, impact=None, missed_duration=None):
    times, pushed = run["Time"], run["force_x"]
    first, last = touching(times, pushed)
    left = run.momentum(1)[-1][0] / run.mass(1)
    checks = [Check(f"{label}: duration [s]", duration, last - first, bounds[0], known_miss=missed_duration),
              Check(f"{label}: force", force, middle_mean(times, pushed, first, duration), bounds[1]),
              Check(f"{label}: velocity of the rebound", speed, left, bounds[2], known_miss=0.04)]
    if impact is not None:
        checks.insert(0, Check(f"{label}: impact in steps", 0.0, (first - impact) / (times[1] - times[0]), 1.0, 1.0))
    return checks


@case(refined=[10, 50, 100])
def rod_on_wall(bench, n=50):
    run = bench.run("rod_on_wall", rod(n))
    return [*wall_checks("steel", run, 11.85e6, 0.790e-3, 1.5, (0.025, 0.005, 0.01), 0.001 / 1.5), *balances([run], has_plane=True)]


@case()
def rod_on_wall_vm265(bench):
    run = bench.run("rod_on_wall", rod(20, 10.0, 1.0, 0.01), density=0.73, youngs=3e7, end_time=4e-3, speed=202.2, scale=4)
    return [*wall_checks("VM265", run, 9.4624e5, 3.16929e-3 - 49.456e-6, 202.2, (0.035, 0.01, 0.03), 49.456e-6),
            *balances([run], has_plane=True)]


@case()
def confined_rod_on_wall(bench):
    run = bench.run("rod_on_wall", rod(200), density=8000, youngs=200e9, end_time=1.6e-3, nu=0.3, confined=1)
    return [*wall_checks("nu = 0.3", run, 13.92e6, 0.6895e-3, 1.5, (0.01, 0.01, 0.01)),
            *balances([run], has_plane=True)]


@case()
def dropped_rod(bench):
    run = bench.run("rod_on_wall", rod(50, gap=0.01), density=7800, youngs=200e9, end_time=0.0925, speed=0, gravity=9.81)
    first, last = touching(run["Time"], run["force_x"])
    nodes = run.nodes_of(1)
    height = np.average(run.nodal("coordinates")[:, nodes, 0], axis=1, weights=run.nodal("mass")[0, nodes]) - 1.0
    return [Check("impact [s]", 45.152e-3, first, 0.002),
            Check("height of the rebound [m]", 0.01, np.max(height[run.times > last + 1e-3]), 0.02, known_miss=0.04),
            *balances([run], has_plane=True, tolerance=0.005)]
