#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs that store states are killed at random moments, or find disk or memory full: what is left is whole, and goes on."""
import collections
import os
import pathlib
import re
import signal
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from campaign import Campaign, scratch_folder
from harm import harm_of_end
from results import EXODUS, exodus_difference, files_of, problem_of_exodus, read_summary
from running import asan_library, build_shim, run, start
from samples import Samples
from stored_runs import LogWatch, StoredDecks, difference_at_end

MUMPS_ENDS = "Attempt to DEALLOCATE unallocated"  # without memory MUMPS 5.5 ends the process itself, with exit code 2
LARGE = 16384  # bytes of the allocations that fail, and more


class Kills:
    def __init__(self, campaign, folder):
        self.program, self.folder = campaign.program, folder / "run"
        self.decks = StoredDecks(campaign.program, Samples(campaign.source, folder), folder, self.counting)
        self.shim = build_shim(folder, campaign.arguments.compiler)
        self.counts = collections.Counter()
        self.limit = 60.0
        self.before = asan_library(campaign.program)

    def shimmed(self, kind, at, folder=None):
        return {"LD_PRELOAD": " ".join([*self.before, str(self.shim)]), "FAULT_KIND": kind, "FAULT_AT": str(at),
                "FAULT_BYTES": str(LARGE), "FAULT_FOLDER": str(folder or self.folder)}

    def counting(self, folder):
        """Has a straight run count what kills and faults are drawn from."""
        return {**self.shimmed("count", -1, folder), "FAULT_COUNT": str(folder / "count.txt")}

    @staticmethod
    def measure(deck):
        """Numbers of calls that change files, and of large allocations, in the straight run."""
        return map(int, (deck.straight / "count.txt").read_text().split())

    def attempts(self):
        """AddressSanitizer has an allocation of its own, which the shim does not reach."""
        return [self.try_kills, self.try_kills, self.try_full, self.try_full if self.before else self.try_no_memory]

    def kill(self, rng, deck, n_before):
        """Kills one run: at a moment of the clock, or at a call, before it or when half of its bytes are written.

        What has gone on a number of times has less and less before it.
        """
        n_calls, _ = self.measure(deck)
        share = rng.random() ** (1 + n_before)
        kind = rng.choice(["clock", "kill", "kill", "kill_within"])
        if kind == "clock":
            process = start(deck.command(self.program), self.folder)
            time.sleep(share * deck.outcome.seconds)
            process.kill()
            code = process.wait()
        else:
            code = run(deck.command(self.program), self.folder, self.limit, **self.shimmed(kind, int(share * n_calls))).code
        self.counts["kills" if code == -signal.SIGKILL else "ended before"] += 1
        return "" if code in (-signal.SIGKILL, 0) else f"exit code {code} of a run that should be killed"

    def look_behind(self):
        """What a kill may not leave: a broken summary, results without a beginning."""
        try:
            read_summary(self.folder / "summary.json")
        except ValueError as error:
            return f"after a kill the summary is no JSON: {error}"
        for path in files_of(self.folder, EXODUS):
            problem = path.stat().st_size and problem_of_exodus(path)
            if problem:
                return f"after a kill: {problem}"
        return ""

    def try_kills(self, rng, deck):
        """Some kills in a row, then a run to the end."""
        self.decks.put(deck, self.folder)
        n_kills = rng.randint(2, 8)
        for i in range(n_kills + 1):
            watch = LogWatch(self.folder)
            if i < n_kills:
                harm = self.kill(rng, deck, i) or self.look_behind()
            else:
                harm = harm_of_end(run(deck.command(self.program), self.folder, self.limit), (0,))
            harm = harm or watch.harm()
            if harm:
                return harm
        return difference_at_end(deck, self.folder)

    def try_full(self, rng, deck):
        """From a random call on the disk is full or broken: the run says which file, or has lost nothing."""
        n_calls, _ = self.measure(deck)
        self.decks.put(deck, self.folder)
        outcome = run(deck.command(self.program), self.folder, self.limit,
                      **self.shimmed(rng.choice(["enospc", "eio"]), rng.randrange(n_calls)))
        self.counts["disks full"] += 1
        return self.harm_of_fault(deck, outcome) or self.unnamed(outcome)

    def unnamed(self, outcome):
        names = [path.name for path in self.folder.iterdir()] + ["campaign", "run.log", "summary.json", "report.html"]
        if outcome.code == 3 and not any(name in outcome.text for name in names):
            return f"no file is named: {outcome.text.strip()[-200:]}"
        return ""

    def try_no_memory(self, rng, deck):
        """From a random large allocation on there is no memory."""
        _, n_large = self.measure(deck)
        if n_large == 0:
            return ""
        self.decks.put(deck, self.folder)
        outcome = run(deck.command(self.program), self.folder, self.limit,
                      **self.shimmed("malloc", rng.randrange(n_large)))
        self.counts["out of memory"] += 1
        if MUMPS_ENDS in outcome.text:
            self.counts["ended by MUMPS"] += 1
            return ""
        return self.harm_of_fault(deck, outcome)

    def harm_of_fault(self, deck, outcome):
        harm = harm_of_end(outcome, (0, 3))
        if harm:
            return harm
        for whole in files_of(deck.straight, re.compile(r"^campaign.*\.[eh]$")):
            path = self.folder / whole.name
            if outcome.code == 0 and (not path.exists() or exodus_difference(whole, path)):
                return f"exit code 0, but {path.name} is not what it should be"
        return self.look_behind()


def main():
    campaign = Campaign("kills", __doc__, lambda parser: parser.add_argument("--compiler", default=os.environ.get("CC", "cc")))
    with scratch_folder() as folder:
        kills = Kills(campaign, pathlib.Path(folder))
        for rng in campaign.cases():
            deck = kills.decks.draw(rng)
            attempt = rng.choice(kills.attempts())
            harm = attempt(rng, deck)
            if harm:
                campaign.finding(f"{deck.sample.name}: {harm}", kills.folder)
    campaign.end(", ".join(f"{n} {what}" for what, n in sorted(kills.counts.items())))


if __name__ == "__main__":
    main()
