// SPDX-License-Identifier: BSD-3-Clause
#include "app/manual/html_manual.hpp"

#include "app/manual/count_parts.hpp"
#include "app/manual/foreign_keywords.hpp"
#include "app/manual/sample_commands.hpp"
#include "app/manual/variable_rows.hpp"
#include "support/catch.hpp"

using namespace contactsim;
using Catch::Matchers::Contains;
using contactsim::test::count_parts;

TEST_CASE("pages of variables, other programs and the command line hold their rows", "[app][manual]") {
  CHECK(count_parts(make_variables_page().text, "<tr>") == output_variables().size() + 1);
  const std::string foreign = make_foreign_page().text;
  CHECK(count_parts(foreign, "<tr>") ==
        foreign_keywords().size() + foreign_programs().size() + left_out_rows().size());
  const std::string commands = make_command_line_page(test::sample_commands()).text;
  CHECK_THAT(commands, Contains("<code>-o, --output <i>FILE</i></code>") && Contains("<h2 id=\"sort\">"));
  CHECK(make_html_manual(test::sample_commands()).size() == 5);
}
