# SPDX-License-Identifier: BSD-3-Clause
"""What counts as harm that a run does, whatever its deck says."""
import re

from results import problem_of_results, read_summary

SANITIZER = re.compile(r"(\S*Sanitizer\S*:.*|.*runtime error: .*)")
ERROR = re.compile(r"\berror:")
PLACED = re.compile(r"^[^\s:]+(:\d+)?(:\d+)?: error:|^\s*error: |^contactsim: error:", re.MULTILINE)
DECK_PLACE = re.compile(r"^[^\s:]+:\d+(:\d+)?: error:", re.MULTILINE)
STATES = {0: "done", 2: "failed", 3: "failed", 4: "failed", 5: "stopped"}
ENERGY_BOUND = 0.1  # of the largest energy; the program itself tells of a hundredth,
SETTLED = 40  # steps, but not of the first thirty (app/run/energy_watch.cpp)
ROUND_OFF = 1e-15  # energy of decks in SI units that round-off may make
ENERGY_TOLD = re.compile(r"energy|runaway|ENERGY|load step|balance")


def harm_of_end(outcome, codes):
    """Of the way the run ended."""
    found = SANITIZER.search(outcome.text)
    if found:
        return f"sanitizer: {found.group(0)[:200]}"
    if outcome.is_stuck:
        return f"stuck: did not stop within {outcome.seconds:.0f} s"
    if outcome.code == 1 or outcome.code not in codes:
        lines = outcome.text.strip().splitlines()
        return f"exit code {outcome.code}: {lines[-1][:200] if lines else ''}"
    if outcome.code == 5 and not outcome.is_late:
        return "stopped by a signal that nobody sent"
    return ""


def harm_of_texts(outcome):
    """Errors of decks have a place, every failure has a text."""
    if outcome.code in (2, 3, 4) and not ERROR.search(outcome.text):
        return f"exit code {outcome.code} without an error"
    if outcome.code == 2 and not DECK_PLACE.search(outcome.text):
        return f"an error of the deck without a line: {ERROR.search(outcome.text).string.strip()[-200:]}"
    return ""


def harm_of_summary(outcome, path):
    try:
        summary = read_summary(path)
    except ValueError as error:
        return f"summary is no JSON: {error}"
    if summary is None:
        return "" if outcome.code == 3 else "no summary"
    if summary["exit_code"] != outcome.code or summary["state"] != STATES[outcome.code]:
        return f"summary has {summary['state']}, {summary['exit_code']}, the run ended with {outcome.code}"
    run = summary["run"]
    if outcome.code != 0 or run is None:
        return ""
    share = run["energies"].pop("error_share")
    if share is None or any(value is None for value in run["energies"].values()) or run["time"] is None:
        return f"no finite energies: {run['energies']}"
    told = any(ENERGY_TOLD.search(f"{warning['id']} {warning['text']}") for warning in summary["warnings"])
    is_real = max(abs(value) for value in run["energies"].values()) > ROUND_OFF and run["steps"] >= SETTLED
    if abs(share) > ENERGY_BOUND and is_real and not told:
        return f"energy error of {share:.3g} of the largest energy, not told"
    return ""


def harm_of_leftovers(folder):
    left = sorted(path.name for path in folder.rglob("*") if re.search(r"\.(part|tmp)\b|~$", path.name))
    return f"files left behind: {', '.join(left)}" if left else ""


def find_harm(outcome, folder, summary="summary.json", codes=(0, 2, 3, 4, 5)):
    """The first harm of a run in `folder`, "" where it did none."""
    harm = harm_of_end(outcome, codes) or harm_of_texts(outcome) or harm_of_summary(outcome, folder / summary)
    harm = harm or harm_of_leftovers(folder)
    if not harm and outcome.code in (0, 5):
        harm = problem_of_results(folder)
    return harm
