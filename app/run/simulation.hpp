// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "app/cli/options.hpp"
#include "app/reports/log.hpp"
#include "contact/mesh/contact_model.hpp"
#include "contact/overlap/start_overlaps.hpp"
#include "core/base/diagnostics.hpp"
#include "core/base/errors.hpp"
#include "core/definition/declarations.hpp"
#include "core/mesh/mesh.hpp"

namespace contactsim {

/// What a run is made from. All must outlive it.
struct RunInput {
  const Options& options;
  const SimulationDefinition& definition;
  const Procedure& procedure;
  const Region& region;
  const Mesh& mesh;
  const ContactModel* contact = nullptr;        ///< null without a contact definition
  std::span<const StartOverlap> overlaps = {};  ///< of contact surfaces, on this mesh
};

/// Moves a region from its start time to its termination time, with log and output files.
///   warnings  gains what was found on the way
/// Throws DeckError for what cannot be run, FileError. When the motion cannot go on, the last state is
/// written, the log says why, and the code is ExitCode::solve.
ExitCode run_transient(const RunInput& input, Log& log, Diagnostics& warnings);

}  // namespace contactsim
