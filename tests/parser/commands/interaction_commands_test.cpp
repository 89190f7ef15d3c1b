// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/interaction_commands.hpp"

#include "support/bound_region.hpp"
#include "support/catch.hpp"

using namespace contactsim;

TEST_CASE("interaction defaults are off, and say nothing about pairs, until a line does",
          "[parser][interaction]") {
  CHECK_FALSE(bound_contact("").contact.interaction_defaults);
  const BoundContact bound = bound_contact("begin interaction defaults\nend\n");
  CHECK(bound.messages == "");
  const InteractionDefaults& defaults = bound.contact.interaction_defaults.value();
  CHECK_FALSE(defaults.general_contact);
  CHECK_FALSE(defaults.self_contact);
  CHECK(defaults.surfaces.empty());
  CHECK_FALSE(defaults.pair.friction_model);
  CHECK_FALSE(defaults.pair.formulation);
  CHECK_FALSE(defaults.pair.behavior);
  CHECK_FALSE(defaults.pair.normal_tolerance);
}

TEST_CASE("interaction defaults take all of their lines", "[parser][interaction]") {
  const BoundContact bound = bound_contact(
      "begin interaction defaults all\ngeneral contact = on\nself contact = on\nfriction model = "
      "rub\nsurfaces = a b\n"
      "constraint formulation = node_face\ninteraction behavior = infinitesimal_sliding\nend\n");
  CHECK(bound.messages == "");
  const InteractionDefaults& defaults = bound.contact.interaction_defaults.value();
  CHECK(defaults.name.text == "all");
  CHECK(defaults.general_contact);
  CHECK(defaults.self_contact);
  CHECK(defaults.pair.friction_model->text == "rub");
  CHECK(joined_names(defaults.surfaces) == "a b");
  CHECK(defaults.pair.formulation == ConstraintFormulation::node_face);
  CHECK(defaults.pair.behavior == InteractionBehavior::infinitesimal_sliding);
}

TEST_CASE("the defaults exclude surfaces line by line", "[parser][interaction]") {
  const BoundContact bound =
      bound_contact("begin interaction defaults\nexclude surfaces = a b\nexclude_surfaces c\nend\n");
  CHECK(bound.messages == "");
  const InteractionDefaults& defaults = bound.contact.interaction_defaults.value();
  REQUIRE(defaults.exclusions.size() == 2);
  CHECK(joined_names(defaults.exclusions[0].surfaces) == "a b");
  CHECK(to_string(defaults.exclusions[0].location) == "a.i:3:1");
  CHECK(joined_names(defaults.exclusions[1].surfaces) == "c");
}

TEST_CASE("the defaults block of 2003 has tolerances", "[parser][interaction]") {
  const BoundContact bound = bound_contact(
      "begin defaults\nself contact = off\ngeneral contact = on\ncontact surfaces = a\nnormal tolerance = "
      "0.1\n"
      "tangential tolerance = 0.2\noverlap normal tolerance = 0.3\noverlap tangential tolerance = 0.4\nend "
      "defaults\n");
  CHECK(bound.messages == "");
  const InteractionDefaults& defaults = bound.contact.interaction_defaults.value();
  CHECK(defaults.general_contact);
  CHECK(joined_names(defaults.surfaces) == "a");
  CHECK(defaults.pair.normal_tolerance == 0.1);
  CHECK(defaults.pair.tangential_tolerance == 0.2);
  CHECK(defaults.pair.overlap_normal_tolerance == 0.3);
  CHECK(defaults.pair.overlap_tangential_tolerance == 0.4);
}

TEST_CASE("a second block of defaults is an error", "[parser][interaction]") {
  CHECK(bound_contact("begin interaction defaults\nend\nbegin defaults d\nend\n").messages ==
        "a.i:4:16: error: a second INTERACTION DEFAULTS in one contact definition; the first stands at "
        "a.i:2:1\n");
}

TEST_CASE("interactions need no names and keep their order", "[parser][interaction]") {
  const BoundContact bound = bound_contact(
      "begin interaction\nsurfaces = a b c\nend\nbegin interaction tie\nsurfaces a a\nfriction model = "
      "tied\nend\n");
  CHECK(bound.messages == "");
  REQUIRE(bound.contact.interactions.size() == 2);
  CHECK(joined_names(bound.contact.interactions[0].surfaces) == "a b c");
  CHECK(to_string(bound.contact.interactions[0].name.location) == "a.i:2:1");
  CHECK(bound.contact.interactions[1].name.text == "tie");
  CHECK(joined_names(bound.contact.interactions[1].surfaces) == "a a");
  CHECK(bound.contact.interactions[1].pair.friction_model->text == "tied");
}

