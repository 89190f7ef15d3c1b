# SPDX-License-Identifier: BSD-3-Clause
"""Curved and edged bodies that are pressed together in load steps, at default settings of contact."""
import itertools
import math

import numpy as np

from cases import FORMULATIONS, balances, case
from cases_hertz import cylinder_on_block, graded
from cases_static import blocks
from cases_static_contact import last_error
from mesh_maker import MeshMaker
from runs import Check, at_most
from shapes import add_ring_sector, near_zero


def near(value, level):
    return np.abs(value - level) < 1e-6


def two_rings(around):
    """Quarters of rings, half a millimetre long, with so many elements round each."""
    mesh = MeshMaker()
    add_ring_sector(mesh, "inner", 10, 20.0025, 0.5, (12, around[0], 1))
    add_ring_sector(mesh, "outer", 20, 30, 0.5, (12, around[1], 1))
    for axis, name in enumerate(("on_x", "on_y", "on_z")):
        mesh.node_set_where(name, lambda *place, axis=axis: near(place[axis], 0))
    mesh.side_set("inner_side", mesh.sides_where("inner", lambda x, y, z: near(np.hypot(x, y), 20.0025)))
    mesh.side_set("outer_side", mesh.sides_where("outer", lambda x, y, z: near(np.hypot(x, y), 20)))
    return mesh


def mean_fit_pressure(run):
    """Radial forces over the area of the interface."""
    side = run.nodes_of(1)
    side = side[near(np.hypot(*run.start[side, :2].T), 20.0025)]
    outwards = run.start[side, :2] / 20.0025
    return -np.sum(run.nodal("force_contact")[-1, side, :2] * outwards) / (0.5 * math.pi * 20 * 0.5)


@case()
def static_fit(bench):
    """CalculiX issue 98."""
    checks, runs = [], []
    for form in FORMULATIONS:
        for around, smoothing, bar in (((24, 24), "off", 0.01), ((24, 24), "auto", 0.003), ((24, 32), "auto", 0.003)):
            run = bench.run("static_fit", two_rings(around), form=form, smoothing=smoothing, free_length=1)
            runs.append(run)
            label = f"{form}, {around[0]} and {around[1]} elements, smoothing {smoothing}: mean pressure [MPa]"
            checks.append(Check(label, 5.8594, mean_fit_pressure(run), bar))
    run = bench.run("static_fit", two_rings((24, 32)), smoothing="auto")
    runs.append(run)
    return [*checks, Check("plane strain: mean pressure [MPa]", 5.8594 / 0.91, mean_fit_pressure(run), 0.003),
            *balances(runs)]


@case()
def static_lowered_blocks(bench):
    """code_aster SSNP121; its pressure of 1e5 is E log(0.95) at finite strain, E 0.1/1.95 by the motion of one step."""
    checks, runs = [], []
    for (lower, upper), (steps, stress) in itertools.product(((3, 2), (2, 3)), ((1, -2e6 * 0.1 / 1.95), (2, 2e6 * math.log(0.95)))):
        run = bench.run("static_patch", blocks(lower, upper, 1.0, 2), load="depth", amount=0.1, nu=0, youngs=2e6, steps=steps)
        runs.append(run)
        low = run.nodes_of(1)[run.start[run.nodes_of(1), 2] == 1.0]
        level = run.nodal("displacement")[-1, low, 2]
        label = f"{upper}x{upper} on {lower}x{lower}, steps: {steps}"
        checks += [at_most(f"{label}: error of stress", last_error(run, stress), 1e-4),
                   Check(f"{label}: interface, the worst node", -0.05, level[np.argmax(np.abs(level + 0.05))], 1e-4)]
    return checks + balances(runs)


def plate(n):
    mesh = MeshMaker()
    mesh.hexes("plate", (0, 0, 0), (0.04, 0.04 / n, 0.04), (n, 1, n))
    mesh.node_set_where("middle", lambda x, y, z: near(x, 0.04))
    mesh.side_set("top", mesh.sides_where("plate", lambda x, y, z: near(z, 0.04)))
    mesh.side_set("end", mesh.sides_where("plate", lambda x, y, z: near(x, 0)))
    mesh.side_set("foot", mesh.sides_where("plate", lambda x, y, z: near(z, 0)))
    return mesh


