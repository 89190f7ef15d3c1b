#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs on 2, 3, 4, 7 and 8 ranks of MPI write the same bytes as one process, decks that are changed at random among them;
every second writes results in pieces, which are joined."""
import pathlib
import re
import shutil
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from campaign import Campaign, scratch_folder
from running import run
from thread_equality import ThreadEquality

RANKS = (2, 3, 4, 7, 8)
HEARTBEAT = re.compile(r"^( *)begin heartbeat output\b.*?^\1end\b[^\n]*\n", re.MULTILINE | re.DOTALL | re.IGNORECASE)
FIRST_PIECE = re.compile(r"^(.*)\.(\d+)\.0+$")
# Ranks share processors here, and containers have one user.
MPIRUN = ["mpirun", "-q", "--allow-run-as-root", "--oversubscribe", "--bind-to", "none", "--mca", "plm", "isolated",
          "--mca", "mpi_yield_when_idle", "1", "--mca", "btl_vader_single_copy_mechanism", "none"]


def join_pieces(program, folder):
    """Puts files in the place of their pieces."""
    for first in sorted(folder.iterdir()):
        if not (named := FIRST_PIECE.match(first.name)):
            continue
        joined = subprocess.run([program, "join", first.name, named[1]], cwd=folder, capture_output=True, text=True, timeout=60)
        if joined.returncode == 0:
            for piece in folder.glob(f"{named[1]}.{named[2]}.*"):
                piece.unlink()
    log = folder / "run.log"
    if log.exists():
        log.write_text(re.sub(r"([^ ]+)\.(\d+)\.0+ to \1\.\2\.\d+", r"\1", log.read_text()))


class RankEquality(ThreadEquality):
    counts, what, in_pieces = RANKS, "ranks", False

    def draw(self, rng):
        self.in_pieces = rng.random() < 0.5
        sample, text, words = super().draw(rng)
        # Heartbeats have all of a state brought to all ranks.
        return sample, HEARTBEAT.sub("", text) if self.in_pieces and rng.random() < 0.5 else text, words

    def run(self, sample, text, words, count, folder):
        shutil.rmtree(folder, ignore_errors=True)
        self.samples.put(sample, text, folder)
        start = [] if count == 1 else [*MPIRUN, "-np", str(count)]
        words = [*words, "--pieces"] if self.in_pieces and count > 1 else words
        command = [*start, self.program, f"{sample.deck}.i", *words, "--threads", "1", "--quiet", "--log", "run.log",
                   "--summary", "summary.json", "--surfaces-json", "s.json", "--surfaces-csv", "s.csv",
                   "--surfaces", "s.exo"]
        outcome = run(command, folder, 60)
        if self.in_pieces and count > 1:
            join_pieces(self.program, folder)
        return outcome


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
