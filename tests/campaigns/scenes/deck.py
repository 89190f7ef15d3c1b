# SPDX-License-Identifier: BSD-3-Clause
"""Writes a scene as a deck and an Exodus mesh."""
import math

import numpy as np

from bodies import LINES, SHELLS, make_body
from mesh_maker import MeshMaker

N_FRAMES = 8  # results over the run, beside that of the start


class Units:
    """Factors from the units of a scene to those of its deck."""

    def __init__(self, units):
        self.length = units["length"]
        self.density = units["density"]
        self.modulus = units["modulus"]
        self.speed = units.get("speed") or math.sqrt(self.modulus / self.density)
        self.time = self.length / self.speed
        self.rate = 1 / self.time


def vector(values):
    return " ".join(repr(float(v)) for v in values)


def name_of(number):
    return f"body_{number + 1}"


def mesh_of(scene):
    """Points in the deck's units, and of each body its cells, Exodus type and thickness."""
    units, points, blocks = Units(scene["units"]), [], []
    for body in scene["bodies"]:
        mesh = make_body(body)
        first = sum(len(p) for p in points)
        points.append((mesh.points @ np.array(body["turn"]).T + np.array(body["at"])) * units.length)
        thickness = body["thickness"] * units.length if body["shape"] in SHELLS else None
        blocks.append([mesh.cells + first, mesh.kind, thickness])
    return np.concatenate(points), blocks


def write_mesh(path, scene, points, blocks, order=None):
    """The blocks are written in an order that may be another than that of the bodies."""
    maker = MeshMaker()
    maker.points = points
    for number in order if order is not None else range(len(blocks)):
        cells, kind, thickness = blocks[number]
        maker.blocks.append((name_of(number), kind, (cells + 1).tolist(), thickness))
    maker.write(path)


def _material(number, body, units):
    m, e = body["material"], units.modulus
    modulus, stress = m["modulus"] * e, m["yield"] * m["modulus"] * e
    lines = [f"youngs modulus = {modulus!r}", f"poissons ratio = {m['nu']!r}"]
    if m["model"] == "mooney_rivlin":
        shear = modulus / (2 * (1 + m["nu"]))
        lines = [f"poissons ratio = {m['nu']!r}", f"c10 = {0.4 * shear!r}", f"c01 = {0.1 * shear!r}"]
    elif m["model"] == "elastic_plastic":
        lines += [f"yield stress = {stress!r}", f"hardening modulus = {0.05 * modulus!r}"]
    elif m["model"] in ("ep_power_hard", "johnson_cook"):
        lines += [f"yield stress = {stress!r}", f"hardening constant = {2 * stress!r}", "hardening exponent = 0.4"]
    if m["model"] == "johnson_cook":
        lines += ["rate constant = 0.02", f"reference rate = {1e-3 * units.rate!r}"]
    return [f"begin material material_{number + 1}", f"density = {m['density'] * units.density!r}",
            f"begin parameters for model {m['model']}", *lines, "end", "end"]


def _section(number, body, units):
    """The lines of a section, empty when the block needs none."""
    shape, lines = body["shape"], []
    if shape in SHELLS:
        kind, lines = "shell", [f"thickness = {body['thickness'] * units.length!r}"]
    elif shape == "beam":
        width = 2 * body["radius"] * units.length
        kind, lines = "beam", ["section = rod", f"width = {width!r}", f"height = {width!r}",
                               f"t axis = {vector(np.array(body['turn'])[:, 2])}"]
    elif shape == "truss":
        kind, lines = "truss", [f"area = {math.pi * (body['radius'] * units.length) ** 2!r}"]
    elif shape == "particles":
        kind, lines = "particle", [f"radius = {body['radius'] * units.length!r}"]
    else:
        kind = "solid"
        if body["formulation"]:
            lines = [f"formulation = {body['formulation']}"]
    if body["rigid"]:
        lines.append(f"rigid body = rigid_{number + 1}")
    return [f"begin {kind} section section_{number + 1}", *lines, "end"] if lines else []


def _block(number, body, units):
    lines = [f"begin parameters for block {name_of(number)}", f"material = material_{number + 1}",
             f"model = {body['material']['model']}"]
    if _section(number, body, units):
        lines.append(f"section = section_{number + 1}")
    if body["linear_viscosity"] is not None and body["shape"] in ("box", "ball"):
        lines += [f"linear bulk viscosity = {body['linear_viscosity']!r}", "quadratic bulk viscosity = 0"]
    return [*lines, "end"]


def _velocity_functions(number, body, units):
    """Of a body that turns: velocity as a function of place, a component each."""
    spin = np.array(body["spin"]) * units.rate
    if not np.any(spin):
        return []
    centre, lines = (np.array(body["at"]) * units.length).tolist(), []
    velocity, spin = (np.array(body["velocity"]) * units.speed).tolist(), spin.tolist()
    for i, c in enumerate("xyz"):
        j, k = (i + 1) % 3, (i + 2) % 3
        terms = (f"{velocity[i]!r} + ({spin[j]!r}) * (p{'xyz'[k]} - ({centre[k]!r}))"
                 f" - ({spin[k]!r}) * (p{'xyz'[j]} - ({centre[j]!r}))")
        lines += [f"begin definition for function flight_{number + 1}_{c}", "type = analytic",
                  *(f"expression variable: p{a} = nodal model_coordinates({a})" for a in "xyz" if a != c),
                  f'evaluate expression = "{terms}"', "end"]
    axis = f"spin_{number + 1}"
    return lines + [f"define point {axis}_point with coordinates {vector(centre)}",
                    f"define direction {axis}_direction with vector {vector(spin)}",
                    f"define axis {axis} with point {axis}_point direction {axis}_direction"]


