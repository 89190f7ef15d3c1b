# SPDX-License-Identifier: BSD-3-Clause
"""What campaigns share: command line, time budget, seed, findings that are kept, and the line that counts.

A campaign draws inputs from a random generator until its time is over, and fails when one of them does harm. The whole
label has CONTACTSIM_CAMPAIGN_SECONDS (60 where it is not set); a campaign takes the share that CMake gives it.
Case k of seed S is the same on every machine: `--seed S --first k --count 1` runs it alone.
"""
import argparse
import os
import pathlib
import random
import shutil
import sys
import tempfile
import time


class Campaign:
    """One campaign: `for rng in campaign.cases():` draws cases, `campaign.finding(text, folder)` keeps what did harm."""

    def __init__(self, name, description, add_arguments=None):
        parser = argparse.ArgumentParser(description=description)
        parser.add_argument("program", type=pathlib.Path, help="contactsim")
        parser.add_argument("source", type=pathlib.Path, help="the repository, for decks and meshes")
        parser.add_argument("--share", type=float, default=1.0, help="part of CONTACTSIM_CAMPAIGN_SECONDS")
        parser.add_argument("--seconds", type=float, help="time budget [s], in place of the share")
        parser.add_argument("--count", type=int, help="number of cases, however long they take")
        parser.add_argument("--seed", type=int, default=1)
        parser.add_argument("--first", type=int, default=0, help="number of the first case")
        parser.add_argument("--keep", type=pathlib.Path, default=pathlib.Path(f"campaign_{name}"),
                            help="folder of the findings")
        if add_arguments:
            add_arguments(parser)
        self.name = name
        self.arguments = parser.parse_args()
        self.program = self.arguments.program.resolve()
        self.source = self.arguments.source.resolve()
        self.n_cases = 0
        self.case = None
        self.findings = []
        whole = float(os.environ.get("CONTACTSIM_CAMPAIGN_SECONDS", "60"))
        self.seconds = whole * self.arguments.share if self.arguments.seconds is None else self.arguments.seconds
        self._start = time.monotonic()

    def cases(self):
        """A random generator for each case, until the time or the count is over."""
        count = self.arguments.count
        while (self.n_cases < count) if count is not None else (time.monotonic() - self._start < self.seconds):
            self.case = self.arguments.first + self.n_cases
            self.n_cases += 1
            yield random.Random(f"{self.name} {self.arguments.seed} {self.case}")

    def finding(self, text, folder=None):
        """Tells what did harm and keeps the files of `folder`."""
        self.findings.append(text)
        kept = ""
        if folder is not None:
            target = self.arguments.keep / f"seed_{self.arguments.seed}_case_{self.case}"
            shutil.rmtree(target, ignore_errors=True)
            shutil.copytree(folder, target, symlinks=True)
            kept = f" (files in {target})"
        print(f"finding, seed {self.arguments.seed} case {self.case}: {text}{kept}", flush=True)

    def end(self, counts=""):
        """The counts; leaves the program, with 1 when there were findings."""
        more = f", {counts}" if counts else ""
        print(f"campaign {self.name}: {self.n_cases} cases{more}, {len(self.findings)} findings, "
              f"seed {self.arguments.seed}, {time.monotonic() - self._start:.1f} s")
        sys.exit(1 if self.findings else 0)


def scratch_folder():
    """A folder that is gone when its `with` ends."""
    return tempfile.TemporaryDirectory(prefix="contactsim_campaign_")
