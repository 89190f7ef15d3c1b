// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "app/cli/options.hpp"
#include "app/reports/log.hpp"
#include "contact/mesh/contact_model.hpp"
#include "core/base/diagnostics.hpp"
#include "core/base/errors.hpp"
#include "core/definition/declarations.hpp"
#include "core/mesh/mesh.hpp"

namespace contactsim {

/// The contact surfaces of a region, and how writing them went.
struct ResolvedContact {
  std::optional<ContactModel> model;  ///< absent without a contact definition
  ExitCode code = ExitCode::done;     ///< of a file that could not be written
};

/// Resolves the contact surfaces of a region, prints their tables and writes the files that are asked for.
///   warnings  gains what was found on the way
/// Throws DeckError.
ResolvedContact resolve_contact(const Options& options, const SimulationDefinition& definition,
                                const Region& region, const Mesh& mesh, Log& log, Diagnostics& warnings);

/// Wrong names of surfaces in a deck that has other errors already, so that one run shows all that is wrong.
/// Without a mesh that can be read there is nothing to compare them with.
void add_surface_name_errors(const SimulationDefinition& definition, const Region& region,
                             const std::string& mesh_path, Diagnostics& errors);

}  // namespace contactsim
