// SPDX-License-Identifier: BSD-3-Clause
#include "contact/surfaces/claims.hpp"

#include "support/catch.hpp"
#include "support/contact_deck.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// Element 1 a hexahedron, 2 and 3 shells beside one another far from it. surface_1: 1:6, 1:2 twice;
/// surface_2: the top of shell 3 and 1:1. nodelist_3: nodes 3, 1, 1.
Mesh small_model() {
  MeshBuilder b;
  b.add_hexes({.id = 1});
  b.add_shells({.id = 2, .cells = {2, 1}, .origin = {0, 0, 5}, .u = {2, 0, 0}});
  b.add_side_set(1, "", {{{0}, 6}, {{0}, 2}, {{0}, 6}});
  b.add_side_set(2, "", {{{2}, 1}, {{0}, 1}});
  b.add_node_set(3, "", std::vector<std::uint32_t>{2, 0, 0});
  return b.build();
}

using Positions = std::vector<std::uint32_t>;

struct Claims {
  Positions faces, lofted;
  std::vector<NodeIndex> nodes;
};

/// What the last of some lines claims. The candidates of all lines together: faces 1:1 to 1:6 have the
/// positions 0 to 5, 3:1 has 6; the shells have 0 and 1.
Claims claims_of(const std::string& lines, const std::vector<std::uint8_t>& alive = {}) {
  const Mesh mesh = small_model();
  const ContactDefinition contact =
      parse_contact("contact surface all contains block_1 block_2 surface_2\n" + lines);
  Diagnostics diagnostics;
  const auto requests = make_surface_requests(contact, {}, mesh, diagnostics);
  REQUIRE(diagnostics.empty());
  const ContactDomain domain(mesh, contact.subdomain, alive);
  const SkinFaces skin_faces = make_skin_faces(requests, mesh, domain);
  const SurfaceRequest& last = requests.back();
  return {claimed_faces(last, mesh, skin_faces), claimed_lofted(last, mesh, skin_faces),
          claimed_nodes(last, mesh, domain)};
}

std::string block_form(const std::string& lines) { return "begin contact surface s\n" + lines + "end\n"; }

}  // namespace

TEST_CASE("a request claims skins and side-set faces, ascending, each once", "[contact][claims]") {
  CHECK(claims_of("contact surface s contains surface_1\n").faces == Positions{1, 5});
  CHECK(claims_of("contact surface s contains surface_2 surface_1\n").faces == Positions{0, 1, 5, 6});
  const Claims both = claims_of("contact surface s contains surface_2 block_1 surface_1\n");
  CHECK(both.faces == Positions{0, 1, 2, 3, 4, 5, 6});
  CHECK(both.lofted.empty());
}

TEST_CASE("a request claims shells of its blocks and single ones, each once", "[contact][claims]") {
  CHECK(claims_of("contact surface s contains block_2 block_1\n").lofted == Positions{0, 1});
  CHECK(claims_of(block_form("element = 3 2 3\nblock = block_2\n")).lofted == Positions{0, 1});
  CHECK(claims_of(block_form("element = 3\n")).lofted == Positions{1});
}

TEST_CASE("removed side sets take faces and shells out of a claim", "[contact][claims]") {
  const Claims claims = claims_of(block_form("include all blocks\nremove surface = surface_2 surface_1\n"));
  CHECK(claims.faces == Positions{2, 3, 4});
  CHECK(claims.lofted == Positions{0});
}

TEST_CASE("nodes come from sets, sides and elements that live", "[contact][claims]") {
  const auto ids = [](const Claims& claims) {
    Positions positions;
    for (const NodeIndex node : claims.nodes) positions.push_back(node.value);
    return positions;
  };
  // Nodes of the hexahedron are 0 to 7, x fastest and z slowest; the strip's are 8 9 10 and 11 12 13.
  CHECK(ids(claims_of("contact node set n contains nodelist_3\n")) == Positions{0, 2});
  CHECK(ids(claims_of("contact node set n contains surface_1\n")) == Positions{1, 3, 4, 5, 6, 7});
  const std::string block_2 = "contact node set n contains block_2 nodelist_3\n";
  CHECK(ids(claims_of(block_2)) == Positions{0, 2, 8, 9, 10, 11, 12, 13});
  CHECK(ids(claims_of(block_2, {1, 0, 1})) == Positions{0, 2, 9, 10, 12, 13});
  CHECK(ids(claims_of("contact node set n contains surface_1 nodelist_3\n", {0, 1, 1})) == Positions{0, 2});
  CHECK(ids(claims_of(block_2 + "restrict contact to subdomain defined by radius 1 and point 0 0 5\n")) ==
        Positions{8, 9, 11});
}
