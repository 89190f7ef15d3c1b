# SPDX-License-Identifier: BSD-3-Clause
"""Meshes of balls and rings."""
import math

import numpy as np

from mesh_maker import MeshMaker


def on_ball(centre, radius):
    """Maps a cube [-1, 1]^3 to a core and six caps, from 1 to 2 beyond its faces, to the rest of a ball."""
    def place(*point):
        p = np.array(point, dtype=float)
        inner = np.clip(p, -1, 1)
        core = 0.5 * radius * inner * (1 - 0.1 * (inner @ inner - inner * inner))
        share = np.max(np.abs(p)) - 1
        if share <= 1e-12:
            return tuple(centre + core)
        out = np.where(np.abs(p) > 1 + 1e-12, np.sign(p), np.tan(math.pi / 4 * p))
        return tuple(centre + core + share * (radius * out / np.linalg.norm(out) - core))
    return place


def add_ball(mesh, centre, radius, n, block=None):
    """A core of n x n x n elements under six caps of n layers, each a block of its own unless one is named."""
    mesh.new_body()
    mesh.place = on_ball(np.array(centre), radius)
    mesh.hexes(block or "core", (-1, -1, -1), (2, 2, 2), (n, n, n))
    for name, axis, side in (("east", 0, 1), ("west", 0, -2), ("north", 1, 1), ("south", 1, -2), ("top", 2, 1), ("bottom", 2, -2)):
        origin, size = [-1, -1, -1], [2, 2, 2]
        origin[axis], size[axis] = side, 1
        cells = [n, n, n]
        cells[axis] = max(2, n // 2)
        mesh.hexes(block or name, tuple(origin), tuple(size), tuple(cells))


def add_ring(mesh, name, centre, inner, outer, width, cells):
    """Cells along the radius, around, and along the width."""
    def place(r, angle, z):
        return centre[0] + r * math.cos(angle), centre[1] + r * math.sin(angle), z

    mesh.new_body()
    mesh.place = place
    mesh.hexes(name, (inner, 0, 0), (outer - inner, 2 * math.pi, width), cells)


def add_ring_sector(mesh, name, inner, outer, width, cells, angle=0.5 * math.pi):
    """As add_ring, from the x axis to an angle."""
    mesh.new_body()
    mesh.place = lambda r, turn, z: (r * math.cos(turn), r * math.sin(turn), z)
    mesh.hexes(name, (inner, 0, 0), (outer - inner, angle, width), cells)


def hairpin(n_leg, n_bend, thickness):
    """Two legs of length 4, one apart from the other by 2, and the half ring that joins them."""
    def place(s, t, z):
        r = 1 + thickness - t
        if s < 4:
            return s, -r, z
        if s > 4 + math.pi:
            return 8 + math.pi - s, r, z
        angle = s - 4 - math.pi / 2
        return 4 + r * math.cos(angle), r * math.sin(angle), z

    mesh = MeshMaker(place)
    mesh.hexes("strip", (0, 0, 0), (4, thickness, 1), (n_leg, 2, 2))
    mesh.hexes("strip", (4, 0, 0), (math.pi, thickness, 1), (n_bend, 2, 2))
    mesh.hexes("strip", (4 + math.pi, 0, 0), (4, thickness, 1), (n_leg, 2, 2))
    mesh.node_set("lower", lambda s, t, z: s < 4)
    mesh.node_set("upper", lambda s, t, z: s > 4 + math.pi)
    return mesh


def near_zero(t, slope):
    """Maps [0, 1] to itself, steps near 0 smaller by a factor."""
    return t * (slope + (1 - slope) * t * t)


def add_quarter_ball(mesh, name, level, radius, pole_up, n=16, slope=0.4):
    """The quarter x, y > 0 of a ball around (0, 0, level), with small elements at its upper or lower pole: those of an even
    mesh times the slope."""
    mesh.new_body()
    ball = on_ball(np.array((0.0, 0.0, level)), radius)

    def place(u, v, w):
        u, v = (near_zero(t, slope) if t < 1 else t for t in (u, v))
        if (w > 0) == pole_up and abs(w) > 1:
            w = math.copysign(2 - near_zero(2 - abs(w), slope), w)
        return ball(u, v, w)
    mesh.place = place
    few = n // 4
    upper, lower = (3 * few, few) if pole_up else (few, 3 * few)
    mesh.hexes(name, (0, 0, -1), (1, 1, 2), (n, n, 2 * few))
    mesh.hexes(name, (1, 0, -1), (1, 1, 2), (few, n, 2 * few))
    mesh.hexes(name, (0, 1, -1), (1, 1, 2), (n, few, 2 * few))
    mesh.hexes(name, (0, 0, 1), (1, 1, 1), (n, n, upper))
    mesh.hexes(name, (0, 0, -2), (1, 1, 1), (n, n, lower))


def add_box(mesh, name, side, n, thickness, place=lambda p: p, has_lid=True):
    """The walls of a cube around the origin; `place` maps its coordinates."""
    mesh.new_body()
    for axis in range(3):
        for sign in (-1, 1):
            if (axis, sign) == (2, 1) and not has_lid:
                continue

            def wall(u, v, _, axis=axis, sign=sign):
                spot = np.zeros(3)
                spot[axis], spot[(axis + 1) % 3], spot[(axis + 2) % 3] = sign, *((u, v) if sign > 0 else (v, u))
                return tuple(place(0.5 * side * spot))
            mesh.place = wall
            mesh.shells(name, (-1, -1, 0), (2, 2), (n, n), thickness)
