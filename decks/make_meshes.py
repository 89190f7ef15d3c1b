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


if __name__ == "__main__":
    folder = Path(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).parent)
    two_blocks().write(folder / "two_blocks.g")
    taylor_bar().write(folder / "taylor_bar.g")
    ball_on_plate().write(folder / "impact.g")
