// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "app/manual/foreign_keywords.hpp"
#include "support/catch.hpp"
#include "support/program_run.hpp"

using namespace contactsim;
using Catch::Matchers::Contains;
using contactsim::test::ProgramDirectory;

namespace {

std::string explained_foreign(const std::vector<std::string>& words) {
  return explain_foreign_keywords(words);
}

}  // namespace

TEST_CASE("explain prints the page of one program or of all, and single keywords", "[app][explain]") {
  const ProgramDirectory directory;
  const auto [code, out, err] = directory.run({"explain", "coming", "from", "Abaqus"});
  CHECK(code == 0);
  CHECK_THAT(out, Contains("*CONTACT EXCLUSIONS with a, b") && Contains("EXCLUDE SURFACES = a b") &&
                      Contains("in BEGIN INTERACTION DEFAULTS") && Contains("left out, and why") &&
                      !Contains("SFPRPEN"));
  CHECK_THAT(directory.run({"explain", "coming from"}).out, Contains("SFPRPEN") && Contains("CalculiX"));
  CHECK_THAT(directory.run({"explain", "*contact", "pair,", "adjust=0.01"}).out,
             Contains("GAP CLOSURE TOLERANCE = 0.01"));
  std::size_t begin = 0;
  while (begin < out.size()) {
    const std::size_t end = std::min(out.find('\n', begin), out.size());
    CHECK(end - begin <= 100);
    begin = end + 1;
  }
  CHECK(directory.run({"explain", "coming from nowhere"}).exit_code == 2);
}

TEST_CASE("a keyword of another program is found without its stars, in any case", "[app][explain]") {
  const std::string text = explained_foreign({"*Contact", "Pair"});
  CHECK_THAT(text, Contains("Abaqus\n") && Contains("*CONTACT PAIR"));
  CHECK(explained_foreign({"contact_pair"}) == text);
  CHECK(explained_foreign({"CONTACT", "PAIR,"}) == text);
}

TEST_CASE("words that ask for no keyword of another program have no answer", "[app][explain]") {
  CHECK(explained_foreign({}) == "");
  CHECK(explained_foreign({""}) == "");
  CHECK(explained_foreign({"friction", "coefficient"}) == "");
  CHECK(explained_foreign({"coming", "from", "nowhere"}) == "");
}

TEST_CASE("the page of a program has its rows and what is left out, that of all has every program",
          "[app][explain]") {
  const std::string all = explained_foreign({"coming", "from"});
  for (const std::string_view program : foreign_programs()) {
    const std::string head = "If you come from " + std::string(program) + ": ";
    CHECK_THAT(all, Contains(head));
    const std::string own = explained_foreign({"coming_from", std::string(program)});
    CHECK(own.starts_with(head));
    CHECK_THAT(own, Contains("\nleft out, and why\n"));
    CHECK(own.find("If you come from", 1) == std::string::npos);
  }
}

TEST_CASE("places of a deck are reported as the manual says them", "[app][explain]") {
  CHECK(to_string(DeckPlace::interaction) == "in BEGIN INTERACTION");
  CHECK(to_string(DeckPlace::sierra) == "at the top");
  CHECK(to_string(DeckPlace::none) == "");
}
