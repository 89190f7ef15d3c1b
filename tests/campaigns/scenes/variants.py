# SPDX-License-Identifier: BSD-3-Clause
"""The same scene written another way: another frame, other numbers, other units, more threads."""
import copy

import numpy as np

from deck import Units, mesh_of
from draw import random_direction, random_rotation

# Rounding differs, and grows by what contact decides: whether a point touches, sticks, how many passes a step takes
# (forces end at 1e-4 of their sum). Velocities agree within this share of the fastest, in the median of the nodes.
FRAME_TOLERANCE = 1e-5
# Light rigid bodies are solved for to a finite residual, with pivots that compare masses with inertias.
RIGID_TOLERANCE = 1e-5


class Variant:
    """A scene, its mesh, and how to bring what the run has back to the first."""

    def __init__(self, name, scene):
        self.name, self.scene, self.threads, self.order = name, copy.deepcopy(scene), 1, None
        self.turn, self.boost, self.nodes, self.length, self.speed = np.eye(3), np.zeros(3), None, 1.0, 1.0
        self.points, self.blocks, self.is_exact = None, None, False

    def finish(self):
        if self.points is None:
            self.points, self.blocks = mesh_of(self.scene)
        return self

    def velocities(self, result):
        """[frames x nodes x 3] in the frame, order and units of the first."""
        v = result.vector("velocity") / self.speed
        v = v if self.nodes is None else v[:, self.nodes]
        return (v - self.boost) @ self.turn

    def coordinates(self, result):
        x = result.vector("coordinates") / self.length
        return x if self.nodes is None else x[:, self.nodes]


def moved(rng, scene):
    """Turned and shifted as a whole."""
    variant = Variant("frame", scene)
    turn, shift = random_rotation(rng), rng.uniform(0, 3) * random_direction(rng)
    for body in variant.scene["bodies"]:
        body["turn"] = (turn @ np.array(body["turn"])).tolist()
        body["at"] = (turn @ np.array(body["at"]) + shift).tolist()
        for key in ("velocity", "spin"):
            body[key] = (turn @ np.array(body[key])).tolist()
    if scene["plane"]:
        plane = variant.scene["plane"]
        plane["normal"] = (turn @ np.array(plane["normal"])).tolist()
        plane["origin"] = (turn @ np.array(plane["origin"]) + shift).tolist()
    variant.turn = turn
    return variant.finish()


def boosted(rng, scene):
    """With the same velocity added to all; planes stand still, so that scenes with one are only moved."""
    if scene["plane"]:
        return moved(rng, scene)
    variant = Variant("Galilei", scene)
    boost = scene["speed"] * rng.uniform(0.3, 1) * random_direction(rng)
    for body in variant.scene["bodies"]:
        body["velocity"] = (np.array(body["velocity"]) + boost).tolist()
    variant.boost = boost * Units(scene["units"]).speed
    return variant.finish()


def renumbered(rng, scene):
    """Nodes, and the elements of a block, in another order."""
    variant = Variant("numbers", scene).finish()
    number = list(range(len(variant.points)))
    rng.shuffle(number)
    number = np.array(number)  # of each node in the new mesh
    points = np.empty_like(variant.points)
    points[number] = variant.points
    for block in variant.blocks:
        rows = list(range(len(block[0])))
        rng.shuffle(rows)
        block[0] = number[block[0]][rows]
    variant.points, variant.nodes = points, number
    return variant


def reordered(rng, scene):
    """Blocks in another order, which says which side of a pair is the first."""
    variant = Variant("blocks", scene).finish()
    variant.order = list(range(len(variant.blocks)))
    while len(variant.order) > 1 and variant.order == sorted(variant.order):
        rng.shuffle(variant.order)
    return variant


def rescaled(rng, scene):
    """In units that are powers of 64 of the first ones: nothing is rounded differently, not even square and cube roots."""
    variant = Variant("units", scene)
    units, first = variant.scene["units"], Units(scene["units"])
    length, mass, time = (64.0 ** rng.randint(-2, 2) for _ in range(3))
    units["length"] *= length
    units["density"] *= mass / length**3
    units["modulus"] *= mass / (length * time**2)
    units["speed"] = first.speed * length / time
    variant.length, variant.speed = length, length / time
    variant.is_exact = True
    return variant.finish()


def threaded(_, scene):
    """On two threads."""
    variant = Variant("threads", scene)
    variant.threads, variant.is_exact = 2, True
    return variant.finish()


VARIANTS = {"frame": moved, "Galilei": boosted, "numbers": renumbered, "blocks": reordered, "units": rescaled, "threads": threaded}


def difference(variant, first, second):
    """The largest difference of velocities in each frame that both have at the same time, over the fastest; of exact variants
    of places too. The second number says how many frames have other times: the steps that penalties leave differ."""
    a, b = first.vector("velocity"), variant.velocities(second)
    n = min(len(a), len(b))
    scale = max(np.max(np.linalg.norm(a, axis=2)), 1e-300)
    worst = np.max(np.linalg.norm(a[:n] - b[:n], axis=2), axis=1) / scale
    if variant.is_exact:
        if not np.array_equal(first.vector("coordinates")[:n], variant.coordinates(second)[:n]):
            worst = np.maximum(worst, 1e-17)
        return worst, 0
    same = np.abs(first.times[:n] - second.times[:n]) <= 1e-6 * np.max(first.columns["timestep"])
    return worst[same], n - np.count_nonzero(same)


def depends_on_order(variant):
    """What the passes of momentum balance leave between faces depends on which side is the first, in one of twenty scenes."""
    contact = variant.scene["contact"]
    return variant.name == "blocks" and contact["enforcement"] == "" and contact["formulation"] != "node_face"


def tolerance(variant):
    if not variant.is_exact:
        return FRAME_TOLERANCE
    has_rigid = any(b["rigid"] for b in variant.scene["bodies"])
    return RIGID_TOLERANCE if has_rigid and variant.name == "units" else 0.0


def check_variant(variant, first, second):
    """The properties that fail, as in properties.py, and the difference."""
    if second.code != first.code:
        return {variant.name: f"ends with exit code {second.code}, the first with {first.code}: {second.error()}"}, np.inf
    n_first, n_second = (len(r.columns["timestep"]) for r in (first, second))
    if n_first != n_second and variant.is_exact:
        return {variant.name: f"takes {n_second} rows, the first {n_first}"}, np.inf
    frames, n_other = difference(variant, first, second)
    worst, failed = np.max(frames), {}
    if worst > tolerance(variant):
        known = ", known" if depends_on_order(variant) else ""
        failed[variant.name + known] = f"velocities differ by {worst:.2g} of the fastest"
    if n_other:
        failed["steps, known"] = f"{n_other} frames have other times"
    return failed, worst
