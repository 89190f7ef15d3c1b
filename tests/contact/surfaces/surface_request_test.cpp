// SPDX-License-Identifier: BSD-3-Clause
#include "contact/surfaces/surface_request.hpp"

#include "support/asked_model.hpp"
#include "support/catch.hpp"
#include "support/contact_deck.hpp"
#include "support/deck_dump.hpp"

// What is wrong in a deck's surface-making commands. Columns count from 1: in "contact surface s contains x"
// the name s stands in column 17 and x in 28; in "begin contact surface s" s stands in column 23.

using namespace contactsim;
using namespace contactsim::test;

namespace {

std::string request_errors(const std::string& lines) {
  return resolve(asked_model().build(), lines).messages;
}

}  // namespace

TEST_CASE("two surfaces with one name are an error at the second", "[contact][request]") {
  CHECK(request_errors("contact surface Top contains block_1\n"
                       "contact node set TOP contains corners\n") ==
        "c.i:2:18: error: a second contact surface with the name 'TOP'; the first stands at c.i:1:17\n");
}

TEST_CASE("a surface may not have the name of a block of SKIN ALL BLOCKS", "[contact][request]") {
  CHECK(request_errors("contact surface SKIN contains block_1\n"
                       "skin all blocks = on exclude plate dust\n") ==
        "c.i:2:1: error: a second contact surface with the name 'skin'; the first stands at c.i:1:17\n");
  CHECK(request_errors("skin all blocks = on exclude block_1 dust\n"
                       "contact surface block_3 contains block_1\n") ==
        "c.i:2:17: error: a second contact surface with the name 'block_3'; the first stands at c.i:1:1\n");
  CHECK(
      request_errors("skin all blocks = on exclude skin block_3 dust\nskin all blocks = on exclude dust\n") ==
      "c.i:2:1: error: a second contact surface with the name 'plate'; the first stands at c.i:1:1\n");
}

TEST_CASE("the name of a subset must be free", "[contact][request]") {
  const std::string block =
      "begin contact surface s\n"
      "  block = block_1\n"
      "  subset x with normal 1 0 0\n"
      "  subset X with normal 0 1 0\n"
      "end\n";
  CHECK(request_errors(block) ==
        "c.i:4:10: error: a second contact surface with the name 's_X'; the first stands at c.i:3:10\n");
  CHECK(request_errors("contact surface s_up contains skin\n"
                       "begin contact surface s\n"
                       "  block = block_1\n"
                       "  subset up with normal 0 0 1\n"
                       "end\n") ==
        "c.i:4:10: error: a second contact surface with the name 's_up'; the first stands at c.i:1:17\n");
}

TEST_CASE("a name of two kinds is clear only to a command that takes one of them", "[contact][request]") {
  const std::string error =
      "error: 'plate' is the name of a block and a side set in the mesh; use the name with its id, such as "
      "block_<id> or surface_<id>\n";
  CHECK(request_errors("contact surface s contains plate\n") == "c.i:1:28: " + error);
  CHECK(request_errors("contact node set s contains plate\n") == "c.i:1:29: " + error);
  CHECK(request_errors("begin contact surface s\n block = plate\n remove surface = plate\nend\n").empty());
  CHECK(request_errors("contact surface s contains block_1 surface_10\n").empty());
  CHECK(request_errors("skin all blocks = on exclude plate\n").empty());
}

TEST_CASE("an analytic object has one surface and a name of its own", "[contact][request]") {
  const std::string objects =
      "begin analytic object floor\n normal direction = 0 0 1\nend\n"
      "begin analytic object skin\n normal direction = 0 0 1\nend\n"
      "begin contact definition\n";
  const Mesh mesh = asked_model().build();
  const auto twice = resolve(mesh, parse_region(objects + "contact surface a contains floor\n"
                                                          "contact surface b contains block_1 Floor\n"
                                                          "end\n"));
  CHECK(twice.messages ==
        "c.i:9:36: error: analytic object 'Floor' is already in surface 'a'; it was claimed at c.i:8:28\n");
  const auto both = resolve(mesh, parse_region(objects + "contact surface a contains skin\nend\n"));
  CHECK(both.messages ==
        "c.i:8:28: error: 'skin' is both an analytic object and a part of the mesh; rename the analytic "
        "object\n");
}

TEST_CASE("all that is wrong appears in one run", "[contact][request]") {
  CHECK(request_errors("contact surface a contains plat block_3\n"
                       "contact surface a contains block_33\n"
                       "begin contact surface b\n  surface = skin\n  element = 1\nend\n") ==
        "c.i:1:28: error: the mesh has no side set, block or assembly 'plat'; did you mean 'plate'?\n"
        "c.i:2:17: error: a second contact surface with the name 'a'; the first stands at c.i:1:17\n"
        "c.i:2:28: error: the mesh has no side set, block or assembly 'block_33'; did you mean 'block_3'?\n"
        "c.i:4:13: error: 'skin' is a block of the mesh, but BEGIN CONTACT SURFACE takes a side set\n"
        "c.i:5:13: error: element 1 is a HEX8 of block 'plate'; ELEMENT picks lofted elements only (shells, "
        "beams, particles)\n");
}

TEST_CASE("requests hold positions in the mesh, each once", "[contact][request]") {
  const Mesh mesh = asked_model().build();
  const ContactDefinition contact = parse_contact(
      "begin contact surface s\n"
      "  include all blocks\n"
      "  block = skin block_2\n"
      "  remove block = block_3\n"
      "  surface = surface_10 sideset_10\n"
      "  subset up with normal 0 0 4\n"
      "end\n"
      "contact node set n contains corners nodelist_20 plate_ring\n");
  Diagnostics diagnostics;
  const auto requests = make_surface_requests(contact, {}, mesh, diagnostics);
  CHECK(messages(diagnostics) ==
        "c.i:8:49: error: the mesh has no node set, side set, block or assembly 'plate_ring'\n");
  REQUIRE(requests.size() == 2);
  CHECK(requests[0].blocks == std::vector<std::uint32_t>{0, 1});
  CHECK(requests[0].removed_blocks == std::vector<std::uint32_t>{2});
  CHECK(requests[0].particle_blocks_left_out == std::vector<std::uint32_t>{3});
  CHECK(requests[0].side_sets == std::vector<std::uint32_t>{0});
  CHECK(requests[0].is_block_form);
  CHECK(requests[0].subsets.at(0).name == "s_up");
  CHECK(requests[0].subsets.at(0).normal == Eigen::Vector3d::UnitZ());
  CHECK(requests[1].node_sets == std::vector<std::uint32_t>{0});
  CHECK(requests[1].kind == SurfaceKind::node);
}
