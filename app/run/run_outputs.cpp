// SPDX-License-Identifier: BSD-3-Clause
#include "app/run/run_outputs.hpp"

#include <sstream>

#include "app/run/file_clashes.hpp"
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
  OutputSettings made;
  made.results_path = settings.results_path;
  made.command_line = settings.command_line;
  made.always_computes = !input.region.element_deaths.empty();
  made.deck_lines = lines_of(input.definition.text);
  if (contact != nullptr) contact->add_to(made);
  made.log = settings.write_text;
  return made;
}

void check_output_paths(const std::vector<RunFile>& kept, const std::vector<std::string>& paths) {
  for (const std::string& path : paths) {
    const RunFile file{path, "the output file " + path};
    const std::string clash = find_file_clash(kept, {&file, 1});
    if (!clash.empty()) throw FileError(path, clash);
  }
}

}  // namespace contactsim