@case()
def static_plate(bench):
    """code_aster SSNV128."""
    run = bench.run("static_plate", plate(16))
    line = np.flatnonzero(near(run.start[:, 1], 0) & near(run.start[:, 2], 0))
    line = line[np.argsort(run.start[line, 0])]
    checks = []
    for place, way in ((0, 2.861e-5), (1.25e-3, 2.722e-5), (5e-3, 2.285e-5), (7.5e-3, 1.98e-5), (11.25e-3, 1.54e-5)):
        reached = np.interp(place, run.start[line, 0], run.nodal("displacement")[-1, line, 0])
        checks.append(Check(f"{1e3 * place:g} mm from the end [m]", way, reached, 0.01))
    return checks + balances([run], has_plane=True)


def second_moment_width(run):
    """Of pressure as Hertz has it the mean of x^2 is a quarter of the half width's [length]."""
    ball = run.nodes_of(1)
    force = run.nodal("force_contact")[-1, ball, 2]
    return 2 * math.sqrt(np.sum(force * run.start[ball, 0] ** 2) / np.sum(force))


@case(is_long=True)
def static_cylinder_on_block(bench):
    """NAFEMS CGS-1 without friction, and with: numbers of code_aster's V6.03.154, which MARC shares."""
    checks, runs = [], []
    for friction in (0.0, 0.1):
        run = bench.run("static_hertz", cylinder_on_block(50, 0.78, 28, 24, 100), youngs=210e3, nu=0.3, density=7.8e-9,
                        base="body", base_youngs=70e3, drive="pressure", amount=17.5e3 / 32.5, plane_strain=1,
                        friction=friction)
        runs.append(run)
        below = -run.element("stress_zz", 2)[-1, 28 * 27]
        if friction == 0.0:
            checks += [Check("largest pressure, in the block [MPa]", 3585.37, below, 0.03),
                       Check("half width, by the second moment of forces [mm]", 6.21, second_moment_width(run), 0.03)]
        else:
            base = run.nodes_of(2)
            touched = base[np.argmin(np.sum(run.start[base] ** 2, axis=1))]
            checks += [Check("friction: largest pressure, in the block [MPa]", 3542.69, below, 0.03),
                       Check("friction: lowest point of the cylinder [mm]", -1.30264,
                             run.nodal("displacement")[-1, touched, 2], 0.01)]
    return checks + balances(runs[:1]) + balances(runs[1:], has_friction=True)


