// SPDX-License-Identifier: BSD-3-Clause
#include "app/manual/man_pages.hpp"

#include <fmt/format.h>

#include "app/manual/sample_commands.hpp"
#include "parser/row_reference.hpp"
#include "support/catch.hpp"

using namespace contactsim;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

TEST_CASE("the page of the program has its options, those of subcommands and their footers",
          "[app][manual]") {
  const ManualFile page = make_program_page(test::sample_commands());
  CHECK(page.path == "man1/contactsim.1");
  CHECK_THAT(page.text, StartsWith(".TH CONTACTSIM 1"));
  CHECK_THAT(page.text,
             Contains("\\fB\\-o\\fR, \\fB\\-\\-output\\fR \\fIFILE\\fR\nResults [of a run]: here\n"));
  CHECK_THAT(page.text, Contains(".nf\nExamples:   a\\-b\n.fi\n"));
  CHECK_THAT(page.text, Contains(".SH SORT\nSorts.\n.TP\n\\fIKIND\\fR\nHow\n"));
  CHECK_THAT(page.text, Contains("\n\\&.begins with a stop\n"));
  CHECK_THAT(page.text, Contains("\n.B contactsim sort\n.RI [ options ]\n.I KIND\n"));
}

TEST_CASE("the page of decks has each row of the command tree once", "[app][manual]") {
  const std::string text = make_deck_page().text;
  std::size_t n_entries = 0;
  for (std::size_t at = text.find("\n.TP\n"); at != std::string::npos; at = text.find("\n.TP\n", at + 1))
    ++n_entries;
  CHECK(n_entries == command_tree().size());
  CHECK_THAT(text, Contains(".TP\n\\fBFRICTION COEFFICIENT = <real >= 0>\\fR\nCoulomb coefficient"));
  CHECK_THAT(text, Contains(".SH SIERRA > PRESTO PROCEDURE > PRESTO REGION > CONTACT DEFINITION\n"));
  CHECK_THAT(text, Contains("\ninside: as in "));
}
