# SPDX-License-Identifier: BSD-3-Clause
"""The figures and examples of the surface rules as runs: cubes are thrown at every side of every element."""
from dataclasses import dataclass
from typing import Callable

import numpy as np

from cases import balances, case
from mesh_maker import MeshMaker
from runs import Check, Run, at_most

SIDES = {"HEX8": ((0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (0, 4, 7, 3), (0, 3, 2, 1), (4, 5, 6, 7)),
         "TETRA4": ((0, 1, 3), (1, 2, 3), (0, 3, 2), (0, 2, 1))}
CUBE, GAP, LOFT = 0.2, 0.02, 0.25


@dataclass
class Target:
    """A side of an element of a figure."""
    name: str  # element:side
    block: str
    place: np.ndarray  # its middle
    normal: np.ndarray  # out of the element, along an axis


def targets_of_solid(block, kind, element, corners):
    for side, local in enumerate(SIDES[kind], 1):
        ring = corners[list(local)]
        normal = np.cross(ring[1] - ring[0], ring[2] - ring[0])
        normal /= np.linalg.norm(normal)
        if np.max(np.abs(normal)) > 0.999:
            yield Target(f"{element}:{side}", block, np.mean(ring, axis=0), np.round(normal))


def targets_of_shell(block, element, corners):
    """Top and bottom; edges are narrower than a cube."""
    middle, up = np.mean(corners, axis=0), np.array((0, 0, 1.0))
    yield Target(f"{element}:1", block, middle + LOFT * up, up)
    yield Target(f"{element}:2", block, middle - LOFT * up, -up)


def targets_of_beam(block, element, corners):
    """Over and under the middle; the prism's corners lie on the circle around the section."""
    middle, up = np.mean(corners, axis=0), np.array((0, 0, 1.0))
    for way in (up, -up):
        yield Target(f"{element}:1", block, middle + 2 ** 0.5 * LOFT * way, way)


def targets_of(mesh):
    points, element, found = np.array(mesh.points), 0, []
    for block, kind, rows, _ in mesh.blocks:
        for row in rows:
            element += 1
            corners = points[np.array(row) - 1]
            if kind == "SHELL4":
                found += targets_of_shell(block, element, corners)
            elif kind == "BEAM2":
                found += targets_of_beam(block, element, corners)
            else:
                found += targets_of_solid(block, kind, element, corners)
    return found


def add_cubes(mesh, targets):
    """A cube in front of each target, in the order of theirs; returns the nodes of each from 0."""
    sets, nodes = {f"from_{i}": [] for i in range(6)}, []
    for target in targets:
        mesh.new_body()
        first = len(mesh.points)
        mesh.hexes("probes", target.place + (GAP + 0.5 * CUBE) * target.normal - 0.5 * CUBE, (CUBE,) * 3, (1, 1, 1))
        nodes.append(range(first, first + 8))
        axis = np.argmax(np.abs(target.normal))
        sets[f"from_{2 * axis + (target.normal[axis] > 0)}"] += range(first + 1, first + 9)
    mesh.node_sets += sets.items()
    return nodes


def cube():
    mesh = MeshMaker()
    mesh.hexes("block_1", (0, 0, 0), (1, 1, 1), (1, 1, 1))
    mesh.side_set("surface_1", [(1, 6)])
    return mesh


def brick():
    """2 x 3 x 4 cells; side set: the tops with y < 2."""
    mesh = MeshMaker()
    mesh.hexes("block_1", (0, 0, 0), (2, 3, 4), (2, 3, 4))
    mesh.side_set("set_2", [(19, 6), (20, 6), (21, 6), (22, 6)])
    return mesh


def pair_of_plates():
    """Elements from above: 3 4 | 7 8 over 1 2 | 5 6; side sets on the tops of 1, 3 and of 2, 4, 5, 7."""
    mesh = MeshMaker()
    mesh.hexes("block_1", (0, 0, 0), (2, 2, 1), (2, 2, 1))
    mesh.hexes("block_2", (2, 0, 0), (2, 2, 1), (2, 2, 1))
    mesh.side_set("set_2", [(1, 6), (3, 6)])
    mesh.side_set("set_4", [(2, 6), (4, 6), (5, 6), (7, 6)])
    return mesh


def three_blocks():
    """The first two side by side on the third, a row of four cells."""
    mesh = MeshMaker()
    mesh.hexes("block_1", (0, 1, 0), (2, 2, 1), (2, 2, 1))
    mesh.hexes("block_2", (2, 1, 0), (2, 2, 1), (2, 2, 1))
    mesh.hexes("block_3", (0, 0, 0), (4, 1, 1), (4, 1, 1))
    return mesh


def joined_bar():
    """Two blocks of 3 x 2 x 2 cells that meet at x = 3; side set: the tops beside the joint."""
    mesh = MeshMaker()
    mesh.hexes("block_1", (0, 0, 0), (3, 2, 2), (3, 2, 2))
    mesh.hexes("block_2", (3, 0, 0), (3, 2, 2), (3, 2, 2))
    mesh.side_set("set_3", [(9, 6), (12, 6), (19, 6), (22, 6)])
    return mesh


def holed_plate():
    mesh = MeshMaker()
    mesh.hexes("block_1", (0, 0, 0), (7, 3, 1), (7, 3, 1))
    return mesh


def clad_brick():
    """4 x 2 x 2 cells, 2 x 2 shells on the half of the top with x < 2."""
    mesh = MeshMaker()
    mesh.hexes("block_1", (0, 0, 0), (4, 2, 2), (4, 2, 2))
    mesh.shells("block_2", (0, 0, 2), (2, 2), (2, 2), None)
    return mesh


def five_blocks():
    """Two bricks, a cube of five tetrahedra, shells and beams, far from each other."""
    mesh = MeshMaker()
    mesh.hexes("block_1", (0, 0, 0), (1, 1, 1), (1, 1, 1))
    mesh.hexes("block_2", (3, 0, 0), (1, 1, 1), (1, 1, 1))
    mesh.tetrahedra("block_3", (6, 0, 0), (1, 1, 1))
    mesh.shells("block_4", (9, 0, 0), (2, 1), (2, 1), None)
    mesh.lines("block_5", (12, 0, 0), (14, 0, 0), 2)
    return mesh


def among(names):
    return lambda target: target.name in names.split()


def outside(block, high, low=(0, 0, 0), but=""):
    """The sides on the faces of a box that are of a block, without some."""
    def is_in(target):
        is_out = np.any((np.abs(target.place - low) < 1e-9) | (np.abs(target.place - high) < 1e-9))
        return target.block == block and is_out and target.name not in but.split()
    return is_in


def both(one, other):
    return lambda target: one(target) or other(target)


@dataclass
class Figure:
    """What a figure says: the sides that each surface owns, when some elements are dead."""
    mesh: Callable
    lines: str
    owners: dict
    dead: str = ""
    sheet: str = ""
    rod: str = ""


GENERAL = "begin interaction defaults\ngeneral contact = on\nend"
SIX = "1:1 1:2 1:3 1:4 1:5 1:6"
TOPS = "9:6 12:6 19:6 22:6"
TWO_LINES = "contact surface block_1 contains block_1\ncontact surface block_2 contains block_2"
C3_FIRST = "contact surface c3 contains set_3\ncontact surface c1 contains block_1\ncontact surface c2 contains block_2"
C3_BETWEEN = "contact surface c1 contains block_1\ncontact surface c3 contains set_3\ncontact surface c2 contains block_2"
CLAD = "contact surface c1 contains block_1\ncontact surface c2 contains block_2"
CLAD_TURNED = "contact surface c2 contains block_2\ncontact surface c1 contains block_1"
SHELLS = "17:1 17:2 18:1 18:2 19:1 19:2 20:1 20:2"


def of_bar(c1="", c2="", c3="", gained_1="", gained_2=""):
    """Of the two blocks of the bar: what the outside lacks in c1 and c2, what there is in c3, what deaths expose."""
    return {"c1": both(outside("block_1", (6, 2, 2), but=c1), among(gained_1)),
            "c2": both(outside("block_2", (6, 2, 2), but=c2), among(gained_2)), "c3": among(c3)}


def of_clad(lost="", gained="", shells=SHELLS):
    return {"c1": both(outside("block_1", (4, 2, 2), but="9:6 10:6 13:6 14:6 " + lost), among(gained)), "c2": among(shells)}


RESTRICTED = "skin all blocks = on\nrestrict contact to subdomain defined by radius 2.3 and point 1.5 1.5 0.5"


def of_restricted(lost="", gained=""):
    """The first three of the plate's seven columns are within the sphere."""
    is_out = outside("block_1", (7, 3, 1), but=lost)
    return {"block_1": both(lambda target: is_out(target) and (int(target.name.split(":")[0]) - 1) % 7 < 3, among(gained))}


FIGURES = {
    "8.4.4, restricted": Figure(holed_plate, RESTRICTED, of_restricted()),
    "8.4.4, restricted, holes inside and beyond": Figure(
        holed_plate, RESTRICTED, dead="9 12", owners=of_restricted(lost="9:5 9:6", gained="2:3 8:2 10:4 16:1")),
    "8.4.4.1, subsets": Figure(
        cube, "begin contact surface surf1\nblock = block_1\nsubset xp with normal 1 0 0\nsubset zm with normal 0 0 -1\nend",
        {"surf1": among("1:1 1:3 1:4 1:6"), "surf1_xp": among("1:2"), "surf1_zm": among("1:5")}),
    "8.4.5, one block left out": Figure(
        five_blocks, "skin all blocks = on exclude block_2",
        {name: lambda target, name=name: target.block == name for name in ("block_1", "block_3", "block_4", "block_5")},
        sheet="block_4", rod="block_5"),
    "8.2 (b)": Figure(
        brick, "contact surface surfB contains set_2\ncontact surface surfA contains block_1",
        {"surfB": among("19:6 20:6 21:6 22:6"), "surfA": outside("block_1", (2, 3, 4), but="19:6 20:6 21:6 22:6")}),
    "8.3 (b)": Figure(
        pair_of_plates, "contact surface surfD contains set_4\ncontact surface surfB contains set_2\n"
        "contact surface surfA contains block_1\ncontact surface surfC contains block_2",
        {"surfD": among("2:6 4:6 5:6 7:6"), "surfB": among("1:6 3:6"),
         "surfA": outside("block_1", (4, 2, 1), but="1:6 2:6 3:6 4:6"),
         "surfC": outside("block_2", (4, 2, 1), but="5:6 7:6")}),
    "8.3 (c)": Figure(
        pair_of_plates, "contact surface surfB contains set_2\ncontact surface surfA contains block_1\n"
        "contact surface surfC contains block_2\ncontact surface surfD contains set_4",
        {"surfB": among("1:6 3:6"), "surfA": outside("block_1", (4, 2, 1), but="1:6 3:6"),
         "surfC": outside("block_2", (4, 2, 1)), "surfD": among("")}),
    "8.3 (c), skin all blocks": Figure(
        pair_of_plates,
        "contact surface surfB contains set_2\nskin all blocks = on\ncontact surface surfD contains set_4",
        {"surfB": among("1:6 3:6"), "block_1": outside("block_1", (4, 2, 1), but="1:6 3:6"),
         "block_2": outside("block_2", (4, 2, 1)), "surfD": among("")}),
    "8.4": Figure(brick, "contact surface block_1 contains block_1", {"block_1": outside("block_1", (2, 3, 4))}),
    "8.4, skin all blocks": Figure(brick, "skin all blocks = on", {"block_1": outside("block_1", (2, 3, 4))}),
    "8.5": Figure(pair_of_plates, TWO_LINES,
                  {name: outside(name, (4, 2, 1)) for name in ("block_1", "block_2")}),
    "8.5, skin all blocks": Figure(pair_of_plates, "skin all blocks = on",
                                   {name: outside(name, (4, 2, 1)) for name in ("block_1", "block_2")}),
    "8.6 (A)": Figure(three_blocks, TWO_LINES + "\ncontact surface block_3 contains block_3",
                      {name: outside(name, (4, 3, 1)) for name in ("block_1", "block_2", "block_3")}),
    "8.6 (B)": Figure(three_blocks, TWO_LINES,
                      {name: outside(name, (4, 3, 1), low=(0, 1, 0)) for name in ("block_1", "block_2")}),
    "8.6 (B), one block left out": Figure(
        three_blocks, "skin all blocks = on exclude block_3",
        {name: outside(name, (4, 3, 1), low=(0, 1, 0)) for name in ("block_1", "block_2")}),
    "8.7 (B)": Figure(joined_bar, C3_FIRST, of_bar(c1=TOPS, c2=TOPS, c3=TOPS)),
    "8.7 (C)": Figure(joined_bar, C3_BETWEEN, of_bar(c2=TOPS, c3="19:6 22:6")),
    "8.7 (D)": Figure(joined_bar, C3_FIRST, dead="9", owners=of_bar(
        c1=TOPS + " 9:1", c2=TOPS, c3="12:6 19:6 22:6", gained_1="3:6 8:2 12:1", gained_2="19:4")),
    "8.7 (C), with (D)'s dead": Figure(joined_bar, C3_BETWEEN, dead="9", owners=of_bar(
        c1="9:1 9:6", c2=TOPS, c3="19:6 22:6", gained_1="3:6 8:2 12:1", gained_2="19:4")),
    "8.7, the side set dead": Figure(joined_bar, C3_FIRST, dead="9 12 19 22", owners=of_bar(
        c1=TOPS + " 9:1 12:3", c2=TOPS + " 19:1 22:3", gained_1="3:6 6:6 8:2 11:2", gained_2="13:6 16:6 20:4 23:4")),
    "8.4.7, a side set alone": Figure(joined_bar, "contact surface c3 contains set_3", {"c3": among("12:6 19:6 22:6")},
                                       dead="9"),
    "8.4.7, a hole": Figure(holed_plate, "contact surface block_1 contains block_1", dead="11", owners={
        "block_1": both(outside("block_1", (7, 3, 1), but="11:5 11:6"), among("10:2 12:4 4:3 18:1"))}),
    "8.8 (B)": Figure(clad_brick, CLAD, of_clad(), sheet="block_2"),
    "8.8 (B), turned round": Figure(clad_brick, CLAD_TURNED, of_clad(), sheet="block_2"),
    "8.8 (C)": Figure(clad_brick, CLAD, sheet="block_2", dead="17",
                      owners=of_clad(gained="9:6", shells="18:1 18:2 19:1 19:2 20:1 20:2")),
    "8.8 (C), turned round": Figure(clad_brick, CLAD_TURNED, sheet="block_2", dead="17",
                                    owners=of_clad(gained="9:6", shells="18:1 18:2 19:1 19:2 20:1 20:2")),
    "8.8, a solid dead": Figure(clad_brick, CLAD, sheet="block_2", dead="9",
                                owners=of_clad(lost="9:1 9:4", gained="10:4 13:1 1:6")),
    "8.10": Figure(cube, "skin all blocks = on\ncontact surface surf_1 contains surface_1",
                   {"block_1": among(SIX), "surf_1": among("")}),
    "8.11": Figure(cube, "contact surface surf_1 contains surface_1\nskin all blocks = on",
                   {"surf_1": among("1:6"), "block_1": among(SIX[:-4])}),
}


def count_in_table(log, surfaces):
    """Faces and lofted elements that surfaces own by the last table of a log."""
    rows = {}
    for row in map(str.split, log.splitlines()):
        if len(row) > 9 and row[1] in surfaces and row[2] in ("CONTACT", "SKIN", "BEGIN"):
            rows[row[1]] = int(row[-6]) + int(row[-3])
    return sum(rows.values())


def count_owned(targets, mesh):
    """As tables do: a lofted element once."""
    lofted = {name for name, kind, _, _ in mesh.blocks if kind in ("SHELL4", "BEAM2")}
    return len({target.name.split(":")[0] if target.block in lofted else target.name for target in targets})


@dataclass
class Throw:
    """A run with the sides that should answer, and the push on each cube over its momentum."""
    run: Run
    due: np.ndarray
    push: np.ndarray
    n_owned: int  # as the table should say


def throw(bench, figure, surface):
    """At one surface, or at all."""
    mesh = figure.mesh()
    targets = targets_of(mesh)
    cubes = add_cubes(mesh, targets)
    owners = figure.owners.values() if surface == "all" else [figure.owners[surface]]
    due = np.array([any(owns(target) for owns in owners) for target in targets])
    pairs = GENERAL if surface == "all" else f"begin interaction thrown\nsurfaces = {surface} probes\nend"
    lines = figure.lines if "skin all" in figure.lines else figure.lines + "\ncontact surface probes contains probes"
    run = bench.run("figures", mesh, lines=lines, pairs=pairs, sheet=figure.sheet, rod=figure.rod, dead=figure.dead,
                    n_dead=len(figure.dead.split()), frame=2e-3)
    momentum = run.nodal("mass")[..., None] * run.nodal("velocity")
    change = np.array([np.sum(momentum[-1, nodes] - momentum[0, nodes], axis=0) for nodes in cubes])
    push = np.sum(change * [target.normal for target in targets], axis=1) / (1000 * CUBE ** 3 * 10)
    return Throw(run, due, push, count_owned([t for t, is_due in zip(targets, due) if is_due], mesh))


@case()
def figures(bench):
    checks, thrown = [], []
    for name, figure in FIGURES.items():
        throws = [throw(bench, figure, surface) for surface in [*figure.owners, "all"]]
        n_due, n_hit = sum(np.sum(t.due) for t in throws), sum(np.sum(np.abs(t.push) > 0.1) for t in throws)
        last = throws[-1]
        checks += [Check(f"{name}: faces in the table", last.n_owned, count_in_table(last.run.log, figure.owners), 1e-12),
                   Check(f"{name}: cubes that bounce", n_due, n_hit, 1e-12)]
        thrown += throws
    due, push = (np.concatenate(parts) for parts in zip(*((t.due, t.push) for t in thrown)))
    return [*checks, Check("least push on a cube, over its momentum", 2, np.min(push[due]), 0.05),
            Check("most", 2, np.max(push[due]), 0.05),
            at_most("push on cubes that nothing is in the way of, over theirs", np.max(np.abs(push[~due])), 1e-12),
            *balances([t.run for t in thrown], is_free=True)]
