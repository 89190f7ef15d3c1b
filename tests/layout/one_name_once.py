#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""No class and no free function of namespace contactsim is defined in two files.

    one_name_once.py ROOT

Two definitions of one name in libraries that are linked together are no error to the linker: it takes the first that it
meets, and the other's users work on the wrong one. What stands in unnamed namespaces, is static or is a member may have
any name. Functions are told apart by the types of their parameters; templates of functions are passed over.
"""
import re
import sys
from collections import defaultdict
from pathlib import Path

MODULES = ("core", "parser", "contact", "io", "app")
NO_CODE = re.compile(
    r'R"([^\s()\\]{0,16})\(.*?\)\1"|//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|(?<!\w)\'(?:\\.|[^\'\\\n])+\'|'
    r"^[ \t]*#(?:[^\n]*\\\n)*[^\n]*", re.DOTALL | re.MULTILINE)
NAMESPACE = re.compile(r"^(?:inline )?namespace ?([\w:]*)$")
CLASS = re.compile(r"^(?:template ?<.*> ?)?(?:class|struct|union|enum(?: class)?) (?:\[\[.*?\]\] ?)?([\w:]+ ?(?:<.*>)?)"
                   r"(?: final)?(?: ?:[^:].*)?$")
FUNCTION = re.compile(r"^([A-Za-z][\w:<>,&* \[\]]*?[ &*>])((?:operator ?[^\w ]+)|\w+) ?\((.*)\)(?: noexcept)?"
                      r"(?: ?->.*)?$")
NAME_OF_PARAMETER = re.compile(r"(?<=[\w>&*]) ?(?<![\w:])(?!const\b)\w+$")


def types_of(parameters):
    """The parameters without their names and defaults, as one text."""
    depth, parts = 0, [""]
    for character in parameters:
        depth += character in "<([{"
        depth -= character in ">)]}"
        if character == "," and depth == 0:
            parts.append("")
        else:
            parts[-1] += character
    return ", ".join(NAME_OF_PARAMETER.sub("", part.split(" = ")[0].strip()) for part in parts)


def kind_of(head, spaces):
    """What an opening brace begins: ("namespace", name), ("class" or "function", whole name) or ("other", "")."""
    if found := NAMESPACE.match(head):
        return "namespace", found[1]
    if None in spaces:
        return "other", ""
    if found := CLASS.match(head):
        return "class", "::".join([*spaces, found[1].strip()])
    if (found := FUNCTION.match(head)) and not re.search(r"\b(static|template|return|else)\b", found[1]):
        return "function", "::".join([*spaces, f"{found[2]}({types_of(found[3])})"])
    return "other", ""


def definitions(text):
    """The names of classes and functions that a file defines where others can take them for theirs."""
    code = re.sub(r"\s+", " ", NO_CODE.sub(" ", text))
    spaces, found, head = [], set(), ""  # spaces: names of the open namespaces, None of anything else
    for character in code:
        if character == "{":
            kind, name = kind_of(head.strip(), spaces)
            spaces.append(name if kind == "namespace" and name else None)
            if kind != "namespace" and name.startswith("contactsim::"):
                found.add(name)
            head = ""
        elif character == "}":
            if spaces:
                spaces.pop()
            head = ""
        else:
            head = "" if character == ";" else head + character
    return found


def find_doubles(files):
    """Names with the files that define them, of those in more than one.

    files  pairs of a path and a text
    """
    places = defaultdict(list)
    for path, text in files:
        for name in definitions(text):
            places[name].append(path)
    return {name: sorted(paths) for name, paths in sorted(places.items()) if len(paths) > 1}


SAMPLE = """// struct Comment {};
namespace contactsim {
namespace { struct Hidden { int a; }; int hidden(int x) { return x; } }
%s
static int local(int x) { return x; }
Shown::Shown() : a_{1}, b_(2) {}
}  // namespace contactsim
"""
# Definitions, and the name under which each is found.
PLANTED = {
    "struct Twice : Base { int a = 1'000; char b = '{'; };": "contactsim::Twice",
    "enum class Kind { a, b };": "contactsim::Kind",
    "namespace test { class Inner final { struct Nested {}; }; }": "contactsim::test::Inner",
    "std::vector<int> find_all(const std::string& name, int n) { return {}; }":
        "contactsim::find_all(const std::string&, int)",
}


def test_itself():
    """Finds what is planted in two files, and nothing in files that only look alike."""
    for planted, name in PLANTED.items():
        text = SAMPLE % planted
        doubles = find_doubles([("a.hpp", text), ("b.cpp", text)])
        assert doubles == {name: ["a.hpp", "b.cpp"]}, (planted, doubles)
    alike = [("a.cpp", SAMPLE % "class Declared; int of(double x) { return 1; }"),
             ("b.cpp", SAMPLE % "class Declared; int of(int x) { return 1; }")]
    assert not find_doubles(alike), find_doubles(alike)


def main():
    test_itself()
    root = Path(sys.argv[1])
    paths = [path for module in MODULES for path in sorted((root / module).rglob("*.?pp"))]
    if not paths:
        sys.exit(f"there are no sources in {root}")
    files = [(str(path.relative_to(root)), path.read_text()) for path in paths]
    doubles = find_doubles(files)
    for name, places in doubles.items():
        print(f"{name} is defined in {' and '.join(places)}")
    n_names = sum(len(definitions(text)) for _, text in files)
    print(f"{n_names} names in {len(files)} files, {len(doubles)} defined twice")
    sys.exit(1 if doubles or n_names < 1000 else 0)


if __name__ == "__main__":
    main()
