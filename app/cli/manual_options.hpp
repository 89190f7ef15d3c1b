// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "app/manual/command_line.hpp"

namespace CLI {
class App;
}

namespace contactsim {

/// What `contactsim manual` is asked for.
struct ManualOptions {
  bool is_asked = false;              ///< whether the command line says manual
  std::string kind;                   ///< one of the kinds of manual_kinds.hpp
  std::optional<std::string> folder;  ///< where files go; without: a single one is printed
  CommandLineText command_line;       ///< of the whole program
};

/// Adds the subcommand `manual`.
CLI::App* add_manual(CLI::App& app, ManualOptions& options);

/// The program and its subcommands, as the reader of the command line knows them.
CommandLineText describe(const CLI::App& app);

}  // namespace contactsim
