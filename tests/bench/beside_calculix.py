#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the same contact models in CalculiX (ccx, Debian's calculix-ccx) and in contactsim, one after the other on one thread.

    beside_calculix.py PROGRAM [--models hertz fit punch beam blocks-20 ...] [--repeats N] [--limit SECONDS] [--alone]

blocks-N presses two blocks of N x N x N elements onto each other: 20 are 16,000, 40 are 128,000. The program runs with nodal
blocks and with the full tangent, CalculiX with nodes and with faces on faces, the latter also by its iterative solver. The smallest wall time of the repeats is told; a
run that takes longer than the limit, 900 s, is ended and told as such. --alone leaves CalculiX out and runs the program with each
equation solver.
"""
import argparse
import math
import os
import re
import shutil
import subprocess
import sys
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path

HERE = Path(__file__).resolve().parent
DECKS = HERE.parents[1] / "decks"
sys.path[:0] = [str(DECKS), str(DECKS / "verification")]
sys.dont_write_bytecode = True
import numpy as np  # noqa: E402
from cases_hertz import cylinder_on_block  # noqa: E402
from mesh_maker import MeshMaker  # noqa: E402
from runs import Run  # noqa: E402
from shapes import add_ring_sector  # noqa: E402

# Sides of a hexahedron: of Exodus, and the faces of CalculiX.
FACES = {1: 3, 2: 4, 3: 5, 4: 6, 5: 1, 6: 2}
ONE_THREAD = {name: "1" for name in ("OMP_NUM_THREADS", "CCX_NPROC_EQUATION_SOLVER", "OPENBLAS_NUM_THREADS")}


@dataclass
class Model:
    """A mesh of two bodies, of which numbers are asked: label, a function of what a run has left behind, value by theory.

    `stiffness`: of contact in CalculiX [force/length^3], 10 to 50 times that of the elements behind it.
    """
    mesh: MeshMaker
    load: str
    amount: float
    youngs: tuple
    nu: float
    stiffness: float
    asked: list
    is_tied: bool = False
    kind: str = "C3D8"


@dataclass
class Answer:
    """Displacements [nodes x 3], stresses zz of elements, force on what is driven or held along z."""
    moved: np.ndarray
    stress: np.ndarray
    force: float


def points_of(mesh):
    return np.array(mesh.points)


def near(value, level, size=1.0):
    return np.abs(value - level) < 1e-6 * size


def node_at(mesh, place):
    return int(np.argmin(np.sum((points_of(mesh) - place) ** 2, axis=1)))


def hertz():
    """Half of the cylinder on a block of NAFEMS CGS-1, plane strain; elements of an eighth of the contact's half width."""
    mesh = cylinder_on_block(50, 0.78, 28, 24, 100)
    pole, sets, sides = len(mesh.blocks[0][2]), dict(mesh.node_sets), dict(mesh.side_sets)
    mesh.node_sets = [("held_x", sets["on_x"]), ("held_z", sets["bottom"])]
    mesh.node_set_where("held_y", lambda x, y, z: x == x)
    mesh.blocks = [("upper", *mesh.blocks[0][1:]), ("lower", *mesh.blocks[1][1:])]
    mesh.side_sets = [("loaded", sides["top"]), ("upper_side", [(e, 5) for e in range(1, 29)]),
                      ("lower_side", [(pole + 28 * 27 + i, 6) for i in range(1, 29)])]
    top = node_at(mesh, (0, 0, 50))
    return Model(mesh, "pressure", 17.5e3 / 32.5, (70e3, 210e3), 0.3, 2e6,
                 [("pressure in the element at the pole [MPa]", lambda a: -a.stress[0], 3585.37),
                  ("approach of the cylinder's middle [mm]", lambda a: -a.moved[top, 2], None)])


