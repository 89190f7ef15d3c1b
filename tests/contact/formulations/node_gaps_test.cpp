// SPDX-License-Identifier: BSD-3-Clause
#include "contact/formulations/node_gaps.hpp"

#include "contact/search/contact_search.hpp"
#include "support/catch.hpp"
#include "support/contact_faces.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

IndexedVector<ContactNodeIndex, double> node_gaps_of(ContactParts& parts) {
  parts.move();
  return find_node_gaps(parts.kinematics, parts.mesh, parts.rules, parts.definition.dash, parts.motion());
}

}  // namespace

TEST_CASE("nodes over a face have their gap, others the distance up to which they are tracked",
          "[contact][node_gaps]") {
  const double gap = GENERATE(0.1, -0.1);
  ContactParts parts(cube_over_cube(gap, 0.5, 0.25), general_contact("tracking distance = 0.3\n"));
  const auto gaps = node_gaps_of(parts);
  REQUIRE(gaps.size() == 16);
  for (const ContactNodeIndex node : indices(gaps)) {
    const bool is_over = node.value >= 8 && node.value < 12;
    CHECK(gaps[node] == Approx(is_over ? gap : 0.3));
  }
}

TEST_CASE("what is farther than the tracking distance has that", "[contact][node_gaps]") {
  ContactParts parts(cube_over_cube(0.1, 0.5, 0.25), general_contact("tracking distance = 0.06\n"));
  for (const double gap : node_gaps_of(parts)) CHECK(gap == 0.06);
}

TEST_CASE("without a tracking distance nodes are at least as far as the margin of the search",
          "[contact][node_gaps]") {
  ContactParts parts(cube_over_cube(5.0), general_contact());
  const ContactSearch search(parts.contact_mesh, parts.mesh, parts.rules, {}, parts.definition.dash);
  const auto gaps = node_gaps_of(parts);
  for (const ContactNodeIndex node : indices(gaps)) {
    CHECK(gaps[node] == search.margin_of(node));
    CHECK(gaps[node] > 0.0);
  }
}

TEST_CASE("nodes whose surfaces meet nothing now have 0", "[contact][node_gaps]") {
  MeshBuilder b = cube_over_cube(0.1);
  b.add_hexes({.id = 3, .origin = {5, 0, 0}, .share_nodes = false});
  ContactParts parts(b,
                     "skin all blocks = on\nbegin interaction\nside a = block_1\nside b = block_2\n"
                     "tracking distance = 0.3\nend\n");
  const auto gaps = node_gaps_of(parts);
  for (const ContactNodeIndex node : indices(gaps)) CHECK((gaps[node] == 0.0) == (node.value >= 16));
  parts.rules.activate(0.0, false);
  for (const double gap : node_gaps_of(parts)) CHECK(gap == 0.0);
}
