// SPDX-License-Identifier: BSD-3-Clause
#include "contact/surfaces/surface_pairs.hpp"

#include <fmt/format.h>

#include "contact/surfaces/resolve_surfaces.hpp"
#include "core/interface_laws/interface_law_table.hpp"
#include "support/catch.hpp"
#include "support/contact_deck.hpp"
#include "support/deck_dump.hpp"

using namespace contactsim;
using Catch::Matchers::Contains;
using namespace contactsim::test;

namespace {

/// Pairs and what was reported on the way.
struct Paired {
  SurfacePairs pairs;
  std::string text;      ///< one line per pair: "a b friction 0.3 face_face (general contact)"
  std::string messages;  ///< in machine form
};

std::string describe(const ContactSurfaces& surfaces, const SurfacePair& pair) {
  return fmt::format("{} {} {} {}{} ({})\n", surfaces.surfaces[pair.first].name,
                     surfaces.surfaces[pair.second].name, describe_law(*pair.law),
                     pair.formulation == ConstraintFormulation::face_face ? "face_face" : "node_face",
                     pair.is_one_sided ? " one-sided" : "", pair.interaction);
}

/// Pairs of five surfaces, made in lines 1 to 5: bricks a, b, c, nodes n, m. `planes` adds two analytic
/// surfaces, floor and wall, in lines 6 and 7.
Paired pair_up(const std::string& lines, const std::string& planes = "", bool is_static = false) {
  MeshBuilder b;
  for (const int id : {1, 2, 3}) b.add_hexes({.id = id, .origin = {3.0 * id, 0, 0}});
  b.add_node_set(1, "", {0, 1}).add_node_set(2, "", {2, 3});
  const Region region = parse_region(planes);
  ContactDefinition contact = parse_contact(
      "contact surface a contains block_1\ncontact surface b contains block_2\n"
      "contact surface c contains block_3\ncontact node set n contains nodelist_1\n"
      "contact node set m contains nodelist_2\n" +
      lines);
  contact.enforcement.is_static = is_static;
  Diagnostics diagnostics;
  const ContactSurfaces surfaces =
      resolve_surfaces(contact, {region.analytic_planes, {}}, b.build(), diagnostics);
  REQUIRE(diagnostics.empty());
  Paired paired{make_surface_pairs(contact, surfaces, diagnostics), "", ""};
  for (const SurfacePair& pair : paired.pairs) paired.text += describe(surfaces, pair);
  paired.messages = messages(diagnostics);
  return paired;
}

std::string pairs_of(const std::string& lines) {
  const Paired paired = pair_up(lines);
  CHECK(paired.messages == "");
  return paired.text;
}

/// Pairs with two planes, whose surfaces floor and wall come after the others.
std::string pairs_with_planes(const std::string& lines) {
  const Paired paired =
      pair_up("contact surface floor contains z0\ncontact surface wall contains x0\n" + lines,
              "begin analytic object z0\n normal direction = 0 0 1\nend\n"
              "begin analytic object x0\n normal direction = 1 0 0\nend\n");
  CHECK(paired.messages == "");
  return paired.text;
}

}  // namespace

TEST_CASE("general contact pairs every surface with every other, nodes with faces only", "[contact][pairs]") {
  CHECK(pairs_of("begin interaction defaults\n general contact = on\nend\n") ==
        "a b frictionless face_face (general contact)\n"
        "a c frictionless face_face (general contact)\n"
        "a n frictionless node_face one-sided (general contact)\n"
        "a m frictionless node_face one-sided (general contact)\n"
        "b c frictionless face_face (general contact)\n"
        "b n frictionless node_face one-sided (general contact)\n"
        "b m frictionless node_face one-sided (general contact)\n"
        "c n frictionless node_face one-sided (general contact)\n"
        "c m frictionless node_face one-sided (general contact)\n");
}

TEST_CASE("self contact pairs each surface of faces with itself", "[contact][pairs]") {
  CHECK(pairs_of("begin interaction defaults\n self contact = on\nend\n") ==
        "a a frictionless face_face (self contact)\n"
        "b b frictionless face_face (self contact)\n"
        "c c frictionless face_face (self contact)\n");
}

