#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs are stopped at random steps and go on: to the last bit they end as the straight run does."""
import collections
import pathlib
import shutil
import signal
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from campaign import Campaign, scratch_folder
from harm import harm_of_end
from results import values
from running import run, start
from samples import Samples
from stored_runs import LogWatch, StoredDecks, difference_at_end

import netCDF4


class Restarts:
    def __init__(self, campaign, folder):
        self.program, self.folder = campaign.program, folder / "run"
        self.decks = StoredDecks(campaign.program, Samples(campaign.source, folder), folder)
        self.counts = collections.Counter()

    def run(self, rng, deck):
        """A run to the end, which goes on from what is stored."""
        watch = LogWatch(self.folder)
        harm = harm_of_end(run(deck.command(self.program, rng.choice([1, 1, 2])), self.folder, 60), (0,))
        self.counts["gone on" if "\nRestart from " in watch.told() else "begun anew"] += 1
        return harm or watch.harm()

    def ended(self, rng, deck):
        """The first run ends at an earlier step, of one procedure: of two, both would."""
        if deck.is_twofold:
            return self.stopped(rng, deck)
        self.decks.put(deck, self.folder, n_steps=rng.randint(1, deck.n_steps))
        harm = harm_of_end(run(deck.command(self.program), self.folder, 60), (0,))
        self.decks.change(deck, self.folder)
        return harm or self.run(rng, deck)

    def stopped(self, rng, deck):
        """SIGTERM ends the run, up to three times."""
        self.decks.put(deck, self.folder)
        for _ in range(rng.randint(1, 3)):
            process = start(deck.command(self.program, rng.choice([1, 2])), self.folder)
            time.sleep(rng.uniform(0.02, 0.02 + deck.outcome.seconds))
            process.send_signal(signal.SIGTERM)
            code = process.wait()
            # What comes before the program's main has the system's way with signals: see signals.py.
            if code not in (0, 5, -signal.SIGTERM):
                return f"exit code {code} of a run that was asked to stop"
        return self.run(rng, deck)

    def by_time(self, rng, deck):
        """From a state of the straight run that RESTART TIME names, in one place of the deck or the other."""
        shutil.rmtree(self.folder, ignore_errors=True)
        shutil.copytree(deck.straight, self.folder)
        line = f"restart time = {self.draw_time(rng, deck)!r}"
        how = {"lines": (), "top": (line,)} if rng.random() < 0.5 or deck.is_twofold else {"lines": (line,)}
        self.decks.change(deck, self.folder, **how)
        return self.run(rng, deck)

    def draw_time(self, rng, deck):
        with netCDF4.Dataset(rng.choice(sorted(deck.straight.glob("campaign*.h")))) as file:
            return float(rng.choice(list(values(file, "time_whole"))))


def main():
    campaign = Campaign("restarts", __doc__)
    with scratch_folder() as folder:
        restarts = Restarts(campaign, pathlib.Path(folder))
        for rng in campaign.cases():
            deck = restarts.decks.draw(rng)
            way = rng.choice([restarts.ended, restarts.ended, restarts.stopped, restarts.by_time])
            harm = way(rng, deck) or difference_at_end(deck, restarts.folder)
            if harm:
                campaign.finding(f"{deck.sample.name}, {way.__name__}: {harm}", restarts.folder)
    campaign.end(", ".join(f"{n} {what}" for what, n in sorted(restarts.counts.items())))


if __name__ == "__main__":
    main()
