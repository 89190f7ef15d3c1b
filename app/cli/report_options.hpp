// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace contactsim {

/// What `contactsim report` is asked for.
struct ReportOptions {
  bool is_asked = false;              ///< whether the command line says report
  std::vector<std::string> results;   ///< Exodus files, side by side
  std::optional<std::string> output;  ///< in place of <first results>.html
  // In place of the files beside the results, of one run alone:
  std::optional<std::string> deck, summary;
  std::vector<std::string> heartbeats;
};

/// Adds the subcommand `report`.
CLI::App* add_report(CLI::App& app, ReportOptions& options);

}  // namespace contactsim