TEST_CASE("sides have a newer and an older spelling", "[parser][interaction]") {
  for (const std::string lines :
       {"side a = x y\nside b = z\n", "master = x y\nslave = z\n", "SIDE_A IS x y\nSide_B z\n"}) {
    const BoundContact bound = bound_contact("begin interaction\n" + lines + "end\n");
    CHECK(bound.messages == "");
    CHECK(joined_names(bound.contact.interactions.at(0).side_a) == "x y");
    CHECK(joined_names(bound.contact.interactions.at(0).side_b) == "z");
  }
}

TEST_CASE("an interaction takes all of its lines", "[parser][interaction]") {
  const BoundContact bound = bound_contact(
      "begin interaction\nsurfaces = a b\nconstraint formulation = face_face\nnormal tolerance = 1\n"
      "tangential tolerance = 2\noverlap normal tolerance = 3\noverlap tangential tolerance = 4\n"
      "capture tolerance = 5\ninteraction behavior = no_interaction\nfriction coefficient = 0.2\n"
      "active periods = p1\nend\n");
  CHECK(bound.messages == "");
  const Interaction& interaction = bound.contact.interactions.at(0);
  CHECK(interaction.pair.formulation == ConstraintFormulation::face_face);
  CHECK(interaction.pair.normal_tolerance == 1.0);
  CHECK(interaction.pair.tangential_tolerance == 2.0);
  CHECK(interaction.pair.overlap_normal_tolerance == 3.0);
  CHECK(interaction.pair.overlap_tangential_tolerance == 4.0);
  CHECK(interaction.pair.capture_tolerance == 5.0);
  CHECK(interaction.pair.behavior == InteractionBehavior::no_interaction);
  CHECK(interaction.friction_coefficient == 0.2);
  CHECK(joined_names(interaction.periods.active) == "p1");
}

TEST_CASE("pairs and their defaults take a penalty stiffness and a damping", "[parser][interaction]") {
  const std::string lines = "penalty scale = 0.5\npenalty stiffness = 1e9\ncontact damping fraction = 0.1\n";
  const BoundContact bound = bound_contact("begin interaction defaults\n" + lines +
                                           "end\nbegin interaction\nsurfaces = a b\n" + lines + "end\n");
  CHECK(bound.messages == "");
  for (const PairSettings& pair :
       {bound.contact.interaction_defaults.value().pair, bound.contact.interactions.at(0).pair}) {
    CHECK(pair.penalty_scale == 0.5);
    CHECK(pair.penalty_stiffness == PenaltyStiffness{1e9});
    CHECK(pair.damping_fraction == 0.1);
  }
}

TEST_CASE("pairs and their defaults take a search distance, or AUTO", "[parser][interaction]") {
  const BoundContact bound = bound_contact(
      "begin interaction defaults\nsearch distance = auto\nend\nbegin interaction\nsurfaces = a b\n"
      "srchdis = 0.25\nend\n");
  CHECK(bound.messages == "");
  CHECK(bound.contact.interaction_defaults->pair.search_distance == SearchDistance{});
  CHECK(bound.contact.interactions.at(0).pair.search_distance == SearchDistance{0.25});
  CHECK_THAT(bound_contact("begin interaction\nsurfaces = a b\nsearch distance = -1\nend\n").messages,
             Catch::Contains("error"));
}

TEST_CASE("an automatic penalty stiffness can be asked for", "[parser][interaction]") {
  const BoundContact bound =
      bound_contact("begin interaction\nsurfaces = a b\npenalty stiffness = AUTO\nend\n");
  CHECK(bound.messages == "");
  CHECK(bound.contact.interactions.at(0).pair.penalty_stiffness == PenaltyStiffness{});
  CHECK_FALSE(bound.contact.interactions.at(0).pair.penalty_scale);
}

TEST_CASE("penalties must be positive and damping not negative", "[parser][interaction]") {
  CHECK(bound_contact("begin interaction\nsurfaces = a b\npenalty stiffness = 0\npenalty scale = -1\n"
                      "contact damping fraction = -0.1\nend\n")
            .messages ==
        "a.i:4:21: error: 'penalty stiffness' must be greater than 0, found '0'\n"
        "a.i:5:17: error: 'penalty scale' must be greater than 0, found '-1'\n"
        "a.i:6:28: error: 'contact damping fraction' must not be negative, found '-0.1'\n");
}

