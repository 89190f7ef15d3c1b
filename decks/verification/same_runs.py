#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs decks with two programs and compares everything that they write, bit by bit: for changes that must not show.

  same_runs.py OLD NEW [CASE ...]   the verification cases (the short ones by default), and the decks above this folder

Left out is what no two runs share: times of the clock, date and command in logs, QA and info records, the case whose
run is killed.
"""
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

import netCDF4
import verify
from cases import CASES
from runs import Bench

DEMOS = ("two_blocks.i", "taylor_bar.i", "impact.i")
CLOCK = re.compile(r"^(.*( s +\d+\.\d %|per second| s of the clock ).*|  (date|command) {4,}.*)$", re.MULTILINE)
EXODUS = re.compile(r"\.[egh](-s\d+)?$")
OF_THE_PROGRAM = {"qa_records", "info_records"}  # its version, the time of day


def run_all(program, cases, folder):
    for name in cases:
        (folder / name).mkdir()
        CASES[name].run(Bench(program, folder / name))
    for deck in DEMOS:
        run = folder / "demos" / Path(deck).stem
        run.mkdir(parents=True)
        for suffix in (".i", ".g"):
            shutil.copy((verify.HERE.parent / deck).with_suffix(suffix), run)
        for options in (["--check"], []):
            result = subprocess.run([program, deck, *options], cwd=run, capture_output=True, text=True)
            (run / f"printed{''.join(options)}.txt").write_text(result.stdout + result.stderr)


def is_same_exodus(old, new):
    with netCDF4.Dataset(old) as a, netCDF4.Dataset(new) as b:
        if list(a.variables) != list(b.variables):
            return False
        for data in (a, b):
            data.set_auto_mask(False)
        return all(name in OF_THE_PROGRAM or a[name][:].tobytes() == b[name][:].tobytes() for name in a.variables)


def is_same(old, new):
    if old.read_bytes() == new.read_bytes():
        return True
    if EXODUS.search(old.name):
        return is_same_exodus(old, new)
    if old.suffix in (".log", ".txt"):
        return CLOCK.sub("", old.read_text()) == CLOCK.sub("", new.read_text())
    return False


def files_of(folder):
    """Restart files hold the time of day; runs that go on from them show whether they are the same."""
    return {path.relative_to(folder) for path in folder.rglob("*") if path.is_file() and ".rsout" not in path.name}


def main(arguments):
    if len(arguments) < 2 or arguments[0].startswith("-"):
        sys.exit(__doc__)
    programs = [str(Path(program).resolve()) for program in arguments[:2]]
    cases = arguments[2:] or [name for name, case in CASES.items() if not case.is_long and name != "killed"]
    with tempfile.TemporaryDirectory() as folder:
        here, kept = Path(folder) / "run", Path(folder) / "old"  # both run in one place, which logs name
        for program in programs:
            if here.exists():
                here.rename(kept)
            here.mkdir()
            run_all(program, cases, here)
        old, new = files_of(kept), files_of(here)
        differ = sorted((old ^ new) | {path for path in old & new if not is_same(kept / path, here / path)})
    for path in differ:
        print(f"differs: {path}")
    print(f"{len(old)} files of {len(cases)} cases: {len(differ)} differ")
    return 1 if differ else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
