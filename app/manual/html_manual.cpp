// SPDX-License-Identifier: BSD-3-Clause
#include "app/manual/html_manual.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/manual/foreign_keywords.hpp"
#include "app/manual/html_frame.hpp"
#include "app/manual/variable_rows.hpp"

namespace contactsim {

namespace {

std::string table_row(std::initializer_list<std::string_view> cells) {
  return fmt::format("<tr><td>{}</td></tr>\n", fmt::join(cells, "</td><td>"));
}

std::string options_table(const std::vector<OptionText>& options) {
  std::string text = "<table>\n";
  for (const OptionText& option : options) {
    const std::string names = fmt::format("{}", fmt::join(option.names, ", "));
    const std::string value = option.value.empty() ? "" : fmt::format("<i>{}</i>", html_text(option.value));
    text += table_row({fmt::format("<code>{} {}</code>", names, value), html_text(option.help)});
  }
  return text + "</table>\n";
}

std::string command_section(const CommandText& command) {
  std::string synopsis = "contactsim" + (command.name.empty() ? "" : " " + command.name) + " [options]";
  for (const OptionText& word : command.words)
    synopsis += word.is_required ? " " + word.value : fmt::format(" [{}]", word.value);
  return fmt::format("<h2 id=\"{}\">{}</h2>\n<p>{}</p>\n<pre>{}</pre>\n{}{}<pre>{}</pre>\n",
                     command.name.empty() ? "run" : command.name,
                     command.name.empty() ? "A run" : command.name, html_text(command.help),
                     html_text(synopsis), options_table(command.words), options_table(command.options),
                     html_text(command.footer));
}

std::string foreign_table(std::string_view program) {
  std::string text = fmt::format(
      "<h2 id=\"{}\">If you come from {}</h2>\n<table>\n<tr><th>there</th><th>here</th>"
      "<th>what differs</th></tr>\n",
      html_anchor(program), program);
  for (const ForeignKeyword& row : foreign_keywords()) {
    if (row.program != program) continue;
    const std::string place = row.place == DeckPlace::none ? "" : std::string(to_string(row.place));
    const std::string here =
        row.lines.empty() ? "" : fmt::format("{}<pre>{}</pre>", html_text(place), html_text(row.lines));
    text += table_row({html_text(row.keyword), here, html_text(row.note)});
  }
  return text + "</table>\n";
}

}  // namespace

ManualFile make_variables_page() {
  std::string text =
      "<h1>Output variables</h1>\n<table>\n<tr><th>of</th><th>name</th><th>components</th><th></th></tr>\n";
  for (const VariableText& row : output_variables()) {
    text +=
        table_row({row.location, fmt::format("<code>{}</code>", html_text(row.name)),
                   row.n_components == 0 ? "group" : std::to_string(row.n_components), html_text(row.help)});
  }
  return {"variables.html", html_page("Output variables", text + "</table>\n")};
}

ManualFile make_foreign_page() {
  std::string text =
      "<h1>If you come from another program</h1>\n<p>What is written there, and what a deck has here.</p>\n";
  for (const std::string_view program : foreign_programs()) text += foreign_table(program);
  text += "<h2 id=\"left-out\">Left out, and why</h2>\n<table>\n";
  for (const LeftOut& row : left_out_rows()) text += table_row({html_text(row.what), html_text(row.why)});
  return {"coming_from.html", html_page("If you come from another program", text + "</table>\n")};
}

ManualFile make_command_line_page(const CommandLineText& commands) {
  std::string text = "<h1>Command line</h1>\n";
  for (const CommandText& command : commands) text += command_section(command);
  return {"command_line.html", html_page("Command line", text)};
}

std::vector<ManualFile> make_html_manual(const CommandLineText& commands) {
  return {make_reference_page(), make_variables_page(), make_foreign_page(), make_command_line_page(commands),
          html_style()};
}

}  // namespace contactsim
