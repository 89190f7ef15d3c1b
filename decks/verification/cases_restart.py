# SPDX-License-Identifier: BSD-3-Clause
"""Runs that go on from where others were, or were killed."""
import random
import signal
import subprocess
import time

import netCDF4
import numpy as np

from cases import case
from mesh_maker import MeshMaker
from runs import at_most


def bodies():
    mesh, mm = MeshMaker(), 1e-3

    def brick(name, origin, size, cells):
        mesh.new_body()
        mesh.hexes(name, [mm * o for o in origin], [mm * s for s in size], cells)

    brick("anvil", (0, 0, 0), (8, 6, 2), (8, 6, 2))
    brick("hammer", (1.3, 1.7, 2.1), (3, 3, 3), (3, 3, 3))
    brick("floor", (20, 0, 0), (8, 6, 2), (8, 6, 2))
    brick("slider", (21.3, 1.7, 2.1), (3, 3, 3), (3, 3, 3))
    brick("low", (40, 0, 0), (4, 4, 2), (4, 4, 2))
    brick("high", (40.5, 0.5, 2), (3, 3, 2), (2, 2, 2))
    brick("left", (60, 0, 0), (2, 4, 4), (2, 4, 4))
    brick("right", (62, 0, 0), (2, 4, 4), (2, 3, 3))
    brick("brick", (82.2, 2.3, 0.5), (2, 2, 2), (2, 2, 2))
    mesh.new_body()
    mesh.shells("sheet", (80 * mm, 0, 0), (7 * mm, 7 * mm, 0), (7, 7), 0.5 * mm)
    mesh.new_body()
    mesh.lines("rail", (100 * mm, 0, 0), (100 * mm, 8 * mm, 0), 6)
    mesh.new_body()
    mesh.lines("rod", (96 * mm, 4.4 * mm, mm), (104 * mm, 4.4 * mm, mm), 5)
    mesh.node_set("held", lambda x, y, z: is_held(x / mm, y / mm, z / mm))
    return mesh


def is_held(x, y, z):
    if x < 50:
        return z == 0
    if x < 70:
        return x <= 60
    if x < 90:
        return z == 0 and (x in (80, 87) or y in (0, 7))
    return x == 100 and y in (0, 8) and z == 0


def count_differences(straight, restarted):
    """Arrays of a restarted run's Exodus file that are not, to the last bit, the end of those of the straight run; -1 if
    it has no steps."""
    with netCDF4.Dataset(straight) as whole, netCDF4.Dataset(restarted) as part:
        n_steps = part.dimensions["time_step"].size
        if n_steps == 0:
            return -1
        return sum(np.ma.getdata(variable[-n_steps:]).tobytes() != np.ma.getdata(part[name][:]).tobytes()
                   for name, variable in whole.variables.items() if "time_step" in variable.dimensions)


def lines_of(path):
    return path.read_text().splitlines()


def restarted_checks(bench, straight, at, threads):
    folder, command = bench.copy(straight, "restart", threads=threads, at=at)
    bench.execute(folder, command)
    n_bits = sum(abs(count_differences(straight.folder / name, folder / f"{name}-s0002"))
                 for name in ("restart.e", "restart.h"))
    part = lines_of(folder / "restart.csv-s0002")[1:]
    n_bits += part != lines_of(straight.folder / "restart.csv")[-len(part):]
    return at_most(f"arrays that differ after {1e6 * at:.0f} us, {threads} threads", n_bits, 0)


@case()
def restart(bench):
    straight = bench.run("restart", bodies())
    return [restarted_checks(bench, straight, at, threads) for at, threads in [(4e-6, 1), (2.5e-5, 2), (3.5e-5, 1)]]


def run_and_kill(folder, command, seconds):
    """Returns whether the run was still there to be killed."""
    process = subprocess.Popen(command, cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    time.sleep(seconds)
    process.send_signal(signal.SIGKILL)
    return process.wait() == -signal.SIGKILL


@case()
def killed(bench, n_kills=50):
    """A run that stores every step is killed again and again and goes on each time."""
    chance = random.Random(27)
    folder, command = bench.prepare("restart", bodies(), goes_on=1, stored=1)
    kills = n_damaged = n_lost = 0
    while kills < n_kills:
        # A file that a killed run had not finished is no state yet.
        had_states = any(file.suffix != ".part" for file in folder.glob("restart.rsout*"))
        log = folder / "restart.log"
        n_told = log.stat().st_size if log.exists() else 0
        if not run_and_kill(folder, command, chance.uniform(0.05, 0.25)):
            for left in folder.glob("restart.*-s*"):
                left.unlink()
            for left in folder.glob("restart.rsout.*"):
                left.unlink()
            continue
        kills += 1
        told = log.read_bytes()[n_told:].decode() if log.exists() else ""
        n_damaged += "damaged" in told
        n_lost += had_states and "the run begins at its start" in told
    bench.execute(folder, command)
    straight = bench.run("restart", bodies(), stored=1000000)
    last = [folder / "restart.h", *sorted(folder.glob("restart.h-s*"))][-1]
    return [at_most("stored states that were damaged", n_damaged, 0), at_most("runs that lost their states", n_lost, 0),
            at_most("arrays that differ at the end", abs(count_differences(straight.folder / "restart.h", last)), 0)]
