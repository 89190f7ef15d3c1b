#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs a rod of 1,000 elements, one of them ten times shorter, with and without SUBCYCLE BLOCKS in turn on one thread.

    subcycled_rod.py PROGRAM [--repeats N]

Tells the least processor time of each, and how often the one goes into the other: hexahedra, then trusses.
"""
import argparse
import os
import re
import resource
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
DECKS = HERE.parents[1] / "decks"
sys.path[:0] = [str(DECKS), str(DECKS / "verification")]
sys.dont_write_bytecode = True
from cases_solids import graded_bar_mesh  # noqa: E402
from mesh_maker import MeshMaker  # noqa: E402


def truss_mesh(n, short=0.1):
    mesh, size, half = MeshMaker(), 2.0 / (n + short), n // 2
    for name, begin, end, cells in (("left", 0, half, half), ("short", half, half + short, 1),
                                    ("right", half + short, n + short, n - half)):
        mesh.lines(name, (begin * size, 0, 0), (end * size, 0, 0), cells, "TRUSS2")
    mesh.node_set("wall", lambda x, y, z: x == 0)
    return mesh


def truss_deck(deck):
    deck = re.sub("( +)model = elastic\n", r"\g<0>\1section = thin\n", deck)
    deck = re.sub("( *)begin finite element model", r"\1begin truss section thin\n\1  area = 1e-6\n\1end\n\n\g<0>", deck)
    return deck.replace("        element variables = stress\n", "")


def seconds(program, folder, subcycled):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run([program, "rod.i", "--threads", "1", "--quiet", "-D", f"subcycled={subcycled}"], cwd=folder, check=True,
                   capture_output=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def main():
    options = argparse.ArgumentParser(usage=__doc__)
    options.add_argument("program")
    options.add_argument("--repeats", type=int, default=5)
    asked = options.parse_args()
    program = os.path.abspath(asked.program)
    deck = (DECKS / "verification/graded_bar.i").read_text().replace("graded_bar.g", "rod.g")
    deck = deck.replace("at step 0 increment = 1\n", "at step 0 increment = 1000\n")
    for name, mesh, text in (("hexahedra", graded_bar_mesh(999), deck), ("trusses", truss_mesh(999), truss_deck(deck))):
        with tempfile.TemporaryDirectory() as folder:
            mesh.write(Path(folder) / "rod.g")
            (Path(folder) / "rod.i").write_text(text)
            times = {0: [], 1: []}
            for _ in range(asked.repeats):
                for subcycled in times:
                    times[subcycled].append(seconds(program, folder, subcycled))
            plain, cycled = min(times[0]), min(times[1])
            print(f"{name:10} {plain:8.3f} s {cycled:8.3f} s {plain / cycled:6.2f} times")


if __name__ == "__main__":
    main()
