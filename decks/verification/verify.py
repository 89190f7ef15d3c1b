#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the verification decks of this folder and compares what they reach with what they should.

  verify.py PROGRAM [CASE ...]   run the cases (all of them by default); fails when a number misses
  verify.py PROGRAM --table      write decks/VALIDATION.md from all cases and the refined meshes
  verify.py --meshes FOLDER      only make the meshes, to run a deck by hand

Everything is run in a temporary folder.
"""
import csv
import math
import subprocess
import sys
import tempfile
from pathlib import Path

import netCDF4
import numpy as np

sys.dont_write_bytecode = True  # decks/ may be read-only
HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
import make_meshes  # noqa: E402
from mesh_maker import MeshMaker  # noqa: E402


class Check:
    """A number that a run should reach, within a share of it or of a scale."""

    def __init__(self, quantity, expected, reached, tolerance, scale=None):
        self.quantity, self.expected, self.reached, self.tolerance = quantity, expected, reached, tolerance
        self.error = (reached - expected) / (abs(expected) if scale is None else scale)

    def holds(self):
        return abs(self.error) <= self.tolerance


def brick(name, size, cells, sets):
    mesh = MeshMaker()
    mesh.hexes(name, (0, 0, 0), size, cells)
    for set_name, is_in in sets.items():
        mesh.node_set(set_name, is_in)
    return mesh


def read_columns(path):
    with open(path, newline="") as file:
        rows = list(csv.reader(file))
    names = [name.strip() for name in rows[0]]
    return dict(zip(names, np.array(rows[1:], dtype=float).T))


def crossing(times, values, level):
    """The first time at which the values pass the level, by linear interpolation."""
    i = int(np.argmax(values >= level))
    return times[i - 1] + (level - values[i - 1]) / (values[i] - values[i - 1]) * (times[i] - times[i - 1])


def energy_check(columns, terms):
    largest = max(np.max(np.abs(columns[term])) for term in terms)
    return Check("energy balance", 0.0, np.max(np.abs(columns["energy_error"])), 0.005, largest)


class Bar:
    """Elements of steel in uniaxial strain."""
    density, bulk, shear = 7800.0, 200e9 / (3 * 0.4), 200e9 / 2.6
    modulus = bulk + 4 / 3 * shear
    speed = math.sqrt(modulus / density)


def wave_in_bar_mesh(n):
    return brick("bar", (2, 0.1, 0.1), (n, 1, 1), {"wall": lambda x, y, z: x == 0})


def wave_in_bar(folder):
    columns = read_columns(folder / "wave_in_bar.csv")
    best = np.argmax(columns["tip"])
    arrival = 2.0 / math.sqrt(3e12 / 7.8)
    return [Check("largest displacement of the free end", 1000 * arrival, columns["tip"][best], 0.01),
            Check("time of it", arrival, columns["Time"][best], 0.01), energy_check(columns, ["kinetic_energy"])]


def pushed_bar_mesh(n):
    return brick("bar", (1, 1 / n, 1 / n), (n, 1, 1), {"pushed": lambda x, y, z: x == 0})


def confined_bar(folder):
    columns = read_columns(folder / "confined_bar.csv")
    times = columns["Time"]
    behind = (times > 0.4 / Bar.speed) & (times < 0.8 / Bar.speed)
    return [Check("arrival in the middle", 0.5 / Bar.speed, crossing(times, columns["middle_velocity"], 0.5), 0.01),
            Check("stress behind the front", -Bar.density * Bar.speed, np.mean(columns["stress"][behind]), 0.01),
            energy_check(columns, ["external_energy"])]


def elastic_plastic_bar(folder):
    columns = read_columns(folder / "elastic_plastic_bar.csv")
    yield_stress, hardening, velocity = 400e6, 10e9, 100.0
    plastic = Bar.bulk + 4 / 3 * Bar.shear * hardening / (3 * Bar.shear + hardening)
    plastic_speed = math.sqrt(plastic / Bar.density)
    elastic_stress = yield_stress * Bar.modulus / (2 * Bar.shear)
    elastic_velocity = elastic_stress / (Bar.density * Bar.speed)
    stress = elastic_stress + Bar.density * plastic_speed * (velocity - elastic_velocity)
    times = columns["Time"]
    behind = (times > 0.4 / plastic_speed) & (times < 0.6 / plastic_speed)
    plateau = 0.5 * (elastic_velocity + velocity)
    middle = columns["middle_velocity"]
    return [Check("arrival of the elastic front", 0.5 / Bar.speed, crossing(times, middle, 0.5 * elastic_velocity), 0.02),
            Check("arrival of the plastic front", 0.5 / plastic_speed, crossing(times, middle, plateau), 0.02),
            Check("stress behind both", -stress, np.mean(columns["stress"][behind]), 0.01),
            energy_check(columns, ["external_energy"])]


def cantilever_mesh(n):
    return brick("beam", (1, 0.05, 0.1 / 2), (10 * n, 1, n), {"clamped": lambda x, y, z: x == 0})


def cantilever(folder):
    columns = read_columns(folder / "cantilever.csv")
    tip, times = columns["tip"], columns["Time"]
    rising = [i for i in range(1, len(tip)) if tip[i - 1] < 0 <= tip[i]]
    zeros = [0.0] + [times[i - 1] - tip[i - 1] / (tip[i] - tip[i - 1]) * (times[i] - times[i - 1]) for i in rising]
    period = (zeros[-1] - zeros[0]) / (len(zeros) - 1)
    exact = 1.875104 ** 2 / (2 * math.pi) * math.sqrt(200e9 / 7800 * 0.05 ** 2 / 12)
    return [Check("frequency [Hz]", exact, 1 / period, 0.03), energy_check(columns, ["kinetic_energy"])]


def spinning_body_mesh(n):
    return brick("body", (0.2, 0.1, 0.05), (4 * n, 2 * n, n), {})


def spinning_body(folder):
    with netCDF4.Dataset(folder / "spinning_body.e") as file:
        names = [name.decode().strip("\0 ") for name in netCDF4.chartostring(file["name_nod_var"][:]).astype("S")]
        elements = [name.decode().strip("\0 ") for name in netCDF4.chartostring(file["name_elem_var"][:]).astype("S")]
        globals_ = [name.decode().strip("\0 ") for name in netCDF4.chartostring(file["name_glo_var"][:]).astype("S")]

        def nodal(name, step):
            return np.asarray(file[f"vals_nod_var{names.index(name) + 1}"][step])

        def angular_momentum(step):
            x = np.array([file["coord" + c][:] + nodal("displacement_" + c, step) for c in "xyz"])
            v = np.array([nodal("velocity_" + c, step) for c in "xyz"])
            return np.sum(nodal("mass", step) * np.cross(x, v, axis=0), axis=1)

        start, end = angular_momentum(0), angular_momentum(-1)
        stress = np.max(file[f"vals_elem_var{elements.index('von_mises') + 1}eb1"][-1])
        energies = file["vals_glo_var"][:]
        kinetic = energies[0, globals_.index("kinetic_energy")]
        error = energies[-1, globals_.index("energy_error")]
    return [Check("change of angular momentum", 0.0, np.linalg.norm(end - start), 1e-9, np.linalg.norm(start)),
            Check("largest von Mises stress [Pa]", 0.0, stress, 31e6, 1.0),
            Check("energy balance", 0.0, error, 0.001, kinetic)]


def thick_cylinder_mesh(n):
    def place(r, angle, z):
        return (r * math.cos(angle), r * math.sin(angle), z)

    mesh = MeshMaker(place)
    first = mesh.hexes("pipe", (1, 0, 0), (1, math.pi / 2, 0.1), (n, 2 * n, 1))
    mesh.node_set("on_x", lambda r, angle, z: angle == 0)
    mesh.node_set("on_y", lambda r, angle, z: abs(angle - math.pi / 2) < 1e-8)
    mesh.side_set("inside", [(first + n * j, 4) for j in range(2 * n)])
    return mesh


def thick_cylinder(folder):
    columns = read_columns(folder / "thick_cylinder.csv")
    late = columns["Time"] > 0.012
    a, b, p, nu, modulus = 1.0, 2.0, 1e6, 0.3, 200e9
    displacement = p * a * (1 + nu) / modulus * (a * a * (1 - 2 * nu) + b * b) / (b * b - a * a)
    with netCDF4.Dataset(folder / "thick_cylinder.e") as file:
        n = round(math.sqrt(file.dimensions["num_elem"].size / 2))
    # The mean stress of an element's middle: the mean of p a^2/(b^2 - a^2) (1 + b^2/r^2) over its thickness.
    outer = a + (b - a) / n
    hoop = p * a * a / (b * b - a * a) * (1 + b * b / (a * outer))
    return [Check("displacement of the inner wall", displacement, np.mean(columns["inner"][late]), 0.01),
            Check("hoop stress of the innermost elements", hoop, np.mean(columns["hoop"][late]), 0.03),
            energy_check(columns, ["external_energy"])]


def taylor_bar(folder):
    columns = read_columns(folder / "taylor_bar.csv")
    return [Check("length [m]", 21.5e-3, columns["length"][-1], 0.03),
            Check("radius of the foot [m]", 7.1e-3, columns["foot_radius"][-1], 0.03),
            energy_check(columns, ["kinetic_energy"])]


# Each case: its mesh by refinement, the refinement that is tested, what its run must reach, refinements of the table.
CASES = {
    "wave_in_bar": (wave_in_bar_mesh, 100, wave_in_bar, []),
    "confined_bar": (pushed_bar_mesh, 100, confined_bar, [25, 50, 100, 200, 400]),
    "elastic_plastic_bar": (pushed_bar_mesh, 200, elastic_plastic_bar, []),
    "cantilever": (cantilever_mesh, 4, cantilever, [2, 4, 8]),
    "spinning_body": (spinning_body_mesh, 2, spinning_body, []),
    "thick_cylinder": (thick_cylinder_mesh, 16, thick_cylinder, [4, 8, 16, 32]),
    "taylor_bar": (make_meshes.taylor_bar, 4, taylor_bar, [3, 4, 6]),
}


def deck_of(case):
    """In this folder, or the one above."""
    own = HERE / f"{case}.i"
    return own if own.exists() else HERE.parent / own.name


def run(program, case, refinement):
    """Runs a case; returns its checks."""
    make_mesh, _, evaluate, _ = CASES[case]
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        make_mesh(refinement).write(folder / f"{case}.g")
        done = subprocess.run([program, str(deck_of(case))], cwd=folder, capture_output=True, text=True)
        if done.returncode != 0:
            sys.exit(f"{case}: exit code {done.returncode}\n{done.stdout}{done.stderr}")
        return evaluate(folder)


def row(check):
    return f"{check.quantity} | {check.expected:.6g} | {check.reached:.6g} | {check.error:+.2e} | {check.tolerance:.0e}"


def run_cases(program, cases):
    failed = False
    for case in cases:
        for check in run(program, case, CASES[case][1]):
            print(f"{'ok  ' if check.holds() else 'MISS'} {case}: {row(check)}")
            failed |= not check.holds()
    return 1 if failed else 0


def write_table(program):
    lines = ["# Verification", "", "What the decks of `decks/verification` should reach and do. Errors are relative. Made by",
             "`decks/verification/verify.py PROGRAM --table`.", "",
             "| case | quantity | expected | reached | error | tolerance |", "| --- | --- | --- | --- | --- | --- |"]
    for case, (_, refinement, _, _) in CASES.items():
        lines += [f"| {case} | {row(check)} |" for check in run(program, case, refinement)]
    lines += ["", "## Refined meshes", "",
              "Errors of the first quantities of a case by its number of elements: along the bar, over the beam's thickness,",
              "through the wall, across the core of the rod.", "", "| case | elements | quantity | expected | reached | error |",
              "| --- | --- | --- | --- | --- | --- |"]
    for case, (_, _, _, refinements) in CASES.items():
        for refinement in refinements:
            for check in run(program, case, refinement)[:-1]:
                lines.append(f"| {case} | {refinement} | {check.quantity} | {check.expected:.6g} | {check.reached:.6g} "
                             f"| {check.error:+.2e} |")
    (HERE.parent / "VALIDATION.md").write_text("\n".join(lines) + "\n")


def main(arguments):
    if not arguments or arguments == ["--meshes"]:
        sys.exit(__doc__)
    if arguments[0] == "--meshes":
        for case, (make_mesh, refinement, _, _) in CASES.items():
            make_mesh(refinement).write(Path(arguments[1]) / f"{case}.g")
        return 0
    program = str(Path(arguments[0]).resolve())
    if arguments[1:] == ["--table"]:
        return write_table(program)
    return run_cases(program, arguments[1:] or CASES)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
