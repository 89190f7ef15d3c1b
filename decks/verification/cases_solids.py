# SPDX-License-Identifier: BSD-3-Clause
"""Solids without contact."""
import math

import numpy as np

import make_meshes
from cases import FORMULATIONS, case
from mesh_maker import MeshMaker
from runs import Check, at_most


def brick(name, size, cells, sets):
    mesh = MeshMaker()
    mesh.hexes(name, (0, 0, 0), size, cells)
    for set_name, is_in in sets.items():
        mesh.node_set(set_name, is_in)
    return mesh


def crossing(times, values, level):
    """The first time at which the values pass the level, by linear interpolation."""
    i = int(np.argmax(values >= level))
    return times[i - 1] + (level - values[i - 1]) / (values[i] - values[i - 1]) * (times[i] - times[i - 1])


def energy_check(run, terms):
    largest = max(np.max(np.abs(run[term])) for term in terms)
    return Check("energy balance", 0.0, np.max(np.abs(run["energy_error"])), 0.005, largest)


class Bar:
    """Elements of steel in uniaxial strain."""
    density, bulk, shear = 7800.0, 200e9 / (3 * 0.4), 200e9 / 2.6
    modulus = bulk + 4 / 3 * shear
    speed = math.sqrt(modulus / density)


def wave_in_bar_mesh(n):
    return brick("bar", (2, 0.1, 0.1), (n, 1, 1), {"wall": lambda x, y, z: x == 0})


@case()
def wave_in_bar(bench, n=100):
    run = bench.run("wave_in_bar", wave_in_bar_mesh(n))
    best = np.argmax(run["tip"])
    arrival = 2.0 / math.sqrt(3e12 / 7.8)
    return [Check("largest displacement of the free end", 1000 * arrival, run["tip"][best], 0.01),
            Check("time of it", arrival, run["Time"][best], 0.01), energy_check(run, ["kinetic_energy"])]


def graded_bar_mesh(n, short=0.1):
    """n equal elements of a bar of length 2 with a short one among them."""
    mesh, size, half = MeshMaker(), 2.0 / (n + short), n // 2
    for name, begin, end, cells in (("left", 0, half, half), ("short", half, half + short, 1),
                                    ("right", half + short, n + short, n - half)):
        mesh.hexes(name, (begin * size, 0, 0), ((end - begin) * size, size, size), (cells, 1, 1))
    mesh.node_set("wall", lambda x, y, z: x == 0)
    return mesh


def total_energy_check(name, run):
    total = run["kinetic_energy"] + run["internal_energy"]
    return at_most(f"{name}: change of energy", np.max(np.abs(total / total[0] - 1)), 0.01)


@case()
def graded_bar(bench, n=199):
    runs = {"plain": bench.run("graded_bar", graded_bar_mesh(n), subcycled=0),
            "subcycled": bench.run("graded_bar", graded_bar_mesh(n)),
            "by sizes": bench.run("graded_bar", graded_bar_mesh(n), small="all")}
    arrival = 2.0 / math.sqrt(3e12 / 7.8)
    checks = []
    for name, run in runs.items():
        best = np.argmax(run["tip"])
        checks += [Check(f"{name}: largest displacement of the free end", 1000 * arrival, run["tip"][best], 0.01),
                   Check(f"{name}: time of it", arrival, run["Time"][best], 0.01), total_energy_check(name, run),
                   energy_check(run, ["kinetic_energy"])]
    plain, cycled = runs["plain"], runs["subcycled"]
    off = np.abs(np.interp(cycled["Time"], plain["Time"], plain["tip"]) - cycled["tip"])
    checks.append(at_most("free end, subcycled less plain, of v L/c", np.max(off) / (1000 * arrival), 0.01))
    checks.append(at_most("free end, by sizes less named", np.max(np.abs(runs["by sizes"]["tip"] - cycled["tip"])), 0.0))
    return checks


@case(is_long=True)
def graded_bar_long_after(bench, n=60, short=0.163):
    """Vibrations that nothing damps go to and fro for 10^5 steps."""
    run = bench.run("graded_bar", graded_bar_mesh(n, short), end_time=5e-3)
    start = run["kinetic_energy"][0]
    return [at_most("change of energy", np.max(np.abs((run["kinetic_energy"] + run["internal_energy"]) / start - 1)), 0.01),
            at_most("kinetic energy beyond that of the start", np.max(run["kinetic_energy"] / start - 1), 0.01),
            at_most("internal energy below zero", np.max(-run["internal_energy"] / start), 0.01)]


