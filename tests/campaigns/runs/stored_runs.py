# SPDX-License-Identifier: BSD-3-Clause
"""Runs that store states, straight runs to compare with, and whether a run that went on ended as the straight one."""
import shutil

from results import exodus_difference, files_of, outcome_of, read_summary, EXODUS, TEXT
from running import run
from samples import ask_for_more, go_on_in_another, shorten, store_states

BEGINS_AT_START = "the run begins at its start"
DAMAGED = "damaged"


class StoredDeck:
    """A sample as a run that stores states and goes on from them, and the folder of its straight run."""

    def __init__(self, sample, words, text, folder):
        self.sample, self.words, self.text, self.straight = sample, words, text, folder
        self.outcome = None

    def command(self, program, threads=1):
        return [program, f"{self.sample.deck}.i", *self.words, "--threads", str(threads), "--quiet",
                "--summary", "summary.json", "--report", "report.html", "--log", "run.log"]


class StoredDecks:
    """Draws decks whose straight run ends well; keeps what it has drawn."""

    def __init__(self, program, samples, folder):
        self.program, self.samples, self.folder = program, samples, folder
        self._known = {}

    def draw(self, rng):
        while True:
            key = (rng.choice(self.samples.names), rng.random() < 0.3, rng.choice([1, 3, 7]), rng.choice([12, 40]))
            if key not in self._known:
                self._known[key] = self.make(rng, *key)
            if self._known[key].outcome.code == 0:
                return self._known[key]

    def make(self, rng, name, is_twofold, increment, n_steps):
        sample = self.samples.get(name)
        text = (go_on_in_another(sample.text) if is_twofold else None) or sample.text
        text = store_states(text, increment, ["restart = automatic", "optional", "cycle count = 3"])
        text = shorten(ask_for_more(text, 2), n_steps)
        deck = StoredDeck(sample, sample.definitions(), text, self.folder / f"straight_{len(self._known)}")
        self.samples.put(sample, text, deck.straight)
        deck.outcome = run(deck.command(self.program), deck.straight, 30)
        return deck

    def put(self, deck, folder):
        shutil.rmtree(folder, ignore_errors=True)
        self.samples.put(deck.sample, deck.text, folder)


def latest(folder, name):
    """The file of that name which the last run wrote: with the highest suffix -s0002, -s0003, ..."""
    found = sorted(folder.glob(f"{name}-s*"))
    return found[-1] if found else folder / name


def text_difference(whole, part):
    lines = part.read_text().splitlines()[1:]
    if lines and lines != whole.read_text().splitlines()[-len(lines):]:
        return f"{part.name} has other lines"
    return ""


def difference_at_end(deck, folder):
    """What of the last run in a folder is not the end of the straight run."""
    for pattern, differ in ((EXODUS, exodus_difference), (TEXT, text_difference)):
        for whole in files_of(deck.straight, pattern):
            part = latest(folder, whole.name)
            if not part.exists():
                # What went on in a later procedure writes no file of an earlier one.
                if not deck_is_twofold(deck):
                    return f"{whole.name} is not there"
                continue
            difference = differ(whole, part)
            if difference:
                return difference
    return summary_difference(deck, folder)


def deck_is_twofold(deck):
    return deck.text.lower().count(" procedure ") > 1 and "procedural transfer" in deck.text.lower()


def summary_difference(deck, folder):
    straight, gone_on = (outcome_of(read_summary(path / "summary.json")) for path in (deck.straight, folder))
    differ = [key for key in ("run", "pairs", "exit_code") if straight[key] != gone_on[key]]
    if differ == ["run"]:
        # A state at the termination time is over for its time, whatever condition held then, too.
        a, b = straight["run"], gone_on["run"]
        differ = [f"{key} {a[key]} -> {b[key]}" for key in a if a[key] != b[key] and key != "ended_by"]
    return f"summary: {'; '.join(differ)}" if differ else ""
