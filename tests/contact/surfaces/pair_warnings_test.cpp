// SPDX-License-Identifier: BSD-3-Clause
#include "contact/surfaces/pair_warnings.hpp"

#include "support/catch.hpp"
#include "support/contact_deck.hpp"
#include "support/deck_dump.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// Three surfaces, and interactions in lines 1, 3 and 5 of a deck; the second one has no name.
struct NotedPairs {
  ContactDefinition contact =
      parse_contact("begin interaction rub\nend\nbegin interaction\nend\nbegin interaction slide\nend\n");
  SurfaceList surfaces;
  std::vector<PairExclusion> exclusions;
  PairWarnings warnings{contact, surfaces};

  NotedPairs() {
    for (const char* name : {"a", "b", "c"}) surfaces.emplace_back().name = name;
    PairExclusion exclusion{"apart", contact.interactions[2].name.location, true};
    exclusions.push_back(exclusion);
  }
  std::string told() const {
    Diagnostics diagnostics;
    warnings.add_to(exclusions, diagnostics);
    return messages(diagnostics);
  }
};

const PairKey a_b{{0}, {1}}, a_c{{0}, {2}}, b_c{{1}, {2}};

}  // namespace

TEST_CASE("an interaction without a name is known by its number", "[contact][pairs]") {
  const NotedPairs pairs;
  CHECK(name_of_interaction(pairs.contact, 0) == "rub");
  CHECK(name_of_interaction(pairs.contact, 1) == "interaction 2");
}

TEST_CASE("what overrides an interaction is told once for all pairs that both have", "[contact][pairs]") {
  NotedPairs pairs;
  CHECK(pairs.told().empty());
  pairs.warnings.note(a_b, {.interaction = 0, .by = 1});
  pairs.warnings.note(b_c, {.interaction = 0, .by = 1});
  pairs.warnings.note(a_c, {.interaction = 0, .by = 2});
  CHECK(
      pairs.told() ==
      "c.i:3:1: warning: 'interaction 2' overrides 'rub' for the pair of 'a' and 'b' and 1 more; the earlier "
      "one stands at c.i:1:19 [interaction-overridden]\n"
      "c.i:5:19: warning: 'slide' overrides 'rub' for the pair of 'a' and 'c'; the earlier one stands at "
      "c.i:1:19 [interaction-overridden]\n");
}

TEST_CASE("an exclusion is told as one, and one without effect too", "[contact][pairs]") {
  NotedPairs pairs;
  pairs.warnings.note(b_c, {.interaction = 0, .by = 0, .is_by_exclusion = true});
  CHECK(
      pairs.told() ==
      "c.i:5:19: warning: 'apart' overrides 'rub' for the pair of 'b' and 'c'; exclusions win in any order; "
      "the interaction stands at c.i:1:19 [interaction-overridden]\n");
  NotedPairs idle;
  idle.exclusions[0].has_effect = false;
  CHECK(idle.told() ==
        "c.i:5:19: warning: 'apart' takes out pairs that do not meet without it either; no interaction names "
        "them, nor does GENERAL or SELF CONTACT [exclusion-without-effect]\n");
}

TEST_CASE("surfaces on both sides, or of nodes, are told once for an interaction", "[contact][pairs]") {
  NotedPairs pairs;
  for (const SurfaceIndex surface : {SurfaceIndex{2}, SurfaceIndex{1}, SurfaceIndex{2}})
    pairs.warnings.note_both_sides(0, surface);
  pairs.warnings.note_nodes(2, {0});
  CHECK(
      pairs.told() ==
      "c.i:1:19: warning: 'rub' has 'b' and 1 more on both sides; both give faces and nodes; a surface meets "
      "itself both ways: SURFACES with its name alone says so [one-sided-self]\n"
      "c.i:5:19: warning: 'slide' asks for FACE_FACE of 'a', a surface of nodes; NODE_FACE is taken; write "
      "CONSTRAINT FORMULATION = NODE_FACE, or make it a surface of faces [node-set-face-face]\n");
}

TEST_CASE("pairs that load steps press by weighted gaps are told once for a line", "[contact][pairs]") {
  NotedPairs pairs;
  SurfacePair pair;
  for (const std::size_t i : {0, 2, 0}) {
    pair.interaction = name_of_interaction(pairs.contact, i);
    pair.location = pairs.contact.interactions[i].name.location;
    pairs.warnings.note_weighted(pair);
  }
  const std::string told = pairs.told();
  CHECK(std::ranges::count(told, '\n') == 2);
  CHECK_THAT(told, Catch::Matchers::Contains("c.i:1:19: warning: 'rub' asks for NODE_FACE") &&
                       Catch::Matchers::Contains("c.i:5:19: warning: 'slide' asks for NODE_FACE") &&
                       Catch::Matchers::Contains("[node-face-weighted]"));
}