def pushed_bar_mesh(n):
    return brick("bar", (1, 1 / n, 1 / n), (n, 1, 1), {"pushed": lambda x, y, z: x == 0})


@case(refined=[25, 50, 100, 200, 400])
def confined_bar(bench, n=100):
    run = bench.run("confined_bar", pushed_bar_mesh(n))
    times = run["Time"]
    behind = (times > 0.4 / Bar.speed) & (times < 0.8 / Bar.speed)
    return [Check("arrival in the middle", 0.5 / Bar.speed, crossing(times, run["middle_velocity"], 0.5), 0.01),
            Check("stress behind the front", -Bar.density * Bar.speed, np.mean(run["stress"][behind]), 0.01),
            energy_check(run, ["external_energy"])]


@case()
def elastic_plastic_bar(bench, n=200):
    run = bench.run("elastic_plastic_bar", pushed_bar_mesh(n))
    yield_stress, hardening, velocity = 400e6, 10e9, 100.0
    plastic = Bar.bulk + 4 / 3 * Bar.shear * hardening / (3 * Bar.shear + hardening)
    plastic_speed = math.sqrt(plastic / Bar.density)
    elastic_stress = yield_stress * Bar.modulus / (2 * Bar.shear)
    elastic_velocity = elastic_stress / (Bar.density * Bar.speed)
    stress = elastic_stress + Bar.density * plastic_speed * (velocity - elastic_velocity)
    times = run["Time"]
    behind = (times > 0.4 / plastic_speed) & (times < 0.6 / plastic_speed)
    plateau = 0.5 * (elastic_velocity + velocity)
    middle = run["middle_velocity"]
    return [Check("arrival of the elastic front", 0.5 / Bar.speed, crossing(times, middle, 0.5 * elastic_velocity), 0.02),
            Check("arrival of the plastic front", 0.5 / plastic_speed, crossing(times, middle, plateau), 0.02),
            Check("stress behind both", -stress, np.mean(run["stress"][behind]), 0.01),
            energy_check(run, ["external_energy"])]


def cantilever_mesh(n):
    return brick("beam", (1, 0.05, 0.1 / 2), (10 * n, 1, n), {"clamped": lambda x, y, z: x == 0})


def frequency(run):
    tip, times = run["tip"], run["Time"]
    rising = [i for i in range(1, len(tip)) if tip[i - 1] < 0 <= tip[i]]
    zeros = [0.0] + [times[i - 1] - tip[i - 1] / (tip[i] - tip[i - 1]) * (times[i] - times[i - 1]) for i in rising]
    return (len(zeros) - 1) / (zeros[-1] - zeros[0])


@case(refined=[2, 4, 8])
def cantilever(bench, n=4):
    run = bench.run("cantilever", cantilever_mesh(n))
    exact = 1.875104 ** 2 / (2 * math.pi) * math.sqrt(200e9 / 7800 * 0.05 ** 2 / 12)
    return [Check("frequency [Hz]", exact, frequency(run), 0.03), energy_check(run, ["kinetic_energy"])]


def tied_cantilever_mesh(n, over):
    """Halves of n and `over` elements over the thickness."""
    mesh = MeshMaker()
    for name, x, layers in (("near", 0, n), ("far", 0.5, over)):
        mesh.new_body()
        mesh.hexes(name, (x, 0, 0), (0.5, 0.05, 0.05), (5 * n, 1, layers))
    mesh.node_set("clamped", lambda x, y, z: x == 0)
    return mesh


@case()
def tied_cantilever(bench, n=4):
    one = frequency(bench.run("cantilever", cantilever_mesh(n)))
    checks, runs = [], []
    for form in FORMULATIONS:
        for over in (n, n + 1):
            runs.append(bench.run("cantilever", tied_cantilever_mesh(n, over), form=form))
            checks.append(Check(f"{form}, {n} and {over} layers: frequency over that of one mesh", 1.0,
                                frequency(runs[-1]) / one, 0.01))
    return checks + [energy_check(run, ["kinetic_energy"]) for run in runs]


