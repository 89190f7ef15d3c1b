// SPDX-License-Identifier: BSD-3-Clause
#include "app/run_outputs.hpp"

#include <sstream>

#include "app/file_clashes.hpp"
#include "app/output_files.hpp"
#include "core/definition/simulation.hpp"

namespace contactsim {

namespace {

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(std::move(line));
  return lines;
}

}  // namespace

OutputSettings output_settings(const RunInput& input, RunContact* contact, Log& log) {
  OutputFileSettings files;
  files.mesh_path = input.mesh.path();
  files.command_line = input.options.command_line;
  files.deck_lines = lines_of(input.definition.text);
  files.log = [&log](std::string_view text) { log.write(text); };
  OutputSettings settings;
  settings.writers = make_output_writers(std::move(files));
  settings.results_path = input.options.results;
  settings.always_computes = !input.region.element_deaths.empty();
  if (contact != nullptr) contact->add_to(settings);
  return settings;
}

void check_output_paths(const RunInput& input, const std::vector<std::string>& paths) {
  std::vector<RunFile> kept = files_read(input.options);
  kept.push_back({input.mesh.path(), "the mesh"});
  kept.push_back({log_path(input.options), "the log"});
  for (const std::string& path : paths) {
    const RunFile file{path, "the output file " + path};
    const std::string clash = find_file_clash(kept, {&file, 1});
    if (!clash.empty()) throw FileError(path, clash);
  }
}

}  // namespace contactsim
