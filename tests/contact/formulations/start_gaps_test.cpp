// SPDX-License-Identifier: BSD-3-Clause
#include "contact/formulations/start_gaps.hpp"

#include "support/catch.hpp"
#include "support/contact_faces.hpp"
#include "support/lofted_meshes.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Eigen::Vector3d;

namespace {

const Vector3d looks_up = Vector3d::UnitZ();

/// The gap of the bottom of the upper cube to the top of the lower one.
std::optional<StartGap> gap_of_bottom(const ContactParts& parts) {
  return find_start_gap(parts.kinematics, *parts.rules[{0}].pair, face_of(parts, 1, -looks_up),
                        face_of(parts, 0, looks_up));
}

/// The gap of a node to any of the faces near it.
std::optional<StartGap> gap_of_node(ContactParts& parts, std::uint32_t mesh_node) {
  parts.search();
  const SurfaceNodeIndex row = row_of_node(parts, mesh_node);
  return find_start_gap(parts.kinematics, parts.rules, row, parts.node_faces.of(row));
}

const std::string of_nodes = "constraint formulation = node_face\n";

}  // namespace

TEST_CASE("the gap of parallel faces is the same everywhere where they lie before each other",
          "[contact][start_gaps]") {
  const double gap = GENERATE(0.3, 0.0, -0.2);
  const ContactParts parts(cube_over_cube(gap, 0.5, 0.75), general_contact());
  const auto found = gap_of_bottom(parts);
  REQUIRE(found);
  CHECK(found->entity == face_of(parts, 1, -looks_up).value);
  CHECK(found->mean == Approx(gap).margin(1e-12));
  CHECK(found->smallest == Approx(gap).margin(1e-12));
  CHECK(found->area == Approx(0.25 * 0.25));
}

TEST_CASE("the mean gap of faces that lean is that of the middle of their overlap", "[contact][start_gaps]") {
  ContactParts parts(cube_over_cube(0.1), general_contact());
  for (const std::uint32_t node : {9, 11}) parts.x(2, node) += 0.06;
  parts.move();
  const auto found = gap_of_bottom(parts);
  REQUIRE(found);
  CHECK(found->mean == Approx(0.13).epsilon(1e-2));  // as seen along the normal between
  CHECK(found->smallest < 0.12);
  CHECK(found->smallest > 0.099);
}

TEST_CASE("what contact would not take has no gap", "[contact][start_gaps]") {
  const auto has_gap = [](const MeshBuilder& b) {
    return gap_of_bottom(ContactParts(b, general_contact())).has_value();
  };
  CHECK(has_gap(cube_over_cube(-0.45)));
  CHECK_FALSE(has_gap(cube_over_cube(-0.55)));           // deeper than half the element
  CHECK_FALSE(has_gap(cube_over_cube(-0.2, 1.0, 0.9)));  // deeper than wide
  CHECK(has_gap(cube_over_cube(-0.05, 1.0, 0.9)));
  CHECK_FALSE(has_gap(cube_over_cube(0.1, 1.0, 1.0)));         // beside each other
  CHECK_FALSE(has_gap(cube_over_cube(0.1, 1.0, 1.0 - 1e-7)));  // but for a sliver
}

TEST_CASE("the gap of a node is that to the nearest face over which it stands", "[contact][start_gaps]") {
  const double gap = GENERATE(0.1, -0.1);
  ContactParts parts(cube_over_cube(gap, 0.5, 0.25), general_contact(of_nodes));
  const auto found = gap_of_node(parts, 8);
  REQUIRE(found);
  CHECK(found->entity == row_of_node(parts, 8).value);
  CHECK(found->pair == PairIndex{0});
  CHECK(found->mean == Approx(gap));
  CHECK(found->smallest == found->mean);
  CHECK(found->area == Approx(parts.contact_mesh.surface_nodes[row_of_node(parts, 8)].area));
  CHECK_FALSE(gap_of_node(parts, 7));   // beside the upper cube
  CHECK_FALSE(gap_of_node(parts, 12));  // looks away
}

TEST_CASE("a node that is deeper than half an element has no gap", "[contact][start_gaps]") {
  ContactParts parts(cube_over_cube(-0.6, 0.5, 0.25), general_contact(of_nodes));
  CHECK_FALSE(gap_of_node(parts, 8));
}

TEST_CASE("the gap of a sphere counts from its surface", "[contact][start_gaps]") {
  MeshBuilder b;
  b.add_hexes({.id = 1});
  add_balls(b, 2, {{0.4, 0.6, 1.4}}, 0.25);
  ContactParts parts(b, general_contact());
  const auto found = gap_of_node(parts, 8);
  REQUIRE(found);
  CHECK(found->mean == Approx(0.15));
}
