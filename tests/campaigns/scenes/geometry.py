# SPDX-License-Identifier: BSD-3-Clause
"""Geometry of bodies apart from that of the program: volumes as tetrahedra, skins as triangles, distances."""
import numpy as np

HEX_TETS = [(0, 1, 3, 4), (1, 2, 3, 6), (1, 4, 5, 6), (3, 4, 6, 7), (1, 3, 4, 6)]
HEX_FACES = [(0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7), (0, 3, 2, 1), (4, 5, 6, 7)]
TET_FACES = [(0, 1, 3), (1, 2, 3), (0, 3, 2), (0, 2, 1)]
# A ten-node tetrahedron in eight: one at each corner, four around the diagonal of its midside nodes 5 and 7 (from 0: 4..9).
TET10_TETS = [(0, 4, 6, 7), (4, 1, 5, 8), (6, 5, 2, 9), (7, 8, 9, 3), (4, 5, 6, 7), (4, 8, 5, 7), (5, 8, 9, 7), (6, 5, 9, 7)]


class Hull:
    """What a body is made of, by its nodes: tetrahedra, faces and triangles of the skin, edges, nodes of the skin.

    Corners of a quadrilateral need not lie in a plane: `skin` makes four triangles of it about its middle.
    """

    def __init__(self, cells, kind):
        self.faces = np.zeros((0, 3), int)
        cells = np.asarray(cells)
        self.kind, self.nodes = kind, np.unique(cells)
        self.tets, self.triangles, self.edges = np.zeros((0, 4), int), np.zeros((0, 3), int), np.zeros((0, 2), int)
        if kind in ("HEX8", "TETRA4", "TETRA10"):
            self._make_solid(cells, kind)
        elif kind in ("SHELL4", "SHELL3"):
            parts = [(0, 1, 2), (0, 2, 3)] if kind == "SHELL4" else [(0, 1, 2)]
            self.triangles = np.concatenate([cells[:, p] for p in parts])
            self.faces = cells
        elif kind == "BEAM2":
            self.edges = cells
        if len(self.triangles):
            pairs = np.concatenate([self.triangles[:, p] for p in [(0, 1), (1, 2), (2, 0)]])
            self.edges = np.unique(np.sort(pairs, axis=1), axis=0)
            self.nodes = np.unique(self.triangles)

    def _make_solid(self, cells, kind):
        parts = {"HEX8": HEX_TETS, "TETRA4": [(0, 1, 2, 3)], "TETRA10": TET10_TETS}[kind]
        self.tets = np.concatenate([cells[:, p] for p in parts])
        faces = np.concatenate([cells[:, f] for f in (HEX_FACES if kind == "HEX8" else TET_FACES)])
        if kind == "TETRA10":
            faces = np.concatenate([self.tets[:, f] for f in TET_FACES])
        _, first, count = np.unique(np.sort(faces, axis=1), axis=0, return_index=True, return_counts=True)
        self.faces = skin = faces[first[count == 1]]
        self.triangles = np.concatenate([skin[:, p] for p in [(0, 1, 2), (0, 2, 3)]]) if skin.shape[1] == 4 else skin

    def skin(self, x):
        """Corners [3 x n x 3] of triangles of the skin, of which the first two are an edge of a face when it has four."""
        if self.faces.shape[1] == 3:
            return [x[self.faces[:, i]] for i in range(3)]
        middle = np.mean(x[self.faces], axis=1)
        edges = [(0, 1), (1, 2), (2, 3), (3, 0)]
        return [np.concatenate([x[self.faces[:, e[i]]] for e in edges]) for i in (0, 1)] + [np.tile(middle, (4, 1))]

    def rim_faces(self):
        """Of each triangle of the skin, whether its first two corners are an edge of one face alone; of triangular faces
        whether any edge is."""
        n = self.faces.shape[1]
        pairs = np.concatenate([self.faces[:, (i, (i + 1) % n)] for i in range(n)])
        _, back, count = np.unique(np.sort(pairs, axis=1), axis=0, return_inverse=True, return_counts=True)
        is_rim = count[back.ravel()] == 1
        return np.any(is_rim.reshape(3, -1), axis=0) if n == 3 else is_rim


def inside(points, corners):
    """Which of points [n x 3] lie in one of the tetrahedra [m x 4 x 3]."""
    found = np.zeros(len(points), bool)
    near = np.flatnonzero(np.all((points >= corners.min(axis=(0, 1))) & (points <= corners.max(axis=(0, 1))), axis=1))
    if len(near) == 0:
        return found
    sides = np.stack([corners[:, i] - corners[:, 0] for i in (1, 2, 3)], axis=-1)
    size = np.abs(np.linalg.det(sides))
    good = size > 1e-9 * np.max(size)
    inverse = np.linalg.inv(sides[good])
    share = np.einsum("mij,nmj->nmi", inverse, points[near][:, None] - corners[good][None, :, 0])
    found[near] = np.any((share.min(axis=2) > 0) & (share.sum(axis=2) < 1), axis=1)
    return found


