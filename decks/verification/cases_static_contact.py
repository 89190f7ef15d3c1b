# SPDX-License-Identifier: BSD-3-Clause
"""Contact in load steps."""
import itertools
import math

import numpy as np

from cases import FORMULATIONS, balances, case
from cases_hertz import ball, ball_on_ball, contact_size
from cases_static import blocks
from mesh_maker import MeshMaker
from runs import Check, at_most


def last_error(run, stress):
    """The largest error of the stress of an element at the end."""
    errors = [np.abs(run.element("stress_zz", block)[-1] / stress - 1) for block in (1, 2)]
    return max(np.max(e) for e in errors)


def nodal_error(run, cells):
    """The largest error of a nodal contact force: the integral of the node's shape function over the uniform pressure."""
    places = run.start + run.nodal("displacement")[-1]
    forces = run.nodal("force_contact")[-1][:, 2]
    total, errors = np.sum(forces[run.nodes_of(2)]), []
    for block, n in zip((1, 2), cells):
        nodes = run.nodes_of(block)[forces[run.nodes_of(block)] != 0]
        x = places[nodes, :2]
        at_border = np.isclose(x, x.min(axis=0)) | np.isclose(x, x.max(axis=0))
        share = np.prod(np.where(at_border, 0.5, 1.0), axis=1) / n**2
        errors.append(np.max(np.abs(np.abs(forces[nodes]) / (total * share) - 1)))
    return max(errors)


@case()
def static_patch(bench):
    checks, runs = [], []
    for form, nu in itertools.product(FORMULATIONS, (0.0, 0.3)):
        for lower, upper in ((2, 2), (3, 2), (2, 3), (4, 2)):
            runs.append(bench.run("static_patch", blocks(lower, upper), form=form, nu=nu))
            label = f"{form}, {upper}x{upper} on {lower}x{lower}, nu = {nu}: error of stress"
            checks.append(at_most(label, last_error(runs[-1], -100), 1e-3))
    for form, (lower, upper) in itertools.product(FORMULATIONS, ((3, 2), (4, 2))):
        runs.append(bench.run("static_patch", blocks(lower, upper), form=form, target=1e-9))
        label = f"{form}, {upper}x{upper} on {lower}x{lower}, forces balanced to 1e-9"
        checks += [at_most(f"{label}: error of stress", last_error(runs[-1], -100), 1e-6),
                   at_most(f"{label}: error of a nodal force", nodal_error(runs[-1], (lower, upper)), 1e-6)]
    for form in FORMULATIONS:
        run = bench.run("static_patch", blocks(3, 2), form=form, tied=1, amount=-100)
        bar = 0.001 if form == "face_face" else 0.69
        checks.append(at_most(f"{form}, tied: error of stress", last_error(run, 100), bar))
    return checks + balances(runs)


@case()
def static_cubes(bench):
    """Unit cubes with a given penalty, with and without multipliers."""
    checks = []
    exact = -1e6 * math.log(1 - 0.5e-3)
    for search in ("newton", "cg"):
        with_updates = bench.run("static_patch", blocks(1, 1, 1.0, 1), search=search, load="depth", amount=1e-3, nu=0,
                                 penalty=1e9, target=1e-9)
        alone = bench.run("static_patch", blocks(1, 1, 1.0, 1), search=search, load="depth", amount=1e-3, nu=0,
                          penalty=1e9, updates=0, target=1e-9)
        # The strain that the spring leaves.
        force = exact
        for _ in range(50):
            force = -1e6 * math.log(1 - 0.5 * (1e-3 - force / 1e9))
        checks += [Check(f"{search}: force with multipliers", exact, -with_updates["force"][-1], 1e-6),
                   Check(f"{search}: force of the penalty alone", force, -alone["force"][-1], 1e-6)]
    return checks


@case(is_long=True)
def static_deep_balls(bench):
    """code_aster SSNV104: two balls of 50 mm come closer by 4 mm, in four steps."""
    run = bench.run("static_hertz", ball_on_ball(50, 1.25, 16, 12), youngs=20e3, nu=0.3, density=2e-9, base="body",
                    amount=4.0)
    return [Check("largest pressure [MPa]", 2798.3, -run.element("stress_zz", 1)[-1, 0], 0.05),
            *balances([run], tolerance=0.1)]


@case(is_long=True)
def static_hertz(bench):
    """ANSYS VM63, and code_aster SSNV104 at a small approach; a/R as in hertz.i."""
    checks, runs = [], []
    for approach, step in ((0.05, 0.08), (0.12742, 0.126)):
        run = bench.run("static_hertz", ball(8, step), amount=approach)
        size, force = math.sqrt(8 * approach), 4 / 3 * 1000 / 0.91 * math.sqrt(8) * approach ** 1.5
        # Of small approaches: the theory of the larger one is off by as much.
        checks += [Check(f"approach of {approach} mm for the force", approach,
                         approach * (4 * run["force"][-1] / force) ** (2 / 3), 0.02 if approach < 0.1 else 0.04),
                   Check(f"approach of {approach} mm: largest pressure", 1.5 * force / (math.pi * size ** 2),
                         -np.mean(run.element("stress_zz", 1)[-1, 0]), 0.05),
                   Check(f"approach of {approach} mm: radius of contact", size, contact_size(run), step, 1.0)]
    runs.append(bench.run("static_hertz", ball_on_ball(50, 0.2, 16, 12), youngs=20e3, nu=0.3, density=2e-9, base="body",
                          amount=0.1))
    force = 4 / 3 * 10e3 / 0.91 * math.sqrt(25) * 0.1 ** 1.5
    checks.append(Check("two balls: force", force, 4 * runs[-1]["force"][-1], 0.03))
    return checks + balances(runs, tolerance=0.1)


def hanging(stack):
    """A block held at its bottom, and blocks above it with gaps of a tenth of their height."""
    mesh = MeshMaker()
    mesh.hexes("lower", (0, 0, 0), (1, 1, 0.5), (3, 3, 2))
    for i, name in enumerate(["between", "upper"][2 - stack:]):
        mesh.new_body()
        first = mesh.hexes(name, (0.2, 0.2, 0.55 * (i + 1)), (0.6, 0.6, 0.5), (2, 2, 2))
    mesh.node_set("bottom", lambda x, y, z: z == 0)
    mesh.node_set("axis", lambda x, y, z: z > 0.5 and abs(x - 0.5) < 1e-9 and abs(y - 0.5) < 1e-9)
    mesh.node_set("beside", lambda x, y, z: z > 0.5 and x < 0.3 and abs(y - 0.5) < 1e-9)
    mesh.side_set("top", [(first + 4 + i, 6) for i in range(4)])
    return mesh


@case()
def static_hanging(bench):
    """Blocks that nothing holds come to rest on another one as those do that are held along their axis."""
    checks, runs = [], []
    variants = [("ten steps", {}), ("one step", {"steps": 1}), ("a tenth of the coefficient", {"stabilization": 0.1}),
                ("ten times the coefficient", {"stabilization": 10})]
    for stack, form in ((1, "face_face"), (2, "face_face"), (1, "node_face")):
        guided = bench.run("static_hanging", hanging(stack), stack=stack, form=form, guided=1, stabilization=0)
        for label, variables in variants:
            run = bench.run("static_hanging", hanging(stack), stack=stack, form=form, **variables)
            about = f"{form}, {stack} above, {label}"
            checks += [Check(f"{about}: force", guided["force"][-1], run["force"][-1], 1e-4),
                       Check(f"{about}: way", guided["way"][-1], run["way"][-1], 1e-4)]
            runs.append(run)
    return checks + balances(runs, tolerance=0.1)
