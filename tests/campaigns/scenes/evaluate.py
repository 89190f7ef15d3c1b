# SPDX-License-Identifier: BSD-3-Clause
"""Runs a scene and one of its variants, and tells what fails."""
import random
import re

from properties import begins_with_overlap, check_energy, check_momentum, check_through
from run import run, write_scene
from variants import VARIANTS, check_variant

# What may end a run by its nature: elements that a hit crushes, and what the program refuses in a deck.
CRUSHED = re.compile("turned inside out|below 1e-4|no volume|time step")


class Verdict:
    """What fails, and what the program itself tells of, as {property: text}; `ended` says why a scene could not be judged, else
    it is empty; `difference` is that of the variant; `overlaps` says whether sides are in each other at the start."""

    def __init__(self, failed=None, ended="", told=None, difference=0.0, overlaps=False):
        self.failed, self.ended, self.told, self.difference = failed or {}, ended, told or {}, difference
        self.overlaps = overlaps


def _ended(result):
    if result.code == 2:
        return Verdict(ended="refused")
    if result.code == 4 and CRUSHED.search(result.error()):
        return Verdict(ended="crushed")
    if result.code == 4 and "runs away" in result.error():
        return Verdict(told={"runs away, told": result.error()})  # contact that makes energy ends the run
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
    second_result = run(program, second, variant.threads)
    of_variant, worst = check_variant(variant, result, second_result)
    failed |= of_variant
    told = {name: text for name, text in failed.items() if name.endswith((", told", ", known"))}
    return Verdict({n: t for n, t in failed.items() if n not in told}, told=told, difference=worst,
                   overlaps=begins_with_overlap(result))
