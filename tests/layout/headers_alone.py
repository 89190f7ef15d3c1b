#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Compiles every header alone, twice over, so that each includes what it needs and may be included again.

    headers_alone.py ROOT FOLDER COMPILER FLAGS...

What many headers include in the end (Eigen, strings, our own largest headers) is compiled once, into precompiled
headers in FOLDER. A header is compiled behind one only if it includes all of it anyway, itself or through others: so
nothing that it forgot is there by chance. Clang takes a third of GCC's time for the same.
"""
import os
import re
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

MODULES = ("core", "parser", "contact", "io", "app")
TEXTS = ("cstdint", "optional", "span", "string", "string_view", "vector")
NUMBERS = TEXTS + ("Eigen/Core", "array", "memory", "utility")
# What is compiled once. The first entry that a header includes all of is taken: the largest stand first.
COMMON = (
    ("contact/formulations/contact_step_context.hpp",),
    ("contact/mesh/contact_kinematics.hpp",),
    ("core/output/output_variables.hpp",),
    ("core/dynamics/model.hpp",),
    ("core/base/tensor_lanes.hpp",),
    NUMBERS + ("Eigen/Geometry",),
    NUMBERS,
    TEXTS,
)


def read_includes(root, has_python):
    """Of each header what it includes: ours by path, others as they are named between angle brackets. Those for Python
    are left out where it is not built for."""
    includes = {}
    for module in MODULES:
        for header in sorted((root / module).rglob("*.hpp")):
            found = re.findall(r'^#include [<"]([^>"]+)[>"]', header.read_text(), re.MULTILINE)
            if has_python or not any(other.startswith("pybind11/") for other in found):
                includes[str(header.relative_to(root))] = found
    return includes


def includes_in_the_end(header, includes, known):
    """All that a header includes, itself or through others of ours."""
    if header not in known:
        known[header] = set(includes[header])
        for included in includes[header]:
            if included in includes:
                known[header] |= includes_in_the_end(included, includes, known)
    return known[header]


def precompile(root, folder, compiler):
    """Makes the precompiled headers and gives the flags by which a compilation uses each."""
    is_clang = "clang" in Path(compiler[0]).name
    folder.mkdir(parents=True, exist_ok=True)
    commands, flags = [], []
    for number, headers in enumerate(COMMON):
        path = folder / f"common_{number}.hpp"
        path.write_text("".join(f"#include <{header}>\n" for header in headers))
        made = f"{path}.pch" if is_clang else f"{path}.gch"
        instantiated = ["-fpch-instantiate-templates"] if is_clang else []
        commands.append(compiler + instantiated + ["-x", "c++-header", str(path), "-o", made])
        flags.append(["-include-pch", made] if is_clang else ["-include", str(path), "-Winvalid-pch"])
    with ThreadPoolExecutor(os.cpu_count()) as threads:
        list(threads.map(lambda command: subprocess.run(command, cwd=root, check=True), commands))
    return flags


def main():
    root, folder, compiler = Path(sys.argv[1]), Path(sys.argv[2]), sys.argv[3:]
    includes = read_includes(root, any("python" in flag for flag in compiler))
    if not includes:
        sys.exit(f"there are no headers in {root}")
    flags = precompile(root, folder, compiler)
    known = {}

    def check(header):
        all_of_it = includes_in_the_end(header, includes, known)
        behind = next((flags[i] for i, common in enumerate(COMMON) if all_of_it.issuperset(common)), [])
        command = compiler + behind + ["-fsyntax-only", "-x", "c++", "-"]
        text = f'#include "{header}"\n' * 2
        return header, subprocess.run(command, input=text, cwd=root, text=True, capture_output=True)

    failed = 0
    with ThreadPoolExecutor(os.cpu_count()) as threads:
        for header, run in threads.map(check, includes):
            if run.returncode != 0:
                failed += 1
                print(f"{run.stderr}not alone: {header}")
    print(f"{len(includes)} headers, {failed} not alone")
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