def spinning_body_mesh(n):
    return brick("body", (0.2, 0.1, 0.05), (4 * n, 2 * n, n), {})


@case()
def spinning_body(bench, n=2):
    run = bench.run("spinning_body", spinning_body_mesh(n))
    x, v, mass = run.start + run.nodal("displacement"), run.nodal("velocity"), run.nodal("mass")
    momentum = np.sum(mass[..., None] * np.cross(x, v), axis=1)
    start, end = momentum[0], momentum[-1]
    kinetic, error = run.single("kinetic_energy")[0], run.single("energy_error")[-1]
    return [Check("change of angular momentum", 0.0, np.linalg.norm(end - start), 1e-9, np.linalg.norm(start)),
            at_most("largest von Mises stress [Pa]", np.max(run.element("von_mises", 1)[-1]), 31e6),
            Check("energy balance", 0.0, error, 0.001, kinetic)]


def total_energy(run):
    """The largest change of kinetic + internal energy, as a share of it."""
    total = run.single("kinetic_energy") + run.single("internal_energy")
    return np.max(np.abs(total / total[0] - 1))


def spin_checks(bench, n, formulations):
    checks = []
    for formulation in formulations:
        run = bench.run("steady_spin", brick("cube", (0.02, 0.02, 0.02), (n, n, n), {}), formulation=formulation)
        internal = run.single("internal_energy") / run.single("kinetic_energy")[0]
        checks += [at_most(f"change of kinetic + internal energy, {formulation}", total_energy(run), 0.001),
                   at_most(f"largest internal energy, {formulation}", np.max(np.abs(internal)), 0.001)]
    return checks


@case()
def steady_spin(bench, n=2):
    return spin_checks(bench, n, ["mean_quadrature", "selective_deviatoric", "fully_integrated"])


@case(is_long=True)
def steady_spin_fine(bench, n=8):
    return spin_checks(bench, n, ["mean_quadrature", "selective_deviatoric", "fully_integrated"])


@case()
def twisted_cube(bench, n=2):
    sides = {"left": lambda x, y, z: x == 0, "right": lambda x, y, z: x > 0.0799}
    run = bench.run("twisted_cube", brick("cube", (0.08, 0.08, 0.08), (n, n, n), sides))
    return [at_most("change of kinetic + internal energy", total_energy(run), 0.01)]


def thick_cylinder_mesh(n):
    def place(r, angle, z):
        return (r * math.cos(angle), r * math.sin(angle), z)

    mesh = MeshMaker(place)
    first = mesh.hexes("pipe", (1, 0, 0), (1, math.pi / 2, 0.1), (n, 2 * n, 1))
    mesh.node_set("on_x", lambda r, angle, z: angle == 0)
    mesh.node_set("on_y", lambda r, angle, z: abs(angle - math.pi / 2) < 1e-8)
    mesh.side_set("inside", [(first + n * j, 4) for j in range(2 * n)])
    return mesh


@case(refined=[4, 8, 16, 32])
def thick_cylinder(bench, n=16):
    run = bench.run("thick_cylinder", thick_cylinder_mesh(n))
    late = run["Time"] > 0.012
    a, b, p, nu, modulus = 1.0, 2.0, 1e6, 0.3, 200e9
    displacement = p * a * (1 + nu) / modulus * (a * a * (1 - 2 * nu) + b * b) / (b * b - a * a)
    # The mean stress of an element's middle: the mean of p a^2/(b^2 - a^2) (1 + b^2/r^2) over its thickness.
    outer = a + (b - a) / n
    hoop = p * a * a / (b * b - a * a) * (1 + b * b / (a * outer))
    return [Check("displacement of the inner wall", displacement, np.mean(run["inner"][late]), 0.01),
            Check("hoop stress of the innermost elements", hoop, np.mean(run["hoop"][late]), 0.03),
            energy_check(run, ["external_energy"])]


@case(refined=[3, 4, 6])
def taylor_bar(bench, n=4):
    run = bench.run("taylor_bar", make_meshes.taylor_bar(n))
    return [Check("length [m]", 21.5e-3, run["length"][-1], 0.03),
            Check("radius of the foot [m]", 7.1e-3, run["foot_radius"][-1], 0.03),
            energy_check(run, ["kinetic_energy"])]
