// SPDX-License-Identifier: BSD-3-Clause
#include "contact/formulations/mark_start_reach.hpp"

#include "support/catch.hpp"
#include "support/contact_faces.hpp"
#include "support/lofted_meshes.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Eigen::Vector3d;

namespace {

/// Marks what is near of a model with a search distance; nothing of it need be near.
struct MarkedParts {
  ContactParts parts;

  MarkedParts(const MeshBuilder& b, double distance, const std::string& more = "")
      : parts(b, general_contact("search distance = " + std::to_string(distance) + "\n" + more)) {
    mark_start_reach(parts.model, parts.kinematics, parts.rules);
  }
  bool is_marked(SurfaceNodeIndex row) const { return parts.rules.start_reach().may_meet_plane({0}, row); }
  bool is_marked(FaceIndex face) const {
    return parts.rules.start_reach().may_meet_faces({0}, face, face, parts.contact_mesh.faces[face].surface);
  }
  bool is_marked(EdgeIndex edge) const {
    return parts.rules.start_reach().may_meet_edges({0}, edge, edge, {0});
  }
};

/// How far a point is from a box.
double distance_to_box(const Vector3d& x, const Vector3d& low, const Vector3d& high) {
  return (x - x.cwiseMax(low).cwiseMin(high)).norm();
}

}  // namespace

TEST_CASE("nodes and faces are marked by their shortest way to the other body", "[contact][start_reach]") {
  const double gap = GENERATE(0.1, 0.6);
  const double distance = GENERATE(0.05, 0.2, 0.4, 0.65, 1.15, 3.0);
  CAPTURE(gap, distance);
  const MarkedParts marked(cube_over_cube(gap, 0.5, 0.25), distance);
  const ContactParts& parts = marked.parts;
  const Vector3d low_1(0, 0, 0), high_1(1, 1, 1), low_2(0.25, 0.25, 1 + gap), high_2(0.75, 0.75, 2 + gap);
  for (const SurfaceNodeIndex row : indices(parts.contact_mesh.surface_nodes)) {
    const ContactNodeIndex node = parts.contact_mesh.surface_nodes[row].node;
    const Vector3d x = parts.kinematics.x(node);
    const double way = node.value < 8 ? distance_to_box(x, low_2, high_2) : distance_to_box(x, low_1, high_1);
    CHECK(marked.is_marked(row) == (way <= distance));
  }
  for (const FaceIndex face : indices(parts.contact_mesh.faces)) {
    // Faces of boxes are boxes without a thickness.
    const FaceCorners x = parts.kinematics.face_corners(face);
    const bool is_of_first = parts.contact_mesh.faces[face].side.element() == ElementIndex{0};
    const Vector3d low = x.rowwise().minCoeff(), high = x.rowwise().maxCoeff();
    const Vector3d other_low = is_of_first ? low_2 : low_1, other_high = is_of_first ? high_2 : high_1;
    const double way = (other_low - high).cwiseMax(low - other_high).cwiseMax(0.0).norm();
    CHECK(marked.is_marked(face) == (way <= distance));
  }
}

TEST_CASE("an overlap of the start is near however short the distance", "[contact][start_reach]") {
  const MarkedParts marked(cube_over_cube(-0.2, 0.5, 0.25), 0.0);
  CHECK(marked.is_marked(face_of(marked.parts, 0, Vector3d::UnitZ())));
  CHECK(marked.is_marked(face_of(marked.parts, 1, -Vector3d::UnitZ())));
  CHECK(marked.is_marked(row_of_node(marked.parts, 8)));
  CHECK_FALSE(marked.is_marked(row_of_node(marked.parts, 12)));
  CHECK_FALSE(marked.is_marked(face_of(marked.parts, 0, -Vector3d::UnitZ())));
}

TEST_CASE("bodies that stand over each other by a part only are as near as they are",
          "[contact][start_reach]") {
  // Their sides look at each other across both bodies, and do not lie in each other.
  const double aside = GENERATE(0.6, 0.8, 0.95);
  const MarkedParts far(cube_over_cube(0.1, 1.0, aside), 0.09), near(cube_over_cube(0.1, 1.0, aside), 0.11);
  for (const FaceIndex face : indices(far.parts.contact_mesh.faces)) CHECK_FALSE(far.is_marked(face));
  for (const SurfaceNodeIndex row : indices(far.parts.contact_mesh.surface_nodes))
    CHECK_FALSE(far.is_marked(row));
  CHECK(near.is_marked(face_of(near.parts, 0, Vector3d::UnitZ())));
  CHECK(near.is_marked(row_of_node(near.parts, 8)));
  // Deep in each other at an edge they are near.
  const MarkedParts in(cube_over_cube(-0.1, 1.0, aside), 0.0);
  CHECK(in.is_marked(face_of(in.parts, 0, Vector3d::UnitZ())));
  CHECK(in.is_marked(row_of_node(in.parts, 8)));
}

TEST_CASE("a node behind the inner edge of a body is in it", "[contact][start_reach]") {
  // An L of three cells, and a small cube a corner of which is behind its inner edge, in the corner cell.
  MeshBuilder b;
  for (const double y : {0.0, 1.0}) {
    for (const auto& [x, z] : {std::pair(0, 0), {1, 0}, {2, 0}, {0, 1}, {1, 1}, {2, 1}, {0, 2}, {1, 2}})
      b.add_node({double(x), y, double(z)});
  }
  std::vector<std::uint32_t> nodes;
  for (const std::array<std::uint32_t, 4>& cell : {std::array{0u, 1u, 3u, 4u}, {1, 2, 4, 5}, {3, 4, 6, 7}}) {
    for (const std::size_t low : {0, 2}) {
      const std::uint32_t left = cell[low], right = cell[low + 1];
      nodes.insert(nodes.end(), {left, right, right + 8, left + 8});
    }
  }
  b.add_block(1, "", Shape::hex8, nodes);
  b.add_hexes({.id = 2, .origin = {0.9, 0.25, 0.9}, .size = {0.5, 0.5, 0.5}, .share_nodes = false});
  const MarkedParts marked(b, 0.0);
  CHECK(marked.is_marked(row_of_node(marked.parts, 16)));
}

TEST_CASE("spheres are as near as their surface, rods as the way between their axes",
          "[contact][start_reach]") {
  MeshBuilder b;
  b.add_hexes({.id = 1});
  add_balls(b, 2, {{0.4, 0.6, 1.4}}, 0.25);
  CHECK_FALSE(MarkedParts(b, 0.14).is_marked(row_of_node(ContactParts(b, general_contact()), 8)));
  CHECK(MarkedParts(b, 0.16).is_marked(row_of_node(ContactParts(b, general_contact()), 8)));
  MeshBuilder rods;
  add_rod(rods, {.id = 1, .from = {-1, 0, 0}, .to = {1, 0, 0}});
  add_rod(rods, {.id = 2, .from = {0.5, -1, 0.3}, .to = {0.5, 1, 0.3}});
  CHECK_FALSE(MarkedParts(rods, 0.09).is_marked(EdgeIndex{0}));
  CHECK(MarkedParts(rods, 0.11).is_marked(EdgeIndex{0}));
  CHECK(MarkedParts(rods, 0.11).is_marked(EdgeIndex{1}));
}

TEST_CASE("without a search distance nothing is left out", "[contact][start_reach]") {
  ContactParts parts(cube_over_cube(5.0), general_contact());
  mark_start_reach(parts.model, parts.kinematics, parts.rules);
  CHECK_FALSE(parts.rules.start_reach().exists());
  CHECK(parts.rules.start_reach().may_meet_plane({0}, {0}));
}
