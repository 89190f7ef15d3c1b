// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/contact_checks.hpp"

#include "support/bound_region.hpp"
#include "support/catch.hpp"

using namespace contactsim;

TEST_CASE("a contact surface may be used before it is made, in any case", "[parser][contact]") {
  CHECK(contact_name_messages("begin interaction\nsurfaces = A s_T\nend\ncontact surface a contains b\n"
                              "begin contact surface s\nblock = c\nsubset t with normal 1 0 0\nend\n") == "");
}

TEST_CASE("a name in an interaction must be a contact surface, not a part of the mesh", "[parser][contact]") {
  CHECK(contact_name_messages("contact surface left contains block_1\nbegin interaction\nside a = lefd\n"
                              "side b = block_1\nend\nbegin interaction defaults\nsurfaces = lft\nend\n"
                              "begin surface options\nsurface = lleft\nremove surface = up\nend\n") ==
        "a.i:4:10: error: unknown contact surface 'lefd'; did you mean 'left'?\n"
        "a.i:5:10: error: unknown contact surface 'block_1'; the deck has left\n"
        "a.i:8:12: error: unknown contact surface 'lft'; did you mean 'left'?\n"
        "a.i:11:11: error: unknown contact surface 'lleft'; did you mean 'left'?\n"
        "a.i:12:18: error: unknown contact surface 'up'; the deck has left\n");
}

TEST_CASE("ALL of a side or an exclusion is no surface's name", "[parser][contact]") {
  CHECK(contact_name_messages("contact surface left contains block_1\nbegin interaction\nside a = ALL\n"
                              "side b = left all\nend\nbegin interaction defaults\n"
                              "exclude surfaces = all left\nexclude surfaces = lft\nsurfaces = all\nend\n") ==
        "a.i:9:20: error: unknown contact surface 'lft'; did you mean 'left'?\n"
        "a.i:10:12: error: unknown contact surface 'all'; the deck has left\n");
}

TEST_CASE("with SKIN ALL BLOCKS an unknown name may be a block, which the mesh decides",
          "[parser][contact]") {
  CHECK(contact_name_messages("begin interaction\nsurfaces = block_1 block_2\nend\nskin all blocks = on\n") ==
        "");
  CHECK(
      contact_name_messages("begin interaction\nsurfaces = block_1 block_1\nend\nskin all blocks = off\n") ==
      "a.i:3:12: error: unknown contact surface 'block_1'; the deck has no contact surface\n"
      "  1 more like this, at a.i:3:20\n");
}

TEST_CASE("two contact surfaces with one name are an error at the second", "[parser][contact]") {
  CHECK(contact_name_messages("contact surface s contains a\ncontact node set S contains n\n"
                              "begin contact surface s\nblock = b\nend\n") ==
        "a.i:3:18: error: the contact surface 'S' is defined a second time; the first stands at a.i:2:17\n"
        "a.i:4:23: error: the contact surface 's' is defined a second time; the first stands at a.i:2:17\n");
}

TEST_CASE("the surface of a subset must have a name of its own", "[parser][contact]") {
  CHECK(
      contact_name_messages("contact surface s_top contains a\nbegin contact surface s\nblock = b\n"
                            "subset TOP with normal 0 0 1\nsubset bot with normal 0 0 -1\n"
                            "subset bot with normal 0 1 0\nend\n") ==
      "a.i:5:8: error: the contact surface 's_TOP' is defined a second time; the first stands at a.i:2:17\n"
      "a.i:7:8: error: the contact surface 's_bot' is defined a second time; the first stands at a.i:6:8\n");
  CHECK(
      contact_name_messages("begin contact surface s\nblock = b\nsubset top with normal 0 0 1\nend\n"
                            "contact surface s_top contains a\n") ==
      "a.i:6:17: error: the contact surface 's_top' is defined a second time; the first stands at a.i:4:8\n");
}

TEST_CASE("a contact surface block that names nothing is an error", "[parser][contact]") {
  CHECK(
      contact_name_messages("begin contact surface s\nremove block = b\nsubset t with normal 1 0 0\nend\n") ==
      "a.i:2:23: error: the contact surface 's' names nothing; give it INCLUDE ALL BLOCKS, "
      "BLOCK, ELEMENT, SURFACE or ASSEMBLY\n");
  CHECK(contact_name_messages("begin contact surface s\nelement = 3\nend\n") == "");
  CHECK(contact_name_messages("begin contact surface s\ninclude all blocks\nend\n") == "");
}

TEST_CASE("two interactions with one name are an error, unnamed ones may repeat", "[parser][contact]") {
  const std::string surfaces = "contact surface s contains b\n";
  CHECK(contact_name_messages(surfaces +
                              "begin interaction i\nsurfaces = s\nend\nbegin interaction I\nsurfaces = s\n"
                              "end\n") ==
        "a.i:6:19: error: the interaction 'I' is defined a second time; the first stands at a.i:3:19\n");
  CHECK(contact_name_messages(surfaces +
                              "begin interaction\nsurfaces = s\nend\nbegin interaction\nsurfaces = s\n"
                              "end\n") == "");
}

