// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/deck_location.hpp"
#include "core/definition/declarations.hpp"

namespace contactsim {

/// A file that a region of the deck writes, under its own name.
struct DeckFile {
  /// `states` stands for numbered files, of which the path is the beginning.
  enum class Kind : std::uint8_t { results, other, states };

  std::string path;
  DeckLocation location;
  Kind kind = Kind::other;
  bool appends = false;  ///< to what another has written
};

/// The files of a procedure; heartbeats to the log are files of no name.
std::vector<DeckFile> find_deck_files(const SimulationDefinition& definition, const Procedure& procedure);

}  // namespace contactsim
