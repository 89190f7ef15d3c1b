# SPDX-License-Identifier: BSD-3-Clause
"""Friction models past Coulomb's, each along a path of gap and slip."""
import numpy as np

from cases import balances, case
from mesh_maker import MeshMaker
from runs import Check, at_most

END = 0.2  # of the paths [s]


def blocks(width=1.0, gap=0.0, has_far=False):
    """One element on another that is larger; the far one is higher by 0.02."""
    mesh = MeshMaker()
    mesh.hexes("base", (0, 0, 0), (9, 3, 1), (1, 1, 1))
    mesh.new_body()
    mesh.hexes("top", (1, 1, 1 + gap), (width, width, 1), (1, 1, 1))
    if has_far:
        mesh.new_body()
        mesh.hexes("far", (6, 1, 1.02), (width, width, 1), (1, 1, 1))
    return mesh


def model(kind, *lines, name="law"):
    return "\n".join((f"begin {kind} model {name}", *lines, "end"))


def curve(name, points):
    rows = "\n".join(f"{x!r} {y!r}" for x, y in points)
    return f"begin definition for function {name}\ntype = piecewise linear\nbegin values\n{rows}\nend\nend"


def path(points):
    """Of the share of the time and the way there."""
    return "\n".join(f"{END * share!r} {way!r}" for share, way in points)


class Path:
    """What a law answered along a path: gap, slip, and the force on the upper block, > 0 when it is pulled back."""

    def __init__(self, bench, models, away, along, functions=(), mesh=None, block=2, **settings):
        variables = dict(law="law", form="face_face", has_far=0, stiffness=1e7, half=0.5 * END, end_time=END, frame=1e-9)
        variables.update(settings)
        self.run = bench.run("interaction", mesh or blocks(), models=models, functions="\n".join(functions), away=path(away),
                             along=path(along), **variables)
        nodes, forces = self.run.nodes_of(block), self.run.contact_force(block)
        self.times = self.run.times
        self.slip, _, self.gap = self.run.nodal("displacement")[:, nodes[0]].T
        self.pull, self.drag = -forces[:, 2], -forces[:, 0]

    def worst(self, pull, drag, where=slice(None)):
        """The largest difference to forces over the largest of them."""
        error = np.hypot(self.pull - pull, self.drag - drag)[where]
        return np.max(error) / np.max(np.hypot(pull, drag))


def line(x, points):
    return np.interp(x, *zip(*points))


UP, OUT, REST = [(0, 0), (1, 0.03)], [(0, 0), (1, 0.02)], [(0, 0), (1, 0)]


@case()
def adhesion(bench):
    points, checks, runs = [(0, 0), (0.005, 1000), (0.02, 0)], [], []
    for form in ("face_face", "node_face"):
        found = Path(bench, model("adhesion", "adhesion function = pull", "adhesion scale factor = 2"), UP, OUT,
                     [curve("pull", points)], form=form)
        checks.append(at_most(f"{form}: error of the force", found.worst(2 * line(found.gap, points), 0), 1e-9))
        runs.append(found.run)
    return checks + balances(runs)


@case()
def cohesive_zone(bench):
    points, gn, gt = [(0, 0), (0.25, 1000), (1, 0)], 0.02, 0.04
    models = model("cohesive zone", "traction displacement function = s", f"critical normal gap = {gn}",
                   f"critical tangential gap = {gt}")
    checks, runs = [], []
    back = [(0, 0), (0.3, 0.01), (0.6, 0.002), (1, 0.03)]
    for label, away, along in (("mixed", UP, OUT), ("there and back", back, REST)):
        found = Path(bench, models, away, along, [curve("s", points)])
        share = np.hypot(found.gap / gn, found.slip / gt)
        worst = np.maximum(np.maximum.accumulate(share), 1e-300)
        slope = np.where(worst < 1, line(worst, points) / worst, 0)
        checks.append(at_most(f"{label}: error of the force",
                              found.worst(slope * found.gap / gn, slope * gn / gt * found.slip / gt), 1e-9))
        runs.append(found.run)
    return checks + balances(runs)


