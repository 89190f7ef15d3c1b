// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/manual_options.hpp"

#include <CLI/CLI.hpp>

#include "app/cli/run_manual.hpp"

namespace contactsim {

namespace {

constexpr const char* manual_footer =
    "Examples:   contactsim manual man > contactsim.1\n"
    "            contactsim manual html manual\n"
    "            source <(contactsim manual bash)\n"
    "            contactsim manual vim ~/.vim\n"
    "            contactsim manual vscode ~/.vscode/extensions/contactsim";

OptionText describe(const CLI::Option& option) {
  OptionText text;
  if (!option.get_positional() || !option.get_snames().empty() || !option.get_lnames().empty()) {
    for (const std::string& name : option.get_snames()) text.names.push_back("-" + name);
    for (const std::string& name : option.get_lnames()) text.names.push_back("--" + name);
  }
  text.help = option.get_description();
  text.is_required = option.get_required();
  if (option.get_items_expected_max() == 0) return text;
  text.value = option.get_type_name();
  // Checks of values add theirs behind a colon; what has no name of its own is called as it stands.
  text.value = text.value.substr(0, text.value.find(':'));
  if (text.names.empty() && text.value == "TEXT") text.value = option.get_name(true);
  return text;
}

CommandText describe_one(const CLI::App& app) {
  CommandText text{
      app.get_parent() == nullptr ? "" : app.get_name(), app.get_description(), {}, {}, app.get_footer()};
  for (const CLI::Option* option : app.get_options()) {
    OptionText row = describe(*option);
    if (row.names.empty() && text.name == "manual" && row.value == "KIND") row.choices = manual_kinds();
    (row.names.empty() ? text.words : text.options).push_back(std::move(row));
  }
  return text;
}

}  // namespace

CLI::App* add_manual(CLI::App& app, ManualOptions& options) {
  auto* manual =
      app.add_subcommand("manual", "Write man pages, HTML, completions of shells and grammars of editors");
  manual->footer(manual_footer);
  manual->add_option("kind", options.kind, "man, man-deck, html, bash, zsh, fish, vim or vscode")
      ->type_name("KIND")
      ->required()
      ->check(CLI::IsMember(manual_kinds(), CLI::ignore_case).description(""));
  manual->add_option("folder", options.folder, "Where the files go; a single one is printed without it")
      ->type_name("FOLDER");
  return manual;
}

CommandLineText describe(const CLI::App& app) {
  CommandLineText commands{describe_one(app)};
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    commands.push_back(describe_one(*command));
  return commands;
}

}  // namespace contactsim
