// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/run_manual.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "app/manual/completions.hpp"
#include "app/manual/grammars.hpp"
#include "app/manual/html_manual.hpp"
#include "app/manual/man_pages.hpp"
#include "core/base/names.hpp"

namespace contactsim {

namespace {

using Files = std::vector<ManualFile>;

struct Kind {
  const char* name;
  Files (*make)(const CommandLineText&);
};

constexpr std::array kinds{
    Kind{"man", [](const CommandLineText& text) -> Files { return {make_program_page(text)}; }},
    Kind{"man-deck", [](const CommandLineText&) -> Files { return {make_deck_page()}; }},
    Kind{"html", [](const CommandLineText& text) { return make_html_manual(text); }},
    Kind{"bash", [](const CommandLineText& text) -> Files { return {make_bash_completion(text)}; }},
    Kind{"zsh", [](const CommandLineText& text) -> Files { return {make_zsh_completion(text)}; }},
    Kind{"fish", [](const CommandLineText& text) -> Files { return {make_fish_completion(text)}; }},
    Kind{"vim", [](const CommandLineText&) { return make_vim_files(); }},
    Kind{"vscode", [](const CommandLineText&) { return make_vscode_files(); }},
};

void write_file(const std::filesystem::path& path, const std::string& text) {
  std::error_code failure;
  std::filesystem::create_directories(path.parent_path(), failure);
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.close();
  if (!file) throw FileError(path.string(), "cannot be written");
}

}  // namespace

std::vector<std::string> manual_kinds() {
  std::vector<std::string> names;
  for (const Kind& kind : kinds) names.emplace_back(kind.name);
  return names;
}

ExitCode run_manual(const ManualOptions& options) {
  const auto* kind = std::find_if(kinds.begin(), kinds.end(),
                                  [&](const Kind& k) { return fold(k.name) == fold(options.kind); });
  const Files files = kind->make(options.command_line);
  if (!options.folder && files.size() == 1) {
    std::fputs(files.front().text.c_str(), stdout);
    return ExitCode::done;
  }
  if (!options.folder) {
    std::fputs(
        fmt::format("error: {} is {} files: give a folder for them\n", kind->name, files.size()).c_str(),
        stderr);
    return ExitCode::deck;
  }
  for (const ManualFile& file : files)
    write_file(std::filesystem::path(*options.folder) / file.path, file.text);
  return ExitCode::done;
}

}  // namespace contactsim
