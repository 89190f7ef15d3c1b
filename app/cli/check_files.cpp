// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/check_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>
#include <vector>

#include "app/cli/run_mesh.hpp"
#include "app/run/deck_files.hpp"
#include "app/run/file_clashes.hpp"
#include "core/base/file_paths.hpp"
#include "io/restart/restart_database.hpp"

namespace contactsim {

namespace {

std::vector<RunFile> files_read_by(const Options& options, const RunDeck& deck) {
  std::vector<RunFile> files = files_read(options);
  for (const SourceFile& source : deck.sources) {
    if (source.name == options.deck) continue;
    files.push_back(
        {include_path(options.includes_folder, source.name).string(), "a file that the deck includes"});
  }
  const auto add_mesh = [&](const Region& region) {
    const std::string path = run_mesh_path(options, deck.definition, region);
    files.push_back({path, "the mesh"});
    for (std::string& piece : list_mesh_files(path)) {
      if (piece != path) files.push_back({std::move(piece), "a piece of the mesh"});
    }
  };
  if (deck.definition.procedures.empty()) add_mesh(Region{});
  for (const Procedure& procedure : deck.definition.procedures) {
    for (const Region& region : procedure.regions) add_mesh(region);
  }
  return files;
}

std::vector<DeckFile> files_of_deck(const Options& options, const SimulationDefinition& definition) {
  std::vector<DeckFile> files;
  for (const Procedure& procedure : definition.procedures) {
    const bool is_last = &procedure == &definition.procedures.back();
    for (DeckFile& file : find_deck_files(definition, procedure)) {
      // The command line says another name.
      if (options.results && is_last && file.kind == DeckFile::Kind::results) continue;
      files.push_back(std::move(file));
    }
  }
  return files;
}

}  // namespace

std::string find_clash_of_run(const Options& options, const RunDeck& deck) {
  std::vector<RunFile> kept = files_read_by(options, deck);
  const std::vector<RunFile> of_line = files_written(options);
  std::string clash = find_file_clash(kept, of_line);
  if (!clash.empty()) return clash;
  kept.insert(kept.end(), of_line.begin(), of_line.end());
  std::vector<RunFile> written = of_line;
  std::vector<std::string> states;
  for (const DeckFile& file : files_of_deck(options, deck.definition)) {
    if (file.kind == DeckFile::Kind::states) {
      states.push_back(file.path);
      continue;
    }
    const RunFile one{file.path, "the output file " + file.path};
    clash = find_file_clash(kept, {&one, 1});
    if (!clash.empty()) return clash;
    written.push_back(one);
  }
  for (const RunFile& file : written) {
    const auto state_of = std::ranges::find_if(
        states, [&](const std::string& database) { return is_restart_path(database, file.path); });
    if (state_of != states.end())
      return fmt::format("{} would overwrite a restart state of {}, {}", file.what, *state_of, file.path);
  }
  return "";
}

void warn_of_files_outside(const Options& options, const RunDeck& deck, Diagnostics& warnings) {
  for (const DeckFile& file : files_of_deck(options, deck.definition)) {
    const std::filesystem::path path = std::filesystem::path(file.path).lexically_normal();
    if (path.empty() || is_device(path) || !(path.is_absolute() || *path.begin() == "..")) continue;
    warnings.add_warning("output-outside", file.location,
                         fmt::format("'{}' is outside the folder that the run is started in", file.path),
                         "-o and other options of the command line name files anywhere");
  }
}

}  // namespace contactsim
