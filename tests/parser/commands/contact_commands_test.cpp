// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/contact_commands.hpp"

#include "support/bound_region.hpp"
#include "support/catch.hpp"

using namespace contactsim;

TEST_CASE("a contact definition may have a name and periods", "[parser][contact]") {
  const BoundRegion bound = bound_region("begin contact definition c\n active periods = p1 p2\nend\n");
  CHECK(bound.messages == "");
  CHECK(bound.region.contact->name.text == "c");
  CHECK(joined_names(bound.region.contact->periods.active) == "p1 p2");
}

TEST_CASE("a second contact definition in a region is refused at its place", "[parser][contact]") {
  const std::string deck =
      "begin contact definition one\nend\nbegin contact definition two\n contact surface t contains b\nend\n";
  const std::string hint =
      "; the first stands at a.i:1:26; one definition names the surfaces of all periods, and ACTIVE PERIODS "
      "in "
      "its interactions, with INTERACTION BEHAVIOR = NO_INTERACTION too, says which pairs meet when";
  CHECK(bound_region(deck).messages ==
        "a.i:3:26: error: a second CONTACT DEFINITION in one region is not supported" + hint + "\n");
  const BoundRegion lenient = bound_region(deck, true);
  CHECK(lenient.messages ==
        "a.i:3:26: warning: a second CONTACT DEFINITION in one region is not supported, passed over" + hint +
            " [deck-refused]\n");
  CHECK(lenient.region.contact->name.text == "one");
  CHECK(lenient.region.contact->surface_commands.empty());
}

TEST_CASE("smoothed surfaces and older analytic surfaces are refused", "[parser][contact]") {
  CHECK(bound_contact("contact smooth surface s contains b\nbegin analytic plane p\nend\n").messages ==
        "a.i:2:1: error: 'contact smooth surface' is not supported and would change the answer; "
        "write CONTACT SURFACE, and SMOOTHING = AUTO in the interaction, or the shape in BEGIN SURFACE "
        "SMOOTHING\n"
        "a.i:3:7: error: block 'analytic plane' is not supported and would change the answer; "
        "write BEGIN ANALYTIC OBJECT, TYPE = PLANE, in the region\n");
}

TEST_CASE("an unknown line of a contact definition names the nearest known one", "[parser][contact]") {
  CHECK(bound_contact("skin al blocks = on\nbegin tide model t\nend\n").messages ==
        "a.i:2:1: error: unknown command 'skin al blocks = ...' in 'contact definition'; did you "
        "mean 'skin all blocks'?\n"
        "a.i:3:7: error: unknown block 'tide model t' in 'contact definition'; did you mean "
        "'begin tied model'?\n");
}
