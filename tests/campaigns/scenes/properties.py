# SPDX-License-Identifier: BSD-3-Clause
"""What every run of a scene must keep: momentum, energy, and that nobody passes through anybody.

Each check returns the properties that fail, as {name: text}.
"""
import numpy as np

from bodies import LINES, SHELLS, half_thickness
from deck import Units, law_reach, mesh_of
from draw import wave_speed
from geometry import Hull, closest_on_triangles, depth_inside

# Sums of some hundred rounded forces over some hundred steps: about sqrt(1e2 * 3e2) * 1e-16 of what passes through them,
# which is the momentum times how often waves carry it to and fro.
MOMENTUM_TOLERANCE = 1e-12
# A node beside the edge of a face by less than this share counts as before it, and is pushed along the face's normal.
ANGULAR_TOLERANCE_OF_NODES = 1e-8
# Central differences keep the balance to round-off but for the work of materials over a step, whose share is of first order
# in the strain of a step: of a hit the speed over that of waves. Springs, tractions across a gap and what is glued also come
# and go within steps. Above the last tolerance the program tells.
ENERGY_TOLERANCE = 1e-3
ENERGY_TOLERANCE_OF_STRAIN = 0.2
ENERGY_TOLERANCE_TOLD = 1e-2
# Faces meet by areas: a node may sink in below a coarse face while the mean gap is closed. Springs give way.
DEPTH_TOLERANCE = 0.2
PULLING_LAWS = ("adhesion", "junction")
# A penetration that the program tells is at least this share of what is found here.
TOLD_SHARE = 0.5


def momentum_scale(result):
    """The largest sums of |m v| and |m v| |x| over the frames."""
    mass, v, x = result.frames["mass"], result.vector("velocity"), result.vector("coordinates")
    moved = mass * np.linalg.norm(v, axis=2)
    return np.max(np.sum(moved, axis=1)), np.max(np.sum(moved * np.linalg.norm(x, axis=2), axis=1))


def _angular_allowance(scene, result, linear):
    """Friction acts along a surface at both ends of a gap, which leaves its moment: no more than the friction's impulse,
    which the momentum there is bounds, times the gap that may close in a step, or that the law acts across."""
    contact = scene["contact"]
    if contact["law"] in ("", "frictionless", "adhesion") and not contact["damping"]:
        return 0.0
    speed = np.max(np.linalg.norm(result.vector("velocity"), axis=2))
    step = np.max(result.columns["timestep"])
    gap = law_reach(Units(scene["units"])) if contact["law"] == "junction" else 0.0
    return 2 * linear * (speed * step + np.max(result.columns["penetration"]) + gap)


def _loses_moments(scene):
    """Nodes of particles and trusses do not turn: the moment of friction at their surface is lost (contact/enforcement)."""
    thin = any(b["shape"] in ("truss", "particles") for b in scene["bodies"])
    return thin and scene["contact"]["law"] not in ("", "frictionless")


def check_momentum(scene, result):
    """Linear and angular momentum of what nothing holds stay what they are."""
    if scene["plane"]:
        return {}
    failed = {}
    linear, angular = momentum_scale(result)
    if linear == 0:
        return {}
    drift = np.max(np.linalg.norm(result.single("momentum") - result.single("momentum")[0], axis=1))
    if drift > MOMENTUM_TOLERANCE * linear:
        failed["momentum"] = f"momentum changes by {drift / linear:.2g} of the sum of |m v|"
    turned = np.max(np.linalg.norm(result.single("angular_momentum") - result.single("angular_momentum")[0], axis=1))
    by_nodes = scene["contact"]["formulation"] == "node_face"
    bound = (ANGULAR_TOLERANCE_OF_NODES if by_nodes else MOMENTUM_TOLERANCE) * angular + _angular_allowance(scene, result, linear)
    if turned > bound and not _loses_moments(scene):
        failed["angular momentum"] = f"angular momentum changes by {turned / angular:.2g} of the sum of |m v| |x|"
    return failed


