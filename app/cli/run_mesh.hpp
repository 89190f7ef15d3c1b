// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "app/cli/options.hpp"
#include "core/base/diagnostics.hpp"
#include "core/definition/declarations.hpp"
#include "core/mesh/mesh.hpp"

namespace contactsim {

/// The mesh file of a run: that of the command line, else that of the deck.
std::string run_mesh_path(const Options& options, const SimulationDefinition& definition,
                          const Region& region);

/// Reads it.
///   warnings  gains what is odd about the mesh
/// Throws FileError when it cannot be read; when there is no such file, the message names the deck line that
/// asks for it, and the file of that name beside the deck if there is one.
Mesh read_run_mesh(const Options& options, const SimulationDefinition& definition, const Region& region,
                   Diagnostics& warnings);

}  // namespace contactsim
