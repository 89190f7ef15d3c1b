// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/run_decompose.hpp"

#include <fmt/format.h>

#include <cstdio>

#include "core/base/memory_error.hpp"
#include "core/base/pluralize.hpp"
#include "io/decompose/join_file.hpp"
#include "io/decompose/split_file.hpp"

namespace contactsim {

ExitCode run_split(const SplitOptions& options) {
  const std::vector<WrittenPiece> pieces = tell_lack_of_memory(
      "dividing " + options.file, [&] { return split_file(options.file, options.n_pieces); });
  std::string text;
  for (const WrittenPiece& piece : pieces) {
    text += fmt::format("{}: {}, {}\n", piece.path, pluralize(piece.n_nodes, "node"),
                        pluralize(piece.n_elements, "element"));
  }
  std::fputs(text.c_str(), stdout);
  return ExitCode::done;
}

ExitCode run_join(const JoinOptions& options) {
  const JoinedFile joined =
      tell_lack_of_memory("joining " + options.pieces, [&] { return join_file(options.pieces, options.to); });
  std::fputs(fmt::format("{}: {}, {}, {}, joined from {}\n", joined.path, pluralize(joined.n_nodes, "node"),
                         pluralize(joined.n_elements, "element"), pluralize(joined.n_steps, "time"),
                         pluralize(joined.n_pieces, "piece"))
                 .c_str(),
             stdout);
  return ExitCode::done;
}

}  // namespace contactsim
