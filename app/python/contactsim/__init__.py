# SPDX-License-Identifier: BSD-3-Clause
"""contactsim: explicit dynamics of solids, shells and beams in contact.

    run = contactsim.Simulation("impact.i", define={"speed": 120})
    facets = run.facets()
    print(facets["element"][facets["surface"] == "patch"])
    while not run.is_over:
        run.step()
    print(run.time, run.energies["kinetic"], run.outputs)

Numbers are NumPy arrays, copies of what the run has. Problems are DeckError with a list of places, FileError and
SolveError.
"""
import os as _os

# What each level of x86-64 has beyond the one below, as /proc/cpuinfo calls it. Source: x86-64 psABI.
_LEVELS = {"v3": {"avx", "avx2", "bmi1", "bmi2", "f16c", "fma", "abm", "movbe", "xsave"},
           "v4": {"avx512f", "avx512bw", "avx512cd", "avx512dq", "avx512vl"}}


def _folder_of_level():
    """The Debian package has a build for each level of x86-64: the folder of the newest that this processor is."""
    here = _os.path.dirname(__file__)
    level, flags = "v2", set()
    if _os.path.exists("/proc/cpuinfo"):
        with open("/proc/cpuinfo", encoding="ascii") as file:
            flags = next((set(line.split()) for line in file if line.startswith("flags")), set())
    for newer, needed in _LEVELS.items():
        if not needed <= flags:
            break
        level = newer
    return _os.path.join(here, _os.environ.get("CONTACTSIM_LEVEL", level).replace("x86-64-", ""))


# Threads that wait for each other sleep soon, unless the user says how they wait; see app/cli/main.cpp.
if "OMP_WAIT_POLICY" not in _os.environ:
    _os.environ.setdefault("GOMP_SPINCOUNT", "3000")

if _os.path.isdir(_os.path.join(_os.path.dirname(__file__), "v2")):
    __path__.append(_folder_of_level())

from .native import (DeckError, Error, FileError, Mesh, Problem, Results, Simulation, SolveError,  # noqa: E402
                     __version__, read_mesh)

for _public in (DeckError, Error, FileError, Mesh, Problem, Results, Simulation, SolveError):
    _public.__module__ = __name__
del _public

__all__ = ["DeckError", "Error", "FileError", "Mesh", "Problem", "Results", "Simulation", "SolveError",
           "__version__", "read_mesh"]
