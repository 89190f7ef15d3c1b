// SPDX-License-Identifier: BSD-3-Clause
#include "contact/surfaces/block_form_request.hpp"

#include "support/asked_model.hpp"
#include "support/catch.hpp"
#include "support/contact_deck.hpp"
#include "support/deck_dump.hpp"

// Columns count from 1: in "begin contact surface s" s stands in column 23.

using namespace contactsim;
using namespace contactsim::test;

namespace {

std::string errors_of_block(const std::string& lines) {
  return resolve(asked_model().build(), lines).messages;
}

/// What a block form with these lines asks of asked_model().
struct AskedBlock {
  Mesh mesh = asked_model().build();
  Diagnostics diagnostics;
  SurfaceRequest request;

  explicit AskedBlock(const std::string& lines, const std::vector<std::uint32_t>& sizeless = {}) {
    const ContactDefinition contact = parse_contact("begin contact surface s\n" + lines + "end\n");
    const RegionNames names{{}, {}, sizeless};
    RequestParts parts(names, mesh, diagnostics);
    request = make_block_form_request(std::get<ContactSurfaceBlock>(contact.surface_commands.at(0)), parts);
  }
};

using Positions = std::vector<std::uint32_t>;

}  // namespace

TEST_CASE("a block form that names nothing is an error", "[contact][request]") {
  CHECK(errors_of_block("begin contact surface s\nend\n") ==
        "c.i:1:23: error: contact surface 's' names nothing that it could hold; add a line BLOCK, ELEMENT, "
        "SURFACE, ASSEMBLY or INCLUDE ALL BLOCKS\n");
  const std::string removes =
      errors_of_block("begin contact surface s\n remove block = block_1\n subset t with normal 1 0 0\nend\n");
  CHECK(removes.rfind("c.i:1:23: error: contact surface 's' names nothing that it could hold;", 0) == 0);
}

TEST_CASE("ELEMENT takes lofted elements that exist", "[contact][request]") {
  CHECK(errors_of_block("begin contact surface s\n  element = 2 1 99\nend\n") ==
        "c.i:2:15: error: element 1 is a HEX8 of block 'plate'; ELEMENT picks lofted elements only (shells, "
        "beams, particles)\n"
        "c.i:2:17: error: the mesh has no element with id 99\n");
}

TEST_CASE("blocks of particles are no part of a block form", "[contact][request]") {
  const std::string hint = "; use the line CONTACT SURFACE ... CONTAINS, or CONTACT NODE SET\n";
  CHECK(errors_of_block("begin contact surface s\n  block = plate dust\nend\n") ==
        "c.i:2:17: error: block 'dust' holds particles only, which BEGIN CONTACT SURFACE cannot take" + hint);
  CHECK(errors_of_block("begin contact surface s\n  assembly = mixed\nend\n") ==
        "c.i:2:14: error: block 'dust' holds particles only, which BEGIN CONTACT SURFACE cannot take" + hint);
  CHECK(errors_of_block("begin contact surface s\n  assembly = mixed\n  remove block = dust\nend\n").empty());
  CHECK(errors_of_block("begin contact surface s\n  element = 4\nend\n").empty());
  CHECK(errors_of_block("contact surface s contains dust\n").empty());
  CHECK(errors_of_block("contact node set s contains mixed\n").empty());
}

TEST_CASE("a block form holds what it names less what it removes, in any order", "[contact][request]") {
  const AskedBlock asked(
      "remove block = plate\nblock = skin plate\nblock = block_3\nremove surface = plate\n");
  CHECK(messages(asked.diagnostics).empty());
  CHECK(asked.request.blocks == Positions{1, 2});
  CHECK(asked.request.removed_blocks == Positions{0});
  CHECK(asked.request.removed_side_sets == Positions{0});
  CHECK(asked.request.side_sets.empty());
  CHECK(asked.request.is_block_form);
  CHECK(asked.request.kind == SurfaceKind::face);
  CHECK(asked.request.name == "s");
  CHECK(asked.request.command == "BEGIN CONTACT SURFACE");
  CHECK(asked.request.location.line == 1);
  const AskedBlock twice("block = plate\nremove block = block_3 skin block_3\n");
  CHECK(twice.request.removed_blocks == Positions{1, 2});  // ascending, each once
}

TEST_CASE("INCLUDE ALL BLOCKS leaves out particles, which it tells, and what has no size",
          "[contact][request]") {
  CHECK(AskedBlock("include all blocks\n").request.blocks == Positions{0, 1, 2});
  CHECK(AskedBlock("include all blocks\n").request.particle_blocks_left_out == Positions{3});
  const AskedBlock sizeless("include all blocks\n", {2, 3});
  CHECK(sizeless.request.blocks == Positions{0, 1});
  CHECK(sizeless.request.particle_blocks_left_out.empty());
  const AskedBlock removed("include all blocks\nremove block = dust skin\n");
  CHECK(removed.request.blocks == Positions{0, 2});
  CHECK(removed.request.particle_blocks_left_out.empty());
}

TEST_CASE("elements stand in the order in which they are named", "[contact][request]") {
  const AskedBlock asked("element = 4 2\nelement = 3 2\n");
  CHECK(messages(asked.diagnostics).empty());
  CHECK(asked.request.elements == std::vector<ElementIndex>{{3}, {1}, {2}, {1}});
}

TEST_CASE("subsets have names with that of the surface, and normals of length 1 in any units",
          "[contact][request]") {
  const AskedBlock asked(
      "block = plate\nsubset up with normal 0 0 1e-200\nsubset Aside with normal 3e200 4e200 0\n");
  REQUIRE(asked.request.subsets.size() == 2);
  CHECK(asked.request.subsets[0].name == "s_up");
  CHECK((asked.request.subsets[0].normal - Eigen::Vector3d::UnitZ()).norm() < 1e-14);
  CHECK(asked.request.subsets[1].name == "s_Aside");
  CHECK((asked.request.subsets[1].normal - Eigen::Vector3d(0.6, 0.8, 0)).norm() < 1e-14);
  CHECK(asked.request.subsets[1].location.line == 4);
}
