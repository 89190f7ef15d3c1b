# SPDX-License-Identifier: BSD-3-Clause
"""Thin sheets and sharp folds that nothing may pass."""
import math

import numpy as np

from cases import FORMULATIONS, balances, case
from mesh_maker import MeshMaker
from runs import Check, at_most


def turn_about(axis, angle):
    axis = np.array(axis, dtype=float) / np.linalg.norm(axis)
    cross = np.cross(np.eye(3), -axis).T
    return np.eye(3) + math.sin(angle) * cross + (1 - math.cos(angle)) * cross @ cross


def onto_z(direction):
    """Turns a direction to (0, 0, 1)."""
    direction = np.array(direction, dtype=float) / np.linalg.norm(direction)
    return turn_about(np.cross(direction, (0, 0, 1)), math.acos(direction[2]))


# The way that looks down in a cube which stands on a face, an edge along or across the fold, or a vertex.
PROBES = {"face": np.eye(3), "edge along": turn_about((0, 1, 0), math.pi / 4), "edge across": turn_about((1, 0, 0), math.pi / 4),
          "skew edge": turn_about((0, 0, 1), 0.5) @ turn_about((1, 0, 0), math.pi / 4), "vertex": onto_z((1, 1, 1))}


def add_cube(mesh, probe, spot, side=0.05):
    """A cube whose lowest point, edge or face is at a spot."""
    matrix = PROBES[probe]
    corners = 0.5 * side * np.array([(a, b, c) for a in (-1, 1) for b in (-1, 1) for c in (-1, 1)]) @ matrix.T
    lift = np.array(spot) - (0, 0, np.min(corners[:, 2]))
    mesh.new_body()
    mesh.place = lambda x, y, z: tuple(matrix @ (x, y, z) + lift)
    mesh.hexes("probe", (-0.5 * side,) * 3, (side,) * 3, (2, 2, 2))


def cube_over_fold(angle, probe, thickness):
    """Two sheets that meet at an angle inside, along y; three that meet as those of a cube's corner for "corner"."""
    mesh = MeshMaker()
    if angle == "corner":
        up = onto_z((1, 1, 1))
        for axis in range(3):
            def place(u, v, _, axis=axis):
                spot = np.zeros(3)
                spot[(axis + 1) % 3], spot[(axis + 2) % 3] = -u, -v
                return tuple(up @ spot)
            mesh.place = place
            mesh.shells("sheet", (0, 0, 0), (0.3, 0.3), (4, 4), thickness)
    else:
        half = math.radians(angle) / 2
        for side in (-1, 1):
            mesh.place = lambda s, y, _, side=side: (side * math.sin(half) * s, y, -math.cos(half) * s)
            mesh.shells("sheet", (0, -0.2, 0), (0.4, 0.4), (4, 4), thickness)
    aside = (5e-4, 3e-4) if angle == "corner" else (0.003, 0.007)  # beside a corner's top slopes lead down
    add_cube(mesh, probe, (*aside, thickness / 2 + 5e-4))
    return mesh


def cube_over_sheet(thickness):
    mesh = MeshMaker()
    mesh.shells("sheet", (-0.1, -0.1, 0), (0.2, 0.2), (8, 8), thickness)
    add_cube(mesh, "face", (0.003, 0.004, 2e-3))
    return mesh


def rebound_checks(label, run, speed, given_out):
    nodes = run.nodes_of(2)
    share = run.nodal("mass")[0, nodes] / run.mass(2)
    velocity = np.einsum("n,snc->sc", share, run.nodal("velocity")[:, nodes])
    fastest = np.max(np.linalg.norm(velocity, axis=1)) / speed
    return [at_most(f"{label}: still flying down", float(velocity[-1, 2] < 0), 0),
            at_most(f"{label}: faster than it came by", max(0.0, fastest - 1), 0.01),
            at_most(f"{label}: energy given out by contact over that of the flight",
                    max(0.0, -np.min(run["contact_energy"])) / run["kinetic_energy"][0], given_out)]


@case()
def sharp_folds(bench):
    checks, runs = [], []
    for form in FORMULATIONS:
        for angle, probe in ((30, "vertex"), (60, "edge across"), (90, "vertex"), (90, "edge along"), (90, "skew edge"),
                             (120, "vertex"), ("corner", "vertex")):
            runs.append(bench.run("folded_sheet", cube_over_fold(angle, probe, 0.02), form=form))
            checks += rebound_checks(f"{form}, {angle}, {probe}", runs[-1], 5, 0.05)
    return checks + balances(runs)


