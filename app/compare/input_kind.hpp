// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace contactsim {

/// What a file is that can be compared with another of its kind.
enum class InputKind {
  surfaces_json,  ///< an ownership table, of --surfaces-json
  surfaces_csv,   ///< a list of facets, of --surfaces-csv
  summary,        ///< of --summary
  heartbeat,      ///< values over time as CSV
  deck
};

/// "an ownership table (JSON of --surfaces-json)".
std::string describe(InputKind kind);

/// What a text is, by its content.
///   path  of the file, for messages
/// Throws FileError when it is nothing of all that, and says what it is as far as it shows.
InputKind find_input_kind(const std::string& path, const std::string& text);

}  // namespace contactsim
