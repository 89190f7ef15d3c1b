#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The commands of decks/ci do what they say: they pass as they stand, and the comparison fails when an owner changes.

    ci_commands.py PROGRAM ROOT
"""
import os
import re
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree
from pathlib import Path

FILES = ("github.yml", "gitlab.yml")


def read_commands(path):
    """The lines that call contactsim, of either form."""
    return re.findall(r"^ *(?:run:|-) (contactsim .*)$", path.read_text(), re.MULTILINE)


def prepare(folder, root, program):
    for name in ("two_blocks.i", "two_blocks.g", "ci/two_blocks_surfaces.csv"):
        shutil.copy(root / "decks" / name, folder)
    (folder / "bin").mkdir()
    (folder / "bin/contactsim").symlink_to(program)


def run(command, folder):
    path = f"{folder}/bin:{os.environ['PATH']}"
    return subprocess.run(command, shell=True, cwd=folder, env={**os.environ, "PATH": path},
                          capture_output=True, text=True)


def check(commands, root, program):
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        prepare(folder, root, program)
        for command in commands:
            ended = run(command, folder)
            assert ended.returncode == 0, f"{command}\n{ended.stdout}{ended.stderr}"
        suite = xml.etree.ElementTree.parse(folder / "study/study.xml").getroot()
        assert suite.get("tests") == "2" and suite.get("failures") == "0", suite.attrib
        table = folder / "two_blocks_surfaces.csv"
        table.write_text(table.read_text().replace("top,left", "left,left", 1))
        assert run(commands[1], folder).returncode == 1, "a changed owner goes unseen"


def main():
    program, root = Path(sys.argv[1]).resolve(), Path(sys.argv[2])
    lists = [read_commands(root / "decks/ci" / name) for name in FILES]
    assert lists[0] == lists[1] and len(lists[0]) == 3, lists
    check(lists[0], root, program)


if __name__ == "__main__":
    main()