def fit():
    """A quarter of two steel rings of 10, 20 and 30 mm, the inner one 0.0025 mm too wide, plane strain."""
    mesh = MeshMaker()
    add_ring_sector(mesh, "lower", 10, 20.0025, 0.5, (16, 32, 1))
    add_ring_sector(mesh, "upper", 20, 30, 0.5, (16, 32, 1))
    mesh.node_set_where("held_x", lambda x, y, z: near(x, 0))
    mesh.node_set_where("held_y", lambda x, y, z: near(y, 0))
    mesh.node_set_where("held_z", lambda x, y, z: z == z)
    mesh.side_sets = [("lower_side", mesh.sides_where("lower", lambda x, y, z: near(np.hypot(x, y), 20.0025))),
                      ("upper_side", mesh.sides_where("upper", lambda x, y, z: near(np.hypot(x, y), 20)))]
    # Plane strain after Lame, the radii of the interface taken as one.
    a, b, c, youngs, nu = 10, 20, 30, 200e3, 0.3
    plane = youngs / (1 - nu ** 2)
    pressure = plane * 0.0025 / b / ((b * b + a * a) / (b * b - a * a) + (c * c + b * b) / (c * c - b * b))
    bore, outside = node_at(mesh, (a, 0, 0)), node_at(mesh, (c, 0, 0))
    return Model(mesh, "overlap", 0, (youngs, youngs), nu, 2e7,
                 [("bore moves by [mm]", lambda a_: a_.moved[bore, 0], -2 * pressure * a * b * b / (plane * (b * b - a * a))),
                  ("outside moves by [mm]", lambda a_: a_.moved[outside, 0],
                   2 * pressure * c * b * b / (plane * (c * c - b * b)))])


def punch():
    """Half of a steel punch, 100 mm wide with edges rounded by 10 mm, on an aluminium block of 200 x 200 mm, plane strain: as
    NAFEMS CGS-2 but not round."""
    mesh = MeshMaker()
    flat, bend, n_up = 24, 10, 24
    angles = [0] * (flat + 1) + [math.radians(60) * i / bend for i in range(1, bend + 1)]
    levels = np.linspace(0, 1, n_up + 1) ** 1.6

    def place(i, j, k):
        column, level = round(i), levels[round(k)]
        if column <= flat:
            # Columns get narrower towards the rounded edge.
            low = (40 * (1 - (1 - column / flat) ** 1.5), 0)
            high = low[0]
        else:
            angle = angles[column]
            low, high = (40 + 10 * math.sin(angle), 10 * (1 - math.cos(angle))), 40 + 10 * (column - flat) / bend
        return low[0] + level * (high - low[0]), j, low[1] + level * (100 - low[1])
    mesh.place = place
    mesh.hexes("upper", (0, 0, 0), (flat + bend, 1, n_up), (flat + bend, 1, n_up))
    across = np.concatenate([40 * (1 - (1 - np.linspace(0, 1, 21)) ** 1.5), 40 + 60 * np.linspace(0, 1, 21)[1:] ** 1.6])
    mesh.new_body()
    mesh.place = lambda i, j, k: (across[round(i)], j, -200 * (1 - round(k) / 30) ** 1.8)
    mesh.hexes("lower", (0, 0, 0), (40, 1, 30), (40, 1, 30))
    mesh.node_set_where("held_x", lambda x, y, z: near(x, 0))
    mesh.node_set_where("held_y", lambda x, y, z: y == y)
    mesh.node_set_where("held_z", lambda x, y, z: near(z, -200))
    n_columns = flat + bend
    mesh.side_sets = [("loaded", [(n_columns * (n_up - 1) + i, 6) for i in range(1, n_columns + 1)]),
                      ("upper_side", [(i, 5) for i in range(1, n_columns + 1)]),
                      ("lower_side", mesh.sides_where("lower", lambda x, y, z: near(z, 0)))]
    top, line, places = node_at(mesh, (0, 0, 100)), top_line(mesh), points_of(mesh)[:, 0]
    under = n_columns * n_up + 40 * 29
    return Model(mesh, "pressure", 100.0, (70e3, 210e3), 0.3, 2e6,
                 [("top moves down by [mm]", lambda a: -a.moved[top, 2], None),
                  ("pressure below the middle [MPa]", lambda a: -a.stress[under], None),
                  ("block at the edge moves in by [mm]", lambda a: -np.interp(40, places[line], a.moved[line, 0]), None)])


