# SPDX-License-Identifier: BSD-3-Clause
"""Runs decks in folders of their own and reads what they write."""
import csv
import shutil
import subprocess
import sys
from pathlib import Path

import netCDF4
import numpy as np

HERE = Path(__file__).resolve().parent
LINE_WIDTH = 120


class Check:
    """A number that a run should reach, within a share of it or of a scale.

    A known miss has the bound that it must not pass all the same; the deck's head says why it misses.
    """

    def __init__(self, quantity, expected, reached, tolerance, scale=None, known_miss=None):
        self.quantity, self.expected, self.reached, self.tolerance = quantity, expected, reached, tolerance
        self.error = (reached - expected) / (abs(expected) if scale is None else scale)
        self.bound = tolerance if known_miss is None else known_miss

    def holds(self):
        return abs(self.error) <= self.tolerance

    def is_bearable(self):
        return abs(self.error) <= self.bound

    def short_row(self):
        return f"{self.quantity} | {self.expected:.6g} | {self.reached:.6g} | {self.error:+.2e}"

    def row(self):
        return f"{self.short_row()} | {self.tolerance:.2g}{'' if self.holds() else ' **miss**'}"


def at_most(quantity, reached, limit, **known):
    """A number that should not pass a limit."""
    return Check(quantity, 0.0, reached, limit, 1.0, **known)


def find_wide_line(text):
    """A line beyond what the log and tables keep to, but for one that a long word makes so; else None."""
    for line in text.splitlines():
        if len(line) > LINE_WIDTH and max(map(len, line.split())) < LINE_WIDTH // 2:
            return line
    return None


class Run:
    """What a finished run has left behind."""

    def __init__(self, folder, deck, log):
        self.folder, self.deck, self.log = folder, deck, log
        self._columns, self._nodal = None, {}

    @property
    def columns(self):
        """The columns of the heartbeat file by their names."""
        if self._columns is None:
            with open(self.folder / f"{self.deck}.csv", newline="") as file:
                rows = list(csv.reader(file))
            self._columns = dict(zip([n.strip() for n in rows[0]], np.array(rows[1:], dtype=float).T))
        return self._columns

    def __getitem__(self, column):
        return self.columns[column]

    def _open(self):
        return netCDF4.Dataset(self.folder / f"{self.deck}.e")

    @staticmethod
    def _names(file, variable):
        if variable not in file.variables:
            return []
        return [name.decode().strip("\0 ") for name in netCDF4.chartostring(file[variable][:]).astype("S")]

    @property
    def times(self):
        with self._open() as file:
            return np.asarray(file["time_whole"][:])

    def nodal(self, name):
        """[steps x nodes], of a vector [steps x nodes x 3]."""
        if name not in self._nodal:
            with self._open() as file:
                names = self._names(file, "name_nod_var")
                found = [name] if name in names else [f"{name}_{c}" for c in "xyz"]
                values = [np.asarray(file[f"vals_nod_var{names.index(f) + 1}"][:]) for f in found]
            self._nodal[name] = values[0] if len(values) == 1 else np.stack(values, axis=-1)
        return self._nodal[name]

    def element(self, name, block):
        """[steps x elements] of a block, counted from 1."""
        with self._open() as file:
            names = self._names(file, "name_elem_var")
            return np.asarray(file[f"vals_elem_var{names.index(name) + 1}eb{block}"][:])

    def single(self, name):
        """[steps] of a global variable of the results file."""
        with self._open() as file:
            return np.asarray(file["vals_glo_var"][:, self._names(file, "name_glo_var").index(name)])

    def nodes_of(self, block):
        """Nodes from 0 of a block, counted from 1."""
        with self._open() as file:
            return np.unique(np.asarray(file[f"connect{block}"][:])) - 1

    @property
    def start(self):
        """Coordinates of the mesh [nodes x 3]."""
        with self._open() as file:
            return np.stack([np.asarray(file["coord" + c][:]) for c in "xyz"], axis=-1)

    def momentum(self, block):
        """[steps x 3]"""
        nodes = self.nodes_of(block)
        return np.einsum("sn,snc->sc", self.nodal("mass")[:, nodes], self.nodal("velocity")[:, nodes])

    def mass(self, block):
        return np.sum(self.nodal("mass")[0, self.nodes_of(block)])

    def contact_force(self, block):
        """[steps x 3]"""
        return np.sum(self.nodal("force_contact")[:, self.nodes_of(block)], axis=1)


class Bench:
    """Runs decks of this folder in a temporary one."""

    def __init__(self, program, folder):
        self.program, self.folder, self.n_runs = program, Path(folder), 0
        self.threads = 1  # small meshes gain nothing by more, and tests run side by side

    def run(self, deck, mesh, /, **variables):
        """Runs <deck>.i on a mesh, with Aprepro variables; a run that fails ends everything."""
        folder, command = self.prepare(deck, mesh, **variables)
        return Run(folder, deck, self.execute(folder, command))

    def prepare(self, deck, mesh, /, **variables):
        """The folder and the command of a run."""
        folder = self._new_folder()
        for included in HERE.glob("*.inc"):
            shutil.copy(included, folder)
        mesh.write(folder / f"{deck}.g")
        return folder, self._command(deck, self.threads, variables)

    def copy(self, run, deck, /, threads, **variables):
        """The same in a copy of the folder of a run."""
        folder = self._new_folder()
        shutil.copytree(run.folder, folder, dirs_exist_ok=True)
        return folder, self._command(deck, threads, variables)

    @staticmethod
    def execute(folder, command):
        """Returns what the run prints."""
        done = subprocess.run(command, cwd=folder, capture_output=True, text=True)
        if done.returncode != 0:
            sys.exit(f"{' '.join(command)}: exit code {done.returncode}\n{done.stdout}{done.stderr}")
        wide = find_wide_line("\n".join([done.stdout, *(log.read_text() for log in folder.glob("*.log"))]))
        if wide is not None:
            sys.exit(f"{' '.join(command)}: more than {LINE_WIDTH} columns\n{wide}")
        return done.stdout

    def _new_folder(self):
        self.n_runs += 1
        folder = self.folder / str(self.n_runs)
        folder.mkdir()
        return folder

    def _command(self, deck, threads, variables):
        path = HERE / f"{deck}.i"
        command = [self.program, str(path if path.exists() else HERE.parent / path.name), "--threads", str(threads)]
        for name, value in variables.items():
            command += ["-D", f"{name}={value!r}" if isinstance(value, float) else f"{name}={value}"]
        return command
