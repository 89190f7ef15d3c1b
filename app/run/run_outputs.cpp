// SPDX-License-Identifier: BSD-3-Clause
#include "app/run/run_outputs.hpp"

#include <sstream>

#include "app/run/file_clashes.hpp"
#include "app/run/output_files.hpp"
#include "core/base/errors.hpp"
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

OutputSettings output_settings(const RunInput& input, const RunSettings& settings, RunContact* contact) {
  OutputFileSettings files;
  files.mesh_path = input.mesh.path();
  files.command_line = settings.command_line;
  files.deck_lines = lines_of(input.definition.text);
  files.log = settings.write_text;
  OutputSettings made;
  made.writers = make_output_writers(std::move(files));
  made.results_path = settings.results_path;
  made.always_computes = !input.region.element_deaths.empty();
  if (contact != nullptr) contact->add_to(made);
  return made;
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
