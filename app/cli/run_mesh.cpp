// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/run_mesh.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <utility>

#include "app/run/stop_on_errors.hpp"
#include "core/base/errors.hpp"
#include "core/definition/simulation.hpp"
#include "core/mesh/omit_blocks.hpp"
#include "core/mesh/renumber_mesh.hpp"
#include "io/exodus/exodus_reader.hpp"
#include "io/pieces/piece_files.hpp"

namespace contactsim {

namespace {

/// Who asks for a mesh that is not there, and where it may be.
std::string describe_missing_mesh(const std::string& path, const Options& options,
                                  const SimulationDefinition& definition, const Region& region) {
  const FiniteElementModel* model = find_finite_element_model(definition, region);
  std::string text = "no such file; ";
  if (model != nullptr && model->database) {
    text += fmt::format("it is the DATABASE NAME at {}", to_string(model->database->location));
  } else {
    text += "the deck names no mesh, so its own base name is taken";
  }
  const std::filesystem::path beside = std::filesystem::path(options.deck).parent_path() / path;
  std::error_code ignored;
  if (std::filesystem::exists(beside, ignored) || !find_decompositions(beside.string()).empty()) {
    return text + fmt::format(
                      ", and file names are relative to the run directory: run in the deck's "
                      "directory, or add '{}' to the command line",
                      beside.string());
  }
  return text + "; a mesh named on the command line, after the deck, goes before it";
}

}  // namespace

std::string run_mesh_path(const Options& options, const SimulationDefinition& definition,
                          const Region& region) {
  return options.mesh.value_or(mesh_path(definition, region));
}

std::vector<std::string> list_mesh_files(const std::string& path) {
  std::vector<PieceFiles> decompositions;
  std::error_code ignored;
  if (const auto files = parse_piece_path(path)) {
    decompositions.push_back(*files);
  } else if (!std::filesystem::exists(path, ignored)) {
    decompositions = find_decompositions(path);
  }
  if (decompositions.empty()) return {path};
  std::vector<std::string> paths;
  for (const PieceFiles& files : decompositions) {
    for (std::size_t piece = 0; piece < files.count; ++piece) paths.push_back(files.path(piece));
  }
  return paths;
}

Mesh read_run_mesh(const Options& options, const SimulationDefinition& definition, const Region& region,
                   Diagnostics& warnings) {
  const std::string path = find_exodus_path(run_mesh_path(options, definition, region), options.n_ranks);
  std::error_code ignored;
  const auto type = std::filesystem::status(path, ignored).type();
  if (!options.mesh && type == std::filesystem::file_type::not_found) {
    throw FileError(path, describe_missing_mesh(path, options, definition, region));
  }
  const FiniteElementModel* model = find_finite_element_model(definition, region);
  Mesh mesh = read_mesh(path, warnings);
  if (model != nullptr) {
    Diagnostics problems;
    mesh = omit_blocks(*model, std::move(mesh), problems);
    stop_on_errors(problems);
  }
  return renumber_mesh(std::move(mesh));
}

}  // namespace contactsim
