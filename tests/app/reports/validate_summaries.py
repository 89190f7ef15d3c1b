#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Summaries of runs, checks and failures are as app/reports/summary.schema.json says.

    validate_summaries.py PROGRAM ROOT
"""
import json
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

import jsonschema

RUNS = (
    ("two_blocks", ["two_blocks.i", "two_blocks.g"]),
    ("two_blocks", ["two_blocks.i", "two_blocks.g", "--check", "-D", "order=2"]),
    ("two_blocks", ["two_blocks.i", "--parse"]),
    ("two_blocks", ["two_blocks.i", "none.g"]),
    ("two_blocks", ["wrong.i"]),
)


def refuse_constant(name):
    raise ValueError(f"{name} is no JSON")


def main():
    program, root = sys.argv[1], Path(sys.argv[2])
    schema = json.loads((root / "app/reports/summary.schema.json").read_text())
    jsonschema.Draft202012Validator.check_schema(schema)
    validator = jsonschema.Draft202012Validator(schema)
    for deck, arguments in RUNS:
        with tempfile.TemporaryDirectory() as folder:
            for end in (".i", ".g"):
                shutil.copy(root / "decks" / (deck + end), folder)
            (Path(folder) / "wrong.i").write_text("begin sierra\n  bogus = 3\nend\n")
            run = subprocess.run([program, *arguments, "--summary", "s.json"], cwd=folder, capture_output=True)
            text = (Path(folder) / "s.json").read_text()
            summary = json.loads(text, parse_constant=refuse_constant)
            validator.validate(summary)
            assert summary["exit_code"] == run.returncode, (arguments, summary["exit_code"], run.returncode)
    summary.pop("errors")
    assert not validator.is_valid(summary), "the schema takes anything"


if __name__ == "__main__":
    main()
