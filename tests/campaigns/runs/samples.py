# SPDX-License-Identifier: BSD-3-Clause
"""Small decks with their meshes, of the verification cases, shortened to some steps.

A verification case builds its mesh in Python and hands it to a bench with the deck's name and Aprepro variables; the bench
here takes the first such run of each case down in place of running it.
"""
import itertools
import random
import re
import shutil
import sys

REGION_MODEL = re.compile(r"^(\s*)use finite element model\b.*$", re.MULTILINE | re.IGNORECASE)
PROCEDURE = re.compile(r"^( *)begin (?:presto|adagio) procedure\b.*?^\1end\b[^\n]*$", re.MULTILINE | re.DOTALL | re.IGNORECASE)
FILE_LINE = re.compile(r"^(\s*(?:database|stream) name = )(.*)$", re.MULTILINE | re.IGNORECASE)
END_TIME = re.compile(r"^\s*termination time = (.*)$", re.MULTILINE | re.IGNORECASE)
# Meshes or runs of which some dozen steps take more than half a second.
TOO_LONG = {"lead_balls", "glass_spheres", "hertz_ball", "hertz_rigid_ball", "hertz_two_balls", "hertz_cylinders",
            "static_deep_balls", "static_hertz", "static_cylinder_on_block", "static_cylinder_on_plane", "static_cone",
            "static_flat_punch", "static_partial_slip", "static_punch", "static_plate", "taylor_walls",
            "sphere_and_plate", "ball_on_thin_plate", "static_ironing", "static_sharp_die", "killed"}
CHOICES = {"form": ("face_face", "node_face"), "enforcement": ("momentum_balance", "penalty")}


class TakenDown(Exception):
    """The first run of a case is known."""


class RecordingBench:
    threads = 1

    def __init__(self):
        self.taken = None

    def run(self, deck, mesh, /, **variables):
        self.taken = (deck, mesh, variables)
        raise TakenDown

    prepare = run


class Sample:
    """A deck, its mesh in a file, and what -D gives; `text` is of the deck itself."""

    def __init__(self, name, deck, text, mesh, variables):
        self.name, self.deck, self.text, self.mesh, self.variables = name, deck, text, mesh, variables

    def definitions(self, rng=None):
        """The words of the command line; with a generator another formulation or enforcement where the deck has one."""
        words = []
        for name, value in self.variables.items():
            if rng is not None and name in CHOICES:
                value = rng.choice(CHOICES[name])
            words += ["-D", f"{name}={value!r}" if isinstance(value, float) else f"{name}={value}"]
        return words


class Samples:
    """The decks of the repository that a campaign draws from; meshes are written to `folder` as they are needed."""

    def __init__(self, source, folder):
        self.verification, self.folder = source / "decks" / "verification", folder
        sys.path[:0] = [str(self.verification), str(self.verification.parent)]
        import verify  # noqa: F401  the cases are known when it is imported
        from cases import CASES
        self.cases = CASES
        self.names = sorted(set(CASES) - TOO_LONG)
        self.includes = sorted(self.verification.glob("*.inc"))
        self.texts = [path.read_text() for path in sorted(source.glob("decks/**/*.i"))]
        self._known = {}

    def get(self, name):
        if name not in self._known:
            bench = RecordingBench()
            try:
                self.cases[name].run(bench)
            except TakenDown:
                pass
            deck, mesh, variables = bench.taken
            target = self.folder / f"{name}.g"
            mesh.write(target)
            path = self.verification / f"{deck}.i"
            text = (path if path.exists() else self.verification.parent / path.name).read_text()
            self._known[name] = Sample(name, deck, text, target, variables)
        return self._known[name]

    def draw(self, rng):
        return self.get(rng.choice(self.names))

    def put(self, sample, text, folder):
        """Fills a folder: deck, mesh and what it includes."""
        folder.mkdir(parents=True, exist_ok=True)
        for included in self.includes:
            shutil.copy(included, folder)
        shutil.copy(sample.mesh, folder / f"{sample.deck}.g")
        (folder / f"{sample.deck}.i").write_text(text)