@case()
def folds_penalty(bench):
    """By the elastic penalty: thick and thin folds and sheets. At 400 m/s the step falls to a tenth within the hit, which shows
    in the energy balance: central differences keep an energy that depends on the step."""
    checks, runs, fast = [], [], []
    for form in FORMULATIONS:
        for angle, probe, thickness in ((30, "vertex", 0.02), (60, "edge across", 0.02), (90, "vertex", 0.02),
                                        (90, "skew edge", 0.02), ("corner", "vertex", 0.02), (90, "vertex", 0.002)):
            runs.append(bench.run("folded_sheet", cube_over_fold(angle, probe, thickness), form=form, thickness=thickness,
                                  enforcement="penalty"))
            checks += rebound_checks(f"{form}, {angle}, {probe}, {1e3 * thickness:g} mm", runs[-1], 5, 0.02)
        for speed in (40, 400):
            fast.append(bench.run("folded_sheet", cube_over_sheet(1e-3), form=form, thickness=1e-3, speed=speed,
                                  enforcement="penalty"))
            checks += rebound_checks(f"{form}, 1 mm, {speed} m/s", fast[-1], speed, 0.02)
            checks.append(at_most(f"{form}, 1 mm, {speed} m/s: penetration over the thickness",
                                  np.max(fast[-1]["penetration"]) / 1e-3, 0.5))
    return checks + balances(runs) + balances(fast, tolerance=0.05)


@case()
def thin_sheet(bench):
    checks, runs = [], []
    for form in FORMULATIONS:
        for speed in (40, 400):  # m/s; 400 is 3 thicknesses in a step
            runs.append(bench.run("folded_sheet", cube_over_sheet(1e-3), form=form, thickness=1e-3, speed=speed))
            checks += rebound_checks(f"{form}, {speed} m/s", runs[-1], speed, 0.02)
    return checks + balances(runs)


def blade_over_block(kind, slope):
    """A wedge along y or a cone of eight sides, whose sides rise by an angle, above a block."""
    mesh = MeshMaker()
    rise = math.tan(math.radians(slope))
    if kind == "wedge":
        half = min(0.7, 1 / rise)

        def place(across, y, up):
            low = abs(across) * half * rise
            return 2.42 + across * half, y, 0.01 + low + up * (1.6 - low)
        mesh.place = place
        mesh.hexes("blade", (-1, -0.1, 0), (2, 1.2, 1), (4, 5, 3))
        mesh.place = lambda x, y, z: (x, y, z)
    else:
        mesh.cone("blade", (2.42, 0.48, 0.01), 1.5, 1.5 / rise, 8)
    mesh.new_body()
    mesh.hexes("soft", (0, -1, -2), (4, 3, 2), (16, 12, 8))
    mesh.node_set("bottom", lambda x, y, z: z == -2)
    return mesh


def height_of_top(spots, n_x, place):
    """Where a vertical line meets a grid of spots whose rows are n_x long: each cell as two triangles."""
    rows = spots.reshape(-1, n_x, 3)
    heights = []
    for cell in ((rows[:-1, :-1], rows[:-1, 1:], rows[1:, 1:]), (rows[:-1, :-1], rows[1:, 1:], rows[1:, :-1])):
        a, b, c = (corner.reshape(-1, 3) for corner in cell)
        sides = np.stack((b - a, c - a), axis=-1)
        shares = np.linalg.solve(sides[:, :2], (place - a[:, :2])[..., None])
        is_in = (np.min(shares, axis=(1, 2)) >= 0) & (np.sum(shares, axis=(1, 2)) <= 1)
        heights += list((a[:, 2] + (sides[:, 2:] @ shares)[:, 0, 0])[is_in])
    return max(heights)


@case()
def blades(bench):
    checks, runs = [], []
    for form in FORMULATIONS:
        for kind, slope in (("wedge", 60), ("wedge", 75), ("wedge", 85), ("cone", 60), ("cone", 75), ("cone", 85)):
            run = bench.run("blades", blade_over_block(kind, slope), form=form)
            now = run.start + run.nodal("displacement")[-1]
            top = np.flatnonzero(run.start[:, 2] == 0.0)
            top = top[np.lexsort((run.start[top, 0], run.start[top, 1]))]
            runs.append(run)
            checks.append(Check(f"{form}, {kind}, sides that rise at {slope} degrees: the top below its edge [m]", -0.15,
                                height_of_top(now[top], 17, np.array([2.42, 0.48])), 0.25, 0.25))
    return checks + balances(runs)