def kinetic_energy(result):
    """[frames] of nodal velocities and masses as central differences keep it: v before times v behind."""
    step = result.frames["timestep"][:, None].copy()
    step[0] = 0.0  # the start has a velocity, and none before
    total = 0.0
    for mass, v, a in (("mass", "velocity", "acceleration"), ("rotational_mass", "rotational_velocity", None)):
        speed = np.sum(result.vector(v) ** 2, axis=2)
        if a:
            speed = speed - 0.25 * step**2 * np.sum(result.vector(a) ** 2, axis=2)
        total = total + 0.5 * np.sum(result.frames[mass] * speed, axis=1)
    return total


def check_energy(scene, result):
    """No energy from nowhere, by the program's balance and by masses and velocities."""
    failed, columns, warnings = {}, result.columns, result.warnings()
    scale = max(np.max(columns["kinetic_energy"]), 1e-300)
    largest = max(np.max(np.abs(columns[f"{term}_energy"])) for term in ("kinetic", "internal", "external", "contact"))
    error = np.max(np.abs(columns["energy_error"]))
    if error > _energy_tolerance(scene) * largest:
        name = "energy error" + (", told" if "energy-error" in warnings else "")
        failed[name] = f"energy_error reaches {error / largest:.2g} of the largest term"
    if scene["contact"]["law"] in PULLING_LAWS:
        return failed  # sides that fall towards each other gain what the law's traction gives
    told = ", told" if "contact-energy" in warnings else ""
    put_in = _put_in(result)
    allowed = ENERGY_TOLERANCE_TOLD * (scale + put_in) + put_in
    given = -np.min(columns["contact_energy"])
    if given > allowed:
        failed["contact energy" + told] = f"contact gives out {given / scale:.2g} of the largest kinetic energy"
    if any(b["rigid"] for b in scene["bodies"]):
        return failed  # the inertia of a rigid body is not that of its nodal masses
    kinetic = kinetic_energy(result)
    grown = np.max(kinetic - kinetic[0])
    if grown > allowed:
        failed["kinetic energy" + told] = f"kinetic energy grows by {grown / scale:.2g} of itself without a source"
    return failed


def _energy_tolerance(scene):
    slowest = min(wave_speed(b) for b in scene["bodies"])
    law, has_springs = scene["contact"]["law"], scene["contact"]["enforcement"] == "penalty"
    if has_springs or law in (*PULLING_LAWS, "glued"):
        return ENERGY_TOLERANCE_TOLD
    return min(max(ENERGY_TOLERANCE, ENERGY_TOLERANCE_OF_STRAIN * scene["speed"] / slowest), ENERGY_TOLERANCE_TOLD)


def begins_with_overlap(result):
    return np.max(result.columns["penetration"][:2]) > 0 or "overlap-at-start" in result.warnings()


def _put_in(result):
    """What overlaps of the start hold, by the program's balance."""
    return sum(pair["overlap_energy"] or 0.0 for pair in result.summary.get("pairs", []))


class Body:
    """A body of a scene in its run."""

    def __init__(self, number, body, block, units):
        self.name, self.shape, self.hull = f"body_{number + 1}", body["shape"], Hull(block[0], block[1])
        self.half = half_thickness(body) * units.length
        self.is_shell, self.is_line = body["shape"] in SHELLS, body["shape"] in LINES
        self.at_rim = self.hull.rim_faces() if self.is_shell else None
        self.cells = block[0]

    def size(self, x):
        """What depths are measured by: the thickness, or the least edge of a cell at the start [length]."""
        if self.half > 0:
            return 2 * self.half
        corners = x[self.cells[:, :8]]
        n = corners.shape[1]
        return min(np.min(np.linalg.norm(corners[:, i] - corners[:, j], axis=1)) for i in range(n) for j in range(i))


def bodies_of(scene):
    _, blocks = mesh_of(scene)
    units = Units(scene["units"])
    return [Body(n, body, block, units) for n, (body, block) in enumerate(zip(scene["bodies"], blocks))]


