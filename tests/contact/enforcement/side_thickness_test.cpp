// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/side_thickness.hpp"

#include "support/catch.hpp"

using namespace contactsim;

namespace {

/// Two of each, behind the first of which is 1, behind the second 3; surface nodes have 2 and 4.
ContactMesh two_thicknesses() {
  ContactMesh contact_mesh;
  for (const double thickness : {1.0, 3.0}) {
    ContactFace face;
    face.penalty_properties.thickness = thickness;
    contact_mesh.faces.push_back(face);
    ContactEdge edge;
    edge.penalty_properties.thickness = thickness;
    contact_mesh.edges.push_back(edge);
    SurfaceNode node;
    node.penalty_properties.thickness = thickness + 1.0;
    contact_mesh.surface_nodes.push_back(node);
  }
  return contact_mesh;
}

ContactPoint point_between(std::uint32_t first, std::uint32_t second) {
  ContactPoint point;
  point.first_entity = first;
  point.second_entity = second;
  point.first.nodes = {ContactNodeIndex{0}, ContactNodeIndex{1}, ContactNodeIndex{2}, ContactNodeIndex{3}};
  point.first.weights.setConstant(0.25);
  point.second = point.first;
  return point;
}

}  // namespace

TEST_CASE("the thinner side of a point is that of its faces, edges or node", "[contact][enforcement]") {
  const ContactMesh contact_mesh = two_thicknesses();
  ContactPoint point = point_between(1, 0);
  CHECK(thinner_side(contact_mesh, point) == 1.0);
  CHECK(thinner_side(contact_mesh, point_between(1, 1)) == 3.0);
  point.is_of_edges = true;
  CHECK(thinner_side(contact_mesh, point) == 1.0);
  ContactPoint of_node = point_between(0, 1);
  of_node.first.nodes.fill({0});
  REQUIRE(of_node.first.is_node());
  CHECK(thinner_side(contact_mesh, of_node) == 2.0);
  of_node.second.weights.setZero();  // a plane
  CHECK(thinner_side(contact_mesh, of_node) == 2.0);
}
