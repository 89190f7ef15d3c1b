# SPDX-License-Identifier: BSD-3-Clause
"""Reads what runs write: whether it is whole and finite, and whether two runs wrote the same bits."""
import json
import re

import netCDF4
import numpy as np

EXODUS = re.compile(r"\.(e|h|exo)(-s\d+)?$")  # as decks name them
TEXT = re.compile(r"\.csv(-s\d+)?$")
NO_NUMBER = re.compile(r"(?<![a-z_])[-+]?(nan|inf(inity)?)(?![a-z_])", re.IGNORECASE)
OF_THE_PROGRAM = {"qa_records", "info_records"}  # its version, the time of day


def is_netcdf(path):
    with open(path, "rb") as file:
        return file.read(3) == b"CDF"


def files_of(folder, pattern):
    return sorted(path for path in folder.rglob("*") if path.is_file() and pattern.search(path.name))


def values(file, name):
    variable = file[name]
    variable.set_auto_mask(False)
    return variable[:]


def problem_of_exodus(path):
    """What is wrong with an Exodus file, or nothing. The library reads zeros behind the end of a file."""
    try:
        with netCDF4.Dataset(path) as file:
            n_bytes = sum(variable.size * variable.dtype.itemsize for variable in file.variables.values())
            if "time_whole" not in file.variables or path.stat().st_size < n_bytes:
                return f"{path.name} is cut off"
            for name, variable in file.variables.items():
                read = values(file, name)
                if variable.dtype.kind == "f" and not np.all(np.isfinite(read)):
                    return f"{path.name}: {name} is not finite"
    except (OSError, RuntimeError) as error:
        return f"{path.name} cannot be read: {error}"
    return ""


def problem_of_text(path):
    found = NO_NUMBER.search(path.read_text(errors="replace"))
    return f"{path.name}: {found.group(0)}" if found else ""


def problem_of_results(folder):
    """The first file of results whose numbers are not all there."""
    for pattern, look in ((EXODUS, problem_of_exodus), (TEXT, problem_of_text)):
        for path in files_of(folder, pattern):
            problem = (problem_of_exodus if is_netcdf(path) else look)(path)
            if problem:
                return problem
    return ""


def read_summary(path):
    """The summary, or None where there is none; a broken one raises ValueError."""
    return json.loads(path.read_text()) if path.exists() else None


def outcome_of(summary):
    """What of a summary no two runs of a deck may differ in."""
    def of_run(run):
        return run and {key: value for key, value in run.items() if key not in ("wall_time", "stable_step")}

    pairs = [{key: value for key, value in pair.items() if key != "line"} for pair in summary["pairs"]]
    return {"run": of_run(summary["run"]), "pairs": pairs, "exit_code": summary["exit_code"],
            "earlier": [of_run(one["run"]) for one in summary.get("earlier_runs", [])]}


def stepped(file):
    return [name for name, variable in file.variables.items() if "time_step" in variable.dimensions]


def exodus_difference(whole, part):
    """What of the steps of `part` is not, to the last bit, the end of `whole`; "" where nothing differs."""
    with netCDF4.Dataset(whole) as a, netCDF4.Dataset(part) as b:
        n_steps = b.dimensions["time_step"].size
        if n_steps == 0:
            return ""
        if n_steps > a.dimensions["time_step"].size or set(stepped(a)) != set(stepped(b)):
            return f"{part.name} has other steps or variables"
        differ = [name for name in stepped(b) if values(a, name)[-n_steps:].tobytes() != values(b, name).tobytes()]
    return f"{part.name}: {', '.join(differ)}" if differ else ""


def data_sets(group, path=""):
    """The data sets of an HDF5 file, those of its groups too, by their paths."""
    for name, variable in group.variables.items():
        variable.set_auto_maskandscale(False)
        yield f"{path}{name}", variable
    for name, below in group.groups.items():
        yield from data_sets(below, f"{path}{name}/")


def same_restart(one, other):
    """Which data sets of two restart files differ."""
    with netCDF4.Dataset(one) as a, netCDF4.Dataset(other) as b:
        sets, others = dict(data_sets(a)), dict(data_sets(b))
        if not sets or set(sets) != set(others):
            return f"{other.name} has other data sets"
        differ = [name for name, data in sets.items() if np.asarray(data[...]).tobytes() != np.asarray(others[name][...]).tobytes()]
    return f"{other.name}: {', '.join(differ)}" if differ else ""


def same_exodus(one, other):
    """What differs between two Exodus files, the mesh included; the clock's records left out."""
    with netCDF4.Dataset(one) as a, netCDF4.Dataset(other) as b:
        if set(a.variables) != set(b.variables):
            return f"{other.name} has other variables"
        differ = [name for name in a.variables
                  if name not in OF_THE_PROGRAM and values(a, name).tobytes() != values(b, name).tobytes()]
    return f"{other.name}: {', '.join(differ)}" if differ else ""