def add_to_regions(text, lines):
    """Adds lines to every region of a deck; `@` in them stands for the number of the region."""
    numbers = itertools.count(1)

    def add(found):
        number = str(next(numbers))
        return found.group(0) + "".join("\n" + found.group(1) + line.replace("@", number) for line in lines)

    return REGION_MODEL.sub(add, text)


def shorten(text, n_steps):
    """Ends each procedure of a deck after a number of steps."""
    return add_to_regions(text, ["begin solution termination", f"terminate global step >= {n_steps}",
                                 "terminate type = procedure", "end"])


def store_states(text, increment, lines=()):
    """Has every region store its state, in place of what the deck says of it."""
    text = re.sub(r"^\s*begin restart data.*?^\s*end\b.*?$", "", text, flags=re.MULTILINE | re.DOTALL | re.IGNORECASE)
    return add_to_regions(text, ["begin restart data", "database name = campaign@.rsout",
                                 f"at step 0 increment = {increment}", *lines, "end"])


def ask_for_more(text, increment):
    """Has every region write fields, a history and a heartbeat of its own, whatever it writes besides."""
    return add_to_regions(text, [
        "begin results output campaign", "database name = campaign@.e", f"at step 0 increment = {increment}",
        "nodal variables = displacement velocity force_contact", "element variables = stress", "end",
        "begin history output campaign", "database name = campaign@.h", f"at step 0 increment = {increment}",
        "global variables = timestep kinetic_energy internal_energy contact_energy energy_error", "end",
        "begin heartbeat output campaign", "stream name = campaign@.csv", "precision = 17",
        f"at step 0 increment = {increment}", "global kinetic_energy", "global internal_energy", "global momentum",
        "end"])


def without_blocks(text, kind):
    """The text without its blocks of a kind; the end of a block is known by its indentation."""
    return re.sub(rf"^( *)begin {kind}\b.*?^\1end\b[^\n]*$", "", text, flags=re.MULTILINE | re.DOTALL | re.IGNORECASE)


def go_on_in_another(text):
    """A deck whose last procedure is followed by a copy of it that takes its state over; None where that cannot be.

    Contact of explicit procedures is left out: it is not taken over.
    """
    found = list(PROCEDURE.finditer(text))
    times = END_TIME.findall(found[-1].group(0)) if found else []
    if len(times) != 1 or len(re.findall(r"\bstart time =", found[-1].group(0))) != 1:
        return None
    first = found[-1].group(0)
    if "presto procedure" in first.lower():
        first = without_blocks(first, "contact definition")
    end = times[0].strip().strip("{}")
    again = without_blocks(first, "initial velocity").replace('{include("results.inc")}', "")
    again = re.sub(r"^(\s*start time = ).*$", rf"\g<1>{{{end}}}", again, flags=re.MULTILINE | re.IGNORECASE)
    again = END_TIME.sub(f"termination time = {{2 * ({end})}}", again)
    again = FILE_LINE.sub(r"\g<1>again_\g<2>", again)
    head, rest = again.split("\n", 1)
    again = f"{head.rstrip()}_again\nbegin procedural transfer\ninclude all blocks\nend\n{rest}"
    return f"{text[:found[-1].start()]}{first}\n{again}{text[found[-1].end():]}"


def draw_number(rng):
    """A real number as decks may have it, seldom a sound one."""
    return rng.choice(["0", "-1", "1", "1e-300", "1e300", "-1e300", "1e-12", "1e12", "0.5", "2", "7", "1e308", "4e9",
                       "-0.0", "1e-30", f"{rng.uniform(-2, 2):.3g}", f"{10 ** rng.uniform(-9, 9):.4g}"])


if __name__ == "__main__":
    import pathlib
    import tempfile
    with tempfile.TemporaryDirectory() as folder:
        found = Samples(pathlib.Path(__file__).resolve().parents[3], pathlib.Path(folder))
        rng = random.Random(0)
        for name in found.names:
            print(name, found.get(name).deck, *found.get(name).definitions(rng))
