#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Decks of the repository, changed at random, are really run: no bug, no crash, no silent nonsense."""
import collections
import pathlib
import shutil
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from campaign import Campaign, scratch_folder
from grammar import Grammar
from harm import find_harm
from mutate import Donors, Mutator
from running import run, time_limit
from samples import Samples, ask_for_more, go_on_in_another, shorten, store_states


class MutatedRuns:
    def __init__(self, campaign, folder):
        self.program, self.folder = campaign.program, folder / "run"
        self.samples = Samples(campaign.source, folder)
        self.mutator = Mutator(Grammar(campaign.program), Donors(self.samples.texts))
        self.longest = time_limit(campaign.program)
        self.limit = campaign.arguments.stop_after or self.longest

    def draw(self, rng):
        """A sample and its changed text."""
        sample = self.samples.draw(rng)
        text = sample.text
        if rng.random() < 0.1:
            text = go_on_in_another(text) or text
        if rng.random() < 0.2:
            text = store_states(text, rng.choice([1, 5, 10]), rng.choice([[], ["restart = automatic"]]))
        text = ask_for_more(text, rng.choice([1, 5, 10]))
        text = self.mutator.mutate(rng, text)
        return sample, shorten(text, rng.choice([5, 20, 60])), [
            *sample.definitions(rng), *rng.choice([[], [], ["--lenient"]])]

    def run(self, sample, text, words):
        shutil.rmtree(self.folder, ignore_errors=True)
        self.samples.put(sample, text, self.folder)
        command = [self.program, f"{sample.deck}.i", *words, "--threads", "1", "--quiet", "--summary", "summary.json"]
        outcome = run(command, self.folder, self.limit, 2 * self.longest)
        return outcome, find_harm(outcome, self.folder)

    def shrink(self, sample, text, words, harm):
        """Takes lines away while the same kind of harm stays."""
        kind, lines = harm[:12], text.splitlines()
        size = max(1, len(lines) // 4)
        while size >= 1:
            at = 0
            while at < len(lines):
                less = lines[:at] + lines[at + size:]
                if self.run(sample, "\n".join(less) + "\n", words)[1].startswith(kind):
                    lines = less
                else:
                    at += size
            size //= 2
        self.run(sample, "\n".join(lines) + "\n", words)


def add_arguments(parser):
    parser.add_argument("--no-shrink", action="store_true", help="keep what did harm as it was drawn")
    parser.add_argument("--stop-after", type=float, help="seconds of a processor after which a run gets SIGTERM")


def main():
    campaign = Campaign("runs", __doc__, add_arguments)
    codes = collections.Counter()
    with scratch_folder() as folder:
        runs = MutatedRuns(campaign, pathlib.Path(folder))
        for rng in campaign.cases():
            sample, text, words = runs.draw(rng)
            outcome, harm = runs.run(sample, text, words)
            codes["late" if outcome.is_late else outcome.code] += 1
            if harm:
                if not campaign.arguments.no_shrink and not outcome.is_late:
                    runs.shrink(sample, text, words, harm)
                campaign.finding(f"{sample.name}: {harm}", runs.folder)
    campaign.end(", ".join(f"{n} ended with {code}" for code, n in sorted(codes.items(), key=str)))


if __name__ == "__main__":
    main()
