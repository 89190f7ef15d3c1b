// SPDX-License-Identifier: BSD-3-Clause
#include "contact/surfaces/node_ownership.hpp"

#include "core/mesh/node_elements.hpp"
#include "support/catch.hpp"
#include "support/contact_deck.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// Element 1 a hexahedron of the nodes 0 to 7, x fastest and z slowest; 2 and 3 shells beside one another far
/// from it, of the nodes 8 9 10 and 11 12 13. surface_1: 1:6, 1:2; nodelist_3: nodes 2, 0, 0.
Mesh small_model() {
  MeshBuilder b;
  b.add_hexes({.id = 1});
  b.add_shells({.id = 2, .cells = {2, 1}, .origin = {0, 0, 5}, .u = {2, 0, 0}});
  b.add_side_set(1, "", {{{0}, 6}, {{0}, 2}});
  b.add_node_set(3, "", std::vector<std::uint32_t>{2, 0, 0});
  return b.build();
}

using Positions = std::vector<std::uint32_t>;

/// The nodes that some lines claim, with `alive` as [n_elements] marks.
Positions claimed_by(const std::string& lines, const std::vector<std::uint8_t>& alive = {1, 1, 1}) {
  const Mesh mesh = small_model();
  const ContactDefinition contact = parse_contact(lines);
  Diagnostics diagnostics;
  const auto requests = make_surface_requests(contact, {}, mesh, diagnostics);
  REQUIRE(diagnostics.empty());
  const NodeOwnershipRules rules(requests, mesh, ContactDomain(mesh, contact.subdomain));
  const NodeElements elements(mesh);
  Positions claimed, found;
  for (std::uint32_t i = 0; i < mesh.n_nodes(); ++i) {
    const auto around = rules.needs_elements() ? elements.of({i}) : std::span<const ElementIndex>{};
    if (rules.of_node({i}, around, alive).owner) claimed.push_back(i);
  }
  if (alive == std::vector<std::uint8_t>{1, 1, 1}) {
    for (const NodeIndex node : rules.find_claimed()) found.push_back(node.value);
    CHECK(found == claimed);
  }
  return claimed;
}

}  // namespace

TEST_CASE("nodes come from node sets, and from sides and elements that live", "[contact][ownership]") {
  CHECK(claimed_by("contact node set n contains nodelist_3\n") == Positions{0, 2});
  CHECK(claimed_by("contact node set n contains surface_1\n") == Positions{1, 3, 4, 5, 6, 7});
  const std::string block_2 = "contact node set n contains block_2 nodelist_3\n";
  CHECK(claimed_by(block_2) == Positions{0, 2, 8, 9, 10, 11, 12, 13});
  CHECK(claimed_by(block_2, {1, 0, 1}) == Positions{0, 2, 9, 10, 12, 13});
  CHECK(claimed_by("contact node set n contains surface_1 nodelist_3\n", {0, 1, 1}) == Positions{0, 2});
}

TEST_CASE("nodes outside of the subdomain are not claimed", "[contact][ownership]") {
  CHECK(claimed_by("contact node set n contains block_2 nodelist_3\n"
                   "restrict contact to subdomain defined by radius 1 and point 0 0 5\n") ==
        Positions{8, 9, 11});
}

TEST_CASE("surfaces of faces claim no nodes", "[contact][ownership]") {
  CHECK(claimed_by("contact surface s contains block_1 surface_1\n").empty());
}
