#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs on ranks of MPI: the bytes of one process, restarts with other numbers of ranks, errors that are said once, a rank
that is killed."""
import os
import pathlib
import re
import signal
import subprocess
import sys
import tempfile
import time

SOURCE = pathlib.Path(__file__).resolve().parents[3]
sys.path += [str(SOURCE / "tests/campaigns"), str(SOURCE / "tests/campaigns/runs")]
from rank_equality import HEARTBEAT, MPIRUN, RankEquality, join_pieces  # noqa: E402
from results import problem_of_results  # noqa: E402

RESTART = """begin restart data
        database name = impact.rsout
        at step 0 increment = 40
      end
      begin contact definition"""


class Runs:
    """Runs of the ball on the plate, 14 chunks of elements with contact, friction and held nodes."""

    def __init__(self, program, folder):
        self.program, self.folder = program, folder
        self.deck = (SOURCE / "decks/impact.i").read_text().replace("= 120e-6", "= {end}")
        self.mesh = (SOURCE / "decks/impact.g").read_bytes()

    def prepare(self, name, deck):
        folder = self.folder / name
        folder.mkdir(exist_ok=True)
        (folder / "impact.i").write_text(deck)
        (folder / "impact.g").write_bytes(self.mesh)
        return folder

    def command(self, n_ranks, end="8e-6", words=()):
        start = [] if n_ranks == 1 else [*MPIRUN, "-np", str(n_ranks)]
        return [*start, self.program, "impact.i", "--threads", "1", "--quiet", "--log", "run.log", "-D", f"end={end}", *words]

    def run(self, name, n_ranks, deck=None, **more):
        folder = self.prepare(name, deck or self.deck)
        result = subprocess.run(self.command(n_ranks, **more), cwd=folder, capture_output=True, text=True, timeout=120)
        return folder, result


def check(holds, what):
    if not holds:
        sys.exit(f"failed: {what}")


def compare(one, more):
    names = sorted({path.name for path in one.iterdir()} | {path.name for path in more.iterdir()})
    for name in names:
        check((one / name).exists() and (more / name).exists(), f"{more.name} and {one.name}: only one has {name}")
        difference = RankEquality.file_difference(one / name, more / name)
        check(not difference, f"{more.name} is not as {one.name}: {difference}")


def children_of(process):
    found = []
    for path in pathlib.Path("/proc").glob("[0-9]*/stat"):
        try:
            parent = int(path.read_text().rpartition(")")[2].split()[1])
        except OSError:
            continue  # it has ended
        if parent == process:
            found.append(int(path.parent.name))
    return sorted(found)


def bytes_are_those_of_one_process(runs):
    one, result = runs.run("one", 1)
    check(result.returncode == 0, result.stderr)
    for n_ranks in (2, 3, 4, 7):
        more, result = runs.run(f"{n_ranks}_ranks", n_ranks)
        check(result.returncode == 0, result.stderr)
        compare(one, more)
        log = (more / "run.log").read_text()
        check(f"  ranks      {n_ranks}\n" in log, "the log does not say the ranks")
        check(re.search(rf"^  {n_ranks} ranks: \d+\.\d % of the nodes shared", log, re.MULTILINE), "it does not say what they share")


def restarts_go_on_with_other_ranks(runs):
    deck = runs.deck.replace("begin contact definition", RESTART, 1)
    stored, _ = runs.run("stored", 3, deck, end="4e-6")
    alone, _ = runs.run("stored_by_one", 1, deck, end="4e-6")
    compare(alone, stored)
    states = sorted(path.name for path in stored.glob("impact.rsout*"))
    check(states, "no state is stored")
    again = deck.replace("begin sierra ball on plate", "begin sierra ball on plate\n  restart = automatic", 1)
    results = []
    for n_ranks in (1, 2, 4):
        folder = runs.prepare(f"resumed_{n_ranks}", again)
        for name in states:
            (folder / name).write_bytes((stored / name).read_bytes())
        _, result = runs.run(folder.name, n_ranks, again)
        check(result.returncode == 0, result.stderr)
        check((folder / "impact.e-s0002").exists(), "it does not go on from the stored state")
        results.append(folder)
    for folder in results[1:]:
        compare(results[0], folder)


def errors_are_said_once(runs):
    _, result = runs.run("wrong_deck", 3, runs.deck.replace("skin all blocks", "skin al blocks", 1))
    check(result.returncode == 2, f"exit code {result.returncode} of a wrong deck")
    said = re.findall("impact.i:[0-9]+:.*", result.stderr)
    check(said and len(said) == len(set(said)), result.stderr)
    _, result = runs.run("fast", 3, runs.deck.replace("{speed}", "{speed * 1000}").replace("youngs modulus = 70e9", "youngs modulus = 70e5"))
    check(result.returncode == 4, f"exit code {result.returncode} of a motion that cannot go on: {result.stderr}")
    check(result.stderr.count("error: ") == 1, result.stderr)


def commands_are_done_once(runs):
    def run(*words):
        return subprocess.run([*MPIRUN, "-np", "3", runs.program, *words], cwd=runs.folder, capture_output=True, text=True,
                              timeout=60)

    told = run("explain", "friction", "coefficient")
    alone = subprocess.run([runs.program, "explain", "friction", "coefficient"], capture_output=True, text=True, timeout=60)
    check(told.returncode == 0 and told.stdout == alone.stdout, f"explained otherwise: {told.stdout} {told.stderr}")
    runs.prepare("swept", runs.deck)
    refused = run("sweep", "swept/impact.i", "-D", "end=1e-6,2e-6")
    check(refused.returncode == 3, f"exit code {refused.returncode} of a sweep on ranks")
    check(refused.stderr.count("starts 3 processes") == 1, refused.stderr)


def pieces_are_joined_on_any_number_of_ranks(runs):
    whole, result = runs.run("whole", 1, end="2e-6")
    check(result.returncode == 0, result.stderr)
    for n_ranks, pieces in ((1, (5,)), (3, (5,)), (2, (3, 2))):
        folder = runs.prepare(f"pieces_{n_ranks}_{len(pieces)}", runs.deck)
        for n_pieces in pieces:
            made = subprocess.run([runs.program, "split", "impact.g", str(n_pieces)], cwd=folder, capture_output=True, text=True,
                                  timeout=60)
            check(made.returncode == 0, made.stderr)
        (folder / "impact.g").unlink()
        result = subprocess.run(runs.command(n_ranks, end="2e-6"), cwd=folder, capture_output=True, text=True, timeout=120)
        check(result.returncode == 0, result.stderr)
        taken = n_ranks if len(pieces) > 1 else pieces[0]
        check(f"joined from {taken} pieces" in (folder / "run.log").read_text(), f"{n_ranks} ranks take other pieces")
        for path in folder.iterdir():
            if path.name not in ("run.log", "impact.i") and not path.name.startswith("impact.g"):
                difference = RankEquality.file_difference(whole / path.name, path)
                check(not difference, f"{path.name} of {folder.name}: {difference}")
    folder = runs.prepare("unclear", runs.deck)
    for n_pieces in (2, 4):
        subprocess.run([runs.program, "split", "impact.g", str(n_pieces)], cwd=folder, check=True, capture_output=True)
    (folder / "impact.g").unlink()
    result = subprocess.run(runs.command(3), cwd=folder, capture_output=True, text=True, timeout=120)
    check(result.returncode == 3 and result.stderr.count("impact.g.2.0 or impact.g.4.0") == 1, result.stderr)


def results_in_pieces_are_those_of_one_process(runs):
    # Heartbeats would have all of each state brought to all ranks.
    quiet = HEARTBEAT.sub("", runs.deck)
    whole, result = runs.run("in_one", 1, quiet)
    check(result.returncode == 0, result.stderr)
    for n_ranks in (1, 2, 3, 8):
        folder, result = runs.run(f"written_in_{n_ranks}", n_ranks, quiet, words=["--pieces"])
        check(result.returncode == 0, result.stderr)
        pieces = sorted(path.name for path in folder.glob("impact.e*"))
        check(pieces == [f"impact.e.{n_ranks}.{r}" for r in range(n_ranks)], f"{n_ranks} ranks write {pieces}")
        join_pieces(runs.program, folder)
        difference = RankEquality.file_difference(whole / "impact.e", folder / "impact.e")
        check(not difference, f"of {n_ranks} pieces: {difference}")
    _, result = runs.run("written_in_3", 2, quiet, words=["--pieces"])
    check(result.stderr.count("[results-beside-pieces]") == 1 and "impact.e is of an earlier run" in result.stderr, result.stderr)
    folder = runs.prepare("no_room", quiet)
    (folder / "impact.e.3.1").mkdir()
    result = subprocess.run(runs.command(3, words=["--pieces"]), cwd=folder, capture_output=True, text=True, timeout=120)
    check(result.returncode == 3 and result.stderr.count("impact.e.3.1: this is a folder") == 1, result.stderr)
    kept = quiet.replace("database name = %B.e", "database name = %B.e\n        overwrite = off")
    for code in (0, 3):
        _, result = runs.run("kept", 2, kept, words=["--pieces"])
        check(result.returncode == code, f"exit code {result.returncode} in place of {code}: {result.stderr}")
    check(result.stderr.count("impact.e.2.0: exists") == 1, result.stderr)


def a_killed_rank_ends_the_run(runs):
    folder = runs.prepare("killed", runs.deck)
    command = [word for word in runs.command(3, end="120e-6") if word != "-q"]
    with subprocess.Popen(command, cwd=folder, stdout=subprocess.DEVNULL,
                          stderr=subprocess.PIPE, text=True) as run:
        while run.poll() is None and not (folder / "impact.e").exists():
            time.sleep(0.05)
        time.sleep(0.5)
        ranks = children_of(run.pid)
        check(len(ranks) == 3, f"mpirun has {len(ranks)} ranks")
        os.kill(ranks[-1], signal.SIGKILL)
        begun = time.monotonic()
        _, said = run.communicate(timeout=60)
        check(run.returncode != 0 and time.monotonic() - begun < 60.0, "the run did not end")
        check(said, "nobody says why the run has ended")
    problem = problem_of_results(folder)
    check(not problem, problem)


def main():
    with tempfile.TemporaryDirectory() as folder:
        runs = Runs(sys.argv[1], pathlib.Path(folder))
        for test in (bytes_are_those_of_one_process, restarts_go_on_with_other_ranks, errors_are_said_once,
                     commands_are_done_once, pieces_are_joined_on_any_number_of_ranks,
                     results_in_pieces_are_those_of_one_process, a_killed_rank_ends_the_run):
            begun = time.monotonic()
            test(runs)
            print(f"{test.__name__}: {time.monotonic() - begun:.1f} s", flush=True)


if __name__ == "__main__":
    main()
