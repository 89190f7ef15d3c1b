// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "core/base/diagnostics.hpp"
#include "core/definition/simulation.hpp"
#include "parser/text/text_file.hpp"

namespace contactsim {

/// How a deck is to be read.
struct ParseOptions {
  std::vector<std::pair<std::string, std::string>> overrides;  ///< Aprepro variables and their values, -D
  bool is_lenient = false;                                     ///< refused and unknown commands are warnings
  std::size_t max_aprepro_work = std::size_t{1} << 28;         ///< see ApreproOptions
};

/// Reads a deck into the definition tree. All problems of the deck go to `diagnostics`; the definition is
/// whole only when there are no errors among them. Paths of includes are relative to the run directory.
/// Throws FileError when the deck itself cannot be read.
SimulationDefinition parse_deck(const std::string& path, const ParseOptions& options,
                                Diagnostics& diagnostics);

/// The same of a deck that is in memory.
///   name       the deck's path for messages; its base name is what %B stands for
///   read_file  how included files are read
SimulationDefinition parse_deck_text(const std::string& name, const std::string& text,
                                     const ParseOptions& options, Diagnostics& diagnostics,
                                     const FileReader& read_file = read_text_file);

}  // namespace contactsim
