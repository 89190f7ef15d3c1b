#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Load steps on ranks of MPI: the bytes of one process whatever finds equilibrium, with deaths, rigid bodies and contact, restarts
with other numbers of ranks, and errors.

    static_rank_runs.py PROGRAM [--all]

Without --all each deck runs on one number of ranks, bars that break with one solver, and restarts and what finds no equilibrium are
left out: a minute in place of many."""
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import time

HERE = pathlib.Path(__file__).resolve().parent
SOURCE = HERE.parents[2]
sys.path[:0] = [str(path) for path in (HERE, SOURCE / "tests/campaigns", SOURCE / "tests/campaigns/runs", SOURCE / "tests/bench",
                                       SOURCE / "decks", SOURCE / "decks/verification")]
import netCDF4  # noqa: E402
import numpy as np  # noqa: E402
import verify  # noqa: E402, F401  its cases can be imported then
from beside_calculix import blocks as pressed_blocks  # noqa: E402
from cases_load_steps import arch_mesh, breaking_mesh, strip_mesh  # noqa: E402
from cases_static import blocks  # noqa: E402
from cases_static_rigid import punched  # noqa: E402
from mesh_maker import MeshMaker  # noqa: E402
from rank_equality import MPIRUN  # noqa: E402
from rank_runs import check, compare  # noqa: E402
from results import same_exodus  # noqa: E402
from runs import Bench  # noqa: E402

RANKS = (2, 3, 4, 7)
# Blocks of 4 chunks of 512 elements each, where ranks have elements of their own.
LARGE = (12, 10, 0.5, 12)


def stiffened_bar():
    """A bar, a sheet on its top, and a spring: of so many elements that two ranks share them."""
    mesh = MeshMaker()
    mesh.hexes("bar", (0, 0, 0), (6, 1, 1), (22, 12, 12))
    mesh.shells("sheet", (0, 0, 1), (6, 1), (22, 12), 0.05)
    mesh.lines("stay", (6, 0.5, 1), (6, 0.5, 2), 1, "BAR2")
    mesh.node_set("clamped", lambda x, y, z: x == 0)
    mesh.node_set("ground", lambda x, y, z: z == 2)
    mesh.node_set("tip", lambda x, y, z: x == 6 and z == 0)
    return mesh


def press(solver, n=12):
    """The deck beside_calculix and what -D gives for its model, of 7 chunks where there are 12 elements a side."""
    model = pressed_blocks(n)
    tangent = dict(tangent=0) if solver == "nodal" else dict(tangent=1, solver=solver)
    values = dict(lower_youngs=model.youngs[0], upper_youngs=model.youngs[1], nu=model.nu, load=model.load, amount=model.amount,
                  tied=0, **tangent)
    return SOURCE / "tests/bench/beside_calculix", model.mesh, values


def bend(**values):
    return HERE / "stiffened_bar", stiffened_bar(), values


def verification(deck, mesh, **values):
    return SOURCE / "decks/verification" / deck, mesh, values


class Runs(Bench):
    """Runs of decks wherever they are, on ranks."""

    takes_all = "--all" in sys.argv[2:]

    def run_on(self, n_ranks, deck, mesh, values, resumed=None, environment=None):
        folder, command = self.prepare(deck.name, mesh, **values)
        command[1] = f"{deck}.i"
        for path in resumed.glob("*.rsout*") if resumed else ():
            (folder / path.name).write_bytes(path.read_bytes())
        start = [] if n_ranks == 1 else [*MPIRUN, "-np", str(n_ranks)]
        result = subprocess.run([*start, *command, "--quiet", "--log", "run.log"], cwd=folder, capture_output=True, text=True,
                                timeout=300, env={**os.environ, **(environment or {})})
        return folder, result

    def compare(self, ranks, deck, mesh, values, code=0):
        one, result = self.run_on(1, deck, mesh, values)
        check(result.returncode == code, f"{deck.name}: exit code {result.returncode}: {result.stderr}")
        for n_ranks in ranks if self.takes_all else ranks[:1]:
            more, of_ranks = self.run_on(n_ranks, deck, mesh, values)
            check(of_ranks.returncode == code, f"{deck.name} on {n_ranks} ranks: exit code {of_ranks.returncode}: {of_ranks.stderr}")
            compare(one, more)
            said, expected = (text.count("error: ") for text in (of_ranks.stderr, result.stderr))
            check(said == expected, f"{deck.name} on {n_ranks} ranks says {said} errors: {of_ranks.stderr}")
        return one


def all_solvers_have_the_bytes_of_one_process(runs):
    for solver in ("nodal", "direct", "amg"):
        runs.compare(RANKS, *press(solver))


def contact_and_rigid_bodies_have(runs):
    runs.compare((2, 3), *verification("static_patch", blocks(*LARGE), form="node_face", tied=1, amount=-100))
    for load, search in (("free", "newton"), ("weight", "cg")) if runs.takes_all else (("free", "newton"),):
        runs.compare((2, 7), *verification("static_rigid", punched(16), load=load, search=search, steps=2))


def shells_springs_and_deaths_have(runs):
    for solver in ("direct", "nodal") if runs.takes_all else ("direct",):
        one = runs.compare(RANKS, *bend(solver=solver, end=0.75))
        check("nan" not in (one / "stiffened_bar.csv").read_text(), "an energy is no number")
        dead = [float(row.split(",")[-2]) for row in (one / "stiffened_bar.csv").read_text().splitlines()[1:]]
        check(dead[-1] > 0, "nothing has died in the bar")
    runs.compare((2, 4), *verification("static_breaking", breaking_mesh()))
    runs.compare((2,), *verification("static_rollup", strip_mesh(20), steps=10))
    runs.compare((3,), *verification("preload", arch_mesh(16), section="shell"))


def restarts_go_on_with_other_ranks(runs):
    stored, result = runs.run_on(3, *bend(end=0.5))
    check(result.returncode == 0, result.stderr)
    folders = []
    for n_ranks in (1, 2, 4):
        folder, result = runs.run_on(n_ranks, *bend(end=0.75, restart=1), resumed=stored)
        check(result.returncode == 0, result.stderr)
        check((folder / "stiffened_bar.e-s0002").exists(), "it does not go on from the stored state")
        folders.append(folder)
    for folder in folders[1:]:
        compare(folders[0], folder)


def no_equilibrium_is_found_alike(runs):
    runs.compare((2, 4), *bend(way=-40, most_cutbacks=1), code=4)


def a_factor_is_divided_among_ranks(runs):
    def end_of(folder):
        with netCDF4.Dataset(folder / "beside_calculix.e") as file:
            return np.stack([file[f"vals_nod_var{i}"][-1] for i in (1, 2, 3)])

    one, _ = runs.run_on(1, *press("direct", 6))
    expected = end_of(one)
    for n_ranks in (2, 3) if runs.takes_all else (2,):
        folder, result = runs.run_on(n_ranks, *press("distributed", 6))
        check(result.returncode == 0, result.stderr)
        off = np.max(np.abs(end_of(folder) - expected)) / np.max(np.abs(expected))
        check(off < 1e-4, f"displacements on {n_ranks} ranks are off by {off}")  # the target of forces
        log = (folder / "run.log").read_text()
        check("agree to the target of forces" in log, "the log does not say that bytes differ")
        memory = re.search(r"^Factor: (\d+) MB on the rank with most of it, (\d+) MB on all$", log, re.MULTILINE)
        check(memory and 0 < int(memory[1]) < int(memory[2]), "the log does not say what the factor takes")
    folder, result = runs.run_on(1, *press("distributed", 6))
    check(result.returncode == 0 and "LINEAR SOLVER = DISTRIBUTED is DIRECT here: the run is on one rank" in result.stderr,
          result.stderr)
    check(not same_exodus(one / "beside_calculix.e", folder / "beside_calculix.e"), "results are not those of DIRECT")
    bent, result = runs.run_on(2, *bend(solver="distributed", end=0.25))  # of an unsymmetric stiffness
    check(result.returncode == 0, result.stderr)


def a_factor_without_its_library_is_an_error(runs):
    for path in pathlib.Path("/usr/lib").glob("*/libdmumps-*.so"):
        (runs.folder / "none").mkdir(exist_ok=True)
        (runs.folder / "none" / path.name).write_text("")
    _, result = runs.run_on(2, *press("distributed", 6), environment={"LD_LIBRARY_PATH": str(runs.folder / "none")})
    check(result.returncode == 3, f"exit code {result.returncode}: {result.stderr}")
    check(result.stderr.count("LINEAR SOLVER = DISTRIBUTED needs it") == 1, result.stderr)


def main():
    with tempfile.TemporaryDirectory() as folder:
        runs = Runs(sys.argv[1], folder)
        tests = [all_solvers_have_the_bytes_of_one_process, contact_and_rigid_bodies_have, shells_springs_and_deaths_have,
                 a_factor_is_divided_among_ranks, a_factor_without_its_library_is_an_error]
        if runs.takes_all:
            tests += [restarts_go_on_with_other_ranks, no_equilibrium_is_found_alike]
        for test in tests:
            begun = time.monotonic()
            test(runs)
            print(f"{test.__name__}: {time.monotonic() - begun:.1f} s", flush=True)


if __name__ == "__main__":
    main()