@case()
def junction(bench):
    points = [(0, 0), (0.004, 1000), (0.02, 0)]
    models = model("junction", "normal traction function = pull", "tangential traction function = drag",
                   "tangential traction scale factor = 3", "normal cutoff distance for tangential traction = 0.01")
    found = Path(bench, models, [(0, 0), (0.3, 0.004), (0.6, 0.004), (1, 0.02)], [(0, 0), (0.3, 0), (1, 0.014)],
                 [curve("pull", points), curve("drag", [(0, 100), (0.2, 500), (9, 500)])])
    share = found.times / END
    slides, is_off = (share > 0.33) & (found.gap < 0.0099), found.gap > 0.0101
    return [at_most("error of the normal force", np.max(np.abs(found.pull - line(found.gap, points))) / 1000, 1e-9),
            Check("least tangential force at 0.1 m/s [N]", 900, np.min(found.drag[slides]), 1e-9),
            Check("most [N]", 900, np.max(found.drag[slides]), 1e-9),
            at_most("tangential force beyond the cutoff [N]", np.max(np.abs(found.drag[is_off])), 1e-9),
            *balances([found.run], has_friction=True)]


PART = [(0, 1), (0.01, 0.5), (1, 0.5)]
THREADS = [curve("pull", [(0, 0), (0.1, 1e5)]), curve("drag", [(0, 0), (0.1, 2e5)]), curve("part", PART)]


def threads(*lines):
    return model("threaded", "normal traction function = pull", "tangential traction function = drag",
                 "tangential traction gap function = part", *lines)


def failure_checks(label, found, pull, drag, share, n_fade):
    """Forces until the first step at which a share passes 1, and that they fade along a straight line from then on."""
    at = int(np.argmax(share >= 1))
    fading = np.maximum(1 - np.arange(len(share) - at) / n_fade, 0)
    return [at_most(f"{label}: error of the force until it fails", found.worst(pull, drag, slice(0, at)), 1e-9),
            at_most(f"{label}: error of the fading force",
                    np.max(np.abs(found.pull[at:] - fading * found.pull[at])) / np.max(pull[:at]), 1e-9)]


@case()
def threaded_joint(bench):
    def forces(found):
        return 1e6 * found.gap, 2e6 * found.slip * line(found.gap, PART)

    whole = Path(bench, threads("normal capacity = 1e9", "tangential capacity = 1e9"), UP, OUT, THREADS)
    checks = [at_most("error of the force", whole.worst(*forces(whole)), 1e-9)]
    limits = "normal capacity = 15000", "tangential capacity = 20000", "failure decay cycles = 10"
    weak = Path(bench, threads(*limits), UP, OUT, THREADS)
    pull, drag = forces(weak)
    share = (pull / 15000) ** 2 + (drag / 20000) ** 2
    return [*checks, *failure_checks("failing", weak, pull, drag, share, 10), *balances([whole.run, weak.run])]


@case()
def spring_weld(bench):
    """Forces, whatever the area."""
    models = model("spring weld", "normal displacement function = pull", "tangential displacement function = drag",
                   "failure decay cycles = 20")
    functions = [curve("pull", [(0, 0), (0.02, 2000)]), curve("drag", [(0, 0), (0.02, 3000)])]
    checks, runs = [], []
    for width in (1.0, 0.5):
        found = Path(bench, models, UP, OUT, functions, mesh=blocks(width))
        share = (found.gap / 0.02) ** 2 + (found.slip / 0.02) ** 2
        checks += failure_checks(f"{width:g} m wide", found, 1e5 * found.gap, 1.5e5 * found.slip, share, 20)
        runs.append(found.run)
    return checks + balances(runs)


