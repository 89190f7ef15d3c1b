# SPDX-License-Identifier: BSD-3-Clause
"""Meshes of single bodies around the origin: points [n x 3], cells [n x nodes], Exodus type."""
import functools
import math

import numpy as np

from mesh_maker import MeshMaker
from shapes import add_ball

SOLIDS = ("box", "ball")
SHELLS = ("sheet", "fold")
LINES = ("beam", "truss")


class BodyMesh:
    """Points [length], cells counted from 0, the Exodus type, and the least edge of a cell [length]."""

    def __init__(self, points, cells, kind):
        self.points, self.cells, self.kind = np.asarray(points, float), np.asarray(cells, int), kind

    def edge(self):
        """The least distance of two nodes of a cell; of particles nothing."""
        corners = self.points[self.cells]
        n = corners.shape[1]
        if n == 1:
            return math.inf
        return min(np.min(np.linalg.norm(corners[:, i] - corners[:, j], axis=1)) for i in range(n) for j in range(i))


def _grid(cells, grade):
    """Coordinates -0.5 .. 0.5 per axis; with a grade the last step is that times the first."""
    axes = []
    for n in cells:
        steps = grade ** (np.arange(n) / max(1, n - 1))
        axes.append(np.concatenate(([0.0], np.cumsum(steps) / np.sum(steps))) - 0.5)
    return axes


def _box(cells, size, skew, grade):
    x, y, z = (s * axis for s, axis in zip(size, _grid(cells, grade)))
    nx, ny, nz = cells
    points = np.array([(a, b, c) for c in z for b in y for a in x])
    points[:, 0] += skew * points[:, 2]

    def at(i, j, k):
        return i + (nx + 1) * (j + (ny + 1) * k)
    corners = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
    rows = [[at(i + a, j + b, k + c) for a, b, c in corners] for k in range(nz) for j in range(ny) for i in range(nx)]
    return BodyMesh(points, rows, "HEX8")


@functools.lru_cache(maxsize=None)
def _unit_ball(n):
    mesh = MeshMaker()
    add_ball(mesh, (0, 0, 0), 0.5, n, "ball")
    return mesh.points, [[n - 1 for n in row] for row in mesh.blocks[0][2]]


def split_to_tets(mesh, n_nodes):
    """Six tetrahedra a hexahedron, of four or ten nodes."""
    maker = MeshMaker()
    maker.points = [tuple(p) for p in mesh.points]
    maker.given = list(maker.points)
    maker.blocks = [("a", "HEX8", [[int(n) + 1 for n in row] for row in mesh.cells], None)]
    maker.split_hexes(n_nodes)
    _, kind, rows, _ = maker.blocks[0]
    return BodyMesh(maker.points, np.array(rows) - 1, kind)


def _sheet(cells, size, fold):
    """A sheet in x and y, folded along the y axis by an angle [rad]."""
    nx, ny = cells[:2]
    points = []
    for y in np.linspace(-0.5, 0.5, ny + 1) * size[1]:
        for x in np.linspace(-0.5, 0.5, nx + 1) * size[0]:
            points.append((x * math.cos(fold / 2), y, abs(x) * math.sin(fold / 2)))
    rows = [[j * (nx + 1) + i, j * (nx + 1) + i + 1, (j + 1) * (nx + 1) + i + 1, (j + 1) * (nx + 1) + i]
            for j in range(ny) for i in range(nx)]
    return points, rows


def _triangles(rows):
    halves = []
    for number, (a, b, c, d) in enumerate(rows):
        halves += [[a, b, c], [a, c, d]] if number % 2 == 0 else [[a, b, d], [b, c, d]]
    return halves


def _particles(cells, size):
    axes = [np.arange(n) - 0.5 * (n - 1) for n in cells]
    points = [(a * size[0], b * size[1], c * size[2]) for a in axes[0] for b in axes[1] for c in axes[2]]
    return BodyMesh(points, [[i] for i in range(len(points))], "SPHERE")


def make_body(body):
    """The mesh of a body as the scene describes it, around the origin, not yet turned."""
    shape, cells, size = body["shape"], body["cells"], body["size"]
    if shape == "box":
        mesh = _box(cells, size, body["skew"], body["grade"])
    elif shape == "ball":
        points, rows = _unit_ball(cells[0])
        mesh = BodyMesh(size[0] * np.array(points), rows, "HEX8")
    elif shape in SHELLS:
        points, rows = _sheet(cells, size, body["fold"])
        is_tri = body["element"] == "tri3"
        mesh = BodyMesh(points, _triangles(rows) if is_tri else rows, "SHELL3" if is_tri else "SHELL4")
    elif shape in LINES:
        points = [(x * size[0], 0, 0) for x in np.linspace(-0.5, 0.5, cells[0] + 1)]
        mesh = BodyMesh(points, [[i, i + 1] for i in range(cells[0])], "BEAM2")
    else:
        mesh = _particles(cells, size)
    if body["element"] in ("tet4", "tet10"):
        mesh = split_to_tets(mesh, 4 if body["element"] == "tet4" else 10)
    return mesh


def half_thickness(body):
    """How far contact's surface is from the nodes of a body [length]: of sheets, rods and particles."""
    shape = body["shape"]
    if shape in SHELLS:
        return 0.5 * body["thickness"]
    if shape in LINES or shape == "particles":
        return body["radius"]
    return 0.0
