#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the verification decks of this folder and compares what they reach with what they should.

  verify.py PROGRAM [CASE ...]   run the cases (the short ones by default); fails when a number misses
  verify.py PROGRAM --table      write decks/VALIDATION.md from all cases and the refined meshes
  verify.py PROGRAM --table CASE ...   the rows of these cases alone; those of the others stay
  verify.py --list {short|long}  the names of the cases
  verify.py --keep FOLDER PROGRAM CASE ...   as the first, with the runs left in the folder

Numbers that are known to miss are marked and do not fail as long as they get no worse.
"""
import sys
import tempfile
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

sys.dont_write_bytecode = True  # decks/ may be read-only
HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
import cases_crash  # noqa: E402, F401
import cases_death  # noqa: E402, F401
import cases_discrete  # noqa: E402, F401
import cases_elements  # noqa: E402, F401
import cases_enforcement  # noqa: E402, F401
import cases_figures  # noqa: E402, F401
import cases_folds  # noqa: E402, F401
import cases_friction  # noqa: E402, F401
import cases_hertz  # noqa: E402, F401
import cases_impact  # noqa: E402, F401
import cases_interaction  # noqa: E402, F401
import cases_joints  # noqa: E402, F401
import cases_load_steps  # noqa: E402, F401
import cases_lofted  # noqa: E402, F401
import cases_restart  # noqa: E402, F401
import cases_rigid  # noqa: E402, F401
import cases_rods  # noqa: E402, F401
import cases_round  # noqa: E402, F401
import cases_shells  # noqa: E402, F401
import cases_static  # noqa: E402, F401
import cases_static_bodies  # noqa: E402, F401
import cases_static_contact  # noqa: E402, F401
import cases_static_forming  # noqa: E402, F401
import cases_static_rigid  # noqa: E402, F401
import cases_unit  # noqa: E402, F401
import cases_solids  # noqa: E402, F401
import cases_laws  # noqa: E402, F401
from cases import CASES  # noqa: E402
from runs import Bench  # noqa: E402


def run_case(program, name, *refinement):
    with tempfile.TemporaryDirectory() as folder:
        return CASES[name].run(Bench(program, folder), *refinement)


def print_checks(name, checks):
    """Returns whether all of them may pass."""
    for check in checks:
        word = "ok  " if check.holds() else "miss" if check.is_bearable() else "FAIL"
        print(f"{word} {name}: {check.row()}", flush=True)
    return all(check.is_bearable() for check in checks)


def run_cases(program, names):
    return 0 if all([print_checks(name, run_case(program, name)) for name in names]) else 1


def run_and_keep(folder, program, names):
    for name in names:
        (Path(folder) / name).mkdir(parents=True)
        print_checks(name, CASES[name].run(Bench(program, Path(folder) / name)))
    return 0


def rows_of(program, name):
    return [f"| {name} | {check.row()} |" for check in run_case(program, name)]


def refined_rows_of(program, name, refinement):
    checks = run_case(program, name, refinement)
    return [f"| {name} | {refinement} | {check.short_row()} |" for check in checks if "balance" not in check.quantity]


def write_table(program, names):
    path = HERE.parent / "VALIDATION.md"
    before = path.read_text().split("\n## Refined meshes\n") if names else ["", ""]
    names = names or list(CASES)

    def rows_before(part, name):
        return [line for line in before[part].splitlines() if line.startswith(f"| {name} |")]

    lines = ["# Verification", "", "What the decks of `decks/verification` should reach and do. Errors are relative. What",
             "misses its tolerance is marked; the head of the deck says why. Made by `decks/verification/verify.py PROGRAM --table`.", "",
             "| case | quantity | expected | reached | error | tolerance |", "| --- | --- | --- | --- | --- | --- |"]
    with ProcessPoolExecutor() as processes:  # a case a processor
        rows = {name: processes.submit(rows_of, program, name) for name in CASES if name in names}
        refined = {name: [processes.submit(refined_rows_of, program, name, refinement) for refinement in CASES[name].refined]
                   for name in rows}
        for name in CASES:
            lines += rows[name].result() if name in rows else rows_before(0, name)
        lines += ["", "## Refined meshes", "",
                  "The first quantities of a case by its number of elements: along bars, over the beam's thickness, through the",
                  "wall, across the core of the rod or ball.", "", "| case | elements | quantity | expected | reached | error |",
                  "| --- | --- | --- | --- | --- | --- |"]
        for name in CASES:
            lines += [row for case in refined[name] for row in case.result()] if name in rows else rows_before(1, name)
    path.write_text("\n".join(lines) + "\n")
    return 0


def main(arguments):
    if len(arguments) > 1 and arguments[0] == "--list":
        print(";".join(name for name, case in CASES.items() if case.is_long == (arguments[1] == "long")))
        return 0
    if len(arguments) > 3 and arguments[0] == "--keep":
        return run_and_keep(arguments[1], str(Path(arguments[2]).resolve()), arguments[3:])
    if not arguments or arguments[0].startswith("--"):
        sys.exit(__doc__)
    program = str(Path(arguments[0]).resolve())
    makes_table = arguments[1:2] == ["--table"]
    names = arguments[2 if makes_table else 1:]
    if unknown := [name for name in names if name not in CASES]:
        sys.exit(f"no case {', '.join(unknown)}; verify.py --list {{short|long}} names all")
    if makes_table:
        return write_table(program, names)
    return run_cases(program, names or [name for name, case in CASES.items() if not case.is_long])


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