def top_line(mesh):
    """Nodes of the lower block along its top, by x."""
    points, own = points_of(mesh), sorted({n - 1 for row in mesh.blocks[1][2] for n in row})
    line = [n for n in own if near(points[n, 2], 0) and near(points[n, 1], 0)]
    return np.array(sorted(line, key=lambda n: points[n, 0]))


def beam():
    """A clamped beam of two layers that are tied, 20 x 1 x 1 on 30 x 2 x 2 elements of a side, bent by pressure."""
    mesh = MeshMaker()
    mesh.hexes("lower", (0, 0, 0), (10, 1, 0.5), (60, 6, 3))
    mesh.new_body()
    mesh.hexes("upper", (0, 0, 0.5), (10, 1, 0.5), (40, 4, 3))
    for name in ("held_x", "held_y", "held_z"):
        mesh.node_set_where(name, lambda x, y, z: near(x, 0))
    mesh.side_sets = [("loaded", mesh.sides_where("upper", lambda x, y, z: near(z, 1))),
                      ("lower_side", mesh.sides_where("lower", lambda x, y, z: near(z, 0.5))),
                      ("upper_side", mesh.sides_where("upper", lambda x, y, z: near(z, 0.5)))]
    tip = node_at(mesh, (10, 0, 0))
    bending, shear = 1e-3 * 10 ** 4 / (8 * 200 / 12), 1e-3 * 10 ** 2 / (2 * 200 / 2 * 5 / 6)
    return Model(mesh, "pressure", 1e-3, (200, 200), 0.0, 0,
                 [("tip moves down by", lambda a: -a.moved[tip, 2], bending + shear)], is_tied=True, kind="C3D8I")


def blocks(n):
    """A block of 0.8 on one of 1, n x n x n elements each, lowered by a hundredth."""
    mesh = MeshMaker()
    mesh.hexes("lower", (0, 0, 0), (1, 1, 1), (n, n, n))
    mesh.new_body()
    mesh.hexes("upper", (0.1, 0.1, 1), (0.8, 0.8, 0.8), (n, n, n))
    for name in ("held_x", "held_y"):
        mesh.node_set_where(name, lambda x, y, z: near(z, 0) | near(z, 1.8))
    mesh.node_set_where("held_z", lambda x, y, z: near(z, 0))
    cube = n ** 3
    mesh.side_sets = [("loaded", [(2 * cube - n * n + i, 6) for i in range(1, n * n + 1)]),
                      ("lower_side", [(cube - n * n + i, 6) for i in range(1, n * n + 1)]),
                      ("upper_side", [(cube + i, 5) for i in range(1, n * n + 1)])]
    return Model(mesh, "depth", 0.01, (200e9, 200e9), 0.3, 10 * n * 200e9, [("force", lambda a: a.force, None)])


def find_model(name):
    if name.startswith("blocks-"):
        return blocks(int(name.split("-")[1]))
    return {"hertz": hertz, "fit": fit, "punch": punch, "beam": beam}[name]()


