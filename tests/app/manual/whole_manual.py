#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Makes the whole manual and follows its links.

usage: whole_manual.py PROGRAM SOURCES
"""
import os
import subprocess
import sys
import tempfile
from pathlib import Path

import manual_files


def main():
    program, sources, problems = os.path.abspath(sys.argv[1]), Path(sys.argv[2]), []
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([sys.executable, str(sources / "app/manual/make_site.py"), program, folder, "--short"], check=True)
        manual_files.check_links(folder, problems)
        pages = sorted(name for name in os.listdir(folder) if name.endswith(".html"))
        for name in pages:
            text = (Path(folder) / name).read_text(encoding="utf-8")
            problems += [f"{name} does not list {other}" for other in pages if f'href="{other}"' not in text]
        # A page for each room that has theory, and what the deck of the gallery says at its end.
        for room in sources.glob("*/*/README.md"):
            page = "-".join(room.relative_to(sources).parts[:-1]) + ".html"
            if room.parts[-3] in ("core", "contact", "parser", "io", "app") and page not in pages:
                problems.append(f"no page of {room}")
        gallery = (Path(folder) / "gallery.html").read_text(encoding="utf-8")
        for part in ("begin contact definition", "Contact of pairs in the run", "gallery/taylor_bar/taylor_bar.i"):
            if part not in gallery:
                problems.append(f"the gallery lacks {part}")
    print("\n".join(problems))
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
