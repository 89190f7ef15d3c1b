// SPDX-License-Identifier: BSD-3-Clause
#include "app/run/run_outputs.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <sstream>
#include <utility>

#include "app/run/file_clashes.hpp"
#include "app/run/gathered_results.hpp"
#include "app/run/output_files.hpp"
#include "core/base/errors.hpp"
#include "core/definition/simulation.hpp"
#include "core/dynamics/chunk_shares.hpp"
#include "core/parallel/on_root.hpp"

namespace contactsim {

namespace {

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(std::move(line));
  return lines;
}

/// What ranks write together: in pieces each its own, else rank 0 of the values of all.
OutputWriters on_ranks(const ResultsPieces& pieces, bool writes_pieces, const OutputWriters& writers) {
  OutputWriters made = writers;
  Ranks& ranks = pieces.ranks;
  made.open_results = [pieces, writes_pieces, writers](const ResultsFile& file, const Mesh& mesh,
                                                       std::span<const OutputField> fields) {
    const auto open = [&] { return writers.open_results(file, mesh, fields); };
    return writes_pieces && file.has_mesh ? open() : open_gathered_results(pieces, mesh, fields, open);
  };
  made.open_heartbeat = [&ranks, writers](const HeartbeatFile& file,
                                          std::vector<std::string> names) -> OutputWriters::AppendLine {
    OutputWriters::AppendLine append;
    on_root(ranks, [&] { append = writers.open_heartbeat(file, std::move(names)); });
    return [&ranks, append](double time, std::span<const double> values) {
      on_root(ranks, [&] { append(time, values); });
    };
  };
  return made;
}

}  // namespace

OutputSettings output_settings(const RunInput& input, const RunSettings& settings, const Model& model,
                               RunContact* contact, std::function<void()> complete_state) {
  OutputFileSettings files;
  files.mesh_path = input.mesh.path();
  files.command_line = settings.command_line;
  files.deck_lines = lines_of(input.definition.text);
  files.log = settings.write_text;
  Ranks& ranks = settings.ranks;
  const ResultsPieces pieces(ranks, ranks.are_several() || settings.writes_pieces
                                        ? find_ranks_of_elements(model, ranks.count())
                                        : std::vector<std::uint32_t>());
  if (settings.writes_pieces) files.pieces.emplace(pieces);
  OutputSettings made;
  made.writers = make_output_writers(std::move(files));
  if (ranks.are_several()) made.writers = on_ranks(pieces, settings.writes_pieces, made.writers);
  made.complete_state = std::move(complete_state);
  made.results_path = settings.results_path;
  made.always_computes = !input.region.element_deaths.empty();
  if (contact != nullptr) contact->add_to(made);
  return made;
}

void warn_of_results_beside_pieces(const std::vector<std::string>& paths, Diagnostics& warnings) {
  for (const std::string& path : paths) {
    const auto written = parse_piece_path(path);
    if (!written || path != written->path(0)) continue;
    const auto warn = [&](const std::string& other) {
      warnings.add_warning("results-beside-pieces", {},
                           fmt::format("{} is of an earlier run; this one writes {}", other, path),
                           "remove it, or readers may take it for the results of this run");
    };
    std::error_code ignored;
    if (std::filesystem::exists(written->base, ignored)) warn(written->base);
    for (const PieceFiles& others : find_decompositions(written->base)) {
      if (others.count != written->count) warn(others.path(0));
    }
  }
}

void check_output_paths(const std::vector<RunFile>& kept, const std::vector<std::string>& paths) {
  for (const std::string& path : paths) {
    const RunFile file{path, "the output file " + path};
    const std::string clash = find_file_clash(kept, {&file, 1});
    if (!clash.empty()) throw FileError(path, clash);
    const std::string obstacle = find_write_obstacle(path);
    if (!obstacle.empty()) throw FileError(path, obstacle);
  }
}

}  // namespace contactsim
