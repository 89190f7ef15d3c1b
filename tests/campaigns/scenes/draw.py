# SPDX-License-Identifier: BSD-3-Clause
"""Draws scenes: bodies that are about to meet, as plain dictionaries in units of the first body's size, modulus, density."""
import math

import numpy as np

from bodies import LINES, SHELLS, SOLIDS, half_thickness, make_body
from geometry import Hull, way_to_touch

SHAPES = {"box": 45, "ball": 14, "sheet": 15, "fold": 5, "beam": 8, "truss": 4, "particles": 9}
SOLID_ELEMENTS = {"hex8": 70, "tet4": 18, "tet10": 12}
MODELS = {"elastic": 50, "neo_hookean": 14, "mooney_rivlin": 10, "elastic_plastic": 14, "ep_power_hard": 6,
          "johnson_cook": 6}
LAWS = {"": 42, "constant_friction": 32, "tied": 7, "glued": 4, "stick": 4, "adhesion": 4, "junction": 2,
        "pv_dependent": 3, "frictionless": 2}
SYSTEMS = {"one": 25, "SI": 35, "mm t s": 20, "mm kg ms": 10, "any": 10}


def pick(rng, weights):
    return rng.choices(list(weights), list(weights.values()))[0]


def log_uniform(rng, low, high):
    return math.exp(rng.uniform(math.log(low), math.log(high)))


def random_rotation(rng):
    """A rotation matrix, evenly distributed."""
    q = np.array([rng.gauss(0, 1) for _ in range(4)])
    w, x, y, z = q / np.linalg.norm(q)
    return np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                     [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                     [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]])


def random_direction(rng):
    d = np.array([rng.gauss(0, 1) for _ in range(3)])
    return d / np.linalg.norm(d)


def draw_units(rng):
    """Length, density and modulus that stand for 1."""
    system = pick(rng, SYSTEMS)
    if system == "one":
        return {"length": 1.0, "density": 1.0, "modulus": 1.0}
    if system == "SI":
        return {"length": log_uniform(rng, 1e-3, 10), "density": 7800.0, "modulus": 2.1e11}
    if system == "mm t s":
        return {"length": log_uniform(rng, 1e-1, 1e3), "density": 7.8e-9, "modulus": 2.1e5}
    if system == "mm kg ms":
        return {"length": log_uniform(rng, 1e-1, 1e3), "density": 7.8e-6, "modulus": 210.0}
    return {"length": log_uniform(rng, 1e-3, 1e3), "density": log_uniform(rng, 1e-9, 1e4),
            "modulus": log_uniform(rng, 1e-3, 1e12)}


def draw_material(rng, shape):
    models = MODELS if shape in SOLIDS else {k: w for k, w in MODELS.items() if k != "mooney_rivlin"}
    return {"model": pick(rng, models), "nu": rng.uniform(0, 0.45), "yield": log_uniform(rng, 3e-4, 1e-2),
            "modulus": 1.0 if rng.random() < 0.5 else log_uniform(rng, 1e-3, 1e3), "density": log_uniform(rng, 0.3, 3)}


def draw_body(rng):
    shape = pick(rng, SHAPES)
    scale = 1.0 if rng.random() < 0.6 else log_uniform(rng, 0.3, 2)
    body = {"shape": shape, "element": "", "formulation": "", "cells": [rng.randint(1, 4) for _ in range(3)],
            "size": [scale * rng.uniform(0.5, 1.5) for _ in range(3)], "skew": 0.0, "grade": 1.0, "fold": 0.0,
            "thickness": 0.0, "radius": 0.0, "material": draw_material(rng, shape), "rigid": rng.random() < 0.1,
            "linear_viscosity": None if rng.random() < 0.9 else 0.0}
    if shape in SOLIDS:
        _draw_solid(rng, body)
    elif shape in SHELLS:
        body["element"] = rng.choice(["quad4", "quad4", "tri3"])
        body["cells"] = [2 * rng.randint(1, 3), rng.randint(1, 4), 1]
        body["thickness"] = log_uniform(rng, 0.005, 0.15) * scale
        body["fold"] = rng.uniform(0.3, 2.6) if shape == "fold" else 0.0
    elif shape in LINES:
        body["cells"] = [rng.randint(1, 8), 1, 1]
        body["radius"] = log_uniform(rng, 0.01, 0.1) * scale
    else:
        body["cells"] = [rng.randint(1, 3) for _ in range(3)]
        body["radius"] = rng.uniform(0.03, 0.25) * scale
        body["size"] = [2.05 * body["radius"] * rng.uniform(1, 1.3) for _ in range(3)]
        body["rigid"] = False
    return body


def _draw_solid(rng, body):
    body["element"] = pick(rng, SOLID_ELEMENTS)
    if body["element"] == "hex8" and rng.random() < 0.25:
        body["formulation"] = rng.choice(["selective_deviatoric", "fully_integrated"])
    most = 4 if body["element"] == "hex8" else 2
    body["cells"] = [rng.randint(1, most) for _ in range(3)]
    if body["shape"] == "ball":
        body["cells"] = [1 if body["element"] != "hex8" else rng.choice([1, 1, 2])] * 3
        body["size"] = [body["size"][0]] * 3
        return
    body["skew"] = rng.uniform(-0.5, 0.5) if rng.random() < 0.3 else 0.0
    body["grade"] = rng.uniform(1.2, 4.0) if rng.random() < 0.3 else 1.0


