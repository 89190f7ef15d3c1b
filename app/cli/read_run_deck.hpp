// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/deck_location.hpp"
#include "core/base/diagnostics.hpp"
#include "core/definition/simulation.hpp"

namespace contactsim {

/// Where a deck is and how it is to be read.
struct DeckRequest {
  std::string path;
  std::vector<std::string> definitions;        ///< "name=value" for Aprepro
  bool is_lenient = false;                     ///< refused and unknown commands are warnings
  std::optional<std::string> includes_folder;  ///< where relative paths of includes start, if not here
};

/// A deck and the fingerprint of what was read for it.
struct RunDeck {
  SimulationDefinition definition;
  std::uint64_t digest = 0;              ///< of the bytes of the deck and of all files that it includes
  std::vector<SourceFile> sources = {};  ///< these files, each once
};

/// Where a file is that the deck includes by this name.
std::filesystem::path include_path(const std::optional<std::string>& includes_folder,
                                   const std::string& name);

/// The names and values of "name=value". Throws DeckError for anything else.
std::vector<std::pair<std::string, std::string>> split_definitions(
    const std::vector<std::string>& definitions);

/// Reads a deck, as parse_deck does. Throws DeckError, FileError.
RunDeck read_run_deck(const DeckRequest& request, Diagnostics& diagnostics);

/// A region and the procedure that it is part of.
struct ChosenRegion {
  Procedure procedure;
  Region region;
};

/// What a region is preferred by to others, as choose_region() says.
int merit_of(const Procedure& procedure, const Region& region);

/// The region to work on, where one is enough: with contact before without, of an explicit procedure before
/// an implicit one, then the first.
///   may_pass_over  others are left out with a warning; else each is an error, as they would change the
///   answer
ChosenRegion choose_region(const SimulationDefinition& definition, bool may_pass_over,
                           Diagnostics& diagnostics);

/// The region of every procedure, in deck order: of several in one that with contact, then the first. At
/// least one, without names where the deck has none. Errors: procedures without a region.
///   may_pass_over  other regions are left out with a warning; else each is an error
std::vector<ChosenRegion> choose_regions(const SimulationDefinition& definition, bool may_pass_over,
                                         Diagnostics& diagnostics);

}  // namespace contactsim