TEST_CASE("the defaults' surfaces limit general and self contact, names in any case", "[contact][pairs]") {
  CHECK(pairs_of("begin interaction defaults\n general contact = on\n self contact = on\n surfaces = N C A\n"
                 "end\n") ==
        "a a frictionless face_face (self contact)\n"
        "a c frictionless face_face (general contact)\n"
        "a n frictionless node_face one-sided (general contact)\n"
        "c c frictionless face_face (self contact)\n"
        "c n frictionless node_face one-sided (general contact)\n");
}

TEST_CASE("an interaction pairs all that it lists; alone or twice is self contact", "[contact][pairs]") {
  CHECK(pairs_of("begin interaction\n surfaces = c B a\nend\n") ==
        "a b frictionless face_face (interaction 1)\n"
        "a c frictionless face_face (interaction 1)\n"
        "b c frictionless face_face (interaction 1)\n");
  CHECK(pairs_of("begin interaction fold\n surfaces = b\nend\n") == "b b frictionless face_face (fold)\n");
  CHECK(pairs_of("begin interaction\n surfaces = b a b\nend\n") ==
        "a b frictionless face_face (interaction 1)\n"
        "b b frictionless face_face (interaction 1)\n");
  CHECK(pairs_of("begin interaction\n surfaces = n a m\nend\n") ==
        "a n frictionless node_face one-sided (interaction 1)\n"
        "a m frictionless node_face one-sided (interaction 1)\n");
}

TEST_CASE("an interaction overrides the defaults for its pairs and inherits the rest", "[contact][pairs]") {
  const std::string deck =
      "begin constant friction model rub\n friction coefficient = 0.3\nend\n"
      "begin interaction defaults\n general contact = on\n surfaces = a b c\n friction model = Rub\n"
      " constraint formulation = node_face\nend\n";
  CHECK(pairs_of(deck + "begin interaction tie\n surfaces = a c\n friction model = TIED\nend\n") ==
        "a b friction 0.3 node_face (general contact)\n"
        "a c tied node_face (tie)\n"
        "b c friction 0.3 node_face (general contact)\n");
  CHECK(pairs_of(deck + "begin interaction\n surfaces = a c\n constraint formulation = face_face\nend\n") ==
        "a b friction 0.3 node_face (general contact)\n"
        "a c friction 0.3 face_face (interaction 1)\n"
        "b c friction 0.3 node_face (general contact)\n");
}

TEST_CASE("a friction coefficient beats the defaults' friction model", "[contact][pairs]") {
  const std::string deck = "begin interaction defaults\n friction model = tied\nend\n";
  CHECK(pairs_of(deck + "begin interaction\n surfaces = a b\n friction coefficient = 0.25\nend\n") ==
        "a b friction 0.25 face_face (interaction 1)\n");
}

TEST_CASE("an interaction without effect takes its pairs out", "[contact][pairs]") {
  CHECK(pairs_of("begin interaction defaults\n general contact = on\n surfaces = a b c\nend\n"
                 "begin interaction\n surfaces = a b\n interaction behavior = no_interaction\nend\n") ==
        "a c frictionless face_face (general contact)\n"
        "b c frictionless face_face (general contact)\n");
}

TEST_CASE("an exclusion wins wherever it stands", "[contact][pairs]") {
  const std::string on = "begin interaction rub\n surfaces = a b\n friction coefficient = 0.2\nend\n";
  const std::string off =
      "begin interaction off\n surfaces = b a\n interaction behavior = no_interaction\nend\n";
  const std::string general = "begin interaction defaults\n general contact = on\n surfaces = a b c\nend\n";
  const std::string text =
      "warning: 'off' overrides 'rub' for the pair of 'a' and 'b'; exclusions win in any order; the "
      "interaction stands at ";
  for (const bool is_first : {true, false}) {
    const Paired paired = pair_up(general + (is_first ? off + on : on + off));
    CHECK(paired.text ==
          "a c frictionless face_face (general contact)\n"
          "b c frictionless face_face (general contact)\n");
    CHECK(paired.messages == (is_first ? "c.i:10:19: " + text + "c.i:14:19 [interaction-overridden]\n"
                                       : "c.i:14:19: " + text + "c.i:10:19 [interaction-overridden]\n"));
  }
}

TEST_CASE("an exclusion of what does not meet anyway is reported", "[contact][pairs]") {
  CHECK(pair_up("begin interaction\n surfaces = a b\nend\n"
                "begin interaction off\n surfaces = a c\n interaction behavior = no_interaction\nend\n")
            .messages ==
        "c.i:9:19: warning: 'off' takes out pairs that do not meet without it either; no interaction names "
        "them, nor does GENERAL or SELF CONTACT [exclusion-without-effect]\n");
}

