# SPDX-License-Identifier: BSD-3-Clause
"""Runs the benchmark programs that write lines of words and numbers."""
import subprocess


def value(word):
    try:
        return float(word)
    except ValueError:
        return word


def read_lines(text):
    """By the first word of each line, its pairs of a word and a number; lines of one name in a list if there are several."""
    found = {}
    for line in text.splitlines():
        name, *words = line.split()
        found.setdefault(name, []).append(dict(zip(words[0::2], map(value, words[1::2]))))
    return found


def run(program, *arguments):
    """Lines by name, the last one of each."""
    return {name: lines[-1] for name, lines in run_all(program, *arguments).items()}


def run_all(program, *arguments):
    """Lists of lines by name."""
    result = subprocess.run([str(program), *map(str, arguments)], capture_output=True, text=True, check=False)
    if result.returncode != 0:
        raise SystemExit(f"{program}: exit code {result.returncode}\n{result.stdout}{result.stderr}")
    return read_lines(result.stdout)
