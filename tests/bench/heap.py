#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Heaps of loose bodies that fall in a box: what contact takes per contact face and step, at default settings.

    heap.py PROGRAM... [--models cubes-500 cubes-2000 cubes-8000 cubes-2000-node ...] [--steps N] [--speed F] [--threads N...]
            [--repeats N]

Bodies of 2 x 2 x 2 hexahedra with edges of 1 m, sheets of 2 x 2 shells, rods of two beams or particles of 1 m stand on a grid, a
twentieth of a metre apart, each turned by up to 3 degrees, in a box of hexahedra that is held; all fall and each flies its own
way at 28 to 49 m/s, so that after some 40 steps contact is everywhere; `--speed 0.2 --steps 500` is more like a drop. Programs are
run in turn. Told is the time of contact that the log has
over contact faces (nodes of particles and beams, which have none) and steps, the least of the repeats, searches and candidates
per face.
"""
import argparse
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE.parents[1] / "decks")]
sys.dont_write_bytecode = True
import numpy as np  # noqa: E402
from mesh_maker import MeshMaker  # noqa: E402

MODELS = ["cubes-500", "cubes-2000", "cubes-8000", "cubes-2000-node", "sheets-2000", "rods-2000", "particles-2000"]
PITCH = 1.05
WAYS = [(x, y, z - 20) for x in (-20, 20) for y in (-20, 20) for z in (-20, 20)]  # velocities
SECTIONS = {
    "cubes": ("", ""),
    "sheets": ("begin shell section s\n thickness = 0.1\n end", "section = s"),
    "rods": ("begin beam section s\n section = rod\n width = 0.2\n height = 0.2\n reference axis = z\n end", "section = s"),
    "particles": ("begin particle section s\n radius = 0.5\n end", "section = s"),
}
STEEL = """ begin material steel
  density = 7800
  begin parameters for model elastic
   youngs modulus = 200e9
   poissons ratio = 0.3
  end
 end
"""
DECK = "begin sierra heap\n" + STEEL + """{directions}
 {section}
 begin finite element model bodies
  database name = heap.g
  begin parameters for block {blocks}
   material = steel
   model = elastic
   {use}
  end
  begin parameters for block box
   material = steel
   model = elastic
  end
 end
 begin presto procedure fall
  begin time control
   begin time stepping block all
    start time = 0
    begin parameters for presto region heap
     step interval = 1000
    end
   end
   termination time = 1
  end
  begin presto region heap
   use finite element model bodies
   begin fixed displacement
    block = box
    components = x y z
   end
   {velocities}
   begin contact definition all
    skin all blocks = on
    begin interaction defaults
     general contact = on
     self contact = on
     {formulation}
    end
   end
   begin solution termination
    terminate global step >= {steps}
   end
  end
 end
end
"""


def turned(random, middle):
    """A body's way from where it is made to where it stands."""
    axis = random.normal(size=3)
    axis *= np.radians(3) * random.random() / np.linalg.norm(axis)
    x, y, z = axis
    turn = np.eye(3) + np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return lambda *point: tuple(turn @ np.array(point) + middle)


def add_body(mesh, kind, block):
    if kind == "cubes":
        mesh.hexes(block, (-0.5,) * 3, (1,) * 3, (2,) * 3)
    elif kind == "sheets":
        mesh.shells(block, (-0.5, -0.5, 0), (1, 1), (2, 2), 0.1)
    elif kind == "rods":
        mesh.lines(block, (-0.5, 0, 0), (0.5, 0, 0), 2)
    else:
        mesh.particles(block, [(0, 0, 0)])


