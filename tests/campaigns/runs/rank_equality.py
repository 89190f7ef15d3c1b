#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs on 2, 3, 4, 7 and 8 ranks of MPI write the same bytes as one process, decks that are changed at random among them."""
import pathlib
import shutil
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from campaign import Campaign, scratch_folder
from running import run
from thread_equality import ThreadEquality

RANKS = (2, 3, 4, 7, 8)
# Ranks share processors here, and containers have one user.
MPIRUN = ["mpirun", "-q", "--allow-run-as-root", "--oversubscribe", "--bind-to", "none", "--mca", "plm", "isolated",
          "--mca", "mpi_yield_when_idle", "1", "--mca", "btl_vader_single_copy_mechanism", "none"]


class RankEquality(ThreadEquality):
    counts, what = RANKS, "ranks"

    def run(self, sample, text, words, count, folder):
        shutil.rmtree(folder, ignore_errors=True)
        self.samples.put(sample, text, folder)
        start = [] if count == 1 else [*MPIRUN, "-np", str(count)]
        command = [*start, self.program, f"{sample.deck}.i", *words, "--threads", "1", "--quiet", "--log", "run.log",
                   "--summary", "summary.json", "--surfaces-json", "s.json", "--surfaces-csv", "s.csv",
                   "--surfaces", "s.exo"]
        return run(command, folder, 60)


def main():
    campaign = Campaign("ranks", __doc__)
    with scratch_folder() as folder:
        equality = RankEquality(campaign, pathlib.Path(folder))
        for rng in campaign.cases():
            harm, name = equality.compare(rng)
            if harm:
                campaign.finding(f"{name}: {harm}", pathlib.Path(folder))
    campaign.end(", ".join(f"{n} ended with {code}" for code, n in sorted(equality.codes.items())))


if __name__ == "__main__":
    main()
