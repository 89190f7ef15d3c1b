# SPDX-License-Identifier: BSD-3-Clause
"""Runs that store states, straight runs to compare with, and whether a run that went on ended as the straight one."""
import re
import shutil

from results import exodus_difference, files_of, outcome_of, read_summary, EXODUS, TEXT
from running import run
from samples import ask_for_more, go_on_in_another, shorten, store_states



class StoredDeck:
    """A sample as a run that stores states, and the folder of its straight run.

    text         of the deck, not yet shortened, without a word of restart
    increment    steps from one state to the next
    n_steps      of the straight run, of each procedure
    """

    def __init__(self, sample, text, increment, n_steps, folder):
        self.sample, self.text, self.increment, self.n_steps, self.straight = sample, text, increment, n_steps, folder
        self.is_twofold = len(re.findall(r"^\s*begin procedural transfer", text, re.MULTILINE)) > 0
        self.outcome = None

    def deck(self, lines=("restart = automatic",), n_steps=None, top=()):
        """The deck with lines of each RESTART DATA, or of the top."""
        text = store_states(self.text, self.increment, lines)
        text = re.sub(r"^(begin sierra.*)$", lambda found: "\n".join([found.group(0), *top]), text, count=1,
                      flags=re.MULTILINE | re.IGNORECASE)
        return shorten(text, n_steps or self.n_steps)

    def command(self, program, threads=1):
        return [program, f"{self.sample.deck}.i", *self.sample.definitions(), "--threads", str(threads), "--quiet",
                "--summary", "summary.json", "--report", "report.html", "--log", "run.log"]


N_KEPT = 20  # straight runs, whose states take megabytes


class StoredDecks:
    """Draws decks whose straight run ends well; keeps the last ones.

    environment  what a straight run in a folder has in its environment
    """

    def __init__(self, program, samples, folder, environment=lambda folder: {}):
        self.program, self.samples, self.folder, self.environment = program, samples, folder, environment
        self._known, self.n_made = {}, 0

    def draw(self, rng):
        while True:
            key = (rng.choice(self.samples.names), rng.random() < 0.3, rng.choice([1, 3, 7]), rng.choice([12, 40]))
            deck = self._known.pop(key, None) or self.make(*key)
            self._known[key] = deck
            if len(self._known) > N_KEPT:
                shutil.rmtree(self._known.pop(next(iter(self._known))).straight)
            if deck.outcome.code == 0:
                return deck

    def make(self, name, is_twofold, increment, n_steps):
        sample = self.samples.get(name)
        text = (go_on_in_another(sample.text) if is_twofold else None) or sample.text
        self.n_made += 1
        deck = StoredDeck(sample, ask_for_more(text, 2), increment, n_steps, self.folder / f"straight_{self.n_made}")
        self.samples.put(sample, deck.deck(), deck.straight)
        deck.outcome = run(deck.command(self.program), deck.straight, 60, **self.environment(deck.straight))
        return deck

    def put(self, deck, folder, **how):
        """A new folder with the deck, as deck() takes `how`."""
        shutil.rmtree(folder, ignore_errors=True)
        self.samples.put(deck.sample, deck.deck(**how), folder)

    def change(self, deck, folder, **how):
        """Another deck in a folder where a run was."""
        (folder / f"{deck.sample.deck}.i").write_text(deck.deck(**how))


class LogWatch:
    """What a run adds to the log of its folder, and whether it made use of the states that there were."""

    def __init__(self, folder):
        self.log = folder / "run.log"
        self.at = self.log.stat().st_size if self.log.exists() else 0
        self.had_states = any(not path.name.endswith(".part") for path in folder.glob("campaign*.rsout*"))

    def told(self):
        return self.log.read_bytes()[self.at:].decode(errors="replace") if self.log.exists() else ""

    def harm(self):
        if "damaged" in self.told():
            return "a stored state was damaged"
        return "a run lost its states" if self.had_states and "the run begins at its start" in self.told() else ""


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
    """What of the last run in a folder is not the end of the straight run.

    Left out are heartbeats that several procedures share: those of a later one go on without a suffix.
    """
    shared = "append = on" in deck.text.lower()
    for pattern, differ in ((EXODUS, exodus_difference), (TEXT, text_difference)):
        for whole in files_of(deck.straight, pattern):
            part = latest(folder, whole.name)
            if shared and pattern is TEXT and not whole.name.startswith("campaign"):
                continue
            if not part.exists():
                # What went on in a later procedure writes no file of an earlier one.
                if not deck.is_twofold:
                    return f"{whole.name} is not there"
                continue
            difference = differ(whole, part)
            if difference:
                return difference
    return summary_difference(deck, folder)


def summary_difference(deck, folder):
    straight, gone_on = (outcome_of(read_summary(path / "summary.json")) for path in (deck.straight, folder))
    differ = [key for key in ("run", "pairs", "exit_code") if straight[key] != gone_on[key]]
    if differ == ["run"]:
        # A state at the termination time is over for its time, whatever condition held then, too.
        a, b = straight["run"], gone_on["run"]
        differ = [f"{key} {a[key]} -> {b[key]}" for key in a if a[key] != b[key] and key != "ended_by"]
    return f"summary: {'; '.join(differ)}" if differ else ""