TEST_CASE("pairs and their defaults say what gaps count as", "[parser][interaction][gaps]") {
  const std::string lines = "contact offset = -0.1\noverlap ramp time = 2\nadjust = AUTO\n";
  const BoundContact bound = bound_contact("begin interaction defaults\n" + lines +
                                           "end\nbegin interaction\nsurfaces = a b\n" + lines + "end\n");
  CHECK(bound.messages == "");
  for (const PairSettings& pair :
       {bound.contact.interaction_defaults.value().pair, bound.contact.interactions.at(0).pair}) {
    CHECK(pair.gap.contact_offset == -0.1);
    CHECK(pair.gap.overlap_ramp_time == 2.0);
    CHECK(pair.gap_closure == GapClosureTolerance{});
  }
  const BoundContact others = bound_contact(
      "begin interaction\nsurfaces = a b\nignore initial overlap = on\ngap closure tolerance = 0.2\nend\n"
      "begin interaction\nsurfaces = a b\nclearance = -3\nadjust node set = n\nend\n");
  CHECK(others.messages == "");
  CHECK(others.contact.interactions.at(0).pair.gap.ignore_initial_overlap == true);
  CHECK(others.contact.interactions.at(0).pair.gap_closure == GapClosureTolerance{0.2});
  CHECK(others.contact.interactions.at(1).pair.gap.initial_clearance == -3.0);
  CHECK(others.contact.interactions.at(1).pair.adjusted_nodes.value().text == "n");
}

TEST_CASE("pairs and their defaults say whether sides part, and which of shells there are",
          "[parser][interaction][sides]") {
  const auto settings_of = [](const std::string& lines) {
    const BoundContact bound = bound_contact("begin interaction defaults\n" + lines +
                                             "end\nbegin interaction\nsurfaces = a b\n" + lines + "end\n");
    CHECK(bound.messages == "");
    const PairSettings& defaults = bound.contact.interaction_defaults.value().pair;
    CHECK(defaults.separation == bound.contact.interactions.at(0).pair.separation);
    CHECK(defaults.sides == bound.contact.interactions.at(0).pair.sides);
    return defaults;
  };
  CHECK_FALSE(settings_of("").separation);
  CHECK_FALSE(settings_of("").sides);
  for (const char* word : {"off", "NO"})
    CHECK(settings_of(std::string("separation = ") + word + "\n").separation == false);
  for (const char* word : {"on", "yes"})
    CHECK(settings_of(std::string("separation = ") + word + "\n").separation == true);
  for (const char* line : {"sides = top", "morient = NORM", "sides = spos"})
    CHECK(settings_of(std::string(line) + "\n").sides == ShellSides::top);
  for (const char* line : {"sides = bottom", "morient = revnorm", "sides = SNEG"})
    CHECK(settings_of(std::string(line) + "\n").sides == ShellSides::bottom);
  for (const char* line : {"sides = both", "morient = opengap", "sides = two sided"})
    CHECK(settings_of(std::string(line) + "\n").sides == ShellSides::both);
}

TEST_CASE("a side that depends on where bodies stand has to be named", "[parser][interaction][sides]") {
  CHECK_THAT(bound_contact("begin interaction\nsurfaces = a b\nmorient = overlap\nend\n").messages,
             Catch::Contains("OVERLAP goes by where the sides are at the start; name the side"));
  CHECK_THAT(bound_contact("begin interaction\nsurfaces = a b\nsides = tops\nend\n").messages,
             Catch::Contains("'top'"));
}

TEST_CASE("lines of other algorithms are ignored with a reason", "[parser][interaction]") {
  const BoundContact bound = bound_contact(
      "begin interaction\nsurfaces = a b\nkinematic partition = 0.5\nautomatic kinematic partition\n"
      "tension release = 1\nslip penalty = 2\npushback factor = 1.0\nend\n");
  CHECK(bound.messages ==
        "a.i:4:1: warning: 'kinematic partition' has no effect here; of ACME's enforcement; "
        "penalties are balanced [deck-ignored]\n"
        "a.i:5:1: warning: 'automatic kinematic partition' has no effect here; of ACME's "
        "enforcement; penalties are balanced [deck-ignored]\n"
        "a.i:6:1: warning: 'tension release' has no effect here; of implicit runs only "
        "[deck-ignored]\n"
        "a.i:7:1: warning: 'slip penalty' has no effect here; of implicit runs only "
        "[deck-ignored]\n"
        "a.i:8:1: warning: 'pushback factor' has no effect here; penalties push back by their "
        "stiffness alone [deck-ignored]\n");
}

TEST_CASE("a misspelt choice is corrected", "[parser][interaction]") {
  CHECK(bound_contact("begin interaction\nconstraint formulation = face_fase\nend\n").messages ==
        "a.i:3:26: error: expected one of node_face, face_face for 'constraint formulation', "
        "found 'face_fase'; did you mean 'face_face'?\n");
}
