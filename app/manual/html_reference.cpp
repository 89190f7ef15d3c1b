// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>

#include "app/manual/deck_sections.hpp"
#include "app/manual/html_frame.hpp"
#include "app/manual/html_manual.hpp"
#include "parser/row_reference.hpp"
#include "parser/text/phrases.hpp"

namespace contactsim {

namespace {

/// Hides what does not hold the words of the search, and headings without rows.
constexpr const char* search_script = R"(<script>
const box = document.getElementById("search");
function search() {
  const words = box.value.toLowerCase().replace(/_/g, " ").split(/\s+/).filter(Boolean);
  for (const section of document.querySelectorAll("section")) {
    let found = false;
    for (const row of section.querySelectorAll(".row")) {
      const text = row.textContent.toLowerCase().replace(/_/g, " ");
      row.hidden = !words.every(word => text.includes(word));
      found = found || !row.hidden;
    }
    section.hidden = !found;
  }
}
box.addEventListener("input", search);
search();
</script>
)";

/// Of the section of a block: its phrases from the outside in.
std::string anchor_of(const std::vector<const RowText*>& around) {
  std::string path = "deck";
  for (const RowText* block : around) path += " " + block->phrase;
  return html_anchor(path);
}

std::string item(std::string_view label, std::string_view value) {
  return value.empty() ? "" : fmt::format("<dt>{}</dt><dd>{}</dd>\n", label, html_text(value));
}

/// Where the lines of a block are listed: in its own section or in that of a block with the same lines.
std::string contents_link(const TreeRow& entry, const std::map<const RowText*, std::string>& anchors) {
  const RowText* listed = entry.same_as != nullptr ? entry.same_as : entry.row;
  const auto anchor = anchors.find(listed);
  if (anchor == anchors.end()) return "";
  return fmt::format("<dt>holds</dt><dd><a href=\"#{}\">the lines of {}</a></dd>\n", anchor->second,
                     html_text(upper(listed->phrase)));
}

std::string row_text(const TreeRow& entry, const std::map<const RowText*, std::string>& anchors) {
  const RowReference row = reference_of(entry);
  const char* kind = entry.row->support == Support::supported ? ""
                     : entry.row->support == Support::ignored ? " ignored"
                                                              : " refused";
  return fmt::format("<div class=\"row{}\"><code>{}</code>\n<p>{}</p>\n<dl>\n{}{}{}{}{}{}{}</dl></div>\n",
                     kind, html_text(row.form), html_text(row.help),
                     item("also", fmt::format("{}", fmt::join(row.spellings, ", "))),
                     item("names", fmt::format("{}", fmt::join(row.names, ", "))),
                     item("dimension", row.dimension), item("default", row.default_text),
                     item("choice", row.choice),
                     entry.row->support == Support::supported ? "" : item("support", row.support),
                     contents_link(entry, anchors));
}

}  // namespace

ManualFile make_reference_page() {
  const std::vector<DeckSection> sections = deck_sections();
  std::map<const RowText*, std::string> anchors;
  for (const DeckSection& section : sections) {
    if (!section.around.empty()) anchors.emplace(section.around.back(), anchor_of(section.around));
  }
  std::string text =
      "<h1>Commands of a deck</h1>\n<p>A deck may also hold the inside of a region or of a contact "
      "definition "
      "alone.</p>\n<input type=\"search\" id=\"search\" placeholder=\"friction coefficient\" autofocus>\n";
  for (const DeckSection& section : sections) {
    text += fmt::format("<section>\n<h2 id=\"{}\">{}</h2>\n", anchor_of(section.around),
                        html_text(place_of(*section.rows.front())));
    for (const TreeRow* row : section.rows) text += row_text(*row, anchors);
    text += "</section>\n";
  }
  return {"reference.html", html_page("Commands of a deck", text + search_script)};
}

}  // namespace contactsim