TEST_CASE("an exclusion with periods leaves the others to interactions", "[contact][pairs]") {
  const std::string on = "begin interaction rub\n surfaces = a b\n friction coefficient = 0.2\nend\n";
  const std::string off =
      "begin interaction off\n surfaces = a b\n interaction behavior = no_interaction\n"
      " active periods = p1 p2\nend\n";
  for (const std::string& deck : {on + off, off + on}) {
    const Paired paired = pair_up(deck);
    CHECK(paired.messages == "");
    CHECK(paired.text == "a b friction 0.2 face_face (rub)\n");
    REQUIRE(paired.pairs.size() == 1);
    CHECK(paired.pairs[{0}].periods.active.empty());
    REQUIRE(paired.pairs[{0}].periods.inactive.size() == 2);
    CHECK(paired.pairs[{0}].periods.inactive[1].text == "p2");
  }
}

TEST_CASE("outside the periods of an interaction its pairs go on as an earlier one says",
          "[contact][pairs]") {
  const Paired paired = pair_up(
      "begin interaction defaults\n surfaces = a b\n general contact = on\nend\n"
      "begin interaction rub\n surfaces = a b\n friction coefficient = 0.5\n inactive periods = p3\nend\n"
      "begin interaction tie\n surfaces = a b\n friction model = tied\n active periods = p1\nend\n");
  CHECK(paired.messages == "");
  CHECK(paired.text ==
        "a b tied face_face (tie)\n"
        "a b friction 0.5 face_face (rub)\n"
        "a b frictionless face_face (general contact)\n");
  REQUIRE(paired.pairs.size() == 3);
  CHECK(paired.pairs[{0}].periods.active.at(0).text == "p1");
  CHECK(paired.pairs[{1}].periods.inactive.size() == 2);
  CHECK(paired.pairs[{2}].periods.active.size() == 1);
  CHECK(paired.pairs[{2}].periods.active.at(0).text == "p3");
}

TEST_CASE("the defaults exclude pairs, surfaces from themselves and from everything", "[contact][pairs]") {
  const auto excluding = [](const std::string& lines) {
    return pairs_of(
        "begin interaction defaults\n general contact = on\n self contact = on\n surfaces = a b c\n" + lines +
        "end\n");
  };
  const std::string aa = "a a frictionless face_face (self contact)\n",
                    ab = "a b frictionless face_face (general contact)\n",
                    ac = "a c frictionless face_face (general contact)\n",
                    bb = "b b frictionless face_face (self contact)\n",
                    bc = "b c frictionless face_face (general contact)\n",
                    cc = "c c frictionless face_face (self contact)\n";
  CHECK(excluding("") == aa + ab + ac + bb + bc + cc);
  CHECK(excluding(" exclude surfaces = a c\n") == aa + ab + bb + bc + cc);
  CHECK(excluding(" exclude surfaces = b\n") == aa + ab + ac + bc + cc);
  CHECK(excluding(" exclude surfaces = a b c\n exclude surfaces = C c\n") == aa + bb);
  CHECK(excluding(" exclude surfaces = all a\n") == bb + bc + cc);
  CHECK(excluding(" exclude surfaces = a All b\n") == cc);
}

TEST_CASE("what the defaults exclude no interaction brings back", "[contact][pairs]") {
  const Paired paired = pair_up(
      "begin interaction rub\n surfaces = a b c\nend\n"
      "begin interaction defaults\n exclude surfaces = b a\n exclude surfaces = a n\nend\n");
  CHECK(paired.text ==
        "a c frictionless face_face (rub)\n"
        "b c frictionless face_face (rub)\n");
  CHECK(
      paired.messages ==
      "c.i:10:2: warning: 'EXCLUDE SURFACES' overrides 'rub' for the pair of 'a' and 'b'; exclusions win in "
      "any order; the interaction stands at c.i:6:19 [interaction-overridden]\n"
      "c.i:11:2: warning: 'EXCLUDE SURFACES' takes out pairs that do not meet without it either; no "
      "interaction names them, nor does GENERAL or SELF CONTACT [exclusion-without-effect]\n");
}

