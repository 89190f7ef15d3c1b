// SPDX-License-Identifier: BSD-3-Clause
#include "app/run/run_outputs.hpp"

#include <sstream>

#include "app/run/file_clashes.hpp"
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
  OutputSettings settings;
  settings.results_path = input.options.results;
  settings.command_line = input.options.command_line;
  settings.always_computes = !input.region.element_deaths.empty();
  settings.deck_lines = lines_of(input.definition.text);
  if (contact != nullptr) contact->add_to(settings);
  settings.log = [&log](std::string_view text) { log.write(text); };
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
