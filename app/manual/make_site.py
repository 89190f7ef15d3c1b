#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Makes the whole manual in HTML: what `contactsim manual html` writes, the pages of this folder, the theory of each
room from its README.md, and a gallery of decks that it runs. Needs cmark-gfm; pictures need VTK for Python and a display
or xvfb-run, and are left out without them, which is said.

usage: make_site.py PROGRAM FOLDER [--short]
  --short  runs of the gallery end after a tenth of their time, for tests
"""
import html
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

SOURCE = Path(__file__).resolve().parents[2]
PAGES = Path(__file__).resolve().parent / "pages"
# deck and mesh, what is drawn, what it is coloured by, from where it is seen, further arguments of the run
GALLERY = [("impact", "impact.e", "von_mises", (-1.0, -1.0, 0.8), ()),
           ("taylor_bar", "taylor_bar.e", "eqps", (1.0, 0.6, 0.35), ()),
           ("two_blocks", "surfaces.exo", "", (1.0, -1.2, 0.9), ("--tables", "--surfaces", "surfaces.exo"))]
ROOMS = ["core", "contact", "parser", "io", "app"]
LOG_LINES = 45


def all_pages():
    """Sources of pages and the names of what is made of them, in the order of the contents."""
    pages = {PAGES / "users_guide.md": "index.html", PAGES / "meshes.md": "meshes.html", PAGES / "cluster.md": "cluster.html",
             PAGES / "theory.md": "theory.html", SOURCE / "decks/VALIDATION.md": "validation.html"}
    for module in ROOMS:
        found = [SOURCE / module / "README.md"] + sorted((SOURCE / module).glob("*/README.md"))
        pages.update({path: "-".join(path.relative_to(SOURCE).parts[:-1]) + ".html" for path in found})
    return pages


def convert(path):
    command = ["cmark-gfm", "--unsafe", "-e", "table", str(path)]
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout


def anchor(heading):
    """As GitHub names the anchors of headings."""
    text = re.sub(r"<[^>]*>", "", heading).lower()
    return re.sub(r"[^a-z0-9_ -]", "", html.unescape(text)).replace(" ", "-")


def add_anchors(body):
    return re.sub(r"<h([1-6])>(.*?)</h\1>", lambda m: f'<h{m[1]} id="{anchor(m[2])}">{m[2]}</h{m[1]}>', body)


def turn_links(body, path, pages):
    """Links between sources lead to their pages; what has none is named without a link."""
    def turn(match):
        link, text = html.unescape(match[1]), match[2]
        target, _, place = link.partition("#")
        if "://" in link or not target or target in ("reference.html", "variables.html", "coming_from.html",
                                                     "command_line.html", "gallery.html"):
            return match[0]
        page = pages.get((path.parent / target).resolve())
        if page is None:
            return text
        return f'<a href="{page}{"#" + place if place else ""}">{text}</a>'
    return re.sub(r'<a href="([^"]*)">(.*?)</a>', turn, body, flags=re.DOTALL)


def title_of(body, name):
    heading = re.search(r"<h1[^>]*>(.*?)</h1>", body)
    return re.sub(r"<[^>]*>", "", heading[1]) if heading else name


class Frame:
    """The frame of the program's own pages, with the list of all pages."""

    def __init__(self, folder, titles):
        page = (folder / "command_line.html").read_text(encoding="utf-8")
        self.head, rest = page.split("<main>\n")
        self.tail = rest[rest.index("</main>"):]
        self.title = re.search(r"<title>(.*?) - contactsim", page)[1]
        links = {name: self.link(name, title) for name, title in titles.items()}
        rooms = [name for name in titles if name.split("-")[0].split(".")[0] in ROOMS]
        self.links = "".join(link for name, link in links.items() if name not in rooms)
        self.rooms = "".join(links[name] for name in rooms)

    @staticmethod
    def link(name, title):
        within = ' class="within"' if "-" in name else ""
        return f'<a{within} href="{name}">{html.escape(title.split("/")[-1])}</a>\n'

    def page(self, title, body):
        head = self.head.replace(f"<title>{self.title} ", f"<title>{html.escape(title)} ")
        return self.add_links(head + "<main>\n" + body + self.tail)

    def add_links(self, page):
        return page.replace("<!-- pages -->\n", self.links).replace("</nav>", self.rooms + "</nav>")


