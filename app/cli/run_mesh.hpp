// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "app/cli/options.hpp"
#include "core/base/diagnostics.hpp"
#include "core/definition/declarations.hpp"
#include "core/mesh/mesh.hpp"

namespace contactsim {

/// The mesh of a run as it is named: by the command line, else by the deck.
std::string run_mesh_path(const Options& options, const SimulationDefinition& definition,
                          const Region& region);

/// The files that a mesh is read from: the one of that name, or the pieces that it is decomposed into. Where
/// several decompositions are there, the pieces of all. Only names are looked at.
std::vector<std::string> list_mesh_files(const std::string& path);

/// Reads it, joined where it is decomposed: of several decompositions the one of as many pieces as the run
/// has ranks.
///   warnings  gains what is odd about the mesh
/// Throws FileError when it cannot be read; when there is no such file, the message names the deck line that
/// asks for it, and the file of that name beside the deck if there is one.
Mesh read_run_mesh(const Options& options, const SimulationDefinition& definition, const Region& region,
                   Diagnostics& warnings);

}  // namespace contactsim
