// SPDX-License-Identifier: BSD-3-Clause
#include "app/manual/html_manual.hpp"

#include "app/manual/deck_sections.hpp"
#include "app/manual/foreign_keywords.hpp"
#include "app/manual/html_frame.hpp"
#include "app/manual/sample_commands.hpp"
#include "app/manual/variable_rows.hpp"
#include "parser/row_reference.hpp"
#include "support/catch.hpp"

using namespace contactsim;
using Catch::Matchers::Contains;

namespace {

std::size_t count(const std::string& text, std::string_view part) {
  std::size_t n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

}  // namespace

TEST_CASE("text and anchors are as HTML wants them", "[app][manual]") {
  CHECK(html_text("a < b & \"c\"") == "a &lt; b &amp; &quot;c&quot;");
  CHECK(html_anchor("Deck: PRESTO (region)") == "deck-presto-region");
  CHECK_THAT(html_page("A & B", "text"),
             Contains("<title>A &amp; B - contactsim") && Contains("<main>\ntext</main>"));
}

TEST_CASE("sections hold each row once, under the block in which it stands", "[app][manual]") {
  std::size_t n_rows = 0;
  for (const DeckSection& section : deck_sections()) {
    for (const TreeRow* row : section.rows) CHECK(row->around == section.around);
    n_rows += section.rows.size();
  }
  CHECK(n_rows == command_tree().size());
}

TEST_CASE("the reference has every row, and its links lead somewhere", "[app][manual]") {
  const std::string text = make_reference_page().text;
  for (const TreeRow& entry : command_tree()) {
    INFO(entry.row->phrase);
    const bool has_row =
        text.find("<code>" + html_text(reference_of(entry).form) + "</code>") != std::string::npos;
    CHECK(has_row);
  }
  CHECK(count(text, "<div class=\"row") == command_tree().size());
  for (std::size_t at = text.find("href=\"#"); at != std::string::npos; at = text.find("href=\"#", at + 1)) {
    const std::string anchor = text.substr(at + 7, text.find('"', at + 7) - at - 7);
    INFO(anchor);
    CHECK(count(text, "id=\"" + anchor + "\"") == 1);
  }
}

TEST_CASE("pages of variables, other programs and the command line hold their rows", "[app][manual]") {
  CHECK(count(make_variables_page().text, "<tr>") == output_variables().size() + 1);
  const std::string foreign = make_foreign_page().text;
  CHECK(count(foreign, "<tr>") ==
        foreign_keywords().size() + foreign_programs().size() + left_out_rows().size());
  const std::string commands = make_command_line_page(test::sample_commands()).text;
  CHECK_THAT(commands, Contains("<code>-o, --output <i>FILE</i></code>") && Contains("<h2 id=\"sort\">"));
  CHECK(make_html_manual(test::sample_commands()).size() == 5);
}