def head_of(deck):
    """What the comment at the head of a deck says, in paragraphs, without Aprepro."""
    lines = []
    for line in deck.splitlines():
        if not line.startswith("#"):
            break
        if not line.startswith("# {"):
            lines.append(line[1:].strip())
    return "".join(f"<p>{html.escape(part)}</p>\n" for part in "\n".join(lines).strip().split("\n\n"))


def draw(results, picture, colour, eye):
    """Whether there is a picture now."""
    command = ["/usr/bin/python3", str(SOURCE / "decks/draw.py"), results, picture, "--from", *map(str, eye)]
    if colour:
        command += ["--colour", colour]
    return subprocess.run(command, capture_output=True, check=False).returncode == 0 and os.path.exists(picture)


def end_early(deck):
    """Has a run end after a tenth of its time."""
    text = deck.read_text(encoding="utf-8")
    deck.write_text(re.sub(r"(termination time = )(\S+)", lambda m: m[1] + str(0.1 * float(m[2])), text),
                    encoding="utf-8")


def show_deck(program, folder, is_short, name, results, colour, eye, arguments):
    """Runs a deck in a folder of its own and tells of it."""
    work = folder / "gallery" / name
    work.mkdir(parents=True, exist_ok=True)
    for ending in ("i", "g"):
        shutil.copy(SOURCE / f"decks/{name}.{ending}", work)
    if is_short:
        end_early(work / f"{name}.i")
    subprocess.run([program, f"{name}.i", f"{name}.g", "--quiet", *arguments], cwd=work, check=True,
                   capture_output=True)
    deck = (work / f"{name}.i").read_text(encoding="utf-8")
    log = (work / f"{name}.log").read_text(encoding="utf-8").splitlines()
    picture = draw(str(work / results), str(work / f"{name}.png"), colour, eye)
    (work / results).unlink()
    if not picture:
        print(f"make_site.py: no picture of {name}: it takes VTK for Python and a display or xvfb-run", file=sys.stderr)
    end = "\n".join(log[-LOG_LINES:])
    image = f'<p><img src="gallery/{name}/{name}.png" alt="{name} at its end, coloured by {colour or "surface"}"></p>\n'
    return (f'<h2 id="{name}">{name}</h2>\n{head_of(deck)}{image if picture else ""}'
            f'<p><a href="gallery/{name}/{name}.i">deck</a>, <a href="gallery/{name}/{name}.g">mesh</a>, '
            f'<a href="gallery/{name}/{name}.log">log</a></p>\n'
            f'<details><summary>The deck</summary><pre>{html.escape(deck)}</pre></details>\n'
            f'<details><summary>The end of the log</summary><pre>{html.escape(end)}</pre></details>\n')


def main():
    program, folder = os.path.abspath(sys.argv[1]), Path(sys.argv[2])
    subprocess.run([program, "manual", "html", str(folder)], check=True)
    pages = all_pages()
    bodies = {name: turn_links(add_anchors(convert(path)), path, pages) for path, name in pages.items()}
    bodies["gallery.html"] = "<h1>Gallery</h1>\n" + "".join(
        show_deck(program, folder, "--short" in sys.argv[3:], *row) for row in GALLERY)
    order = ["index.html", "gallery.html"] + [name for name in bodies if name not in ("index.html", "gallery.html")]
    titles = {name: title_of(bodies[name], name) for name in order}
    own = list(folder.glob("*.html"))
    frame = Frame(folder, titles)
    for path in own:
        path.write_text(frame.add_links(path.read_text(encoding="utf-8")), encoding="utf-8")
    for name, body in bodies.items():
        (folder / name).write_text(frame.page(titles[name], body), encoding="utf-8")


if __name__ == "__main__":
    main()