def write_calculix(model, path, form, solver):
    """One increment that follows large motion, as the deck does; contact is linear in the depth."""
    mesh, lines = model.mesh, ["*NODE,NSET=ALL"]
    lines += [f"{n},{p[0]:.12g},{p[1]:.12g},{p[2]:.12g}" for n, p in enumerate(mesh.points, 1)]
    number = 0
    for name, _, rows, _ in mesh.blocks:
        lines.append(f"*ELEMENT,TYPE={model.kind},ELSET={name}")
        for row in rows:
            number += 1
            lines.append(",".join(map(str, [number, *row])))
    for name, nodes in mesh.node_sets:
        lines += [f"*NSET,NSET={name}", *(f"{n}," for n in nodes)]
    for name, sides in mesh.side_sets:
        lines += [f"*SURFACE,NAME={name}", *(f"{e},S{FACES[s]}" for e, s in sides)]
    for block, youngs in zip(("lower", "upper"), model.youngs):
        lines += [f"*MATERIAL,NAME=of_{block}", "*ELASTIC", f"{youngs},{model.nu}",
                  f"*SOLID SECTION,ELSET={block},MATERIAL=of_{block}"]
    lines += ["*ELSET,ELSET=everything", "lower,upper"]
    # The finer side is the dependent one.
    sizes = {name: len(sides) for name, sides in mesh.side_sets}
    fine, coarse = ("upper_side", "lower_side") if sizes["upper_side"] >= sizes["lower_side"] else ("lower_side", "upper_side")
    if model.is_tied:
        lines += ["*TIE,NAME=glue,POSITION TOLERANCE=0.01", f"{fine},{coarse}"]
    else:
        forces_far_apart = f",{1e-3 * min(model.youngs)}" if form == "node" else ""
        lines += ["*SURFACE INTERACTION,NAME=press", "*SURFACE BEHAVIOR,PRESSURE-OVERCLOSURE=LINEAR",
                  f"{model.stiffness}{forces_far_apart}",
                  f"*CONTACT PAIR,INTERACTION=press,TYPE={'NODE' if form == 'node' else 'SURFACE'} TO SURFACE",
                  f"{fine},{coarse}"]
    lines += ["*BOUNDARY", "held_x,1,1", "held_y,2,2", "held_z,3,3", "*STEP,NLGEOM,INC=1000",
              f"*STATIC,DIRECT,SOLVER={solver}", "1.,1."]
    sets, reactions = dict(mesh.side_sets), "held_z"
    if model.load == "pressure":
        lines += ["*DLOAD", *(f"{e},P{FACES[s]},{model.amount}" for e, s in sets["loaded"])]
    elif model.load == "depth":
        corners = {6: (4, 5, 6, 7)}
        rows = [row for _, _, rows, _ in mesh.blocks for row in rows]
        driven = sorted({rows[e - 1][c] for e, s in sets["loaded"] for c in corners[s]})
        lines += ["*BOUNDARY", *(f"{n},3,3,{-model.amount}" for n in driven)]
    lines += ["*NODE PRINT,NSET=ALL", "U", f"*NODE PRINT,NSET={reactions},TOTALS=ONLY", "RF",
              "*EL PRINT,ELSET=everything", "S", "*END STEP", ""]
    path.write_text("\n".join(lines))


def read_calculix(path, model):
    """The numbers of the last increment."""
    moved, stress, count, force, reading = np.zeros((len(model.mesh.points), 3)), {}, {}, 0.0, None
    for line in path.read_text().splitlines():
        words = line.split()
        if not words:
            continue
        if "displacements" in line:
            reading = "moved"
        elif "total force" in line:
            reading = "force"
        elif "stresses" in line:
            reading, stress, count = "stress", {}, {}
        elif reading == "moved":
            moved[int(words[0]) - 1] = [float(w) for w in words[1:4]]
        elif reading == "force":
            force = float(words[2])
        elif reading == "stress":
            element = int(words[0]) - 1
            stress[element] = stress.get(element, 0.0) + float(words[4])
            count[element] = count.get(element, 0) + 1
    return Answer(moved, np.array([stress[e] / count[e] for e in sorted(stress)]), force)


def read_contactsim(folder, model):
    run = Run(folder, "beside_calculix", "")
    stress = np.concatenate([run.element("stress_zz", block)[-1] for block in (1, 2)])
    lower = 1 if model.mesh.blocks[0][0] == "lower" else 2
    return Answer(run.nodal("displacement")[-1], stress, -np.sum(run.nodal("force_contact")[-1, run.nodes_of(lower), 2]))


def time_command(command, folder, limit):
    """Wall time, what is printed, whether it came to an end."""
    start = time.perf_counter()
    try:
        done = subprocess.run(command, cwd=folder, env={**os.environ, **ONE_THREAD}, capture_output=True, text=True, timeout=limit)
        printed, is_done = done.stdout + done.stderr, done.returncode == 0
    except subprocess.TimeoutExpired:
        printed, is_done = "", False
    return time.perf_counter() - start, printed, is_done


