# SPDX-License-Identifier: BSD-3-Clause
"""Makes small Exodus II meshes over netCDF (64-bit offset), written with python3-netcdf4."""
import netCDF4
import numpy as np


class MeshMaker:
    """Collects blocks and sets whose nodes are shared where they coincide."""

    def __init__(self, place=lambda x, y, z: (x, y, z)):
        """`place` maps the coordinates in which bricks are given to those of the mesh."""
        self.nodes, self.given, self.points, self.place = {}, [], [], place
        self.blocks, self.side_sets, self.node_sets = [], [], []
        self.set_rules = {}  # of node_sets by name: whether a node belongs to it

    def new_body(self):
        """From here on nodes are no longer shared with what there is, so that bodies may touch."""
        self.nodes = {}

    def node(self, x, y, z):
        point = self.place(x, y, z)
        number = self.nodes.setdefault(tuple(round(c, 9) for c in point), len(self.points) + 1)
        if number > len(self.points):
            self.points.append(point)
            self.given.append((x, y, z))
        return number

    def hexes(self, name, origin, size, cells):
        """A brick of HEX8 cells, added to the last block if that has the name; returns its first element (from 1)."""
        grid = [np.linspace(o, o + s, n + 1) for o, s, n in zip(origin, size, cells)]
        rows = []
        for k in range(cells[2]):
            for j in range(cells[1]):
                for i in range(cells[0]):
                    corners = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
                    rows.append([self.node(grid[0][i + a], grid[1][j + b], grid[2][k + c]) for a, b, c in corners])
        return self._add(name, "HEX8", rows)

    def shells(self, name, origin, size, cells, thickness):
        """A horizontal sheet of SHELL4 cells with a thickness attribute."""
        x = np.linspace(origin[0], origin[0] + size[0], cells[0] + 1)
        y = np.linspace(origin[1], origin[1] + size[1], cells[1] + 1)
        rows = [[self.node(x[i + a], y[j + b], origin[2]) for a, b in [(0, 0), (1, 0), (1, 1), (0, 1)]]
                for j in range(cells[1]) for i in range(cells[0])]
        return self._add(name, "SHELL4", rows, thickness)

    def lines(self, name, start, end, n, kind="BEAM2"):
        """Cells of two nodes along a straight line."""
        spots = [self.node(*(np.array(start) + (np.array(end) - np.array(start)) * i / n)) for i in range(n + 1)]
        return self._add(name, kind, [[a, b] for a, b in zip(spots, spots[1:])])

    def particles(self, name, spots):
        """Cells of one node each."""
        return self._add(name, "SPHERE", [[self.node(*spot)] for spot in spots])

    def triangles(self, name, origin, size, cells, thickness):
        """A horizontal sheet of cells of two SHELL3 each, with a thickness attribute; their diagonals alternate."""
        x = np.linspace(origin[0], origin[0] + size[0], cells[0] + 1)
        y = np.linspace(origin[1], origin[1] + size[1], cells[1] + 1)
        rows = []
        for j in range(cells[1]):
            for i in range(cells[0]):
                a, b, c, d = [self.node(x[i + p], y[j + q], origin[2]) for p, q in [(0, 0), (1, 0), (1, 1), (0, 1)]]
                rows += [[a, b, c], [a, c, d]] if (i + j) % 2 == 0 else [[a, b, d], [b, c, d]]
        return self._add(name, "SHELL3", rows, thickness)

    def shell_of_cube(self, name, across, layers):
        """HEX8 cells between the surface of the cube |x|, |y|, |z| <= 1 and that of twice its size."""
        grid = np.linspace(-1, 1, across + 1)
        depth = np.linspace(1, 2, layers + 1)
        rows = []
        for axis in range(3):
            for sign in (-1, 1):
                def point(u, v, t):
                    spot = np.zeros(3)
                    spot[axis], spot[(axis + 1) % 3], spot[(axis + 2) % 3] = sign, *((u, v) if sign > 0 else (v, u))
                    return self.node(*(t * spot))

                for k in range(layers):
                    for j in range(across):
                        for i in range(across):
                            ring = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)]
                            rows.append([point(grid[a], grid[b], depth[k + c]) for c in (0, 1) for a, b in ring])
        return self._add(name, "HEX8", rows)

    def tetrahedra(self, name, origin, size):
        """A brick of five TETRA4 cells."""
        corners = [self.node(*(np.array(origin) + np.array(size) * ((i ^ i >> 1) & 1, i >> 1 & 1, i >> 2))) for i in range(8)]
        rows = [(0, 1, 3, 4), (1, 2, 3, 6), (1, 4, 5, 6), (3, 4, 6, 7), (1, 3, 4, 6)]
        return self._add(name, "TETRA4", [[corners[i] for i in row] for row in rows])

    def cone(self, name, tip, height, radius, n):
        """A cone of n flat sides that stands on its tip, of TETRA4 cells around its axis."""
        x, y, z = tip
        ring = [self.node(x + radius * np.cos(2 * np.pi * i / n), y + radius * np.sin(2 * np.pi * i / n), z + height)
                for i in range(n)]
        axis = [self.node(*tip), self.node(x, y, z + height)]
        return self._add(name, "TETRA4", [[axis[0], ring[i], ring[(i + 1) % n], axis[1]] for i in range(n)])

    def joint(self, name, lower, upper):
        """A HEX8 cell without thickness between the top of one cell and the bottom of another, given by their nodes."""
        return self._add(name, "HEX8", [[*lower[4:], *upper[:4]]])

    def split_hexes(self, n_nodes=10):
        """Makes six tetrahedra of each HEX8 cell, of four nodes or with midside nodes in ten; before side sets are made.

        Each cell is cut from its node of the smallest number, its other faces from theirs: cells fit together.
        """
        for number, (name, kind, rows, attribute) in enumerate(self.blocks):
            if kind == "HEX8":
                tets = [tet for row in rows for tet in self._tets_of(row)]
                self.blocks[number] = (name, f"TETRA{n_nodes}", tets, attribute)
        if n_nodes == 10:
            self._add_midside_nodes()

    @staticmethod
    def _tets_of(row):
        faces = [(0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (0, 4, 7, 3), (0, 3, 2, 1), (4, 5, 6, 7)]
        apex, tets = min(row), []
        for face in ([row[i] for i in face] for face in faces):
            if apex not in face:
                k = face.index(min(face))
                a, b, c, d = face[k:] + face[:k]
                tets += [[a, c, b, apex], [a, d, c, apex]]  # bases look at the apex
        return tets

    def _add_midside_nodes(self):
        middles = {}
        for _, kind, rows, _ in self.blocks:
            for row in rows if kind == "TETRA10" else []:
                for i, j in [(0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3)]:
                    edge = tuple(sorted((row[i], row[j])))
                    if edge not in middles:
                        middles[edge] = self._middle(*edge)
                    row.append(middles[edge])

    def _middle(self, first, second):
        """A node halfway between two, as bricks are given."""
        given = tuple((a + b) / 2 for a, b in zip(self.given[first - 1], self.given[second - 1]))
        self.points.append(self.place(*given))
        self.given.append(given)
        for name, nodes in self.node_sets:
            if name in self.set_rules and self.set_rules[name](*given):
                nodes.append(len(self.points))
        return len(self.points)

    def _add(self, name, kind, rows, attribute=None):
        """Cells of the last block's name and kind join it."""
        first = sum(len(rows) for _, _, rows, _ in self.blocks) + 1
        if self.blocks and self.blocks[-1][:2] == (name, kind):
            self.blocks[-1][2].extend(rows)
        else:
            self.blocks.append((name, kind, rows, attribute))
        return first

    def side_set(self, name, sides):
        """Sides are pairs of an element (from 1) and its side."""
        self.side_sets.append((name, sides))

    def node_set(self, name, is_in):
        """The nodes for whose coordinates, as bricks are given, is_in(x, y, z) holds; midside nodes join later."""
        self.node_sets.append((name, [n for n, given in enumerate(self.given, 1) if is_in(*given)]))
        self.set_rules[name] = is_in

    def sides_where(self, block, is_on):
        """The sides of a block of HEX8 whose nodes all lie where is_on(x, y, z), of arrays of coordinates, holds."""
        corners = {1: (0, 1, 5, 4), 2: (1, 2, 6, 5), 3: (2, 3, 7, 6), 4: (3, 0, 4, 7), 5: (0, 3, 2, 1), 6: (4, 5, 6, 7)}
        good = is_on(*np.array(self.points).T)
        sides, number = [], 0
        for name, _, rows, _ in self.blocks:
            for row in rows:
                number += 1
                if name == block:
                    sides += [(number, side) for side, spots in corners.items() if all(good[row[c] - 1] for c in spots)]
        return sides

    def node_set_where(self, name, is_in):
        """The nodes that lie, as they are placed, where is_in(x, y, z), of arrays of coordinates, holds."""
        self.node_sets.append((name, [int(n) + 1 for n in np.flatnonzero(is_in(*np.array(self.points).T))]))

    def transform(self, matrix):
        """Maps all coordinates linearly; a mirrored mesh gets its hexes turned, so that volumes stay positive."""
        self.points = [tuple(p) for p in np.array(self.points) @ np.array(matrix).T]
        if np.linalg.det(matrix) < 0:
            self.blocks = [(n, k, [r[4:] + r[:4] for r in rows], a) for n, k, rows, a in self.blocks]
            self.side_sets = [(n, [(e, {5: 6, 6: 5}.get(s, s)) for e, s in sides]) for n, sides in self.side_sets]

    def reverse_elements(self):
        """Turns round the order of the elements within each block; for meshes without side sets."""
        self.blocks = [(n, k, rows[::-1], a) for n, k, rows, a in self.blocks]

    def write(self, path):
        with netCDF4.Dataset(path, "w", format="NETCDF3_64BIT_OFFSET") as file:
            self._write_head(file)
            self._write_blocks(file)
            self._write_side_sets(file)
            self._write_node_sets(file)

    def _write_head(self, file):
        file.setncatts({"api_version": np.float32(8.25), "version": np.float32(8.25),
                        "floating_point_word_size": np.int32(8), "file_size": np.int32(1),
                        "title": "mesh of a contactsim deck"})
        for name, size in [("len_string", 33), ("len_name", 33), ("four", 4), ("num_dim", 3),
                           ("num_nodes", len(self.points)), ("num_elem", sum(len(b[2]) for b in self.blocks)),
                           ("num_el_blk", len(self.blocks)), ("num_side_sets", len(self.side_sets)),
                           ("num_node_sets", len(self.node_sets))]:
            if size > 0:
                file.createDimension(name, size)
        points = np.array(self.points)
        for axis, name in enumerate(["coordx", "coordy", "coordz"]):
            file.createVariable(name, "f8", ("num_nodes",))[:] = points[:, axis]

    def _write_names(self, file, prefix, dimension, names):
        ids = file.createVariable(f"{prefix}_prop1", "i4", (dimension,))
        ids.setncattr("name", "ID")
        ids[:] = np.arange(1, len(names) + 1)
        file.createVariable(f"{prefix}_status", "i4", (dimension,))[:] = 1
        text = file.createVariable(f"{prefix}_names", "S1", (dimension, "len_name"))
        text[:] = netCDF4.stringtochar(np.array([n.encode() for n in names], "S33"))

    def _write_blocks(self, file):
        self._write_names(file, "eb", "num_el_blk", [b[0] for b in self.blocks])
        for number, (_, kind, rows, attribute) in enumerate(self.blocks, 1):
            file.createDimension(f"num_el_in_blk{number}", len(rows))
            file.createDimension(f"num_nod_per_el{number}", len(rows[0]))
            connect = file.createVariable(f"connect{number}", "i4", (f"num_el_in_blk{number}", f"num_nod_per_el{number}"))
            connect.setncattr("elem_type", kind)
            connect[:] = np.array(rows)
            if attribute is not None:
                file.createDimension(f"num_att_in_blk{number}", 1)
                file.createVariable(f"attrib{number}", "f8", (f"num_el_in_blk{number}", f"num_att_in_blk{number}"))[:] = attribute

    def _write_node_sets(self, file):
        if not self.node_sets:
            return
        self._write_names(file, "ns", "num_node_sets", [s[0] for s in self.node_sets])
        for number, (_, nodes) in enumerate(self.node_sets, 1):
            file.createDimension(f"num_nod_ns{number}", len(nodes))
            file.createVariable(f"node_ns{number}", "i4", (f"num_nod_ns{number}",))[:] = nodes

    def _write_side_sets(self, file):
        if not self.side_sets:
            return
        self._write_names(file, "ss", "num_side_sets", [s[0] for s in self.side_sets])
        for number, (_, sides) in enumerate(self.side_sets, 1):
            file.createDimension(f"num_side_ss{number}", len(sides))
            file.createVariable(f"elem_ss{number}", "i4", (f"num_side_ss{number}",))[:] = [s[0] for s in sides]
            file.createVariable(f"side_ss{number}", "i4", (f"num_side_ss{number}",))[:] = [s[1] for s in sides]