def _velocity(number, body, units):
    name, spin = name_of(number), np.array(body["spin"]) * units.rate
    if not np.any(spin):
        return [line for c, v in zip("xyz", body["velocity"])
                for line in ("begin initial velocity", f"block = {name}", f"component = {c}",
                             f"magnitude = {v * units.speed!r}", "end")]
    lines = ["begin initial velocity", f"block = {name}", f"cylindrical axis = spin_{number + 1}",
             f"angular velocity = {float(np.linalg.norm(spin))!r}", "end"]
    for c in "xyz":
        lines += ["begin initial velocity", f"block = {name}", f"component = {c}", f"function = flight_{number + 1}_{c}", "end"]
    return lines


def law_reach(units):
    """The gap that a law across gaps acts over at most [length]."""
    return 0.01 * units.length


def _law(contact, units):
    """The lines of the friction model, and of the functions that it takes."""
    law, stress, reach = contact["law"], contact["scale"] * units.modulus, law_reach(units)
    if not law:
        return [], []
    kind, lines, functions = law.replace("_", " "), [], []
    if law == "constant_friction":
        lines = [f"friction coefficient = {contact['friction']!r}"]
    elif law == "pv_dependent":
        lines = [f"static coefficient = {contact['friction'] * stress!r}",
                 f"dynamic coefficient = {0.5 * contact['friction'] * stress!r}",
                 f"velocity decay = {100 / units.speed!r}", f"reference pressure = {stress!r}"]
    elif law in ("adhesion", "junction"):
        functions = ["begin definition for function pull", "type = piecewise linear", "begin values",
                     f"0 {stress!r}", f"{reach!r} 0", "end", "end"]
        lines = ["adhesion function = pull"] if law == "adhesion" else ["normal traction function = pull"]
    if law == "junction":
        functions += ["begin definition for function drag", "type = piecewise linear", "begin values", "0 0",
                      f"{0.01 * units.speed!r} {stress!r}", f"{units.speed!r} {stress!r}", "end", "end"]
        lines += ["tangential traction function = drag", f"normal cutoff distance for tangential traction = {reach!r}"]
    return [f"begin {kind} model law", *lines, "end"], functions


def _contact(scene, units):
    contact, lines = scene["contact"], ["begin contact definition", "skin all blocks = on"]
    if scene["plane"]:
        lines.append("contact surface ground contains ground_plane")
    if contact["enforcement"]:
        lines.append(f"enforcement = {contact['enforcement']}")
    if not contact["edges"]:
        lines += ["begin surface options", "edge contact = off", "end"]
    lines += _law(contact, units)[0]
    common = ["friction model = law"] if contact["law"] else []
    common += [f"constraint formulation = {contact['formulation']}"] if contact["formulation"] else []
    common += [f"contact damping fraction = {contact['damping']!r}"] if contact["damping"] else []
    if contact["scope"] in ("general", "self"):
        common.append("general contact = on")
    if contact["scope"] == "self":
        common.append("self contact = on")
    lines += ["begin interaction defaults", *common, "end"]
    if contact["scope"] == "pairs":
        names = [name_of(n) for n in range(len(scene["bodies"]))] + (["ground"] if scene["plane"] else [])
        lines += ["begin interaction", f"surfaces = {' '.join(names)}", "end"]
    return [*lines, "end"]


def _outputs(n_steps):
    energies = "kinetic internal external contact friction contact_impact contact_damping".split()
    frame = max(1, n_steps // N_FRAMES)
    return ["begin heartbeat output", "stream name = scene.csv", "precision = 17", "at step 0 increment = 1",
            *(f"global {e}_energy as {e}_energy" for e in energies), "global energy_error as energy_error",
            "global momentum as momentum", "global angular_momentum as angular_momentum",
            "global contact_penetration_max as penetration", "global timestep as timestep", "end",
            "begin results output", "database name = scene.e", f"at step 0 increment = {frame}",
            "nodal variables = coordinates velocity acceleration mass rotational_velocity rotational_mass",
            "global variables = timestep step", "end"]


def deck_of(scene, n_steps):
    """The lines of a deck; results at about N_FRAMES times of n_steps."""
    units, bodies = Units(scene["units"]), list(enumerate(scene["bodies"]))
    lines = ["begin sierra scene"]
    for number, body in bodies:
        lines += _material(number, body, units) + _section(number, body, units) + _velocity_functions(number, body, units)
        lines += [f"begin rigid body rigid_{number + 1}", "end"] if body["rigid"] else []
    lines += _law(scene["contact"], units)[1]
    lines += ["begin finite element model bodies", "database name = scene.g",
              *(line for number, body in bodies for line in _block(number, body, units)), "end",
              "begin presto procedure fly", "begin time control", "begin time stepping block all", "start time = 0",
              "begin parameters for presto region bodies", "step interval = 1000", "end", "end",
              f"termination time = {scene['time'] * units.time!r}", "end",
              "begin presto region bodies", "use finite element model bodies",
              *(line for number, body in bodies for line in _velocity(number, body, units))]
    if scene["plane"]:
        lines += ["begin analytic object ground_plane", "type = plane", f"normal direction = {vector(scene['plane']['normal'])}",
                  f"origin = {vector(np.array(scene['plane']['origin']) * units.length)}", "end"]
    lines += [*_contact(scene, units), *_outputs(n_steps), "end", "end", "end sierra"]
    return lines
