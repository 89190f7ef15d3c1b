// SPDX-License-Identifier: BSD-3-Clause
#include "io/decompose/join_file.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "core/base/errors.hpp"
#include "core/base/file_paths.hpp"
#include "io/decompose/file_layout.hpp"
#include "io/netcdf/netcdf_output.hpp"

namespace contactsim {

namespace {

std::string find_target(const PieceFiles& files, const std::optional<std::string>& target) {
  std::error_code ignored;
  if (!target && std::filesystem::exists(files.base, ignored))
    throw FileError(files.base, "is there already; name the file to write behind the pieces");
  for (std::size_t piece = 0; target && piece < files.count; ++piece) {
    if (would_overwrite(*target, files.path(piece)))
      throw FileError(*target, "would overwrite " + files.path(piece) + ", which it is made of");
  }
  return target.value_or(files.base);
}

}  // namespace

JoinedFile join_file(const std::string& path, const std::optional<std::string>& target) {
  const ExodusFile file(path);
  const auto files = find_pieces(file.path());
  if (!file.n_pieces() || !files)
    throw FileError(path, "is no piece of a decomposed file, like mesh.g.4.0; there is nothing to join");
  const std::string to = find_target(*files, target);
  const NetcdfLayout layout = make_writable(file.layout());
  NetcdfOutput output(to, needs_large_file(layout));
  output.define(layout);
  output.end_definitions();
  for (std::size_t v = 0; v < layout.variables.size(); ++v) {
    const NetcdfDefinition& variable = layout.variables[v];
    read_in_parts(file, variable, is_record(layout, variable),
                  [&](std::optional<std::size_t> record, const NetcdfValues& values) {
                    output.write(static_cast<int>(v), record, values);
                  });
  }
  output.commit();
  return {to, files->count, layout.length("num_nodes"), layout.length("num_elem"),
          layout.length("time_step")};
}

}  // namespace contactsim
