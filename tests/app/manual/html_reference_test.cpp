// SPDX-License-Identifier: BSD-3-Clause
#include "app/manual/count_parts.hpp"
#include "app/manual/html_frame.hpp"
#include "app/manual/html_manual.hpp"
#include "parser/command_tree.hpp"
#include "parser/row_reference.hpp"
#include "support/catch.hpp"

using namespace contactsim;
using contactsim::test::count_parts;

TEST_CASE("the reference has every row, and its links lead somewhere", "[app][manual]") {
  const std::string text = make_reference_page().text;
  for (const TreeRow& entry : command_tree()) {
    INFO(entry.row->phrase);
    const bool has_row =
        text.find("<code>" + html_text(reference_of(entry).form) + "</code>") != std::string::npos;
    CHECK(has_row);
  }
  CHECK(count_parts(text, "<div class=\"row") == command_tree().size());
  for (std::size_t at = text.find("href=\"#"); at != std::string::npos; at = text.find("href=\"#", at + 1)) {
    const std::string anchor = text.substr(at + 7, text.find('"', at + 7) - at - 7);
    INFO(anchor);
    CHECK(count_parts(text, "id=\"" + anchor + "\"") == 1);
  }
}
