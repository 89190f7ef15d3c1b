# SPDX-License-Identifier: BSD-3-Clause
"""The deck language as `contactsim explain` prints it: the lines that each block holds, and random lines after them."""
import re
import subprocess

from samples import draw_number

TOKEN = re.compile(r"\{[^{}]*\}|\[(?:[^\[\]]|\[[^\[\]]*\])*\]|<[^<>]*(?:[<>]=?\s[^<>]*)?>|\.\.\.|[^\s{}\[\]<>]+")


def explain(program, *words):
    return subprocess.run([str(program), "explain", *words], capture_output=True, text=True).stdout.splitlines()


def block_phrases(program):
    """Phrases of all blocks, without names: `CONTACT SURFACE`, `PARAMETERS FOR MODEL ELASTIC`."""
    phrases = set()
    for line in explain(program):
        found = re.match(r"\s*BEGIN ([A-Z0-9_ ]+?)\s*(?:[\[<]|  |$)", line)
        if found:
            phrases.add(found.group(1).strip().lower())
    return sorted(phrases)


def lines_of_block(program, phrase):
    """The patterns of what a block holds."""
    patterns, is_inside = [], False
    for line in explain(program, *phrase.split()):
        if line.strip() == "holds":
            is_inside = True
        elif is_inside and re.match(r" {4}\S", line):
            patterns.append(re.split(r"  +", line.strip())[0])
        elif is_inside and re.match(r" {8}\S", line) and patterns:
            patterns[-1] += " " + re.split(r"  +", line.strip())[0]
        elif is_inside and not line.startswith(" "):
            break
    return patterns


class Grammar:
    def __init__(self, program):
        self.blocks = {phrase: lines_of_block(program, phrase) for phrase in block_phrases(program)}
        self.blocks = {phrase: lines for phrase, lines in self.blocks.items() if lines}

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
