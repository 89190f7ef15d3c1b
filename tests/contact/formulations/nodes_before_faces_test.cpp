// SPDX-License-Identifier: BSD-3-Clause
#include "contact/formulations/nodes_before_faces.hpp"

#include <map>

#include "contact/search/contact_search.hpp"
#include "support/catch.hpp"
#include "support/contact_faces.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// The gaps of nodes of the mesh before the nearest face of the other cube.
std::map<std::uint32_t, double> gaps_before_faces(ContactParts& parts) {
  parts.move();
  ContactSearch search(parts.contact_mesh, parts.mesh, parts.rules, parts.definition.search,
                       parts.definition.dash);
  std::map<std::uint32_t, double> gaps;
  std::map<std::pair<SurfaceNodeIndex, FaceIndex>, double> reported;
  visit_nodes_before_faces(
      search, parts.kinematics, parts.rules, parts.motion(), [&](const NodeBeforeFace& node) {
        const SurfaceNode& row = parts.contact_mesh.surface_nodes[node.row];
        CHECK(node.pair == PairIndex{0});
        CHECK(row.surface != parts.contact_mesh.faces[node.face].surface);
        CHECK(reported.emplace(std::pair(node.row, node.face), node.gap).first->second == node.gap);
        double& gap = gaps.emplace(parts.contact_mesh.mesh_nodes[row.node].value, node.gap).first->second;
        if (std::abs(node.gap) < std::abs(gap)) gap = node.gap;
      });
  return gaps;
}

std::string either_formulation() {
  return GENERATE(as<std::string>{}, "", "constraint formulation = node_face\n");
}

}  // namespace

TEST_CASE("nodes that stand over faces of the other side are reported with their gaps, others are not",
          "[contact][nodes_before_faces]") {
  const double gap = GENERATE(0.1, -0.1);
  ContactParts parts(cube_over_cube(gap, 0.5, 0.25), general_contact(either_formulation()));
  const auto gaps = gaps_before_faces(parts);
  CHECK(gaps.size() == 4);
  for (const std::uint32_t node : {8, 9, 10, 11}) {
    REQUIRE(gaps.contains(node));
    CHECK(gaps.at(node) == Approx(gap));
  }
}

TEST_CASE("nodes right over the border of a face count, on either side", "[contact][nodes_before_faces]") {
  ContactParts parts(cube_over_cube(0.1, 1.0), general_contact(either_formulation()));
  const auto gaps = gaps_before_faces(parts);
  CHECK(gaps.size() == 8);
  for (const auto& [node, gap] : gaps) {
    CHECK((node >= 4 && node < 12));
    CHECK(gap == Approx(0.1));
  }
}

TEST_CASE("what a pair takes off its gaps is taken off", "[contact][nodes_before_faces]") {
  ContactParts parts(cube_over_cube(0.1, 0.5, 0.25),
                     general_contact("contact offset = 0.02\n" + either_formulation()));
  for (const auto& [node, gap] : gaps_before_faces(parts)) CHECK(gap == Approx(0.08));
}

TEST_CASE("pairs that are off tell nothing", "[contact][nodes_before_faces]") {
  ContactParts parts(cube_over_cube(0.1, 0.5, 0.25), general_contact(either_formulation()));
  parts.rules.activate(0.0, false);
  CHECK(gaps_before_faces(parts).empty());
}