def wave_speed(body):
    material = body["material"]
    nu = material["nu"]
    return math.sqrt(material["modulus"] * (1 - nu) / ((1 + nu) * (1 - 2 * nu)) / material["density"])


def step_of(body):
    """About the stable step of a body's elements."""
    if body["shape"] == "particles":
        return 2 * body["radius"] / wave_speed(body)
    share = {"tet4": 0.4, "tet10": 0.3, "tri3": 0.6}.get(body["element"], 0.7)
    return share * make_body(body).edge() / wave_speed(body)


def placed_points(body):
    return make_body(body).points @ np.array(body["turn"]).T + np.array(body["at"])


def place_bodies(rng, bodies, gap, speed):
    """Puts each body beside those before, on its way to one of them."""
    frame = random_rotation(rng)
    is_aligned = rng.random() < 0.4
    for number, body in enumerate(bodies):
        body["turn"] = (frame if is_aligned else random_rotation(rng)).tolist()
        body["at"] = [0.0, 0.0, 0.0]
        body["velocity"] = (speed * rng.choice([0, 0, 1]) * 0.3 * random_direction(rng)).tolist()
        body["spin"] = [0.0, 0.0, 0.0]
        if number > 0:
            _send(rng, bodies[:number], body, frame if is_aligned else None, gap, speed)
        if rng.random() < 0.35:
            reach = max(1e-6, np.max(np.linalg.norm(make_body(body).points, axis=1)))
            body["spin"] = (rng.uniform(0.1, 1) * speed / reach * random_direction(rng)).tolist()


def _send(rng, others, body, frame, gap, speed):
    """Puts a body as far from the others as the gap, along its way to one of them."""
    normal = random_direction(rng) if frame is None else frame[:, rng.randrange(3)] * rng.choice([-1, 1])
    target = others[-1] if rng.random() < 0.6 else rng.choice(others)
    aim, spots = placed_points(target), placed_points(body)
    aside = rng.choice(aim) - rng.choice(spots) if rng.random() < 0.3 else np.mean(aim, axis=0) - np.mean(spots, axis=0)
    aside = 0.8 * aside + 0.15 * random_direction(rng)
    front = max(np.max(placed_points(o) @ normal) + half_thickness(o) for o in others)
    back = np.min(spots @ normal) - half_thickness(body)
    far = aside - normal * (aside @ normal) + normal * (front - back + 1)
    way = _way_to_others(body, spots + far, others, -normal)
    body["at"] = (far + normal * (gap - (way if np.isfinite(way) else 1))).tolist()
    sideways = random_direction(rng) * rng.choice([0, 0, 0.3, 1])
    body["velocity"] = (speed * (-normal + sideways - normal * max(0, sideways @ normal))).tolist()


def _way_to_others(body, spots, others, direction):
    mesh = make_body(body)
    hull = Hull(mesh.cells, mesh.kind)
    ways = []
    for other in others:
        mesh = make_body(other)
        thick = half_thickness(body) + half_thickness(other)
        ways.append(way_to_touch(hull, spots, Hull(mesh.cells, mesh.kind), placed_points(other), direction, thick))
    return min(ways)


def draw_contact(rng):
    # Settings that the deck leaves open are the most frequent ones.
    return {"law": pick(rng, LAWS), "friction": rng.uniform(0.05, 1.0),
            "enforcement": pick(rng, {"": 75, "penalty": 25}),
            "formulation": pick(rng, {"": 60, "face_face": 8, "node_face": 32}),
            "scope": pick(rng, {"general": 60, "self": 20, "pairs": 20}), "damping": rng.choice([0.0] * 9 + [0.3]),
            "scale": 0.01 * log_uniform(rng, 0.1, 10), "edges": rng.random() < 0.95}


def draw_plane(rng, bodies, gap, speed):
    """An analytic plane below the first body, or none: its normal and a point of it."""
    if rng.random() > 0.12:
        return None
    normal = random_direction(rng)
    lowest = min(np.min(placed_points(b) @ normal) - half_thickness(b) for b in bodies)
    for body in bodies:
        body["velocity"] = (np.array(body["velocity"]) - speed * normal).tolist()
    return {"normal": normal.tolist(), "origin": (normal * (lowest - gap)).tolist()}


def draw_scene(rng):
    bodies = [draw_body(rng) for _ in range(pick(rng, {2: 50, 3: 25, 4: 13, 5: 7, 6: 5}))]
    solid = [b for b in bodies if not b["rigid"]] or bodies
    step = min(step_of(b) for b in solid)
    n_steps = rng.randint(60, 180)
    mach = log_uniform(rng, 1e-4, 0.1) if rng.random() < 0.93 else rng.uniform(0.1, 0.3)
    speed = mach * min(wave_speed(b) for b in solid)
    contact = draw_contact(rng)
    gap = speed * step * rng.uniform(3, 30)
    if contact["law"] == "tied":
        gap = 0.0
    elif rng.random() < 0.06:
        gap = -0.03 * rng.random() * min(_depth(b) for b in bodies)
    place_bodies(rng, bodies, gap, speed)
    plane = draw_plane(rng, bodies, max(0.0, gap), speed) if contact["law"] != "tied" else None  # nothing is held to planes
    return {"units": draw_units(rng), "bodies": bodies, "contact": contact, "plane": plane, "time": n_steps * step,
            "step": step, "speed": speed, "gap": gap}


def _depth(body):
    """The size by which overlaps are measured: the thickness of a thin body, else the least edge of a cell."""
    return 2 * half_thickness(body) or make_body(body).edge()
