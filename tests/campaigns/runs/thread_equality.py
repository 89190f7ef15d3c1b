#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs with 1, 2, 3, 4 and 7 threads write the same bytes, decks that are changed at random among them."""
import collections
import pathlib
import re
import shutil
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from campaign import Campaign, scratch_folder
from grammar import Grammar
from harm import harm_of_end
from mutate import Donors, Mutator
from results import is_netcdf, outcome_of, read_summary, same_exodus, same_restart
from running import run
from samples import Samples, ask_for_more, go_on_in_another, shorten

CLOCK = re.compile(r"^.*( s +\d+\.\d %|per second| s of the clock ).*$", re.MULTILINE)
RANKS = re.compile(r"^  \d+ ranks: .*\n", re.MULTILINE)
OF_A_RUN = {"printed.txt", "command.txt"}
THREADS = (2, 3, 4, 7)


def told(log):
    """What a log tells but for the clock, the command and how ranks share the run."""
    text = RANKS.sub("", CLOCK.sub("", log.read_text(errors="replace")))
    text = re.sub(r",\n +", ", ", text)  # where lists of files are folded
    return text.partition("\n  host ")[2].partition("\n")[2]


class ThreadEquality:
    counts, what = THREADS, "threads"

    def __init__(self, campaign, folder):
        self.program, self.folders = campaign.program, (folder / "one", folder / "more")
        self.samples = Samples(campaign.source, folder)
        self.mutator = Mutator(Grammar(campaign.program), Donors(self.samples.texts))
        self.codes = collections.Counter()

    def draw(self, rng):
        sample = self.samples.draw(rng)
        text = sample.text
        if rng.random() < 0.2:
            text = go_on_in_another(text) or text
        text = ask_for_more(text, rng.choice([1, 5]))
        if rng.random() < 0.5:
            text = self.mutator.mutate(rng, text)
        return sample, shorten(text, rng.choice([10, 50])), sample.definitions(rng)

    def run(self, sample, text, words, threads, folder):
        shutil.rmtree(folder, ignore_errors=True)
        self.samples.put(sample, text, folder)
        command = [self.program, f"{sample.deck}.i", *words, "--threads", str(threads), "--quiet", "--log", "run.log",
                   "--summary", "summary.json", "--surfaces-json", "s.json", "--surfaces-csv", "s.csv",
                   "--surfaces", "s.exo"]
        return run(command, folder, 30)

    def compare(self, rng):
        """The harm, and the name of the deck."""
        sample, text, words = self.draw(rng)
        count = rng.choice(self.counts)
        one, more = (self.run(sample, text, words, n, folder) for n, folder in zip((1, count), self.folders))
        self.codes[one.code] += 1
        name = f"{sample.name}, {count} {self.what}"
        if one.is_late or more.is_late:
            return "", name
        harm = harm_of_end(more, (0, 2, 3, 4))
        if not harm and one.code != more.code:
            harm = f"exit codes {one.code} and {more.code}"
        return harm or self.difference(), name

    def difference(self):
        one, more = self.folders
        names = [{path.name for path in folder.iterdir()} - OF_A_RUN for folder in self.folders]
        if names[0] != names[1]:
            return f"other files: {', '.join(sorted(names[0] ^ names[1]))}"
        for name in sorted(names[0]):
            difference = self.file_difference(one / name, more / name)
            if difference:
                return difference
        return ""

    @staticmethod
    def file_difference(one, more):
        if one.read_bytes() == more.read_bytes():
            return ""
        if ".rsout" in one.name:
            return same_restart(one, more)
        if is_netcdf(one):
            return same_exodus(one, more)
        if one.name == "summary.json":
            return "" if outcome_of(read_summary(one)) == outcome_of(read_summary(more)) else "summary.json"
        if one.suffix == ".log":
            return "" if told(one) == told(more) else one.name
        return one.name


def main():
    campaign = Campaign("threads", __doc__)
    with scratch_folder() as folder:
        equality = ThreadEquality(campaign, pathlib.Path(folder))
        for rng in campaign.cases():
            harm, name = equality.compare(rng)
            if harm:
                campaign.finding(f"{name}: {harm}", pathlib.Path(folder))
    campaign.end(", ".join(f"{n} ended with {code}" for code, n in sorted(equality.codes.items())))


if __name__ == "__main__":
    main()