TEST_CASE("ALL of a side is every other surface, and itself too where that is excluded", "[contact][pairs]") {
  CHECK(pairs_of("begin interaction\n side a = b\n side b = ALL\nend\n") ==
        "a b frictionless face_face (interaction 1)\n"
        "b c frictionless face_face (interaction 1)\n"
        "b n frictionless node_face one-sided (interaction 1)\n"
        "b m frictionless node_face one-sided (interaction 1)\n");
  CHECK(pair_up("begin interaction\n side a = all b\n side b = b\n constraint formulation = node_face\nend\n")
            .text ==
        "a b frictionless node_face one-sided (interaction 1)\n"
        "b b frictionless node_face (interaction 1)\n"
        "b n frictionless node_face one-sided (interaction 1)\n"
        "b m frictionless node_face one-sided (interaction 1)\n"
        "c b frictionless node_face one-sided (interaction 1)\n");
  CHECK(pairs_of(
            "begin interaction defaults\n general contact = on\n self contact = on\n surfaces = a b n\nend\n"
            "begin interaction\n side a = all\n side b = b\n interaction behavior = no_interaction\nend\n") ==
        "a a frictionless face_face (self contact)\n"
        "a n frictionless node_face one-sided (general contact)\n");
}

TEST_CASE("outside the periods of an interaction its pairs go on as the defaults say", "[contact][pairs]") {
  const std::string defaults = "begin interaction defaults\n surfaces = a b\n general contact = on\nend\n";
  const auto timed = pair_up(defaults +
                             "begin interaction i\n surfaces = a b\n friction coefficient = 0.5\n"
                             " active periods = p1\nend\n");
  CHECK(timed.text == "a b friction 0.5 face_face (i)\na b frictionless face_face (general contact)\n");
  REQUIRE(timed.pairs.size() == 2);
  CHECK(timed.pairs[{0}].periods.active.at(0).text == "p1");
  CHECK(timed.pairs[{1}].periods.inactive.at(0).text == "p1");
  const auto off = pair_up(defaults +
                           "begin interaction i\n surfaces = a b\n"
                           " interaction behavior = no_interaction\n inactive periods = p2\nend\n");
  CHECK(off.text == "a b frictionless face_face (general contact)\n");
  REQUIRE(off.pairs.size() == 1);
  CHECK(off.pairs[{0}].periods.active.at(0).text == "p2");
}

TEST_CASE("of two interactions that name one pair the later wins, with a warning", "[contact][pairs]") {
  const Paired paired = pair_up(
      "begin interaction\n surfaces = a b c\nend\n"
      "begin interaction tie\n surfaces = b a\n friction model = tied\nend\n"
      "begin interaction last\n surfaces = a b c\n friction coefficient = 0.1\nend\n");
  CHECK(paired.text ==
        "a b friction 0.1 face_face (last)\n"
        "a c friction 0.1 face_face (last)\n"
        "b c friction 0.1 face_face (last)\n");
  CHECK(paired.messages ==
        "c.i:9:19: warning: 'tie' overrides 'interaction 1' for the pair of 'a' and 'b'; the earlier one "
        "stands at c.i:6:1 [interaction-overridden]\n"
        "c.i:13:19: warning: 'last' overrides 'interaction 1' for the pair of 'a' and 'c' and 1 more; the "
        "earlier one stands at c.i:6:1 [interaction-overridden]\n"
        "c.i:13:19: warning: 'last' overrides 'tie' for the pair of 'a' and 'b'; the earlier one stands at "
        "c.i:9:19 [interaction-overridden]\n");
}

TEST_CASE("sides make one-way pairs of faces and nodes, unless faces meet faces", "[contact][pairs]") {
  const std::string node_face = " constraint formulation = node_face\nend\n";
  CHECK(pairs_of("begin interaction\n side a = c\n side b = a b\n" + node_face) ==
        "c a frictionless node_face one-sided (interaction 1)\n"
        "c b frictionless node_face one-sided (interaction 1)\n");
  CHECK(pairs_of("begin interaction\n side a = c\n side b = a n\nend\n") ==
        "a c frictionless face_face (interaction 1)\n"
        "c n frictionless node_face one-sided (interaction 1)\n");
}

