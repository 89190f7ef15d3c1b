#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Load steps on ranks of MPI: the bytes of one process whatever finds equilibrium, with deaths, rigid bodies and contact, restarts
with other numbers of ranks, and errors."""
import pathlib
import subprocess
import sys
import tempfile
import time

HERE = pathlib.Path(__file__).resolve().parent
SOURCE = HERE.parents[2]
sys.path[:0] = [str(path) for path in (HERE, SOURCE / "tests/campaigns", SOURCE / "tests/campaigns/runs", SOURCE / "tests/bench",
                                       SOURCE / "decks", SOURCE / "decks/verification")]
import verify  # noqa: E402, F401  its cases can be imported then
from beside_calculix import blocks as pressed_blocks  # noqa: E402
from cases_load_steps import arch_mesh, breaking_mesh, strip_mesh  # noqa: E402
from cases_static import blocks  # noqa: E402
from cases_static_rigid import punched  # noqa: E402
from mesh_maker import MeshMaker  # noqa: E402
from rank_equality import MPIRUN  # noqa: E402
from rank_runs import check, compare  # noqa: E402
from runs import Bench  # noqa: E402

RANKS = (2, 3, 4, 7)
# Blocks of 4 chunks of 512 elements each, where ranks have elements of their own.
LARGE = (12, 10, 0.5, 12)


def stiffened_bar():
    """A bar of 2 chunks, a sheet on its top, and a spring."""
    mesh = MeshMaker()
    mesh.hexes("bar", (0, 0, 0), (6, 1, 1), (16, 8, 8))
    mesh.shells("sheet", (0, 0, 1), (6, 1), (16, 8), 0.05)
    mesh.lines("stay", (6, 0.5, 1), (6, 0.5, 2), 1, "BAR2")
    mesh.node_set("clamped", lambda x, y, z: x == 0)
    mesh.node_set("ground", lambda x, y, z: z == 2)
    mesh.node_set("tip", lambda x, y, z: x == 6 and z == 0)
    return mesh


def press(solver, **more):
    """The deck beside_calculix and what -D gives for its model of 7 chunks."""
    model = pressed_blocks(12)
    tangent = dict(tangent=0) if solver == "nodal" else dict(tangent=1, solver=solver)
    values = dict(lower_youngs=model.youngs[0], upper_youngs=model.youngs[1], nu=model.nu, load=model.load, amount=model.amount,
                  tied=0, **tangent, **more)
    return SOURCE / "tests/bench/beside_calculix", model.mesh, values


def bend(**values):
    return HERE / "stiffened_bar", stiffened_bar(), values


def verification(deck, mesh, **values):
    return SOURCE / "decks/verification" / deck, mesh, values


class Runs(Bench):
    """Runs of decks wherever they are, on ranks."""

    def run_on(self, n_ranks, deck, mesh, values, resumed=None):
        folder, command = self.prepare(deck.name, mesh, **values)
        command[1] = f"{deck}.i"
        for path in resumed.glob("*.rsout*") if resumed else ():
            (folder / path.name).write_bytes(path.read_bytes())
        start = [] if n_ranks == 1 else [*MPIRUN, "-np", str(n_ranks)]
        result = subprocess.run([*start, *command, "--quiet", "--log", "run.log"], cwd=folder, capture_output=True, text=True,
                                timeout=300)
        return folder, result

    def compare(self, ranks, deck, mesh, values, code=0):
        one, result = self.run_on(1, deck, mesh, values)
        check(result.returncode == code, f"{deck.name}: exit code {result.returncode}: {result.stderr}")
        for n_ranks in ranks:
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
    for load, search in (("free", "newton"), ("weight", "cg")):
        runs.compare((2, 7), *verification("static_rigid", punched(16), load=load, search=search, steps=2))


def shells_springs_and_deaths_have(runs):
    for solver in ("direct", "nodal"):
        one = runs.compare(RANKS, *bend(solver=solver, end=0.75))
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


def main():
    with tempfile.TemporaryDirectory() as folder:
        runs = Runs(sys.argv[1], folder)
        for test in (all_solvers_have_the_bytes_of_one_process, contact_and_rigid_bodies_have, shells_springs_and_deaths_have,
                     restarts_go_on_with_other_ranks, no_equilibrium_is_found_alike):
            begun = time.monotonic()
            test(runs)
            print(f"{test.__name__}: {time.monotonic() - begun:.1f} s", flush=True)


if __name__ == "__main__":
    main()