def closest_on_triangles(point, a, b, c):
    """The nearest of triangles [m x 3 each] to a point: distance, number, weights of the corners."""
    u, v, w = b - a, c - a, point - a
    uu, uv, vv, wu, wv = (np.einsum("ij,ij->i", p, q) for p, q in [(u, u), (u, v), (v, v), (w, u), (w, v)])
    det = np.maximum(uu * vv - uv * uv, 1e-300)
    s, t = (vv * wu - uv * wv) / det, (uu * wv - uv * wu) / det
    weights = [np.stack([1 - s - t, s, t], axis=1)]
    for i, j in [(0, 1), (1, 2), (2, 0)]:
        p, q = (a, b, c)[i], (a, b, c)[j]
        along = np.einsum("ij,ij->i", point - p, q - p) / np.maximum(np.einsum("ij,ij->i", q - p, q - p), 1e-300)
        on_edge = np.zeros((len(a), 3))
        on_edge[:, j] = np.clip(along, 0, 1)
        on_edge[:, i] = 1 - on_edge[:, j]
        weights.append(on_edge)
    weights = np.stack(weights)
    spots = np.einsum("kmi,imd->kmd", weights, np.stack([a, b, c]))
    distance = np.linalg.norm(spots - point, axis=2)
    distance[0, np.min(weights[0], axis=1) < 0] = np.inf
    k, m = np.unravel_index(np.argmin(distance), distance.shape)
    return distance[k, m], m, weights[k, m]


def depth_inside(points, hull, x):
    """How deep points [n x 3] lie below the skin of a body with nodes x; 0 outside."""
    depths = np.zeros(len(points))
    if len(hull.tets) == 0:
        return depths
    a, b, c = hull.skin(x)
    for n in np.flatnonzero(inside(points, x[hull.tets])):
        distance, m, weights = closest_on_triangles(points[n], a, b, c)
        normal = np.cross(b[m] - a[m], c[m] - a[m])
        spot = weights @ np.array([a[m], b[m], c[m]])
        depths[n] = distance if (points[n] - spot) @ normal <= 0 else 0.0
    return depths


def _flat(x, normal):
    """Coordinates across a direction [n x 2]."""
    first = np.cross(normal, np.eye(3)[np.argmin(np.abs(normal))])
    first /= np.linalg.norm(first)
    return x @ np.stack([first, np.cross(normal, first)], axis=1)


def _drops_on_triangles(spots, hull, x, direction, sign, thick):
    """Ways of spots to the triangles of a body along a direction; thick is the gap that counts as touching."""
    if len(hull.triangles) == 0 or len(spots) == 0:
        return []
    corners = x[hull.triangles]
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normal /= np.maximum(np.linalg.norm(normal, axis=1, keepdims=True), 1e-300)
    flat = _flat(corners.reshape(-1, 3), direction).reshape(-1, 3, 2)
    p = _flat(spots, direction)
    u, v = flat[:, 1] - flat[:, 0], flat[:, 2] - flat[:, 0]
    det = u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0]
    slope = np.abs(normal @ direction)
    good = np.flatnonzero(slope > 0.02)
    w = p[:, None] - flat[None, good, 0]
    s = (w[..., 0] * v[good, 1] - w[..., 1] * v[good, 0]) / det[good]
    t = (u[good, 0] * w[..., 1] - u[good, 1] * w[..., 0]) / det[good]
    heights = corners[good] @ direction
    way = sign * (heights[:, 0] + s * (heights[:, 1] - heights[:, 0]) + t * (heights[:, 2] - heights[:, 0])
                  - (spots @ direction)[:, None]) - thick / slope[good]
    return way[(s >= 0) & (t >= 0) & (s + t <= 1)].tolist()


def _drops_of_edges(one, x_one, two, x_two, direction, thick):
    if len(one.edges) == 0 or len(two.edges) == 0:
        return []
    p, q = x_one[one.edges], x_two[two.edges]
    pf, qf = _flat(p.reshape(-1, 3), direction).reshape(-1, 2, 2), _flat(q.reshape(-1, 3), direction).reshape(-1, 2, 2)
    d, e = pf[:, None, 1] - pf[:, None, 0], qf[None, :, 1] - qf[None, :, 0]
    w = qf[None, :, 0] - pf[:, None, 0]
    det = d[..., 0] * e[..., 1] - d[..., 1] * e[..., 0]
    det = np.where(np.abs(det) < 1e-12, np.nan, det)
    s, t = (w[..., 0] * e[..., 1] - w[..., 1] * e[..., 0]) / det, (w[..., 0] * d[..., 1] - w[..., 1] * d[..., 0]) / det
    hp, hq = p @ direction, q @ direction
    way = hq[None, :, 0] + t * (hq[:, 1] - hq[:, 0]) - hp[:, None, 0] - s * (hp[:, 1] - hp[:, 0])[:, None]
    normal = np.cross(p[:, None, 1] - p[:, None, 0], q[None, :, 1] - q[None, :, 0])
    slope = np.abs(normal @ direction) / np.maximum(np.linalg.norm(normal, axis=2), 1e-300)
    way = way - thick / np.maximum(slope, 0.02)
    return way[(s >= 0) & (s <= 1) & (t >= 0) & (t <= 1)].tolist()


def _drops_of_nodes(spots, others, direction, thick):
    if thick == 0:
        return []
    across = np.linalg.norm(_flat(spots, direction)[:, None] - _flat(others, direction)[None], axis=2)
    way = (others @ direction)[None] - (spots @ direction)[:, None]
    return (way - np.sqrt(np.maximum(thick**2 - across**2, 0)))[across < thick].tolist()


def way_to_touch(one, x_one, two, x_two, direction, thick):
    """How far a body goes along a direction until it touches another that is wholly ahead; inf when it goes by."""
    ways = _drops_on_triangles(x_one[one.nodes], two, x_two, direction, 1, thick)
    ways += _drops_on_triangles(x_two[two.nodes], one, x_one, direction, -1, thick)
    ways += _drops_of_edges(one, x_one, two, x_two, direction, thick)
    ways += _drops_of_nodes(x_one[one.nodes], x_two[two.nodes], direction, thick)
    return min(ways, default=np.inf)