TEST_CASE("a surface on both sides meets itself both ways, with a warning", "[contact][pairs]") {
  const std::string sides = "begin interaction\n side a = a b\n side b = b a\n";
  const Paired paired = pair_up(sides + " constraint formulation = node_face\nend\n");
  CHECK(paired.text ==
        "a a frictionless node_face (interaction 1)\n"
        "a b frictionless node_face (interaction 1)\n"
        "b b frictionless node_face (interaction 1)\n");
  CHECK(paired.messages ==
        "c.i:6:1: warning: 'interaction 1' has 'a' and 1 more on both sides; both give faces and nodes; a "
        "surface "
        "meets itself both ways: SURFACES with its name alone says so [one-sided-self]\n");
  CHECK(pair_up(sides + "end\n").messages == "");
}

TEST_CASE("FACE_FACE asked for of a surface of nodes is reported", "[contact][pairs]") {
  const Paired paired =
      pair_up("begin interaction rub\n surfaces = a b n\n constraint formulation = face_face\nend\n");
  CHECK(paired.text ==
        "a b frictionless face_face (rub)\n"
        "a n frictionless node_face one-sided (rub)\n"
        "b n frictionless node_face one-sided (rub)\n");
  CHECK(paired.messages ==
        "c.i:6:19: warning: 'rub' asks for FACE_FACE of 'n', a surface of nodes; NODE_FACE is taken; write "
        "CONSTRAINT FORMULATION = NODE_FACE, or make it a surface of faces [node-set-face-face]\n");
  CHECK(pair_up("begin interaction\n surfaces = a n\nend\n").messages == "");
}

TEST_CASE("planes meet faces and nodes, never each other or themselves", "[contact][pairs]") {
  CHECK(pairs_with_planes("begin interaction defaults\n general contact = on\n self contact = on\n"
                          " surfaces = a n floor wall\nend\n") ==
        "a a frictionless face_face (self contact)\n"
        "a n frictionless node_face one-sided (general contact)\n"
        "floor a frictionless node_face one-sided (general contact)\n"
        "floor n frictionless node_face one-sided (general contact)\n"
        "wall a frictionless node_face one-sided (general contact)\n"
        "wall n frictionless node_face one-sided (general contact)\n");
  CHECK(pairs_with_planes("begin interaction\n side a = a\n side b = floor\nend\n") ==
        "floor a frictionless node_face one-sided (interaction 1)\n");
}

TEST_CASE("an interaction of which nothing can meet is an error", "[contact][pairs]") {
  CHECK(pair_up("begin interaction\n side a = n\n side b = m\nend\n").messages ==
        "c.i:6:1: error: none of the surfaces of the interaction can meet; a node set meets faces only, an "
        "analytic plane faces and nodes only\n");
  CHECK(pair_up("begin interaction\n surfaces = n\nend\n").messages.find("error: none of the surfaces") !=
        std::string::npos);
}

TEST_CASE("without a pair a definition is warned about once", "[contact][pairs]") {
  const std::string warning =
      "warning: no two contact surfaces meet, so that nothing can touch; write GENERAL CONTACT = ON in "
      "INTERACTION DEFAULTS, or an INTERACTION [contact-without-pairs]\n";
  CHECK(pair_up("").messages == warning);
  CHECK(pair_up("begin interaction defaults\n friction model = tied\nend\n").messages == warning);
}

TEST_CASE("settings come from the interaction, the defaults, the shared blocks, the program",
          "[contact][pairs]") {
  const Paired program = pair_up("begin interaction\n surfaces = a b\nend\n");
  REQUIRE(program.pairs.size() == 1);
  CHECK_FALSE(program.pairs[{0}].normal_tolerance);
  CHECK_FALSE(program.pairs[{0}].penalty_stiffness);
  CHECK(program.pairs[{0}].penalty_scale == 1.0);
  CHECK(program.pairs[{0}].damping_fraction == 0.0);
  CHECK(program.pairs[{0}].behavior == InteractionBehavior::sliding);
  const Paired paired = pair_up(
      "begin search options\n search tolerance = user_defined\n normal tolerance = 1\n tangential tolerance "
      "= 2\n"
      " capture tolerance = 3\nend\n"
      "begin remove initial overlap\n overlap normal tolerance = 4\n overlap tangential tolerance = 5\nend\n"
      "begin enforcement options\n penalty scale = 0.5\nend\n"
      "begin interaction defaults\n tangential tolerance = 20\n penalty scale = 3\n penalty stiffness = 7\n"
      " contact damping fraction = 0.1\n interaction behavior = infinitesimal_sliding\nend\n"
      "begin interaction\n surfaces = a b\n capture tolerance = 30\n contact damping fraction = 0.2\n"
      " active periods = p1\nend\n"
      "begin interaction\n surfaces = a c\n penalty stiffness = auto\nend\n");
  REQUIRE(paired.pairs.size() == 2);
  const SurfacePair& pair = paired.pairs[{0}];
  CHECK(pair.normal_tolerance == 1.0);
  CHECK(pair.tangential_tolerance == 20.0);
  CHECK(pair.capture_tolerance == 30.0);
  CHECK(pair.overlap_normal_tolerance == 4.0);
  CHECK(pair.overlap_tangential_tolerance == 5.0);
  CHECK(pair.penalty_scale == 1.5);
  CHECK(pair.penalty_stiffness == 7.0);
  CHECK(pair.damping_fraction == 0.2);
  CHECK(pair.behavior == InteractionBehavior::infinitesimal_sliding);
  CHECK_FALSE(pair.is_from_defaults);
  REQUIRE(pair.periods.active.size() == 1);
  CHECK(pair.periods.active[0].text == "p1");
  CHECK_FALSE(paired.pairs[{1}].penalty_stiffness);
  CHECK(paired.pairs[{1}].damping_fraction == 0.1);
}

