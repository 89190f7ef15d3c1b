// SPDX-License-Identifier: BSD-3-Clause
#include "contact/surfaces/surface_names.hpp"

#include "contact/surfaces/resolve_surfaces.hpp"
#include "support/catch.hpp"
#include "support/contact_deck.hpp"
#include "support/deck_dump.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// The errors in references to surfaces: Top (made by a line), Top_up (a subset), block_2 (SKIN ALL BLOCKS)
/// and tips (nodes). The lines given stand from line 7 on.
std::string errors_of(const std::string& lines) {
  MeshBuilder b;
  b.add_hexes({.id = 1, .name = "plate"});
  b.add_hexes({.id = 2, .origin = {5, 0, 0}});
  b.add_node_set(3, "", {0, 1});
  const ContactDefinition contact = parse_contact(
      "begin contact surface Top\n"
      "  block = plate\n"
      "  subset up with normal 0 0 1\n"
      "end\n"
      "contact node set tips contains nodelist_3\n"
      "skin all blocks = on exclude plate\n" +
      lines);
  Diagnostics diagnostics;
  const ContactSurfaces surfaces = resolve_surfaces(contact, {}, b.build(), diagnostics);
  REQUIRE(diagnostics.empty());
  check_surface_names(contact, surfaces, diagnostics);
  return messages(diagnostics);
}

}  // namespace

TEST_CASE("interactions and options may name surfaces of every origin", "[contact][names]") {
  CHECK(errors_of("begin interaction defaults\n surfaces = top TOP_UP block_2 tips\nend\n"
                  "begin interaction\n surfaces = Block_2 Top_up\nend\n"
                  "begin interaction\n side a = tips\n side b = top\nend\n"
                  "begin surface options\n surface = top block_2\n remove surface = tips\nend\n")
            .empty());
}

TEST_CASE("ALL stands for all surfaces on a side and in an exclusion only", "[contact][names]") {
  CHECK(errors_of("begin interaction\n side a = all\n side b = ALL\nend\n"
                  "begin interaction defaults\n exclude surfaces = top all\nend\n")
            .empty());
  CHECK(errors_of("begin interaction\n surfaces = top all\nend\n"
                  "begin interaction defaults\n exclude surfaces = toop\nend\n") ==
        "c.i:8:17: error: there is no contact surface 'all'\n"
        "c.i:11:21: error: there is no contact surface 'toop'; did you mean 'Top'?\n");
}

TEST_CASE("a surface that nothing made is an error wherever it is named", "[contact][names]") {
  CHECK(errors_of("begin interaction defaults\n surfaces = top toop\nend\n") ==
        "c.i:8:17: error: there is no contact surface 'toop'; did you mean 'Top'?\n");
  CHECK(errors_of("begin interaction\n surfaces = top plate\nend\n") ==
        "c.i:8:17: error: there is no contact surface 'plate'\n");
  CHECK(errors_of("begin interaction\n side a = tipps\n side b = block_1\nend\n") ==
        "c.i:8:11: error: there is no contact surface 'tipps'; did you mean 'tips'?\n"
        "c.i:9:11: error: there is no contact surface 'block_1'; did you mean 'block_2'?\n");
  CHECK(errors_of("begin surface options\n surface = top_dp\n remove surface = nodelist_3\nend\n") ==
        "c.i:8:12: error: there is no contact surface 'top_dp'; did you mean 'Top_up'?\n"
        "c.i:9:19: error: there is no contact surface 'nodelist_3'\n");
}
