// SPDX-License-Identifier: BSD-3-Clause
#include "contact/overlap/overlap_parts.hpp"

#include "support/catch.hpp"
#include "support/lofted_meshes.hpp"
#include "support/overlapping_bodies.hpp"

using namespace contactsim;

TEST_CASE("faces of solids know half of what is behind them, nodes the least of theirs",
          "[contact][overlap]") {
  test::MeshBuilder b;
  b.add_hexes({.id = 1, .size = {2, 8, 0.5}});
  const test::OverlappingBodies box(b);
  const OverlapParts& parts = box.parts;
  REQUIRE(parts.of_face.size() == 6);
  for (const FaceIndex i : indices(parts.of_face)) {
    const Eigen::Vector3d area = box.points.renewed().area(parts.contact_mesh.faces[i]).cwiseAbs();
    CHECK(parts.of_face[i].size == Approx(std::sqrt(area.maxCoeff())));
    CHECK(parts.of_face[i].half_thickness == Approx(0.5 * 8.0 / area.maxCoeff()));
  }
  REQUIRE(parts.of_node.size() == 8);
  for (const SurfaceNodeIndex i : indices(parts.of_node)) {
    CHECK(parts.of_node[i].size == Approx(4.0));
    CHECK(parts.of_node[i].half_thickness == Approx(0.25));
    CHECK(parts.of_node[i].normal.cwiseAbs().isApprox(Eigen::Vector3d(4, 1, 16)));  // three faces
    const Eigen::Vector3d out = box.mesh.coordinates().col(i.value) - Eigen::Vector3d(1, 4, 0.25);
    CHECK((parts.of_node[i].normal.array() * out.array() > 0.0).all());
    CHECK_FALSE(parts.is_lofted(parts.contact_mesh.surface_nodes[i]));
  }
}

TEST_CASE("a node on two surfaces stands once for each, with the faces of each alone", "[contact][overlap]") {
  test::MeshBuilder b;
  b.add_hexes({.id = 1});
  b.add_hexes({.id = 2, .origin = {1, 0, 0}});
  const test::OverlappingBodies boxes(b);
  const ContactMesh& contact_mesh = boxes.parts.contact_mesh;
  std::size_t n_shared = 0;
  for (const SurfaceNodeIndex i : indices(contact_mesh.surface_nodes)) {
    const std::uint32_t node = contact_mesh.mesh_nodes[contact_mesh.surface_nodes[i].node].value;
    if (boxes.mesh.coordinates()(0, node) != 1.0) continue;
    ++n_shared;
    // Two outer faces each; the wall between the blocks is no face.
    CHECK(boxes.parts.of_node[i].normal.cwiseAbs().isApprox(Eigen::Vector3d(0, 1, 1)));
  }
  CHECK(n_shared == 8);
}

TEST_CASE("lofted shells are as thick as they are lofted, bare ones and node sets have no thickness",
          "[contact][overlap]") {
  test::MeshBuilder b;
  test::add_plate(b, {.id = 1}, 0.2);
  test::add_balls(b, 2, {{0, 0, 5}}, 0.3);
  b.add_hexes({.id = 3, .origin = {0, 0, 9}, .share_nodes = false});
  const test::OverlappingBodies bodies(b);
  for (const FaceIndex i : indices(bodies.parts.of_face)) {
    const ContactFace& face = bodies.parts.contact_mesh.faces[i];
    CHECK(is_solid(bodies.mesh, face.side) == !bodies.parts.contact_mesh.is_lofted(face));
    CHECK(bodies.parts.of_face[i].half_thickness == Approx(is_solid(bodies.mesh, face.side) ? 0.5 : 0.1));
  }
  std::size_t n_balls = 0;
  for (const SurfaceNodeIndex i : indices(bodies.parts.of_node)) {
    const SurfaceNode& node = bodies.parts.contact_mesh.surface_nodes[i];
    const bool is_of_solid = node.side.element() == ElementIndex{2};
    CHECK(bodies.parts.is_lofted(node) == !is_of_solid);
    if (!(node.radius > 0.0f)) continue;
    ++n_balls;
    CHECK(bodies.parts.of_node[i].half_thickness == Approx(0.3));
    CHECK(bodies.parts.of_node[i].size == 0.0);
    CHECK(bodies.parts.of_node[i].normal.isZero(0.0));
  }
  CHECK(n_balls == 1);
}

TEST_CASE("parts of nodes as they are now are those of the faces as they are now", "[contact][overlap]") {
  test::MeshBuilder b;
  b.add_hexes({.id = 1});
  test::OverlappingBodies box(b);
  for (std::uint32_t node = 0; node < 8; ++node)
    box.points.shift(NodeIndex{node}, {0.0, 0.0, 2.0 * box.mesh.coordinates()(2, node)});
  box.points.renew();
  const OverlapParts parts = make_overlap_parts(box.points.renewed(), box.mesh);
  CHECK(parts.contact_mesh.faces.size() == 6);
  for (const FaceIndex i : indices(parts.of_face)) {
    const bool is_side = std::abs(box.points.renewed().area(parts.contact_mesh.faces[i]).z()) < 0.5;
    CHECK(parts.of_face[i].size == Approx(is_side ? std::sqrt(3.0) : 1.0));
  }
}
