#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Tells whether kernels have become slower: their times, over what the same machine gives at best in the same run.

    check_ratios.py PROGRAM [--store] [--limit 15] [--rounds 8] [--slow NAME PERCENT]

PROGRAM is contactsim_kernels. The ratio of a kernel is how many multiply-adds apart (`unfused`), or bytes of STREAM's triad
(`triad`), the machine could have done on one core in the time of an item. ratios.txt has those that were found last;
`--store` writes it, the least of three. The table says old, new and change; the exit code is 1 if one is worse by more than the limit, in percent.
Times are the least of many short ones of the thread alone, between which the machine's own rates are taken. Kernels that seem
to be slower are timed again, twice at most, since a neighbour on the machine makes nothing faster.
"""
import argparse
import sys
from pathlib import Path

from kernel_lines import run

sys.dont_write_bytecode = True
STORED = Path(__file__).resolve().parent / "ratios.txt"
WATCHED = ["whole_step", "hex8_plastic", "hex8_selective", "hex8_johnson_cook", "tet4_elastic", "shells_plastic_5",
           "spheres_apart", "spheres_touch", "spheres_touch_node_face", "broad_phase", "broad_phase_refit", "skin"]
HEAD = """# What kernels take of the machine, of one core, per element, node or face: see check_ratios.py.
# kernel, ratio, its unit
"""


def measure(arguments, names):
    """Ratios and what they are to, by kernel."""
    slow = ["--slow", *arguments.slow] if arguments.slow else []
    found = run(arguments.program, "--rounds", arguments.rounds, *slow, *names)
    limits = found.pop("limits")
    return {name: (kernel["seconds"] * limits[kernel["reference"]], kernel["reference"]) for name, kernel in found.items()}


def read_stored():
    rows = [line.split() for line in STORED.read_text().splitlines() if line and not line.startswith("#")]
    return {name: float(ratio) for name, ratio, _ in rows}


def store(found):
    unit = {"unfused": "operations", "triad": "bytes"}
    STORED.write_text(HEAD + "".join(f"{name} {ratio:.4g} {unit[to]}\n" for name, (ratio, to) in found.items()))


def slower(found, old, limit):
    return [name for name, (ratio, _) in found.items() if name in old and ratio > old[name] * (1 + limit / 100)]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--store", action="store_true")
    parser.add_argument("--limit", type=float, default=15)
    parser.add_argument("--rounds", type=int, default=8)
    parser.add_argument("--slow", nargs=2, metavar=("NAME", "PERCENT"))
    arguments = parser.parse_args()
    found = measure(arguments, WATCHED)
    old = {} if arguments.store else read_stored()
    for _ in range(2):
        again = WATCHED if arguments.store else slower(found, old, arguments.limit)
        for name, (ratio, to) in measure(arguments, again).items() if again else []:
            found[name] = (min(ratio, found[name][0]), to)
    if arguments.store:
        store(found)
        return
    bad = slower(found, old, arguments.limit)
    print(f"{'kernel':26} {'old':>8} {'new':>8} {'change':>8}")
    for name, (ratio, _) in found.items():
        before = old.get(name, float("nan"))
        print(f"{name:26} {before:8.4g} {ratio:8.4g} {100 * (ratio / before - 1):+7.1f} %{'  slower' if name in bad else ''}")
    missing = sorted(set(WATCHED) - set(old)) + sorted(set(old) - set(found))
    if missing:
        print("without a stored ratio or without a kernel:", *missing)
    sys.exit(1 if bad or missing else 0)


if __name__ == "__main__":
    main()
