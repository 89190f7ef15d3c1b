// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace contactsim {

/// What `contactsim split` is asked for.
struct SplitOptions {
  bool is_asked = false;  ///< whether the command line says split
  std::string file;
  std::size_t n_pieces = 0;
};

/// What `contactsim join` is asked for.
struct JoinOptions {
  bool is_asked = false;  ///< whether the command line says join
  std::string pieces;     ///< a piece, or the name without P and r
  std::optional<std::string> to;
};

/// Adds the subcommand `split`.
CLI::App* add_split(CLI::App& app, SplitOptions& options);

/// Adds the subcommand `join`.
CLI::App* add_join(CLI::App& app, JoinOptions& options);

}  // namespace contactsim
