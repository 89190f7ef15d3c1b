#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Reports in a headless Chromium: they load without a word on the console and without the network, show the numbers
of the run, turn, play, tell about a face, fit a narrow screen and the dark, and stand side by side.

    report_in_browser.py PROGRAM ROOT [--large] [--pictures FOLDER]

--large tests a model of 100,000 faces instead: size of the file, time to load.
"""
import argparse
import csv
import json
import re
import shutil
import subprocess
import tempfile
from pathlib import Path

import netCDF4
import numpy

from browser import Browser, find_browser

MAX_BYTES, MAX_LOAD_SECONDS = 5_000_000, 20.0  # of a software renderer on a busy machine; 2 s on a free one
CHOOSE = "(id, value) => {{ const e = document.getElementById(id); e.value = value; e.dispatchEvent(new Event('{}')); }}"


class Page:
    """A report in the browser."""

    def __init__(self, browser, path, pictures):
        self.browser, self.path, self.pictures = browser, Path(path), pictures
        browser.problems.clear()
        browser.requests.clear()
        self.load_seconds = browser.open(path)
        self.check_silence()
        assert browser.requests == [self.path.resolve().as_uri()], browser.requests

    def check_silence(self):
        assert not self.browser.problems, self.browser.problems

    def value(self, expression):
        return self.browser.run(expression)

    def choose(self, control, value, event="change"):
        self.value(f"({CHOOSE.format(event)})({json.dumps(control)}, {json.dumps(value)})")

    def canvas(self, panel=0):
        """Left, top, width and height of a view that has been scrolled into sight."""
        self.value(f"report.panels[{panel}].canvas.scrollIntoView({{block: 'center', behavior: 'instant'}})")
        return self.value(f"(({{x, y, width, height}}) => [x, y, width, height])"
                          f"(report.panels[{panel}].canvas.getBoundingClientRect())")

    def colours(self, panel=0):
        """How many colours a view has that are not its background."""
        return self.value(f"""(() => {{
          const {{ view }} = report.panels[{panel}];
          view.draw_now();
          const copy = document.createElement('canvas');
          [copy.width, copy.height] = [view.canvas.width, view.canvas.height];
          const context = copy.getContext('2d');
          context.drawImage(view.canvas, 0, 0);
          const {{ data }} = context.getImageData(0, 0, copy.width, copy.height);
          const seen = new Set();
          for (let i = 0; i < data.length; i += 4) {{
            if (data[i + 3] > 0) seen.add(data[i] << 16 | data[i + 1] << 8 | data[i + 2]);
          }}
          return seen.size;
        }})()""")

    def picture(self, name):
        data = self.browser.picture()
        assert len(data) > 5000, "the picture is empty"
        if self.pictures:
            (self.pictures / f"{name}.png").write_bytes(data)


def run(program, folder, *arguments):
    done = subprocess.run([program, *arguments], cwd=folder, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr


def make_runs(program, root, folder):
    """Two short impacts, the second slower, and their reports."""
    for name in ("fast", "slow"):
        (folder / name).mkdir()
        shutil.copy(root / "decks/impact.g", folder / name)
        deck = (root / "decks/impact.i").read_text().replace("termination time = 120e-6", "termination time = 24e-6")
        (folder / name / "impact.i").write_text(deck)
    run(program, folder / "fast", "impact.i", "--report", "impact.html", "--quiet")
    run(program, folder / "slow", "impact.i", "-D", "speed=40", "--summary", "impact.json", "--quiet")
    run(program, folder, "report", "fast/impact.e", "slow/impact.e", "-o", "two.html")


def check_numbers(page, folder):
    """Moved points and stresses of the page are those of the results file."""
    with netCDF4.Dataset(folder / "impact.e") as file:
        names = [b"".join(row).split(b"\0")[0].decode() for row in file["name_nod_var"][:].filled(b"")]
        moved = [file[f"vals_nod_var{names.index(f'displacement_{axis}') + 1}"][-1] for axis in "xyz"]
        start = [file[f"coord{axis}"][:] for axis in "xyz"]
        connectivity = file["connect2"][:]
        stress = file["vals_elem_var1eb2"][-1]
        first_of_ball = len(file["connect1"])
    shown = page.value("""(() => {
      const { run: { mesh, frames }, view } = report.panels[0];
      const face = mesh.faces.element.indexOf(2401 + 863);
      const field = frames.fields.find(({ name }) => name === 'von_mises');
      const code = field.codes[view.frame * field.columns + face];
      return { stress: field.first + field.step * (code - 1), range: field.highest - field.first,
        points: mesh.faces.corners.map((list) =>
          [0, 1, 2].map((axis) => view.point[3 * list[face] + axis] + mesh.middle[axis])) };
    })()""")
    element = 2401 + 863 - first_of_ball - 1
    assert abs(shown["stress"] - stress[element]) < shown["range"] / 4000, (shown["stress"], stress[element])
    nodes = numpy.array(start)[:, connectivity[element] - 1] + numpy.array(moved)[:, connectivity[element] - 1]
    for point in shown["points"]:
        assert numpy.abs(nodes.T - point).max(axis=1).min() < 1e-5, point  # of a model of 0.06


def check_one(browser, folder, pictures):
    page = Page(browser, folder / "fast/impact.html", pictures)
    text = page.value("document.body.innerText")
    for wanted in ("ball on plate", "Deepest penetration", "surface 'plate': 96 faces already in surface 'patch'",
                   "Claims lost to earlier surfaces", "begin sierra ball on plate"):
        assert wanted in text, wanted
    assert re.search(r"three\.js r\d+", page.value("document.getElementById('licences').textContent"))
    check_numbers(page, folder / "fast")
    with open(folder / "fast/impact.csv") as file:
        rows = list(csv.reader(file, skipinitialspace=True))
    force = page.value("Chart.getChart(document.querySelectorAll('#charts canvas')[5]).data.datasets[2].data.at(-1)")
    assert abs(force["y"] - float(rows[-1][rows[0].index("force_z")])) < 1e-3 * abs(force["y"]), force
    page.picture("start")
    check_view(page)
    check_screens(page)
    page.check_silence()


def check_view(page):
    left, top, width, height = page.canvas()
    assert page.colours() > 50, "the view is empty"
    page.value("report.look_along('z')")
    page.browser.click(left + width / 2, top + height / 2)
    facts = page.value("report.panels[0].facts.innerText")
    assert re.search(r"Element\s+\d+ of (ball|plate) \(HEX8\)\s+Side\s+\d\s+Surface\s+(ball|patch|plate)", facts), facts
    page.value("document.querySelector('.find input').value = '2096'")
    page.value("document.querySelector('.find').requestSubmit()")
    assert "2096 of plate" in page.value("report.panels[0].facts.innerText")
    lost = page.value("""(() => {
      const { mesh } = report.panels[0].run;
      report.panels[0].pick(mesh.faces.owner.indexOf(1));
      return report.panels[0].facts.innerText;
    })()""")
    assert "plate claimed it, patch has it" in lost, lost
    before = page.value("report.panels[0].view.camera.position.toArray()")
    page.browser.drag((left + 200, top + 200), (left + 320, top + 150))
    after = page.value("report.panels[0].view.camera.position.toArray()")
    assert numpy.linalg.norm(numpy.subtract(before, after)) > 0.1 * numpy.linalg.norm(before), "it does not turn"
    page.value("report.panels[0].canvas.focus()")
    page.browser.call("Input.dispatchKeyEvent", type="keyDown", key="ArrowLeft", code="ArrowLeft")
    assert page.value("report.panels[0].view.camera.position.toArray()") != after, "keys do not turn it"
    page.choose("colour", "von_mises")
    page.choose("time", "0", "input")
    assert page.value("report.panels[0].view.frame") == 0
    start = page.value("Array.from(report.panels[0].view.point.slice(0, 300))")
    page.choose("time", "6", "input")
    assert page.value("Array.from(report.panels[0].view.point.slice(-300))") != start
    assert page.colours() > 50
    page.picture("von_mises")


def check_screens(page):
    browser = page.browser
    ground = "getComputedStyle(document.documentElement).backgroundColor"
    light = page.value(ground)
    browser.prefer("dark")
    assert page.value(ground) != light
    page.picture("dark")
    browser.resize(400, 800)
    browser.wait_for("report.panels[0].canvas.clientWidth < 400")
    browser.wait_for("document.documentElement.scrollWidth <= 400", 10)  # curves follow a little later
    page.canvas()
    page.picture("small")
    browser.prefer("light")
    browser.resize(1280, 900)


def check_two(browser, folder, pictures):
    page = Page(browser, folder / "two.html", pictures)
    assert page.value("report.panels.length") == 2
    left, top, _, _ = page.canvas(0)
    page.browser.drag((left + 100, top + 100), (left + 220, top + 130))
    cameras = page.value("report.panels.map(({ view }) => view.camera.position.toArray())")
    assert numpy.allclose(*cameras), "the views do not turn together"
    page.choose("colour", "pressure")
    ranges = page.value("report.panels.map(({ legend }) => legend.innerText)")
    assert ranges[0] == ranges[1], ranges
    page.choose("time", "3", "input")
    assert page.value("report.panels.map(({ view }) => view.frame)") == [3, 3]
    assert page.colours(0) > 50 and page.colours(1) > 50
    page.picture("two")
    page.check_silence()


GRAINS_MESH = """$MeshFormat
2.2 0 8
$EndMeshFormat
$PhysicalNames
3
1 1 "rod"
0 2 "grains"
2 3 "sheet"
$EndPhysicalNames
$Nodes
8
1 0 0 0
2 1 0 0
3 1 1 0
4 0 1 0
5 0.2 0.5 0.3
6 0.8 0.5 0.3
7 0.1 0.8 0.2
8 0.9 0.8 0.2
$EndNodes
$Elements
4
1 3 2 3 1 1 2 3 4
2 15 2 2 2 5
3 15 2 2 3 6
4 1 2 1 4 7 8
$EndElements
"""
GRAINS_DECK = """begin sierra grains
begin material m
density = 1000
begin parameters for model elastic
youngs modulus = 1e7
poissons ratio = 0
end
end
begin shell section thin
thickness = 0.01
end
begin particle section ball
radius = 0.1
end
begin truss section round
area = 1e-4
end
begin finite element model f
begin parameters for block sheet
material = m
model = elastic
section = thin
end
begin parameters for block grains
material = m
model = elastic
section = ball
end
begin parameters for block rod
material = m
model = elastic
section = round
end
end
begin presto procedure p
begin time control
begin time stepping block t
start time = 0
end
termination time = 1e-4
end
begin presto region r
use finite element model f
begin contact definition
skin all blocks = on
begin interaction defaults
general contact = on
end
end
begin results output
database name = grains.e
at time 0 increment = 1e-4
nodal displacement
end
end
end
end
"""


def check_grains(browser, program, folder, pictures):
    """Particles are drawn as balls of their radius; they and lines can be picked where they are seen."""
    (folder / "grains.msh").write_text(GRAINS_MESH)
    (folder / "grains.i").write_text(GRAINS_DECK)
    run(program, folder, "mesh", "grains.msh", "grains.g")
    run(program, folder, "grains.i", "grains.g", "--report", "grains.html", "--quiet")
    page = Page(browser, folder / "grains.html", pictures)
    left, top, width, height = page.canvas()
    page.value("report.look_along('z')")

    def facts_at(x, y, z):
        """What a click on a point of the model tells."""
        across, down = page.value(f"""(() => {{
          const {{ view, run: {{ mesh }} }} = report.panels[0];
          view.camera.updateMatrixWorld();
          const at = new THREE.Vector3({x} - mesh.middle[0], {y} - mesh.middle[1], {z} - mesh.middle[2]).project(view.camera);
          return [(1 + at.x) / 2, (1 - at.y) / 2];
        }})()""")
        page.browser.click(left + across * width, top + down * height)
        return page.value("report.panels[0].facts.innerText")

    grain = facts_at(0.2 + 0.07, 0.5, 0.3)  # within its radius, far beyond the pixels of a dot
    assert re.search(r"Element\s+2 of grains \(SPHERE\)\s+Surface\s+grains\s+Radius\s+0\.1\b", grain), grain
    assert page.value("report.panels[0].picked") is None
    rod = facts_at(0.5, 0.8, 0.2)
    assert re.search(r"Element\s+4 of rod \(\w+\)\s+Surface\s+rod", rod), rod
    sheet = facts_at(0.5, 0.2, 0.0)
    assert "1 of sheet" in sheet, sheet
    page.value("document.querySelector('.find input').value = '3'")
    page.value("document.querySelector('.find').requestSubmit()")
    assert "3 of grains" in page.value("report.panels[0].facts.innerText")
    page.picture("grains")
    page.check_silence()


def check_large(browser, program, folder, pictures):
    subprocess.run(["/usr/bin/python3", Path(__file__).with_name("large_results.py"), folder / "large.e"], check=True)
    run(program, folder, "report", "large.e")
    size = (folder / "large.html").stat().st_size
    page = Page(browser, folder / "large.html", pictures)
    n_faces, n_times = page.value("[report.panels[0].run.mesh.faces.n, report.times.length]")
    print(f"{n_faces} faces, {n_times} times: {size} bytes, loaded in {page.load_seconds:.1f} s")
    assert n_faces > 100_000 and n_times >= 5
    assert size <= MAX_BYTES, size
    assert page.load_seconds < MAX_LOAD_SECONDS
    assert page.colours() > 50
    left, top, width, height = page.canvas()
    page.browser.click(left + width / 2, top + height / 2)
    assert "(HEX8)" in page.value("report.panels[0].facts.innerText")
    page.picture("large")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program", type=lambda text: str(Path(text).resolve()))
    parser.add_argument("root", type=Path)
    parser.add_argument("--large", action="store_true")
    parser.add_argument("--pictures", type=Path)
    asked = parser.parse_args()
    with tempfile.TemporaryDirectory() as name, Browser(find_browser()) as browser:
        folder = Path(name)
        browser.resize(1280, 900)
        if asked.large:
            check_large(browser, asked.program, folder, asked.pictures)
            return
        make_runs(asked.program, asked.root, folder)
        check_one(browser, folder, asked.pictures)
        check_two(browser, folder, asked.pictures)
        check_grains(browser, asked.program, folder, asked.pictures)


if __name__ == "__main__":
    main()