TEST_CASE("an interaction names surfaces or two sides", "[parser][contact]") {
  const auto interaction = [](const std::string& lines) {
    return contact_name_messages(
        "contact surface s contains b\ncontact surface t contains c\nbegin interaction\n" + lines + "end\n");
  };
  CHECK(interaction("side a = s\nside b = t\n") == "");
  CHECK(interaction("surfaces = s\n") == "");
  CHECK(interaction("") ==
        "a.i:4:1: error: the interaction names no contact surfaces; give it a SURFACES line, or SIDE A and "
        "SIDE B\n");
  CHECK(interaction("side a = s\n") == "a.i:4:1: error: the interaction has SIDE A and lacks SIDE B\n");
  CHECK(interaction("slave = s\n") == "a.i:4:1: error: the interaction has SIDE B and lacks SIDE A\n");
  CHECK(interaction("surfaces = s t\nside a = s\n") ==
        "a.i:4:1: error: the interaction takes either SURFACES or SIDE A and SIDE B, found both\n");
}

TEST_CASE("a contact node set meets faces only", "[parser][contact]") {
  const auto interaction = [](const std::string& lines) {
    return contact_name_messages(
        "contact node set n contains b\ncontact node set m contains c\n"
        "contact surface s contains c\nbegin interaction\n" +
        lines + "end\n");
  };
  CHECK(interaction("surfaces = s n\n") == "");
  CHECK(interaction("surfaces = s n m\n") == "");
  CHECK(interaction("side a = s\nside b = n\n") == "");
  CHECK(interaction("surfaces = n m\n") ==
        "a.i:6:12: error: an interaction of contact node sets alone; a node set meets faces only\n");
  CHECK(interaction("surfaces = N\n") ==
        "a.i:6:12: error: an interaction of contact node sets alone; a node set meets faces only\n");
  CHECK(interaction("side a = n\nside b = s\n") ==
        "a.i:6:10: error: the contact node set 'n' cannot be SIDE A, which gives the faces; put it in SIDE "
        "B\n");
}

TEST_CASE("a friction model and a friction coefficient contradict each other", "[parser][contact]") {
  CHECK(contact_name_messages(
            "contact surface s contains b\nbegin interaction\nsurfaces = s\nfriction model = tied\n"
            "friction coefficient = 0.1\nend\n") ==
        "a.i:6:1: error: the interaction has both a friction model and a friction coefficient; keep one "
        "of FRICTION COEFFICIENT and FRICTION MODEL; the first stands at a.i:5:1\n");
}

TEST_CASE("a pair says once what its start counts as", "[parser][contact][gaps]") {
  const auto messages = [](const std::string& block, const std::string& lines) {
    return contact_name_messages("contact surface s contains b\nbegin " + block + "\n" + lines + "end\n");
  };
  CHECK(
      messages("interaction", "surfaces = s\nignore initial overlap = on\noverlap ramp time = 1\n") ==
      "a.i:6:1: error: the interaction says twice what overlaps and gaps of the start count as; keep one of "
      "INITIAL CLEARANCE, IGNORE INITIAL OVERLAP and OVERLAP RAMP TIME; the first stands at a.i:5:1\n");
  const std::string both = "clearance = 1\ncontact offset = 1\n";
  CHECK(messages("interaction", "surfaces = s\n" + both) ==
        "a.i:3:1: error: the interaction has both CONTACT OFFSET and INITIAL CLEARANCE; the clearance is the "
        "gap "
        "that counts: leave the offset out\n");
  CHECK_THAT(messages("interaction defaults", both),
             Catch::Matchers::Contains("has both CONTACT OFFSET and INITIAL CLEARANCE"));
}

TEST_CASE("the periods of contact and of its interactions must be defined", "[parser][contact]") {
  CHECK(contact_name_messages("contact surface s contains b\nactive periods = p1 q1\nbegin interaction\n"
                              "surfaces = s\ninactive periods = q2 p2\nend\n") ==
        "a.i:3:21: error: unknown time stepping block 'q1'; did you mean 'p1'?\n"
        "a.i:6:20: error: unknown time stepping block 'q2'; did you mean 'p2'?\n");
}

TEST_CASE("the friction model of the defaults is looked up", "[parser][contact]") {
  CHECK(contact_name_messages("begin interaction defaults\nfriction model = glue\nend\n") ==
        "a.i:3:18: error: unknown friction model 'glue'; the deck has no friction model: BEGIN CONSTANT "
        "FRICTION MODEL <name>, say\n");
}
