// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pybind11/pybind11.h>

namespace contactsim {

/// Adds the exceptions DeckError, FileError and SolveError, all of Error, and Problem, of which a DeckError
/// has a list.
void bind_errors(pybind11::module_& module);

/// Adds Mesh, and read_mesh.
void bind_mesh(pybind11::module_& module);

/// Adds Results: what an Exodus file stores at its times.
void bind_results(pybind11::module_& module);

/// Adds Simulation.
void bind_run(pybind11::module_& module);

}  // namespace contactsim
