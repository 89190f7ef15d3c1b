# SPDX-License-Identifier: BSD-3-Clause
"""Shells and beams without contact."""
import math

import numpy as np

from cases import case
from cases_solids import energy_check
from mesh_maker import MeshMaker
from runs import Check


def frequency_of(times, values):
    """By the times at which the values rise through zero."""
    rising = [i for i in range(1, len(values)) if values[i - 1] < 0 <= values[i]]
    zeros = [times[i - 1] - values[i - 1] / (values[i] - values[i - 1]) * (times[i] - times[i - 1]) for i in rising]
    return (len(zeros) - 1) / (zeros[-1] - zeros[0])


def steady_part(times, values):
    """The mean, weighted such that vibrations of many periods leave next to nothing."""
    span = times[-1] - times[0]
    weights = (1 - np.cos(2 * math.pi * (times - times[0]) / span)) ** 2
    weights[1:] *= np.diff(times)
    return np.sum(weights * values) / np.sum(weights)


def plate_mesh(n, is_distorted=False, has_triangles=False):
    def place(x, y, z):
        bump = 0.06 * math.sin(2 * math.pi * x) * math.sin(2 * math.pi * y) if is_distorted else 0.0
        return (x + bump, y - 0.7 * bump, z)

    mesh = MeshMaker(place)
    if has_triangles:
        mesh.triangles("plate", (0, 0, 0), (1, 1), (n, n), 0.01)
    else:
        mesh.shells("plate", (0, 0, 0), (1, 1), (n, n), 0.01)
    mesh.node_set("rim", lambda x, y, z: min(x, y, 1 - x, 1 - y) < 1e-9)
    return mesh


@case(refined=[8, 16, 32])
def plate(bench, n=16):
    exact = math.pi * 0.01 * math.sqrt(200e9 / (12 * 7800 * (1 - 0.3 ** 2)))
    checks = []
    for name, mesh, variables in [("squares", plate_mesh(n), {}),
                                  ("distorted", plate_mesh(n, is_distorted=True), {}),
                                  ("triangles", plate_mesh(n, has_triangles=True), {}),
                                  ("trapezoid rule", plate_mesh(n), {"points": 5, "rule": "trapezoid"})]:
        run = bench.run("plate", mesh, **variables)
        checks.append(Check(f"{name}: frequency [Hz]", exact, frequency_of(run["Time"], run["middle"]), 0.015))
    return checks + [energy_check(run, ["kinetic_energy"])]


def twisted_mesh(n):
    def place(x, y, z):
        angle = 0.5 * math.pi * x / 12
        return (x, y * math.cos(angle), y * math.sin(angle))

    mesh = MeshMaker(place)
    mesh.shells("strip", (0, -0.55, 0), (12, 1.1), (6 * n, n), 0.32)
    mesh.node_set("root", lambda x, y, z: x == 0)
    mesh.node_set("tip", lambda x, y, z: x == 12)
    return mesh


@case(refined=[2, 4, 8])
def twisted_beam(bench, n=4):
    checks = []
    for name, way, exact in [("in the plane", "z", 0.005424), ("across it", "y", 0.001754)]:
        run = bench.run("twisted_beam", twisted_mesh(n), way=way, force=1.0 / (n + 1))
        checks.append(Check(f"{name}: deflection [in]", exact, steady_part(run["Time"], run["tip"]), 0.02))
    return checks + [energy_check(run, ["external_energy"])]


def pipe_mesh(n):
    def place(angle, z, _):
        return (math.cos(angle), math.sin(angle), z)

    mesh = MeshMaker(place)
    mesh.shells("pipe", (0, 0, 0), (0.5 * math.pi, 0.05), (n, 1), 0.01)
    mesh.node_set("on_x", lambda angle, z, _: angle == 0)
    mesh.node_set("on_y", lambda angle, z, _: abs(angle - 0.5 * math.pi) < 1e-9)
    return mesh