def make_mesh(path, kind, n):
    """n bodies on a grid in a box, each in the block of a way that chance gives it."""
    random = np.random.default_rng(1)
    across = int(np.ceil(n ** (1 / 3)))
    mesh = MeshMaker()
    ways = random.integers(len(WAYS), size=n)
    for i in np.argsort(ways, kind="stable"):
        spot = np.array([i % across, i // across % across, i // across ** 2])
        mesh.new_body()
        mesh.place = turned(random, PITCH * (spot + 0.5))
        add_body(mesh, kind, f"body_{ways[i]}")
    width = PITCH * across
    mesh.place = lambda *point: point
    for origin, size, cells in [((-1, -1, -1), (width + 2, width + 2, 0.9), (across, across, 1)),
                                ((-1, 0, 0), (0.95, width, width), (1, across, across)),
                                ((width + 0.05, 0, 0), (0.95, width, width), (1, across, across)),
                                ((0, -1, 0), (width, 0.95, width), (across, 1, across)),
                                ((0, width + 0.05, 0), (width, 0.95, width), (across, 1, across))]:
        mesh.new_body()
        mesh.hexes("box", origin, size, cells)
    mesh.write(path)


def make_deck(kind, formulation, n_steps, speed=1.0):
    section, use = SECTIONS[kind]
    velocities = "\n   ".join(
        f"begin initial velocity\n    block = body_{i}\n    direction = way_{i}\n    magnitude = {speed * np.linalg.norm(way)}\n   end"
        for i, way in enumerate(WAYS))
    directions = "\n".join(f" define direction way_{i} with vector {x} {y} {z}" for i, (x, y, z) in enumerate(WAYS))
    return DECK.format(section=section, use=use, velocities=velocities, directions=directions, steps=n_steps,
                       blocks=" ".join(f"body_{i}" for i in range(len(WAYS))),
                       formulation="constraint formulation = node_face" if formulation == "node" else "")


def number(pattern, log):
    found = re.search(pattern, log)
    return float(found[1].replace(",", "")) if found else float("nan")


def run(program, folder, threads):
    """Nanoseconds per face and step, of contact and of the rest; searches; candidates per face."""
    log = subprocess.run([program, "heap.i"], cwd=folder, capture_output=True, text=True, check=False,
                         env=os.environ | {"OMP_NUM_THREADS": str(threads)})
    if log.returncode != 0:
        sys.exit(f"{program}: exit code {log.returncode}\n{log.stdout[-2000:]}{log.stderr}")
    text = log.stdout
    faces, nodes = number(r"(\d+) contact faces", text), number(r"(\d+) contact nodes", text)
    shared = (faces or nodes) * number(r"step is (\d+) >=", text)
    contact, whole = number(r"\n  contact +([\d.]+) s", text), number(r"\n  whole run +([\d.]+) s", text)
    return (1e9 * contact / shared, 1e9 * (whole - contact) / shared, number(r"(\d+) global searches", text),
            number(r"(\d+) at the end", text) / (faces or nodes), faces)


def measure(programs, model, arguments):
    kind, n, *formulation = model.split("-")
    with tempfile.TemporaryDirectory() as folder:
        make_mesh(Path(folder) / "heap.g", kind, int(n))
        (Path(folder) / "heap.i").write_text(make_deck(kind, "".join(formulation), arguments.steps, arguments.speed))
        found = {}
        for _ in range(arguments.repeats):
            for threads in arguments.threads:
                for program in programs:
                    found.setdefault((threads, program), []).append(run(program, folder, threads))
    for (threads, program), runs in found.items():
        contact, rest, searches, candidates, faces = min(runs)
        print(f"{model:18} {threads} thread{'s' if threads > 1 else ' '} {contact:8.0f} ns contact {rest:8.0f} ns rest "
              f"{faces:8.0f} faces {searches:4.0f} searches {candidates:6.1f} candidates a face  {program}", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("programs", nargs="+", metavar="PROGRAM")
    parser.add_argument("--models", nargs="+", default=MODELS)
    parser.add_argument("--steps", type=int, default=100)
    parser.add_argument("--speed", type=float, default=1.0, help="over that of 28 to 49 m/s")
    parser.add_argument("--threads", type=int, nargs="+", default=[1])
    parser.add_argument("--repeats", type=int, default=1)
    arguments = parser.parse_args()
    for model in arguments.models:
        measure([str(Path(program).resolve()) for program in arguments.programs], model, arguments)


if __name__ == "__main__":
    main()
