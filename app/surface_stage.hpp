// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "app/log.hpp"
#include "app/options.hpp"
#include "core/definition/simulation.hpp"
#include "core/diagnostics.hpp"
#include "core/errors.hpp"
#include "core/mesh/mesh.hpp"

namespace contactsim {

/// Resolves the contact surfaces of a region, prints their tables and writes the files that are asked for.
///   warnings  gains what was found on the way
/// Throws DeckError. Returns the code of a file that could not be written.
ExitCode resolve_surfaces(const Options& options, const SimulationDefinition& definition,
                          const Region& region, const Mesh& mesh, Log& log, Diagnostics& warnings);

/// Wrong names of surfaces in a deck that has other errors already, so that one run shows all that is wrong.
/// Without a mesh that can be read there is nothing to compare them with.
void add_surface_name_errors(const SimulationDefinition& definition, const Region& region,
                             const std::string& mesh_path, Diagnostics& errors);

}  // namespace contactsim