def one_core(command):
    return ["taskset", "-c", "0", *command] if shutil.which("taskset") else command


def run_calculix(model, folder, form, solver, limit):
    write_calculix(model, folder / f"{form}.inp", form, solver)
    seconds, printed, is_done = time_command(one_core(["ccx", "-i", form]), folder, limit)
    return seconds, read_calculix(folder / f"{form}.dat", model) if is_done else None, len(re.findall(r"^ iteration ", printed, re.M))


def run_contactsim(program, model, folder, way, limit):
    command = [program, str(HERE / "beside_calculix.i"), "--threads", "1"]
    values = dict(lower_youngs=model.youngs[0], upper_youngs=model.youngs[1], nu=model.nu, load=model.load, amount=model.amount,
                  tied=int(model.is_tied), **way)
    for name, value in values.items():
        command += ["-D", f"{name}={value}"]
    seconds, printed, is_done = time_command(one_core(command), folder, limit)
    if not is_done:
        print(printed[-2000:])
        return seconds, None, 0
    last = re.findall(r"^ +\d+ +\S+e\S+ .*$", printed, re.M)[-1].split()
    return seconds, read_contactsim(folder, model), int(last[5])


def compare(name, arguments):
    model = find_model(name)
    n_elements = sum(len(rows) for _, _, rows, _ in model.mesh.blocks)
    print(f"\n{name}: {n_elements} hexahedra")
    print(f"{'':36s} {'wall [s]':>10s} {'iterations':>10s}  " + "  ".join(f"{label:>24s}" for label, _, _ in model.asked))
    print(f"{'by theory':36s} {'':>10s} {'':>10s}  "
          + "  ".join(f"{'' if known is None else f'{known:.6g}':>{max(24, len(label))}s}" for label, _, known in model.asked))
    way = "tied" if model.is_tied else "faces on faces"
    forms = [(f"CalculiX, {way}", "face", "SPOOLES"), (f"CalculiX, {way}, iterative", "face", "ITERATIVE CHOLESKY")]
    forms += [] if model.is_tied else [("CalculiX, nodes on faces", "node", "SPOOLES")]
    with tempfile.TemporaryDirectory() as folder:
        folder = Path(folder)
        model.mesh.write(folder / "beside_calculix.g")
        jobs = [] if arguments.alone else [
            (label, lambda form=form, solver=solver: run_calculix(model, folder, form, solver, arguments.limit))
            for label, form, solver in forms]
        ways = {"nodal blocks": dict(tangent=0), "full tangent": dict(tangent=1)}
        if arguments.alone:
            ways.update({name: dict(tangent=1, solver=name.lower()) for name in ("DIRECT", "AMG")})
        jobs += [(f"contactsim, {name}", lambda way=way: run_contactsim(arguments.program, model, folder, way, arguments.limit))
                 for name, way in ways.items()]
        best = {}
        for _ in range(arguments.repeats):
            for label, job in jobs:
                if label in best and best[label][1] is None:
                    continue
                outcome = job()
                if label not in best or outcome[0] < best[label][0]:
                    best[label] = outcome
    for label, (seconds, answer, iterations) in best.items():
        if answer is None:
            print(f"{label:36s} {'failed' if seconds < arguments.limit else f'> {arguments.limit:.0f}':>10s}")
        else:
            print(f"{label:36s} {seconds:10.2f} {iterations:10d}  "
                  + "  ".join(f"{ask(answer):{max(24, len(text))}.6g}" for text, ask, _ in model.asked))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=lambda path: str(Path(path).resolve()))
    parser.add_argument("--models", nargs="+", default=["hertz", "fit", "punch", "beam", "blocks-20"])
    parser.add_argument("--repeats", type=int, default=3)
    parser.add_argument("--limit", type=float, default=900.0)
    parser.add_argument("--alone", action="store_true")
    arguments = parser.parse_args()
    for name in arguments.models:
        compare(name, arguments)


if __name__ == "__main__":
    main()
