#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A run in ParaView by decks/show.py: picture, state, side sets of lofted shells, facets, tensors as one variable.

usage: shown_in_paraview.py PROGRAM SOURCES PVPYTHON       with a display, or under xvfb-run
"""
import os
import shutil
import subprocess
import sys
import tempfile


def run(*command):
    result = subprocess.run(command, capture_output=True, text=True, check=False)
    if result.returncode != 0:
        sys.exit(f"{' '.join(command)} ends with {result.returncode}:\n{result.stdout}{result.stderr}")
    return result.stdout


def expect(text, *parts):
    for part in parts:
        if part not in text:
            sys.exit(f"expected '{part}' in\n{text}")


VARIABLES = """
from paraview import simple
reader = simple.IOSSReader(FileName=["taylor_bar.e"])
reader.UpdatePipeline()
print({a.Name: a.GetNumberOfComponents() for a in list(reader.CellData) + list(reader.PointData)})
simple.LoadState("blocks.pvsm")
print(len(simple.GetSources()), simple.GetAnimationScene().AnimationTime > 0)
"""


def main():
    program, sources, pvpython = sys.argv[1:]
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        for name in ("two_blocks", "taylor_bar"):
            for ending in ("i", "g"):
                shutil.copy(f"{sources}/decks/{name}.{ending}", ".")
        deck = open("two_blocks.i", encoding="utf-8").read()
        debug = "begin contact definition\nbegin debug\nvisualize contact facets = on\nend"
        with open("blocks.i", "w", encoding="utf-8") as file:
            file.write(deck.replace("begin contact definition", debug, 1))
        run(program, "blocks.i", "two_blocks.g", "--quiet")
        run(program, "taylor_bar.i", "--quiet")
        show = f"{sources}/decks/show.py"
        expect(run(pvpython, show, "blocks.e", "--sides", "--picture", "blocks.png", "--state", "blocks.pvsm"),
               "blocks.e: 3 blocks", "surfaces top, left, right, cladding",
               "side sets contact_top, contact_left, contact_right, contact_cladding")
        if os.path.getsize("blocks.png") < 10000:
            sys.exit("the picture is empty")
        with open("variables.py", "w", encoding="utf-8") as file:
            file.write(VARIABLES)
        expect(run(pvpython, "variables.py"), "'stress': 6", "'displacement': 3", "4 True")


if __name__ == "__main__":
    main()