@case()
def surface_welds(bench):
    """Capacities are forces of a surface weld, tractions of an area weld; here over 0.25 m2."""
    checks, runs = [], []
    for kind, scale in (("surface weld", 1), ("area weld", 4)):
        models = model(kind, f"normal capacity = {500 * scale}", f"tangential capacity = {400 * scale}",
                       "failure decay cycles = 5")
        for label, away, along in (("apart", UP, REST), ("along", REST, OUT), ("both", UP, OUT)):
            found = Path(bench, models, away, along, mesh=blocks(0.5), stiffness=1e5)
            share = (np.maximum(found.pull, 0) / 500) ** 2 + (found.drag / 400) ** 2
            late = np.max(np.hypot(found.pull, found.drag)[-20:])
            checks += [Check(f"{kind}, {label}: largest share of the capacities", 1, np.max(share) ** 0.5, 0.02),
                       at_most(f"{kind}, {label}: force after the failure [N]", late, 1e-9)]
            runs.append(found.run)
    return checks + balances(runs)


PRESSED = [(0, 0), (0.1, -1e-3), (1, -1e-3)]


def constant(name, mu):
    return model("constant friction", f"friction coefficient = {mu}", name=name)


@case()
def pv_dependent(bench):
    checks, runs = [], []
    slow, fast = (0.2, 0.55), (0.6, 0.95)
    for offset, reference, power in ((0, 1, 1), (200, 1, 1), (200, 4, 0.5)):
        models = model("pv_dependent", "static coefficient = 0.5", "dynamic coefficient = 0.2", "velocity decay = 4",
                       f"reference pressure = {reference}", f"offset pressure = {offset}",
                       f"pressure exponent = {power}")
        ways = [(0, 0), (0.15, 0), (0.575, 0.085 * 0.05), (1, 0.085 * 0.55)]
        found = Path(bench, models, PRESSED, ways, stiffness=1e6)
        share = found.times / END
        for speed, (start, end) in ((0.05, slow), (0.5, fast)):
            where = (share > start) & (share < end)
            mu = 0.2 + 0.3 * np.exp(-4 * speed)
            due = mu * ((-found.pull[where] + offset) / reference) ** power
            label = f"offset {offset}, reference {reference}, exponent {power}, {speed} m/s"
            checks.append(at_most(f"{label}: error of the force", np.max(np.abs(found.drag[where] / due - 1)), 1e-9))
        runs.append(found.run)
    return checks + balances(runs, has_friction=True)


@case()
def hybrid_friction(bench):
    models = "\n".join((constant("near", 0.3), constant("off", 0.6),
                        model("hybrid", "initially close = near", "initially far = off")))
    away = [(0, 0), (0.2, -0.022), (1, -0.022)]
    checks, runs = [], []
    for label, block, mu in (("close", 2, 0.3), ("far", 3, 0.6)):
        found = Path(bench, models, away, [(0, 0), (0.3, 0), (1, 0.02)], mesh=blocks(has_far=True), block=block, has_far=1,
                     stiffness=1e6)
        where = found.times > 0.7 * END
        ratio = found.drag[where] / -found.pull[where]
        checks.append(at_most(f"{label}: error of the friction over the force", np.max(np.abs(ratio - mu)), 1e-9))
        runs.append(found.run)
    return checks + balances(runs, has_friction=True)


@case()
def time_variant_friction(bench):
    models = "\n".join((constant("rough", 0.5), constant("smooth", 0.1),
                        model("time variant", "model = rough during periods first",
                              "model = smooth during periods second")))
    found = Path(bench, models, PRESSED, [(0, 0), (0.15, 0), (1, 0.02)], stiffness=1e6)
    share, ratio = found.times / END, found.drag / np.maximum(-found.pull, 1e-300)
    first, second = (share > 0.2) & (share < 0.49), share > 0.51
    return [at_most("first period: error of the friction over the force", np.max(np.abs(ratio - 0.5)[first]), 1e-9),
            at_most("second period: the same", np.max(np.abs(ratio - 0.1)[second]), 1e-9),
            *balances([found.run], has_friction=True)]