@case()
def breathing_pipe(bench, n=32):
    run = bench.run("breathing_pipe", pipe_mesh(n))
    expansion = 1e6 * (1 - 0.3 ** 2) / (200e9 * 0.01)
    exact = math.sqrt(200e9 / (7800 * (1 - 0.3 ** 2))) / (2 * math.pi)
    return [Check("largest expansion [m]", 2 * expansion, np.max(run["wall"]), 0.01),
            Check("frequency [Hz]", exact, frequency_of(run["Time"], run["wall"] - expansion), 0.01),
            energy_check(run, ["external_energy"])]


def strip_mesh():
    mesh = MeshMaker()
    mesh.shells("strip", (0, 0, 0), (1, 0.1), (10, 2), 0.01)  # one half of it
    mesh.node_set("held", lambda x, y, z: x == 0)
    mesh.node_set("pulled", lambda x, y, z: x == 1)
    mesh.node_set("axis", lambda x, y, z: y == 0)
    return mesh


@case()
def pulled_strip(bench):
    e, nu = math.log(1.5), 0.3
    strains = np.linspace(0, e, 10001)
    work = 1e6 * 0.001 * np.trapz(strains * np.exp((1 - 2 * nu) * strains), strains)  # of one half
    checks = []
    for section in ["membrane", "shell"]:
        run = bench.run("pulled_strip", strip_mesh(), section=section)
        checks += [Check(f"{section}: stress [Pa]", 1e6 * e, run["stress"][-1], 0.002),
                   Check(f"{section}: thickness [m]", 0.01 * 1.5 ** -nu, run["thickness"][-1], 0.002),
                   Check(f"{section}: half the width [m]", 0.1 * 1.5 ** -nu, 0.1 + run["side"][-1], 0.002),
                   Check(f"{section}: work [J]", work, run["external_energy"][-1], 0.002)]
    return checks + [energy_check(run, ["external_energy"])]


def drum_mesh(n, has_triangles=False):
    def place(x, y, z):
        return (x * math.sqrt(1 - 0.5 * y * y), y * math.sqrt(1 - 0.5 * x * x), z)

    mesh = MeshMaker(place)
    (mesh.triangles if has_triangles else mesh.shells)("skin", (-1, -1, 0), (2, 2), (n, n), 0.001)
    mesh.node_set("rim", lambda x, y, z: max(abs(x), abs(y)) > 1 - 1e-9)
    mesh.side_set("below", [(element, 2) for element in range(1, (2 if has_triangles else 1) * n * n + 1)])
    return mesh


@case(refined=[8, 16, 32])
def drum(bench, n=16):
    exact = 0.653 * (8e4 / (200e9 * 0.001)) ** (1 / 3)
    checks = []
    for name, has_triangles in [("quadrilaterals", False), ("triangles", True)]:
        run = bench.run("drum", drum_mesh(n, has_triangles))
        late = run["Time"] > 0.15
        checks.append(Check(f"{name}: deflection [m]", exact, steady_part(run["Time"][late], run["middle"][late]), 0.005))
    return checks + [energy_check(run, ["external_energy"])]


def beam_mesh(n):
    mesh = MeshMaker()
    mesh.lines("beam", (0, 0, 0), (1, 0, 0), n)
    mesh.node_set("clamped", lambda x, y, z: x == 0)
    return mesh


@case(refined=[5, 10, 20])
def beam(bench, n=10):
    run = bench.run("beam", beam_mesh(n))
    checks = []
    for way, size in [("y", 0.05), ("z", 0.02)]:
        exact = 1.875104 ** 2 / (2 * math.pi) * math.sqrt(200e9 * size ** 2 / (12 * 7800))
        checks.append(Check(f"frequency along {way} [Hz]", exact, frequency_of(run["Time"], run[f"tip_{way}"]), 0.01))
    return checks + [energy_check(run, ["kinetic_energy"])]
