#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Makes the meshes of the decks in this folder: ./make_meshes.py [FOLDER]

The meshes are kept beside the decks; this script is here to say what they hold and to make them again.
"""
import math
import sys
from pathlib import Path

import numpy as np

from mesh_maker import MeshMaker


def two_blocks():
    """Two bricks that share nodes, a patch on top across their joint, a shell on part of the second brick."""
    mesh = MeshMaker()
    left = mesh.hexes("left", (0, 0, 0), (4, 4, 2), (4, 4, 2))
    right = mesh.hexes("right", (4, 0, 0), (4, 4, 2), (4, 4, 2))
    mesh.shells("cladding", (6, 0, 2), (2, 4), (2, 4), 0.1)
    top = 16  # first element of the upper layer, counted in its block
    patch = [(left + top + 4 * j + i, 6) for j in (1, 2) for i in (2, 3)]
    patch += [(right + top + 4 * j + i, 6) for j in (1, 2) for i in (0, 1)]
    mesh.side_set("patch", patch)
    return mesh


def taylor_bar(across=4):
    """A quarter of a rod, 3.2 mm by 32.4 mm: a core with bulging sides and a ring about it."""
    along, radius, length = 10 * across, 3.2e-3, 32.4e-3

    def core(x, y):
        return 0.55 * radius * x * (1 - 0.15 * y * y), 0.55 * radius * y * (1 - 0.15 * x * x)

    def place(x, y, z):
        share = max(x, y) - 1
        if share <= 0:
            return (*core(x, y), z)
        angle = math.pi / 4 * y if x > 1 else math.pi / 4 * (2 - x)
        inner = core(min(x, 1), min(y, 1))
        outer = radius * math.cos(angle), radius * math.sin(angle)
        return (*(i + share * (o - i) for i, o in zip(inner, outer)), z)

    mesh = MeshMaker(place)
    mesh.hexes("core", (0, 0, 0), (1, 1, length), (across, across, along))
    mesh.hexes("east", (1, 0, 0), (1, 1, length), (across, across, along))
    mesh.hexes("north", (0, 1, 0), (1, 1, length), (across, across, along))
    mesh.node_set("wall", lambda x, y, z: z == 0)
    mesh.node_set("on_x", lambda x, y, z: y == 0)
    mesh.node_set("on_y", lambda x, y, z: x == 0)
    return mesh


def ball_on_plate(across=6):
    """A ball of 10 mm radius, 0.1 mm above the corner of a plate of 60 x 40 x 4 mm."""
    radius, core, height = 10e-3, 0.45, 10.1e-3

    def place(x, y, z):
        """From the cube |x|, |y|, |z| <= 2, whose middle |x|, |y|, |z| <= 1 becomes the core."""
        most = max(abs(x), abs(y), abs(z))
        inner = np.array([x, y, z]) / max(most, 1)
        bulge = 1 - 0.12 * (np.dot(inner, inner) - inner * inner)  # sides of the core bend outwards
        inner_place = core * radius * inner * bulge
        if most <= 1:
            point = inner_place
        else:
            # On the sphere, angles are shared out evenly.
            direction = np.tan(math.pi / 4 * inner)
            outer = radius * direction / np.linalg.norm(direction)
            point = inner_place + (most - 1) * (outer - inner_place)
        return point[0], point[1], point[2] + height

    mesh = MeshMaker()
    mesh.hexes("plate", (-15e-3, -20e-3, -4e-3), (60e-3, 40e-3, 4e-3), (30, 20, 4))
    mesh.node_set("rim", lambda x, y, z: max(abs(x - 15e-3) - 30e-3, abs(y) - 20e-3) > -1e-9)
    patch = [(30 * 20 * 3 + 30 * j + i + 1, 6) for j in range(6, 14) for i in range(4, 16)]
    mesh.side_set("target", patch)
    mesh.new_body()
    mesh.place = place
    mesh.hexes("ball", (-1, -1, -1), (2, 2, 2), (across, across, across))
    mesh.shell_of_cube("ball", across, across // 2)
    return mesh


def near(value, level):
    return np.abs(value - level) < 1e-6


def pressed_ball(n=8):
    """An eighth of a ball of 10 mm radius over a quarter of a plate of 20 x 20 x 4 mm (mm)."""
    radius, core = 10.0, 0.5

    def place(x, y, z):
        """From the cube 0 <= x, y, -z <= 2, whose corner at the origin, up to 1, becomes the core."""
        most = max(x, y, -z)
        # Smaller cells at the lowest point.
        fine = [0.6 * t + 0.4 * t ** 3 if t < 1 else t for t in (x, y)]
        inner = np.array([min(fine[0], 1), min(fine[1], 1), max(z, -1)])
        inner_place = core * radius * inner * (1 - 0.12 * (np.dot(inner, inner) - inner * inner))
        if most <= 1:
            point = inner_place
        else:
            out = np.where(np.abs([x, y, z]) > 1, np.sign([x, y, z]), np.tan(math.pi / 4 * inner))
            point = inner_place + (most - 1) * (radius * out / np.linalg.norm(out) - inner_place)
        return point[0], point[1], point[2] + radius

    mesh = MeshMaker(place)
    for origin, cells in (((0, 0, -1), (n, n, n)), ((0, 0, -2), (n, n, n // 2)), ((1, 0, -1), (n // 2, n, n)),
                          ((0, 1, -1), (n, n // 2, n))):
        mesh.hexes("ball", origin, (1, 1, 1), cells)
    mesh.new_body()
    mesh.place = lambda x, y, z: (x, y, z)
    mesh.hexes("plate", (0, 0, -2), (10, 10, 2), (10, 10, 2))
    mesh.node_set_where("on_x", lambda x, y, z: near(x, 0))
    mesh.node_set_where("on_y", lambda x, y, z: near(y, 0))
    mesh.node_set_where("ground", lambda x, y, z: near(z, -2))
    mesh.node_set_where("middle", lambda x, y, z: near(z, radius))
    return mesh


def bolted_joint(around=6):
    """A quarter of a flange of 10 mm on z = 0 and of the upper half of a bolt of 10 mm, whose head is meshed 0.01 mm into it (mm)."""
    shank, head, hole, rim, overlap = 5.0, 9.0, 5.5, 25.0, 0.01

    def place(x, y, z):
        """Up to 1 the core, to 2 the ring about it, to 3 the head."""
        most = max(x, y)
        inner = min(x, 1.0), min(y, 1.0)
        core = np.array([0.55 * shank * inner[0] * (1 - 0.15 * inner[1] ** 2), 0.55 * shank * inner[1] * (1 - 0.15 * inner[0] ** 2)])
        if most > 1:
            angle = math.pi / 4 * (y if x > 1 else 2 - x)
            out = np.array([math.cos(angle), math.sin(angle)])
            core = core + (most - 1) * (shank * out - core) if most <= 2 else (shank + (most - 2) * (head - shank)) * out
        return core[0], core[1], z

    mesh = MeshMaker(place)
    for level, height, n in ((0.0, 10.0 - overlap, 6), (10.0 - overlap, 6.0, 4)):
        for origin in ((0, 0), (1, 0), (0, 1)):
            mesh.hexes("bolt", (*origin, level), (1, 1, height), (around, around, n))
        if height == 6.0:
            mesh.hexes("bolt", (2, 0, level), (1, 1, height), (4, around, n))
            mesh.hexes("bolt", (0, 2, level), (1, 1, height), (around, 4, n))
    mesh.new_body()
    # Cells grow outwards.
    mesh.place = lambda r, angle, z: ((hole + (rim - hole) * r ** 1.4) * math.cos(angle),
                                      (hole + (rim - hole) * r ** 1.4) * math.sin(angle), z)
    mesh.hexes("flange", (0, 0, 0), (1, math.pi / 2, 10), (12, 2 * around, 4))
    mesh.node_set_where("on_x", lambda x, y, z: near(x, 0))
    mesh.node_set_where("on_y", lambda x, y, z: near(y, 0))
    mesh.node_set_where("middle", lambda x, y, z: near(z, 0) & (np.hypot(x, y) < hole - 0.1))
    mesh.side_set("pulled", mesh.sides_where("flange", lambda x, y, z: near(z, 10) & (np.hypot(x, y) > 18)))
    mesh.side_set("joint", mesh.sides_where("flange", lambda x, y, z: near(z, 0)))
    mesh.side_set("under_head", mesh.sides_where("bolt", lambda x, y, z: near(z, 10 - overlap) & (np.hypot(x, y) > 4.99)))
    mesh.side_set("seat", mesh.sides_where("flange", lambda x, y, z: near(z, 10)))
    return mesh


def bracket():
    """A bracket of 5 mm on a wall of 10 mm, a block on its arm (mm)."""
    mesh = MeshMaker()
    mesh.hexes("wall", (-10, -20, -40), (10, 40, 60), (2, 8, 12))
    mesh.new_body()
    mesh.hexes("bracket", (0, -15, -30), (5, 30, 30), (3, 10, 10))
    mesh.hexes("bracket", (0, -15, 0), (5, 30, 5), (3, 10, 3))
    mesh.hexes("bracket", (5, -15, 0), (55, 30, 5), (22, 10, 3))
    mesh.new_body()
    mesh.hexes("load", (10, -10, 5), (15, 20, 12), (7, 9, 4))
    mesh.node_set_where("held", lambda x, y, z: near(x, -10))
    mesh.node_set_where("pushed", lambda x, y, z: near(z, 17))
    mesh.side_set("wall_side", mesh.sides_where("wall", lambda x, y, z: near(x, 0)))
    mesh.side_set("back", mesh.sides_where("bracket", lambda x, y, z: near(x, 0)))
    mesh.side_set("arm", mesh.sides_where("bracket", lambda x, y, z: near(z, 5)))
    mesh.side_set("foot", mesh.sides_where("load", lambda x, y, z: near(z, 5)))
    mesh.side_set("top", mesh.sides_where("load", lambda x, y, z: near(z, 17)))
    return mesh


if __name__ == "__main__":
    folder = Path(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).parent)
    two_blocks().write(folder / "two_blocks.g")
    taylor_bar().write(folder / "taylor_bar.g")
    ball_on_plate().write(folder / "impact.g")
    pressed_ball().write(folder / "pressed_ball.g")
    bolted_joint().write(folder / "bolted_joint.g")
    bracket().write(folder / "bracket.g")