TEST_CASE("a pressure of its own makes a pair elastic, whatever ENFORCEMENT says", "[contact][pairs]") {
  const std::string models =
      "begin pressure function model p\n function = f\nend\n"
      "begin hybrid model h\n initially close = p\n initially far = frictionless\nend\n"
      "begin constant friction model c\nend\n";
  const auto enforcement_of = [&](const std::string& line) {
    return pair_up(models + "begin interaction\n surfaces = a b\n enforcement = momentum_balance\n" + line +
                   "end\n")
        .pairs.at(0)
        .enforcement;
  };
  CHECK(enforcement_of("friction model = p\n") == Enforcement::penalty);
  CHECK(enforcement_of("friction model = h\n") == Enforcement::penalty);
  CHECK(enforcement_of("friction model = c\n") == Enforcement::momentum_balance);
  const Paired other = pair_up(models +
                               "begin interaction defaults\n friction model = p\nend\n"
                               "begin interaction\n surfaces = a b\n friction coefficient = 0.1\n"
                               " enforcement = momentum_balance\nend\n");
  CHECK(other.pairs.at(0).enforcement == Enforcement::momentum_balance);
}

TEST_CASE("sides of shells are those of SIDE A, or of all", "[contact][pairs]") {
  using enum ShellSides;
  using Sides = std::array<ShellSides, 2>;
  const auto sides_of = [](const std::string& lines) {
    return pair_up("begin interaction\n" + lines + " sides = top\nend\n").pairs.at(0).sides;
  };
  CHECK(sides_of(" surfaces = a b\n") == Sides{top, top});
  CHECK(sides_of(" side a = a\n side b = b\n") == Sides{top, both});
  CHECK(sides_of(" side a = b\n side b = a\n") == Sides{both, top});  // a comes first
  CHECK(sides_of(" side a = b\n side b = a\n constraint formulation = node_face\n") == Sides{top, both});
  CHECK(pair_up("begin interaction\n surfaces = a b\nend\n").pairs.at(0).separates);
  CHECK_FALSE(pair_up("begin interaction\n surfaces = a b\n separation = no\nend\n").pairs.at(0).separates);
}

TEST_CASE("tolerances of an automatic search are not taken", "[contact][pairs]") {
  const Paired paired =
      pair_up("begin search options\n normal tolerance = 1\nend\nbegin interaction\n surfaces = a b\nend\n");
  CHECK_FALSE(paired.pairs.at(0).normal_tolerance);
}

TEST_CASE("in load steps faces meet faces, nodes alone as nodes, and ties as the deck says",
          "[contact][pairs]") {
  const std::string lines =
      "begin interaction rub\n side a = c\n side b = a n\n constraint formulation = node_face\nend\n"
      "begin interaction tie\n surfaces = a b\n friction model = tied\n constraint formulation = "
      "node_face\nend\n";
  const Paired paired = pair_up(lines, "", true);
  CHECK(paired.text ==
        "a b tied node_face (tie)\n"
        "a c frictionless face_face (rub)\n"
        "c n frictionless node_face one-sided (rub)\n");
  CHECK_THAT(paired.messages, Contains("'rub' asks for NODE_FACE; in load steps") &&
                                  Contains("[node-face-weighted]") && !Contains("'tie'"));
}
