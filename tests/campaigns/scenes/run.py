# SPDX-License-Identifier: BSD-3-Clause
"""Runs a scene in a folder and reads what the run has left behind."""
import csv
import json
import math
import subprocess

import netCDF4
import numpy as np

from deck import deck_of, mesh_of, write_mesh

TIME_LIMIT = 60  # seconds of a run; scenes take a tenth of one


class Result:
    """Rows of the heartbeat, frames of the results, the summary. `code` is the exit code, -1 when the time was over."""

    def __init__(self, folder, code, output):
        self.folder, self.code, self.output = folder, code, output
        self.columns, self.frames, self.summary = {}, {}, {}
        if (folder / "summary.json").exists():
            self.summary = json.loads((folder / "summary.json").read_text())
        if code == 0:
            self._read_rows()
            self._read_frames()

    def _read_rows(self):
        with open(self.folder / "scene.csv", newline="") as file:
            rows = list(csv.reader(file))
        values = np.array(rows[1:], dtype=float).T
        self.columns = dict(zip([n.strip() for n in rows[0]], values))

    def _read_frames(self):
        with netCDF4.Dataset(self.folder / "scene.g") as mesh:
            n_nodes = len(mesh.dimensions["num_nodes"])  # behind them the results have a node for each rigid body
        with netCDF4.Dataset(self.folder / "scene.e") as file:
            file.set_auto_mask(False)
            self.times = file["time_whole"][:]
            for kind in ("nod", "glo"):
                names = netCDF4.chartostring(file[f"name_{kind}_var"][:])
                for number, name in enumerate(str(n).strip("\0 ") for n in names):
                    self.frames[name] = (file[f"vals_nod_var{number + 1}"][:, :n_nodes] if kind == "nod"
                                         else file["vals_glo_var"][:, number])

    def vector(self, name):
        """[frames x nodes x 3]"""
        return np.stack([self.frames[f"{name}_{c}"] for c in "xyz"], axis=-1)

    def single(self, name):
        """Every row of a vector of the heartbeat [rows x 3], or of one number."""
        if name in self.columns:
            return self.columns[name]
        return np.stack([self.columns[f"{name}_{c}"] for c in "xyz"], axis=-1)

    def warnings(self):
        return {w["id"] for w in self.summary.get("warnings", [])}

    def error(self):
        """The id or the text of the first error."""
        errors = self.summary.get("errors", [])
        return f"{errors[0]['id']}: {errors[0]['text']}" if errors else self.output[-300:]


def write_scene(folder, scene, points=None, blocks=None, order=None):
    """Writes scene.i and scene.g; points, blocks and their order may be those of a variant."""
    if points is None:
        points, blocks = mesh_of(scene)
    n_steps = max(1, math.ceil(scene["time"] / scene["step"]))
    (folder / "scene.i").write_text("\n".join(deck_of(scene, n_steps)) + "\n")
    write_mesh(folder / "scene.g", scene, points, blocks, order)


def run(program, folder, threads=1):
    """Runs scene.i of a folder."""
    command = [str(program), "scene.i", "--threads", str(threads), "--summary", "summary.json", "--quiet"]
    try:
        done = subprocess.run(command, cwd=folder, capture_output=True, text=True, timeout=TIME_LIMIT)
    except subprocess.TimeoutExpired:
        return Result(folder, -1, "")
    return Result(folder, done.returncode, done.stdout + done.stderr)
