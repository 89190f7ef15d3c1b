#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What shells, troff and Vim make of what `contactsim manual` writes; each where it is installed, bash always.

usage: manual_files.py PROGRAM
"""
import os
import shutil
import subprocess
import sys
import tempfile
from html.parser import HTMLParser


def run(*command, **options):
    return subprocess.run(command, capture_output=True, text=True, check=False, **options)


def complete(completion, *words):
    """What bash offers for the last word."""
    script = ('source "$1"; shift; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _contactsim; '
              'printf "%s\\n" "${COMPREPLY[@]}"')
    result = run("bash", "-c", script, "bash", completion, "contactsim", *words)
    return sorted(result.stdout.split()), result.stderr


def check_bash(program, problems):
    with open("completion.bash", "w", encoding="utf-8") as file:
        file.write(run(program, "manual", "bash").stdout)
    os.makedirs("folder/decks", exist_ok=True)
    for name in ("plate.i", "plate.g", "plate.log", "folder/part.i"):
        open(name, "w", encoding="utf-8").close()
    for words, expected in [
            (("--su",), ["--summary", "--surfaces", "--surfaces-csv", "--surfaces-json"]),
            (("pl",), ["plate.g", "plate.i"]),
            (("folder/",), ["folder/decks/", "folder/part.i"]),
            (("sw",), ["sweep"]),
            (("plate.i", "plate.g", "-o", "plate.l"), ["plate.log"]),
            (("plate.i", "--threads", ""), []),
            (("diff", "--define-s"), ["--define-second"]),
            (("sweep", "x.i", "--output", "fo"), ["folder"]),
            (("manual", "vs"), ["vscode"]),
            (("manual", "html", "fo"), ["folder"]),
            (("explain", "overla"), ["overlap", "overlaps"]),
    ]:
        found, errors = complete("./completion.bash", *words)
        expected_is_part = words[0] == "explain" and expected[0] in found
        if errors or not (found == expected or expected_is_part):
            problems.append(f"bash offers {found} for {words}, expected {expected} {errors}")


def check_shells(program, problems):
    for shell in ("zsh", "fish"):
        if shutil.which(shell) is None:
            continue
        with open(f"completion.{shell}", "w", encoding="utf-8") as file:
            file.write(run(program, "manual", shell).stdout)
        errors = run(shell, "-n", f"completion.{shell}").stderr
        if errors:
            problems.append(f"{shell}: {errors}")


def check_man_pages(program, problems):
    if shutil.which("groff") is None:
        return
    for kind in ("man", "man-deck"):
        page = run(program, "manual", kind).stdout
        result = run("groff", "-man", "-ww", "-Tascii", input=page)
        if result.stderr or "CONTACTSIM" not in result.stdout:
            problems.append(f"groff, {kind}: {result.stderr[:500]}")


def check_vim(program, problems):
    if shutil.which("vim") is None:
        return
    run(program, "manual", "vim", "vim")
    with open("deck.i", "w", encoding="utf-8") as file:
        file.write("begin sierra s\n  friction coefficient = 0.3 # mu\n  Begin Contact_Definition c\nend\n")
    groups = [(1, 1, "contactsimBlock"), (2, 5, "contactsimCommand"), (2, 26, "contactsimNumber"),
              (2, 31, "contactsimComment"), (3, 5, "contactsimBlock"), (4, 1, "contactsimEnd")]
    names = "".join(f"[synIDattr(synID({line}, {column}, 1), 'name')]+" for line, column, _ in groups)
    run("vim", "-Nu", "NONE", "-es", "-c", "set rtp^=vim", "-c", "filetype plugin on", "-c", "syntax on",
        "-c", "edit deck.i", "-c", f"call writefile([&filetype]+{names[:-1]}, 'groups')", "-c", "qa!")
    found = open("groups", encoding="utf-8").read().split() if os.path.exists("groups") else []
    if found != ["contactsim"] + [group for _, _, group in groups]:
        problems.append(f"vim colours as {found}")


class Anchors(HTMLParser):
    """Names of anchors of a page and where its links lead."""

    def __init__(self, path):
        super().__init__()
        self.names, self.links, self.open = set(), [], []
        self.feed(open(path, encoding="utf-8").read())

    def handle_starttag(self, tag, attrs):
        values = dict(attrs)
        self.names.add(values.get("id"))
        self.links += [values[key] for key in ("href", "src") if key in values]
        if tag not in ("meta", "link", "input", "img", "br", "hr"):
            self.open.append(tag)

    def handle_endtag(self, tag):
        if not self.open or self.open.pop() != tag:
            raise ValueError(f"</{tag}> closes nothing at line {self.getpos()[0]}")


def check_links(folder, problems):
    """Each link of each page leads to a file or an anchor that is there."""
    pages = {name: Anchors(os.path.join(folder, name)) for name in os.listdir(folder) if name.endswith(".html")}
    for name, page in pages.items():
        for link in page.links:
            if "://" in link:
                continue
            target, _, anchor = link.partition("#")
            target = target or name
            if not os.path.exists(os.path.join(folder, target)):
                problems.append(f"{name}: no file {link}")
            elif anchor and anchor not in pages[target].names:
                problems.append(f"{name}: no anchor {link}")
        if page.open:
            problems.append(f"{name}: {page.open} stay open")
    return len(pages)


def main():
    program, problems = os.path.abspath(sys.argv[1]), []
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        check_bash(program, problems)
        check_shells(program, problems)
        check_man_pages(program, problems)
        check_vim(program, problems)
        run(program, "manual", "html", "html")
        if check_links("html", problems) != 4:
            problems.append("expected four pages")
    print("\n".join(problems))
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
