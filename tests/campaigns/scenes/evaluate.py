# SPDX-License-Identifier: BSD-3-Clause
"""Runs a scene and one of its variants, and tells what fails."""
import random
import re

from properties import check_energy, check_momentum, check_through
from run import run, write_scene
from variants import VARIANTS, check_variant

# What may end a run by its nature: elements that a hit crushes, and what the program refuses in a deck.
CRUSHED = re.compile("turned inside out|below 1e-4|no volume|time step")


class Verdict:
    """What fails, as {property: text}; `ended` says why a scene could not be judged, else it is empty."""

    def __init__(self, failed=None, ended="", told=()):
        self.failed, self.ended, self.told = failed or {}, ended, set(told)


def _ended(result):
    if result.code == 2:
        return Verdict(ended="refused")
    if result.code == 4 and CRUSHED.search(result.error()):
        return Verdict(ended="crushed")
    name = {4: "stopped", -1: "endless"}.get(result.code, "crash")
    return Verdict({name: f"exit code {result.code}: {result.error()}"})


def evaluate(program, scene, variant_name, seed, folder):
    """Runs the scene in folder/first and its variant in folder/second; the seed is that of the variant."""
    first, second = folder / "first", folder / "second"
    for place in (first, second):
        place.mkdir(parents=True, exist_ok=True)
        for file in place.iterdir():
            file.unlink()
    write_scene(first, scene)
    result = run(program, first)
    if result.code != 0:
        return _ended(result)
    failed = check_momentum(scene, result) | check_energy(scene, result) | check_through(scene, result)
    variant = VARIANTS[variant_name](random.Random(seed), scene)
    write_scene(second, variant.scene, variant.points, variant.blocks, variant.order)
    failed |= check_variant(variant, result, run(program, second, variant.threads))
    told = {name for name in failed if name.endswith(", told")}
    return Verdict({name: text for name, text in failed.items() if name not in told}, told=told)
