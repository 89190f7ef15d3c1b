#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Paths of a run fall onto each other in all spellings: no input changes, no two outputs share a file without a word."""
import collections
import hashlib
import json
import os
import pathlib
import shutil
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from campaign import Campaign, scratch_folder
from harm import harm_of_end
from results import is_netcdf
from running import run
from samples import Samples, add_to_regions

SAMPLES = ("bounce", "two_particles", "crossed_rods", "steady_spin")  # small, with contact but for the last
OPTIONS = {"-o": "exodus", "--log": "log", "--summary": "json", "--report": "html", "--surfaces-json": "json",
           "--surfaces-csv": "csv", "--surfaces": "exodus"}
OF_DECK = {"results": "exodus", "history": "exodus", "heartbeat": "text", "states": "states"}


def digest(path):
    return hashlib.sha256(path.read_bytes()).hexdigest()


def is_json(path):
    try:
        return isinstance(json.loads(path.read_text()), dict)
    except (ValueError, UnicodeDecodeError):
        return False


def begins_with(path, *words):
    return path.read_bytes()[:300].decode(errors="replace").lower().lstrip().startswith(words)


# Whether a file is what the output that it was asked for writes.
IS_WHOLE = {"exodus": is_netcdf, "json": is_json, "html": lambda path: begins_with(path, "<!doctype", "<html"),
            "log": lambda path: begins_with(path, "contactsim"), "csv": lambda path: begins_with(path, "surface,"),
            "text": lambda path: begins_with(path, "time", "step", '"time')}


class Scene:
    """A folder with inputs, and outputs whose paths are drawn."""

    def __init__(self, rng, samples, folder):
        self.rng, self.folder = rng, folder
        self.sample = samples.get(rng.choice(SAMPLES))
        shutil.rmtree(folder, ignore_errors=True)
        samples.put(self.sample, "", folder)
        (folder / "sub").mkdir()
        (folder / "alias").symlink_to("sub")
        (folder / "here").symlink_to(".")
        self.deck, self.mesh = f"{self.sample.deck}.i", f"{self.sample.deck}.g"
        included = [name for name in ("energies.inc", "results.inc") if name in self.sample.text]
        self.inputs = [self.deck, self.mesh, *included]
        self.outputs = {}  # kind of file and path by what asks for it
        self.taken = list(self.inputs)
        self.n_links = 0

    def draw_outputs(self):
        for option, kind in OPTIONS.items():
            if self.rng.random() < 0.5:
                self.outputs[option] = (kind, self.draw_path(option.strip("-")))
        for block, kind in OF_DECK.items():
            if block != "states" or self.rng.random() < 0.4:
                self.outputs[block] = (kind, self.draw_path(block))

    def draw_path(self, name):
        """A name of its own most of the time, else one that something else has, or nearly."""
        path = self.rng.choice(["", "", "sub/"]) + f"{name}.out"
        if self.rng.random() < 0.25:
            path = self.rng.choice(self.taken)
            path += self.rng.choice(["", "", "", "", ".part", ".1", "-s0002"])
        self.taken.append(path)
        return self.spell(path)

    def spell(self, path):
        """The same file by another word."""
        way = self.rng.choice(["plain", "plain", "dot", "up", "whole", "here", "symlink", "hardlink"])
        if way == "dot":
            return f"./{path}"
        if way == "up":
            return f"sub/../{path}"
        if way == "whole":
            return str(self.folder / path)
        if way == "here":
            return f"here/{path}"
        if way == "plain" or os.path.lexists(self.folder / f"link_{self.n_links}"):
            return path
        self.n_links += 1
        link = self.folder / f"link_{self.n_links}"
        if way == "symlink":
            link.symlink_to(path)
            return link.name
        if not (self.folder / path).is_file():
            return path
        os.link(self.folder / path, link)
        return link.name

    def write_deck(self):
        path = {block: self.outputs[block][1] for block in OF_DECK if block in self.outputs}
        lines = ["begin results output one", f'database name = "{path["results"]}"', "at step 0 increment = 5",
                 "nodal displacement", "end", "begin history output two", f'database name = "{path["history"]}"',
                 "at step 0 increment = 1", "global kinetic_energy", "end", "begin heartbeat output three",
                 f'stream name = "{path["heartbeat"]}"', "at step 0 increment = 1", "global kinetic_energy", "end"]
        if "states" in path:
            lines += ["begin restart data", f'database name = "{path["states"]}"', "at step 0 increment = 3", "end"]
        lines += ["begin solution termination", "terminate global step >= 6", "end"]
        (self.folder / self.deck).write_text(add_to_regions(self.sample.text, lines))

    def command(self, program):
        words = [program, self.spell(self.deck), *self.rng.choice([[], [self.spell(self.mesh)]]),
                 *self.sample.definitions(), "--threads", "1", "--quiet"]
        for option in OPTIONS:
            if option in self.outputs:
                words += [option, self.outputs[option][1]]
        return words

    def harm(self, outcome, before):
        for name in self.inputs:
            path = self.folder / name
            if not path.is_file() or digest(path) != before[name]:
                return f"the input {name} has changed, exit code {outcome.code}"
        harm = harm_of_end(outcome, (0, 2, 3))
        if harm:
            return harm
        if outcome.code:
            known = [pathlib.Path(path).name for _, path in self.outputs.values()] + self.inputs + ["link_"]
            return "" if any(name in outcome.text for name in known) else f"no file is named: {outcome.text[-300:]}"
        return self.shared() or self.broken()

    def written(self):
        """What each output that is not in the place of another one has become."""
        for what, (kind, path) in self.outputs.items():
            if kind != "states" and not (what == "results" and "-o" in self.outputs):
                yield what, kind, (self.folder / path).resolve()

    def shared(self):
        by_place = collections.defaultdict(list)
        for what, _, path in self.written():
            by_place[path].append(what)
        return next((f"{' and '.join(whats)} share {path.name}" for path, whats in by_place.items() if len(whats) > 1), "")

    def broken(self):
        for what, kind, path in self.written():
            if not path.is_file() or not IS_WHOLE[kind](path):
                return f"{what}: {path.name} is not there or not what was asked for"
        return ""


def main():
    campaign = Campaign("clashes", __doc__)
    codes = collections.Counter()
    with scratch_folder() as folder:
        samples = Samples(campaign.source, pathlib.Path(folder))
        for rng in campaign.cases():
            scene = Scene(rng, samples, pathlib.Path(folder).resolve() / "run")
            scene.draw_outputs()
            scene.write_deck()
            command = scene.command(campaign.program)
            before = {name: digest(scene.folder / name) for name in scene.inputs}
            outcome = run(command, scene.folder, 20)
            codes[outcome.code] += 1
            harm = scene.harm(outcome, before)
            if harm:
                campaign.finding(harm, scene.folder)
    campaign.end(", ".join(f"{n} ended with {code}" for code, n in sorted(codes.items())))


if __name__ == "__main__":
    main()
