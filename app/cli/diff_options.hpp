// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/compare/comparison.hpp"

namespace CLI {
class App;
}

namespace contactsim {

/// What `contactsim diff` is asked for.
struct DiffOptions {
  bool is_asked = false;            ///< whether the command line says diff
  std::string first, second;        ///< files
  std::optional<std::string> mesh;  ///< of two decks, in place of theirs
  Tolerance tolerance;
  bool lists_faces = false;
  bool writes_json = false;
  bool is_lenient = false;
  std::vector<std::string> definitions;                            ///< -D of both decks
  std::vector<std::string> first_definitions, second_definitions;  ///< of one of them
};

/// Adds the subcommand `diff`.
CLI::App* add_diff(CLI::App& app, DiffOptions& options);

}  // namespace contactsim
