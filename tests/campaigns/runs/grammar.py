# SPDX-License-Identifier: BSD-3-Clause
"""The deck language as the reference has it: the lines that each block holds, and random lines after them."""
import re
import subprocess

from samples import draw_number

TOKEN = re.compile(r"\{[^{}]*\}|\[(?:[^\[\]]|\[[^\[\]]*\])*\]|<[^<>]*(?:[<>]=?\s[^<>]*)?>|\.\.\.|[^\s{}\[\]<>]+")


def read_blocks(program):
    """Lines that each block holds, by the block's words without a name, of the page that `manual man-deck` prints."""
    page = subprocess.run([str(program), "manual", "man-deck"], capture_output=True, text=True, check=True).stdout
    blocks, lines = {}, []
    for line in page.splitlines():
        if line.startswith(".SH "):
            lines = blocks.setdefault(line[4:].split(" > ")[-1].strip().lower(), [])
        found = re.fullmatch(r"\\fB(.*)\\fR", line)
        if found:
            lines.append(re.sub(r"\\(.)", r"\1", found.group(1)))
    return {phrase: lines for phrase, lines in blocks.items() if lines}


class Grammar:
    def __init__(self, program):
        self.blocks = read_blocks(program)

    def block_of(self, line):
        """The phrase of a `begin` line; None where it is no such line."""
        found = re.match(r"\s*begin\s+(?:definition for\s+)?(.*)", line, re.IGNORECASE)
        if not found:
            return None
        words = found.group(1).lower()
        fitting = [phrase for phrase in self.blocks if words.startswith(phrase)]
        return max(fitting, key=len) if fitting else None

    def line(self, rng, phrase, names):
        """A random line of a block; of an inner block, with some lines in it."""
        pattern = rng.choice(self.blocks[phrase])
        text = fill(rng, pattern, names)
        if not pattern.startswith("BEGIN"):
            return [text]
        inner = self.block_of(text)
        lines = [one for _ in range(rng.randint(0, 4)) for one in self.line(rng, inner, names)] if inner else []
        return [text, *lines, "end"]

    def alternatives(self):
        """Sets of words of which a command takes any: `face_face`, `node_face`."""
        sets = set()
        for lines in self.blocks.values():
            for line in lines:
                for found in re.findall(r"\{([^{}<>\[\]]*\|[^{}<>\[\]]*)\}", line):
                    sets.add(tuple(word.strip().lower() for word in found.split("|")))
        return sorted(sets)


def fill(rng, pattern, names):
    """A line after its pattern: alternatives drawn, brackets left out half the time, numbers and names put in."""
    words = []
    for token in TOKEN.findall(pattern):
        if token == "...":
            if rng.random() < 0.5 and words:
                words.append(words[-1])
        elif token[0] == "[":
            if rng.random() < 0.5:
                words.append(fill(rng, token[1:-1], names))
        elif token[0] == "{":
            words.append(fill(rng, rng.choice(token[1:-1].split("|")), names))
        elif token[0] == "<":
            words.append(fill_place(rng, token, names))
        else:
            words.append(token.lower())
    return " ".join(words)


def fill_place(rng, place, names):
    if "integer" in place or place == "<n>":
        return str(rng.choice([0, 1, 2, 3, 5, 10, 100, -1, 2**31 - 1, 2**31, 2**63]))
    if re.search(r"real|dt|t0|n0|<[xyz]>|from|to>|number", place):
        return draw_number(rng)
    return rng.choice(names)
