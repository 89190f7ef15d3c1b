#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Signals at random moments of runs that store states: none dies of them, and what was stopped goes on to the same end.

The first milliseconds, in which the system's loader has the process and no handler can be there, are counted apart.
"""
import collections
import pathlib
import signal
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from campaign import Campaign, scratch_folder
from harm import harm_of_end
from running import run, start
from samples import Samples
from stored_runs import StoredDecks, difference_at_end

STOP = (signal.SIGTERM, signal.SIGINT, signal.SIGHUP)
HARMLESS = (signal.SIGUSR1, signal.SIGPIPE)


def catches(process, signals):
    """Whether the process has handlers for all of these, or ignores them."""
    try:
        with open(f"/proc/{process.pid}/status") as file:
            masks = [int(line.split()[1], 16) for line in file if line.startswith(("SigCgt", "SigIgn"))]
    except OSError:
        return False
    return all(any(mask >> (number - 1) & 1 for mask in masks) for number in signals)


class Signals:
    def __init__(self, campaign, folder):
        self.program, self.folder = campaign.program, folder / "run"
        self.decks = StoredDecks(campaign.program, Samples(campaign.source, folder), folder)
        self.counts = collections.Counter()

    def wait_for_handlers(self, process):
        """Whether the handlers came before the process ended."""
        while process.poll() is None:
            if catches(process, (signal.SIGTERM, signal.SIGUSR1)):
                return True
            time.sleep(0.0002)
        return False

    def send(self, rng, process, deck):
        """Sends some signals, at most one of those that stop: of two the second has the system's way."""
        numbers = [rng.choice(HARMLESS) for _ in range(rng.randint(0, 4))]
        if rng.random() < 0.6:
            numbers.insert(rng.randint(0, len(numbers)), rng.choice(STOP))
        for number in numbers:
            time.sleep(rng.uniform(0, deck.outcome.seconds / max(1, len(numbers))))
            if process.poll() is None:
                process.send_signal(number)
                self.counts[signal.Signals(number).name] += 1
        return numbers

    def early(self, rng, deck):
        """A signal before main: it may end the process, and what it leaves goes on."""
        self.decks.put(deck, self.folder)
        process = start(deck.command(self.program), self.folder)
        time.sleep(rng.uniform(0, 0.02))
        process.send_signal(rng.choice(STOP + HARMLESS))
        died = process.wait() < 0
        self.counts["early, died" if died else "early, lived"] += 1
        return self.go_on(deck)

    def late(self, rng, deck):
        """Signals once the handlers are there, up to the last moment of the process."""
        self.decks.put(deck, self.folder)
        process = start(deck.command(self.program, rng.choice([1, 2])), self.folder)
        numbers = self.send(rng, process, deck) if self.wait_for_handlers(process) else []
        code = process.wait()
        self.counts[f"exit code {code}"] += 1
        if code not in (0, 5) or (code == 5 and not set(numbers) & set(STOP)):
            return f"exit code {code} after {', '.join(signal.Signals(number).name for number in numbers)}"
        if code == 0:
            return difference_at_end(deck, self.folder)
        return self.go_on(deck)

    def go_on(self, deck):
        harm = harm_of_end(run(deck.command(self.program), self.folder, 60), (0,))
        return harm or difference_at_end(deck, self.folder)


def main():
    campaign = Campaign("signals", __doc__)
    with scratch_folder() as folder:
        signals = Signals(campaign, pathlib.Path(folder))
        for rng in campaign.cases():
            deck = signals.decks.draw(rng)
            harm = (signals.early if rng.random() < 0.1 else signals.late)(rng, deck)
            if harm:
                campaign.finding(f"{deck.sample.name}: {harm}", signals.folder)
    campaign.end(", ".join(f"{n} {what}" for what, n in sorted(signals.counts.items())))


if __name__ == "__main__":
    main()
