// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/run/file_clashes.hpp"
#include "contact/mesh/contact_model.hpp"
#include "contact/overlap/start_overlaps.hpp"
#include "core/definition/declarations.hpp"
#include "core/mesh/mesh.hpp"
#include "core/parallel/ranks.hpp"

namespace contactsim {

class Simulation;

/// What a run is made from, by a deck and a mesh file or in code. All must outlive it.
struct RunInput {
  const SimulationDefinition& definition;
  const Procedure& procedure;  ///< of the definition
  const Region& region;        ///< of the procedure
  const Mesh& mesh;
  const ContactModel* contact = nullptr;  ///< of region and mesh; null: nothing touches
  /// Of contact surfaces, on this mesh; found anew where a state is taken over.
  std::span<const StartOverlap> overlaps = {};
  /// That of the procedure before, over when this one begins: what PROCEDURAL TRANSFER takes its state from,
  /// until then; null: there is none.
  Simulation* earlier = nullptr;
};

/// What a run needs for its outputs besides its input.
struct RunSettings {
  std::optional<std::string> results_path;  ///< in place of the first results file of the region
  std::string command_line;                 ///< for the information records of results files
  std::vector<RunFile> kept_files;          ///< that no output may replace
  /// Takes what heartbeats write to cout, cerr, log, ...
  std::function<void(std::string_view)> write_text = [](std::string_view) {};
  /// The last step ends at the termination time, where another procedure goes on; else at it or past it.
  bool ends_on_time = false;
  /// The processes that share the run; they must outlive it. Rank 0 alone writes files, but pieces.
  Ranks& ranks = one_rank();
  bool writes_pieces = false;  ///< of results, a piece of each rank
};

}  // namespace contactsim