def told_depths(result):
    """Of each pair of surfaces the deepest penetration that the summary tells; through all where nodes passed through."""
    told = {}
    for pair in result.summary.get("pairs", []):
        key = frozenset((pair["first"], pair["second"]))
        depths = [pair["deepest_penetration"], pair["interpenetration"], float("inf") if pair["passages"] else 0.0]
        told[key] = max(told.get(key, 0.0), *(depth or 0.0 for depth in depths))
    return told


def check_through(scene, result):
    """No node below the skin of another body, no node on the other side of a sheet, no rod across another."""
    bodies, x, told, failed = bodies_of(scene), result.vector("coordinates"), told_depths(result), {}
    is_untied = scene["contact"]["law"] == "tied"  # ties hold what touches at the start, and nothing else meets
    for one in bodies:
        for two in bodies:
            if one is two:
                continue
            depth, size = _deepest(one, two, x), min(one.size(x[0]), two.size(x[0]))
            start = depth_inside(x[0][one.hull.nodes], two.hull, x[0]).max(initial=0.0)
            if depth - start > DEPTH_TOLERANCE * size:
                is_told = is_untied or told.get(frozenset((one.name, two.name)), 0.0) > TOLD_SHARE * depth
                failed["through, told" if is_told else "through"] = (
                    f"a node of {one.name} ({one.shape}) is {depth / size:.2g} of the thinner side deep in {two.name} ({two.shape})")
            if _has_sides(scene, two) and _changes_side(one, two, x):
                is_told = is_untied or told.get(frozenset((one.name, two.name)), 0.0) > TOLD_SHARE * 2 * two.half
                failed["sides, told" if is_told else "sides"] = (
                    f"a node of {one.name} ({one.shape}) passes through the sheet {two.name}")
    return failed


def _has_sides(scene, body):
    """Legs of a fold go through each other where the deck has no self contact: then a fold has no sides."""
    return body.shape == "sheet" or (body.shape == "fold" and scene["contact"]["scope"] == "self")


def _deepest(one, two, x):
    return max(depth_inside(frame[one.hull.nodes], two.hull, frame).max(initial=0.0) for frame in x[1:])


def _height(point, sheet, x, reach):
    """Of a point right before the inside of a sheet the nearest face, and the height above it [length]; None where that is not
    plain."""
    corners = sheet.hull.skin(x)
    distance, m, weights = closest_on_triangles(point, *corners)
    near_rim = 0.1  # of the way from the rim to the middle of a face
    from_rim = weights[2] if sheet.hull.faces.shape[1] == 4 else np.min(weights)
    if distance > reach or (sheet.at_rim[m] and from_rim < near_rim) or np.max(weights) > 1 - 1e-6:
        return None
    normal = np.cross(corners[1][m] - corners[0][m], corners[2][m] - corners[0][m])
    return m, (point - corners[0][m]) @ normal / np.linalg.norm(normal)


def _changes_side(one, sheet, x):
    """Whether a node goes from above one side of a sheet to below the other, all the time right before its inside: one that lies
    in the sheet for some frames and comes out again has penetrated, and not passed through."""
    moved = np.max(np.linalg.norm(x[1:] - x[:-1], axis=2), axis=1)
    reaches = sheet.half + 2 * np.maximum.accumulate(moved)
    corners, side, face = x[:, sheet.hull.nodes], dict.fromkeys(one.hull.nodes, 0), {}
    for frame, reach in enumerate(reaches):
        low, high = corners[frame].min(axis=0) - reach, corners[frame].max(axis=0) + reach
        spots = x[frame][one.hull.nodes]
        near = np.all((spots > low) & (spots < high), axis=1)
        for node, is_near in zip(one.hull.nodes, near):
            m, height = (_height(x[frame][node], sheet, x[frame], reach) if is_near else None) or (None, 0.0)
            if m is None or (sheet.shape == "fold" and face.get(node) != m):  # before one leg it may be behind the other
                side[node] = 0
            face[node] = m
            if abs(height) > sheet.half:
                if side[node] * height < 0:
                    return True
                side[node] = np.sign(height)
    return False