def half_below(radius, n, slope=0.2):
    """A quarter of a cylinder along y over z = 0, one cell long: a core of n x n cells, under its faces n/2 layers of others; the
    cells at the lowest line are those of an even mesh times the slope."""
    def place(x, y, up):
        down = -up
        x = near_zero(x, slope) if x < 1 else x
        down = 2 - near_zero(2 - down, slope) if down > 1 else down
        inner = np.minimum((x, down), 1)
        core = 0.55 * radius * inner * (1 - 0.15 * inner[::-1] ** 2)
        share = max(x, down) - 1
        if share > 0:
            angle = 0.25 * math.pi * (inner[0] if down > 1 else 2 - inner[1])
            core = core + share * (radius * np.array((math.sin(angle), math.cos(angle))) - core)
        return core[0], y, radius - core[1]

    mesh, length = MeshMaker(place), 0.05 * radius / n
    mesh.hexes("ball", (0, 0, -2), (1, length, 1), (n, 1, n // 2))
    mesh.hexes("ball", (0, 0, -1), (1, length, 1), (n, 1, n))
    mesh.hexes("ball", (1, 0, -1), (1, length, 1), (n // 2, 1, n))
    mesh.node_set_where("on_x", lambda x, y, z: near(x, 0))
    mesh.side_set("top", mesh.sides_where("ball", lambda x, y, z: near(z, radius)))
    return mesh, length


@case(is_long=True)
def static_cylinder_on_plane(bench):
    """CalculiX without large motion, faces on faces: 67.83 with these elements, 68.74 with the finest of a series of others."""
    mesh, length = half_below(8, 32)
    run = bench.run("static_hertz", mesh, plane_strain=1)
    force = 2 * run["force"][-1] / length
    return [Check("force over length, CalculiX with the same mesh [N/mm]", 67.827, force, 0.005),
            Check("force over length, finest of another series of CalculiX [N/mm]", 68.74, force, 0.005, known_miss=0.016),
            *balances([run], has_plane=True)]


def cubes(depth):
    """Two unit cubes, the upper one lowered into the lower."""
    mesh = MeshMaker()
    mesh.hexes("lower", (0, 0, 0), (1, 1, 1), (2, 2, 2))
    mesh.new_body()
    mesh.hexes("upper", (0, 0, 1 - depth), (1, 1, 1), (2, 2, 2))
    for axis, name in enumerate(("on_x", "on_y", "bottom")):
        mesh.node_set_where(name, lambda *place, axis=axis: near(place[axis], 0))
    mesh.side_set("top", mesh.sides_where("upper", lambda x, y, z: near(z, 2 - depth)))
    return mesh


@case()
def static_overlap(bench):
    """The overlap of CalculiX's example contact3, 0.02, under a pressure that presses the lower cube by 1.415e-5."""
    checks, runs = [], []
    for form in FORMULATIONS:
        run = bench.run("static_patch", cubes(0.02), form=form, nu=0, amount=14.15)
        runs.append(run)
        moved = run.nodal("displacement")[-1, :, 2]
        sides = [run.nodes_of(block)[near(run.start[run.nodes_of(block), 2], level)] for block, level in ((1, 1), (2, 0.98))]
        checks += [Check(f"{form}: lower side", -1.415e-5, np.mean(moved[sides[0]]), 0.01),
                   Check(f"{form}: upper side", 0.02 - 1.415e-5, np.mean(moved[sides[1]]), 0.01)]
    return checks + balances(runs)


def pressed_rings(around):
    mesh = MeshMaker()
    mesh_angle = 0.5 * math.pi / around[1]
    add_ring_sector(mesh, "inner", 0.5, 1, 0.05, (12, around[0], 1))
    add_ring_sector(mesh, "outer", 1, 1.5, 0.05, (12, around[1], 1))
    for axis, name in enumerate(("on_x", "on_y")):
        mesh.node_set_where(name, lambda *place, axis=axis: near(place[axis], 0))
    for block in ("inner", "outer"):
        mesh.side_set(f"{block}_side", mesh.sides_where(block, lambda x, y, z: near(np.hypot(x, y), 1)))
    for i in range(around[1]):
        def is_in(x, y, z, middle=(i + 0.5) * mesh_angle):
            return near(np.hypot(x, y), 1.5) & (np.abs(np.arctan2(y, x) - middle) < 0.6 * mesh_angle)
        mesh.side_set(f"outside_{i + 1}", mesh.sides_where("outer", is_in))
    return mesh


def ring_pressures():
    """The mean contact pressure of the rings and its part in cos 2a; frictionless, by Michell's stress functions."""
    kappa, a, b, c = 3 - 4 * 0.2, 0.5, 1.0, 1.5

    # Of r^2, r^-2, r^4 and 1, each times cos 2a: normal stress, shear and 2 G times the radial displacement.
    def normal(r):
        return np.array([-2, -6 / r ** 4, 0, -4 / r ** 2])

    def shear(r):
        return np.array([2, -6 / r ** 4, 6 * r ** 2, -2 / r ** 2])

    def radial(r):
        return np.array([-2 * r, 2 / r ** 3, (kappa - 3) * r ** 3, (kappa + 1) / r])

    none = np.zeros(4)
    rows = [(normal(a), none), (shear(a), none), (shear(b), none), (none, shear(b)), (normal(b), -normal(b)),
            (radial(b), -radial(b)), (none, normal(c)), (none, shear(c))]
    found = np.linalg.solve(np.array([np.concatenate(row) for row in rows]), [0, 0, 0, 0, 0, 0, -1e4, 0])
    return 1e5 * c * c / (c * c - a * a) * (1 - a * a / (b * b)), -normal(b) @ found[:4]


@case()
def static_rings(bench):
    """code_aster SSNP167."""
    mean, varying = ring_pressures()
    checks, runs = [], []
    for form, around, smoothing in (("face_face", (24, 32), "auto"), ("face_face", (32, 32), "off"),
                                    ("node_face", (24, 32), "auto")):
        run = bench.run("static_rings", pressed_rings(around), form=form, smoothing=smoothing)
        runs.append(run)
        side = run.nodes_of(1)
        side = side[near(np.hypot(*run.start[side, :2].T), 1)]
        angle = np.arctan2(run.start[side, 1], run.start[side, 0])
        force = -np.sum(run.nodal("force_contact")[-1, side, :2] * run.start[side, :2], axis=1)
        area = 0.5 * math.pi * 0.05
        share = area / around[0] / 2 * np.where(near(angle, 0) | near(angle, 0.5 * math.pi), 0.5, 1)
        worst = np.max(np.abs(force / share - mean - varying * np.cos(2 * angle))) / mean
        label = f"{form}, {around[0]} and {around[1]} elements, smoothing {smoothing}"
        checks += [Check(f"{label}: mean pressure [Pa]", mean, np.sum(force) / area, 0.02),
                   Check(f"{label}: its part in cos 2a [Pa]", varying, 2 * np.sum(force * np.cos(2 * angle)) / area, 0.02),
                   at_most(f"{label}: error at the worst node", worst, 0.02)]
    return checks + balances(runs)


SECTOR = math.radians(5)


def on_sector(r, j, z):
    return r * math.cos(j * SECTOR), r * math.sin(j * SECTOR), z


def with_sector_sets(mesh, height):
    mesh.node_set_where("first_plane", lambda x, y, z: near(y, 0))
    mesh.node_set_where("second_plane", lambda x, y, z: near(np.arctan2(y, x), SECTOR))
    mesh.node_set_where("bottom", lambda x, y, z: near(z, np.min(z)))
    mesh.side_set("top", mesh.sides_where("punch", lambda x, y, z: near(z, height)))
    mesh.side_set("seat", mesh.sides_where("base", lambda x, y, z: near(z, 0)))
    return mesh


def punch_on_block():
    """A sector of 5 degrees, one element wide, fine towards the rounded edge."""
    flat, bend, up, hole = 24, 10, 24, 1.0
    levels = np.linspace(0, 1, up + 1) ** 1.6

    def inside(share):
        return hole + (40 - hole) * (1 - (1 - share) ** 1.5)

    def of_punch(i, j, k):
        column, level = round(i), levels[round(k)]
        beyond = max(column - flat, 0) / bend
        high = inside(min(column / flat, 1))
        low, high = high + 10 * math.sin(math.radians(60) * beyond), high + 10 * beyond
        level_low = 10 * (1 - math.cos(math.radians(60) * beyond))
        return on_sector(low + level * (high - low), j, level_low + level * (100 - level_low))

    across = np.concatenate([inside(np.linspace(0, 1, 21)), 40 + 60 * np.linspace(0, 1, 21)[1:] ** 1.6])
    mesh = MeshMaker(of_punch)
    mesh.hexes("punch", (0, 0, 0), (flat + bend, 1, up), (flat + bend, 1, up))
    mesh.new_body()
    mesh.place = lambda i, j, k: on_sector(across[round(i)], j, -200 * (1 - round(k) / 30) ** 1.8)
    mesh.hexes("base", (0, 0, 0), (40, 1, 30), (40, 1, 30))
    mesh.side_set("foot", [(i, 5) for i in range(1, flat + bend + 1)])
    return with_sector_sets(mesh, 100)


def flat_punch_on_block():
    """The same of a flat punch of 10 mm, fine towards its edge, and of a block whose elements grow by a fifth."""
    inside, down = 0.05 + 9.95 * (1 - (1 - np.linspace(0, 1, 25)) ** 2), np.array([0, *np.geomspace(0.1, 1000, 41)])
    across = np.array([*inside, *(10 + down[1:] * 0.99)])
    mesh = MeshMaker(lambda i, j, k: on_sector(inside[round(i)], j, 5 * (k / 8) ** 1.5))
    mesh.hexes("punch", (0, 0, 0), (24, 1, 8), (24, 1, 8))
    mesh.new_body()
    mesh.place = lambda i, j, k: on_sector(across[round(i)], j, -down[41 - round(k)])
    mesh.hexes("base", (0, 0, 0), (len(across) - 1, 1, 41), (len(across) - 1, 1, 41))
    mesh.side_set("foot", [(i, 5) for i in range(1, 25)])
    return with_sector_sets(mesh, 5)


@case()
def static_punch(bench):
    """NAFEMS CGS-2."""
    run = bench.run("static_punch", punch_on_block())
    moved, base = run.nodal("displacement")[-1], run.nodes_of(2)
    line = base[near(run.start[base, 1], 0) & near(run.start[base, 2], 0)]
    line = line[np.argsort(run.start[line, 0])]
    checks = [Check(f"radial displacement at {place} mm [mm]", way, np.interp(place, run.start[line, 0], moved[line, 0]), 0.02)
              for place, way in ((20, -4.690e-3), (30, -8.000e-3), (42, -17.97e-3), (50, -13.895e-3))]
    top = np.argmin(np.sum((run.start - (1, 0, 100)) ** 2, axis=1))
    return [*checks, Check("top of the punch [mm]", -0.18497, moved[top, 2], 0.02), *balances([run])]


@case(is_long=True)
def static_flat_punch(bench):
    """Boussinesq."""
    run = bench.run("static_punch", flat_punch_on_block(), depth=0.01)
    force = np.sum(run.nodal("force_contact")[-1, run.nodes_of(1), 2]) * 2 * math.pi / SECTOR
    return [Check("force [N]", 2 * 10 * 70e3 / 0.91 * 0.01, force, 0.03), *balances([run])]


def whole_cylinders(radius, step, n, layers):
    """The columns of cases_hertz on both sides of the middle, of two cylinders on each other."""
    half = graded(step, 10, n, 0.65 * radius)
    across, along = np.array([*(-half[:0:-1]), *half]), graded(step / radius, 6, layers)

    def place(i, j, k, sign):
        x, share = across[round(i)], along[round(k)]
        surface = radius - math.sqrt(radius ** 2 - x ** 2)
        return x, j * step, sign * (surface + share * (radius - surface))
    mesh = MeshMaker(lambda i, j, k: place(i, j, k, 1))
    mesh.hexes("ball", (0, 0, 0), (2 * n, 1, layers), (2 * n, 1, layers))
    mesh.new_body()
    mesh.place = lambda i, j, k: place(i, j, layers - k, -1)
    mesh.hexes("base", (0, 0, 0), (2 * n, 1, layers), (2 * n, 1, layers))
    mesh.node_set_where("bottom", lambda x, y, z: near(z, -radius))
    mesh.side_set("top", mesh.sides_where("ball", lambda x, y, z: near(z, radius)))
    return mesh


@case(is_long=True)
def static_partial_slip(bench):
    """Cattaneo and Mindlin."""
    checks, runs, step, friction = [], [], 0.1, 0.3
    for shift in (0.04, 0.06):
        run = bench.run("static_hertz", whole_cylinders(8, step, 20, 16), plane_strain=1, friction=friction, base="body",
                        amount=0.12, shift=shift)
        runs.append(run)
        ball = run.nodes_of(1)
        force = run.nodal("force_contact")[-1, ball]
        push, pull = np.sum(force[:, 2]), np.abs(np.sum(force[:, 0]))
        share = pull / (friction * push)
        size = math.sqrt(4 * push / step * 4 / (math.pi * 500 / 0.91))
        sticks = (force[:, 2] > 1e-3 * np.max(force[:, 2])) & (np.abs(force[:, 0]) < 0.97 * friction * force[:, 2])
        checks.append(Check(f"Q / (mu P) = {share:.3f}: half width of what sticks [mm]", size * math.sqrt(1 - share),
                            np.max(run.start[ball[sticks], 0]), step, 1.0))
    return checks + balances(runs, has_friction=True)
