// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

namespace contactsim {

/// What was joined.
struct JoinedFile {
  std::string path;
  std::size_t n_pieces = 0, n_nodes = 0, n_elements = 0, n_steps = 0;
};

/// Joins the pieces of a decomposed Exodus file, mesh or results, into one file.
///   path    of a piece, or what the names of the pieces begin with where there is no file of that name
///   target  the file to write, which replaces an older one; without it the name of the pieces without P and
///           r, which must be free
/// Throws FileError when there are no pieces, they do not go together, or the file cannot be written.
JoinedFile join_file(const std::string& path, const std::optional<std::string>& target);

}  // namespace contactsim
