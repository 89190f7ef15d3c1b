// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/deck_commands.hpp"

#include "support/deck_line.hpp"
#include "support/parsed_deck.hpp"

using namespace contactsim;

namespace {

DeckForm form_of(const std::string& text) { return find_deck_form(block_of(text)); }

}  // namespace

TEST_CASE("the outermost blocks of a deck tell what it holds", "[parser][deck]") {
  CHECK(form_of("begin sierra a title\nend\n") == DeckForm::full);
  CHECK(form_of("BEGIN SIERRA\nend\n") == DeckForm::full);
  CHECK(form_of("begin contact definition c\nend\n") == DeckForm::contact_definition);
  CHECK(form_of("begin contact_definition\nend\nbegin sierra\nend\n") == DeckForm::full);
  CHECK(form_of("contact surface a contains b\n") == DeckForm::contact_commands);
  CHECK(form_of("") == DeckForm::contact_commands);
  // Commands are no blocks, and a block inside another one is not outermost.
  CHECK(form_of("sierra = 1\n") == DeckForm::contact_commands);
  CHECK(form_of("begin interaction\nbegin contact definition\nend\nend\n") == DeckForm::contact_commands);
}

TEST_CASE("each form of a deck has a table of its own, which knows BEGIN SIERRA", "[parser][deck]") {
  const auto& full = deck_table(DeckForm::full).text();
  CHECK(full.rows.size() == 1);
  CHECK(full.rows[0].phrase == "sierra");
  for (const DeckForm form : {DeckForm::contact_definition, DeckForm::contact_commands}) {
    const TableText& text = deck_table(form).text();
    CHECK(&text == &deck_table(form).text());
    CHECK(text.rows.size() > 20);
    CHECK(text.rows[0].phrase == "sierra");
  }
}

TEST_CASE("a fragment of contact is bound into a region without a name", "[parser][deck]") {
  for (const std::string& text : {std::string("contact surface a contains b\n"),
                                  std::string("begin contact definition\ncontact surface a "
                                              "contains b\nend\n")}) {
    const ParsedDeck deck = parsed(text);
    CHECK(deck.messages == "");
    const Region& region = deck.simulation.procedures.at(0).regions.at(0);
    CHECK(region.name.text == "");
    REQUIRE(region.contact);
    CHECK(region.contact->surface_commands.size() == 1);
  }
}

TEST_CASE("a second BEGIN SIERRA is reported with the place of the first", "[parser][deck]") {
  CHECK(parsed("begin sierra a\nend\nbegin sierra b\nend\n")
            .messages.find(
                "a.i:3:1: error: a second BEGIN SIERRA in one deck; the first stands at a.i:1:1\n") !=
        std::string::npos);
}
