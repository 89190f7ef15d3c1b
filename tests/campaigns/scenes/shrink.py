# SPDX-License-Identifier: BSD-3-Clause
"""Makes a failing scene small, step by step, while one of the same properties fails."""
import copy
import time

import numpy as np

PLAIN_CONTACT = {"law": "", "enforcement": "", "formulation": "", "scope": "general", "damping": 0.0, "edges": True}


def _with(scene, change):
    smaller = copy.deepcopy(scene)
    change(smaller)
    return smaller if smaller != scene else None


def _fewer_bodies(scene):
    for number in range(len(scene["bodies"])):
        if len(scene["bodies"]) > (1 if scene["plane"] else 2):
            yield _with(scene, lambda s, n=number: s["bodies"].pop(n))
    if scene["plane"] and len(scene["bodies"]) > 1:
        yield _with(scene, lambda s: s.update(plane=None))


def _shorter(scene):
    for share in (0.3, 0.6, 0.85):
        if scene["time"] * share > scene["step"]:
            yield _with(scene, lambda s, f=share: s.update(time=s["time"] * f))


def _plainer_contact(scene):
    for key, value in PLAIN_CONTACT.items():
        yield _with(scene, lambda s, k=key, v=value: s["contact"].update({k: v}))
    yield _with(scene, lambda s: s.update(units={"length": 1.0, "density": 1.0, "modulus": 1.0}))


def _coarser(scene):
    for number, body in enumerate(scene["bodies"]):
        for axis, n in enumerate(body["cells"]):
            for fewer in sorted({1, n // 2, n - 1}):
                if 1 <= fewer < n and body["shape"] != "fold":
                    yield _with(scene, lambda s, b=number, a=axis, c=fewer: s["bodies"][b]["cells"].__setitem__(a, c))


def _plainer_bodies(scene):
    plain = {"spin": [0.0] * 3, "rigid": False, "formulation": "", "skew": 0.0, "grade": 1.0, "linear_viscosity": None,
             "velocity": [0.0] * 3}
    for number, body in enumerate(scene["bodies"]):
        for key, value in plain.items():
            yield _with(scene, lambda s, b=number, k=key, v=value: s["bodies"][b].update({k: v}))
        for key, value in {"model": "elastic", "modulus": 1.0, "density": 1.0, "nu": 0.0}.items():
            yield _with(scene, lambda s, b=number, k=key, v=value: s["bodies"][b]["material"].update({k: v}))
        if body["shape"] in ("box", "ball"):
            yield _with(scene, lambda s, b=number: s["bodies"][b].update(element="hex8"))
        if body["shape"] == "ball":
            yield _with(scene, lambda s, b=number: s["bodies"][b].update(shape="box"))


def _rounder(scene):
    """All turned so that the first body stands upright; then fewer digits."""
    def upright(s):
        turn = np.array(s["bodies"][0]["turn"]).T
        for body in s["bodies"]:
            body["turn"] = (turn @ np.array(body["turn"])).round(12).tolist()
            for key in ("at", "velocity", "spin"):
                body[key] = (turn @ np.array(body[key])).tolist()
        for key in ("normal", "origin") if s["plane"] else ():
            s["plane"][key] = (turn @ np.array(s["plane"][key])).tolist()
    yield _with(scene, upright)
    for digits in (1, 2, 3):
        for number, body in enumerate(scene["bodies"]):
            for key in ("size", "velocity", "spin", "at"):
                rounded = [float(f"{v:.{digits}g}") for v in body[key]]
                yield _with(scene, lambda s, b=number, k=key, v=rounded: s["bodies"][b].update({k: v}))


PASSES = (_fewer_bodies, _plainer_contact, _shorter, _coarser, _plainer_bodies, _rounder)


def shrink(scene, fails, seconds):
    """The smallest scene found within some seconds for which fails(scene) holds."""
    end, n_tried, has_changed = time.monotonic() + seconds, 0, True
    while has_changed:
        has_changed = False
        for make in PASSES:
            position = 0
            while True:
                candidates = [c for c in make(scene) if c is not None]
                found = None
                for k in range(position, len(candidates)):
                    if time.monotonic() > end:
                        return scene, n_tried
                    n_tried += 1
                    if fails(candidates[k]):
                        found, position = candidates[k], k
                        break
                if found is None:
                    break
                scene, has_changed = found, True
    return scene, n_tried
