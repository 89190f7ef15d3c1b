// SPDX-License-Identifier: BSD-3-Clause
#include "app/manual/html_frame.hpp"

#include "support/catch.hpp"

using namespace contactsim;
using Catch::Matchers::Contains;

TEST_CASE("text and anchors are as HTML wants them", "[app][manual]") {
  CHECK(html_text("a < b & \"c\"") == "a &lt; b &amp; &quot;c&quot;");
  CHECK(html_anchor("Deck: PRESTO (region)") == "deck-presto-region");
  CHECK_THAT(html_page("A & B", "text"),
             Contains("<title>A &amp; B - contactsim") && Contains("<main>\ntext</main>"));
}

TEST_CASE("anchors have no hyphens at their ends, nor two in a row", "[app][manual]") {
  CHECK(html_anchor("") == "");
  CHECK(html_anchor(" -- ") == "");
  CHECK(html_anchor("(a)  B_2!") == "a-b-2");
  CHECK(html_anchor("gr\xc3\xbc\xc3\x9f") == "gr");
}

TEST_CASE("a page leads to all pages that the program writes, and leaves room for others", "[app][manual]") {
  const std::string page = html_page("A", "");
  for (const char* name :
       {"command_line.html", "reference.html", "variables.html", "coming_from.html", "style.css"})
    CHECK_THAT(page, Contains("href=\"" + std::string(name) + "\""));
  CHECK_THAT(page, Contains("\n<!-- pages -->\n"));
  CHECK(page.ends_with("</main>\n</body>\n</html>\n"));
  CHECK(html_style().path == "style.css");
}
