# SPDX-License-Identifier: BSD-3-Clause
"""Friction."""
import math

import numpy as np

from cases import balances, case
from mesh_maker import MeshMaker
from runs import Check, at_most


def slider(scale=1.0, has_plate=True, way=0.01):
    """A block of 4x4x1 elements, on a plate that is longer than its way."""
    mesh = MeshMaker()
    s = scale
    mesh.hexes("slider", (0, 0, 0), (0.02 * s, 0.02 * s, 0.005 * s), (4, 4, 1))
    if has_plate:
        mesh.new_body()
        n = round((0.04 * s + way) / (0.007 * s))
        mesh.hexes("plate", (-0.0137 * s, -0.0121 * s, -0.006 * s), (n * 0.007 * s, 0.049 * s, 0.006 * s), (n, 7, 1))
    return mesh


MASS = 1000 * 0.02 * 0.02 * 0.005


def stop_checks(label, run, distance, time, energy, drift):
    times, way = run["Time"], run["x"]
    steady = (times > 0.2 * time) & (times < 0.8 * time)
    slope_of, start = np.polyfit(times[steady], run["v"][steady], 1)
    stopped = way[times > time + 0.4 * (times[-1] - time)]
    return [Check(f"{label}: distance [m]", distance, way[-1], 0.01),
            Check(f"{label}: time [s]", time, -start / slope_of, 0.01),
            Check(f"{label}: energy lost to friction [J]", energy, run["friction_energy"][-1], 0.01),
            at_most(f"{label}: drift after the stop [m]", np.max(stopped) - np.min(stopped), drift)]


@case()
def sliding_block(bench):
    checks, runs = [], []
    for form in ("face_face", "node_face"):
        runs.append(bench.run("sliding_block", slider(), form=form))
        checks += stop_checks(form, runs[-1], 1e-3, 2e-3, 0.5 * MASS, 1e-7)
    plane = bench.run("sliding_block", slider(has_plate=False), base="plane")
    return [*checks, *stop_checks("plane", plane, 1e-3, 2e-3, 0.5 * MASS, 1e-7),
            *balances(runs, has_friction=True), *balances([plane], has_plane=True)]


@case()
def sticking_block(bench):
    checks = []
    for form in ("face_face", "node_face"):
        run = bench.run("sliding_block", slider(), form=form, model="stick")
        checks += [at_most(f"{form}: distance where it would slide 1e-3", abs(run["x"][-1]), 5e-5),
                   at_most(f"{form}: largest velocity in the last half",
                           np.max(np.abs(run["v"][len(run["v"]) // 2:])), 0.01)]
    return checks


@case()
def sliding_far(bench):
    """For a metre, in one g."""
    run = bench.run("sliding_block", slider(has_plate=False), base="plane", mu=0.2, vx=2, vy=0, gx=0, gz=9.81,
                    youngs=1e7, end_time=1.2)
    return [*stop_checks("1 g", run, 1.01937, 1.01937, 2 * MASS, 1e-7), *balances([run], has_plane=True)]


@case()
def sliding_ways(bench):
    """The same distance whichever way the block is thrown, on a plane."""
    checks = []
    root = math.sqrt(0.5)
    for vx, vy in ((1, 0), (-1, 0), (0, 1), (root, root)):
        run = bench.run("sliding_block", slider(has_plate=False), base="plane", vx=float(vx), vy=float(vy))
        way = vx * run["x"][-1] + vy * run["y"][-1]
        if not checks:
            first = way
        missed = 1e-5 if vx == root else None
        checks.append(Check(f"thrown along ({vx:.3g}, {vy:.3g}): distance [m]", first, way, 1e-6, known_miss=missed))
    return checks[1:]


@case()
def slope(bench):
    g, rise = 9.81, 0.04
    gx, gz = 0.5 * g, math.sqrt(0.75) * g
    checks, runs = [], []
    for scale in (1.0, 0.1, 10.0):
        for mu in (0.3, 0.577, 0.6):
            mesh = slider(scale, way=15 * rise ** 2 if mu == 0.3 else 0)
            runs.append(bench.run("sliding_block", mesh, mu=mu, vx=0, vy=0, gx=gx, gz=gz, youngs=1e8 * scale,
                                  end_time=3 * rise, rise=rise))
            run = runs[-1]
            label, late = f"size x {scale:g}, mu = {mu}", run["Time"] > rise
            if mu < math.tan(math.pi / 6):
                reached = np.polyfit(run["Time"][late], run["v"][late], 1)[0]
                checks.append(Check(f"{label}: acceleration", gx - mu * gz, reached, 0.005))
            else:
                reached = np.polyfit(run["Time"][late], run["x"][late], 1)[0] / (0.02 * scale)
                checks.append(at_most(f"{label}: creep over the size [1/s]", abs(reached), 1e-6, known_miss=1e-4))
    return checks + balances(runs, has_friction=True)


@case()
def stick_limit(bench):
    """A pull that grows to 1.5 times the friction; after slip v = (t - t0)^2 of it."""
    run = bench.run("sliding_block", slider(), vx=0, vy=0, gx=750, gz=1000, ramp=4e-3)
    times, speed = run["Time"], run["v"]
    slips = times > 0.75 * 4e-3
    slope_of, start = np.polyfit(times[slips], np.sqrt(np.maximum(speed[slips], 0)), 1)
    return [Check("pull over weight at slip", 0.5, -start / slope_of / 4e-3 * 0.75, 0.01),
            *balances([run], has_friction=True)]


def block_and_spring():
    mesh = MeshMaker()
    mesh.hexes("slider", (0, 0, 0), (0.1, 0.1, 0.1), (2, 2, 2))
    mesh.hexes("spring", (-0.1, 0, 0), (0.1, 0.1, 0.1), (2, 2, 2))
    mesh.node_set("wall", lambda x, y, z: x < -0.099)
    return mesh


@case()
def spring_and_friction(bench):
    run = bench.run("spring_and_friction", block_and_spring())
    times, place = run["Time"], 0.85e-3 + run["x"]
    checks = []
    for i, expected in enumerate((-0.65e-3, 0.45e-3, -0.25e-3, 0.05e-3)):
        due = 0.01 + (i + 1) * math.pi * 1e-2
        near = np.abs(times - due) < 0.008
        turn = np.argmin(place[near]) if expected < 0 else np.argmax(place[near])
        checks.append(Check(f"turn {i + 1} at [m]", expected, place[near][turn], 5e-6, 1.0))
        if i < 3:
            checks.append(Check(f"turn {i + 1}, time [s]", due - 0.01, times[near][turn] - 0.01, 0.005))
    checks.append(Check("stays at [m]", 0.05e-3, np.mean(place[times > 0.15]), 5e-6, 1.0))
    return checks + balances([run], has_plane=True)
