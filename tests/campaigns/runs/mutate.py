# SPDX-License-Identifier: BSD-3-Clause
"""Random changes of a deck: its lines, numbers, words and blocks, and pieces of other decks."""
import re

from samples import draw_number

NUMBER = re.compile(r"(?<![\w.])[-+]?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?(?![\w.])", re.IGNORECASE)
WORD = re.compile(r"[A-Za-z_]\w*")
COMMAND = re.compile(r"^\s*([^=#{}]+?)\s*=\s*(.+?)\s*$")


def is_idle(line):
    """Comments and lines of Aprepro are left as they are: they decide about much, and other campaigns draw them."""
    text = line.strip()
    return not text or text[0] in "#$" or text.startswith("{")


def end_of_block(lines, begin):
    """The line behind the block that begins at a line."""
    depth = 0
    for i in range(begin, len(lines)):
        words = lines[i].split()
        first = words[0].lower() if words else ""
        depth += (first == "begin") - (first == "end")
        if depth <= 0:
            return i + 1
    return len(lines)


class Donors:
    """What other decks give: values by command, and whole blocks by their first words."""

    def __init__(self, texts):
        self.values, self.blocks = {}, []
        for text in texts:
            lines = text.splitlines()
            for i, line in enumerate(lines):
                found = COMMAND.match(line)
                if found:
                    self.values.setdefault(" ".join(found.group(1).lower().split()), []).append(found.group(2))
                if line.split()[:1] == ["begin"] and end_of_block(lines, i) - i < 60:
                    self.blocks.append(lines[i:end_of_block(lines, i)])


class Mutator:
    def __init__(self, grammar, donors):
        self.grammar, self.donors = grammar, donors
        self.word_sets = grammar.alternatives()
        # Most changes keep a deck that runs; those that seldom do are drawn seldom.
        self.kinds = [self.change_number] * 12 + [self.change_value] * 8 + [self.change_word] * 4 + [
            self.add_line] * 5 + [self.add_block] * 4 + [self.double_block] * 2 + [
                self.delete_line, self.double_line, self.swap_lines, self.move_line, self.delete_block]

    def mutate(self, rng, text):
        """Changes a deck in one to four places."""
        lines = text.splitlines()
        for _ in range(rng.choice([1, 1, 1, 1, 2, 2, 3])):
            self.change(rng, lines)
        return "\n".join(lines) + "\n"

    def change(self, rng, lines):
        for _ in range(20):
            if rng.choice(self.kinds)(rng, lines):
                return

    @staticmethod
    def pick(rng, lines, is_wanted=lambda line: True):
        found = [i for i, line in enumerate(lines) if not is_idle(line) and is_wanted(line)]
        return rng.choice(found) if found else None

    def change_number(self, rng, lines):
        at = self.pick(rng, lines, NUMBER.search)
        if at is None:
            return False
        found = rng.choice(list(NUMBER.finditer(lines[at])))
        number = draw_number(rng)
        if rng.random() < 0.4:
            number = repr(float(found.group(0)) * rng.choice([-1, 0.1, 0.5, 0.99, 2, 10, 1e3, 1e-3, 1e6]))
        lines[at] = lines[at][:found.start()] + number + lines[at][found.end():]
        return True

    def change_value(self, rng, lines):
        """Another value that some deck gives the same command."""
        at = self.pick(rng, lines, COMMAND.match)
        if at is None:
            return False
        found = COMMAND.match(lines[at])
        others = self.donors.values.get(" ".join(found.group(1).lower().split()), [])
        if not others:
            return False
        lines[at] = lines[at][:found.start(2)] + rng.choice(others)
        return True

    def change_word(self, rng, lines):
        """Another word of those that a command takes, or another name of the deck."""
        at = self.pick(rng, lines, COMMAND.match)
        if at is None:
            return False
        found = COMMAND.match(lines[at])
        value = found.group(2).lower()
        sets = [words for words in self.word_sets if value in words]
        words = rng.choice(sets) if sets else WORD.findall("\n".join(lines))
        lines[at] = lines[at][:found.start(2)] + rng.choice(words)
        return True

    def add_line(self, rng, lines):
        """A line of the block's own, as the reference has it."""
        at = self.pick(rng, lines, self.grammar.block_of)
        if at is None:
            return False
        names = WORD.findall(" ".join(line.split()[-1] for line in lines if line.split()))
        lines[at + 1:at + 1] = self.grammar.line(rng, self.grammar.block_of(lines[at]), names)
        return True

    def delete_line(self, rng, lines):
        at = self.pick(rng, lines)
        if at is not None:
            del lines[at]
        return at is not None

    def double_line(self, rng, lines):
        at = self.pick(rng, lines)
        if at is not None:
            lines.insert(at, lines[at])
        return at is not None

    def swap_lines(self, rng, lines):
        a, b = self.pick(rng, lines), self.pick(rng, lines)
        if a is not None:
            lines[a], lines[b] = lines[b], lines[a]
        return a is not None

    def move_line(self, rng, lines):
        a = self.pick(rng, lines, COMMAND.match)
        if a is not None:
            line = lines.pop(a)
            lines.insert(self.pick(rng, lines) or 0, line)
        return a is not None

    def pick_block(self, rng, lines):
        at = self.pick(rng, lines, lambda line: line.split()[0].lower() == "begin")
        return None if at is None else slice(at, end_of_block(lines, at))

    def delete_block(self, rng, lines):
        block = self.pick_block(rng, lines)
        if block is None or block.stop - block.start > 40:
            return False
        del lines[block]
        return True

    def double_block(self, rng, lines):
        block = self.pick_block(rng, lines)
        if block is None:
            return False
        lines[block.start:block.start] = lines[block]
        return True

    def add_block(self, rng, lines):
        """A block of another deck beside one of its kind, or in its place."""
        block = rng.choice(self.donors.blocks)
        kind = " ".join(block[0].lower().split()[:3])
        at = self.pick(rng, lines, lambda line: " ".join(line.lower().split()[:3]) == kind)
        if at is None:
            return False
        end = end_of_block(lines, at)
        lines[at if rng.random() < 0.5 else end:end] = block
        return True
