// SPDX-License-Identifier: BSD-3-Clause
#include "contact/mesh/feature_edges.hpp"

#include <algorithm>
#include <cmath>

#include "support/catch.hpp"
#include "support/contact_bodies.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// Eight flat sides around the z axis between a tip at z = 0 and a rim of radius 1, of tetrahedra with the
/// axis.
///   rise  of the rim over the tip [length]
MeshBuilder sides_around_axis(double rise) {
  constexpr std::uint32_t n = 8;
  MeshBuilder b;
  const NodeIndex tip = b.add_node({0, 0, 0}), end = b.add_node({0, 0, rise});
  std::vector<NodeIndex> rim;
  for (std::uint32_t i = 0; i < n; ++i) {
    const double angle = 2.0 * M_PI * i / n;
    rim.push_back(b.add_node({std::cos(angle), std::sin(angle), rise}));
  }
  std::vector<std::uint32_t> nodes;
  for (std::uint32_t i = 0; i < n; ++i) {
    for (const NodeIndex node : {tip, rim[i], rim[(i + 1) % n], end}) nodes.push_back(node.value);
  }
  return b.add_block(1, "sides", Shape::tet4, nodes);
}

/// The sharpness of the faces that have the first node of a mesh.
double sharpness_at_first(const MeshBuilder& builder) {
  ContactParts parts(builder, "skin all blocks = on\n");
  measure_sharpness(parts.kinematics, parts.contact_mesh);
  float most = 0.0f;
  for (const FaceIndex face : parts.contact_mesh.faces_of_node.of({0}))
    most = std::max(most, parts.contact_mesh.faces[face].sharpness);
  return static_cast<double>(most);
}

/// Of the sides: cosine of their normals and the axis.
double lean_of(double rise) { return std::cos(M_PI / 8.0) / std::hypot(rise, std::cos(M_PI / 8.0)); }

}  // namespace

TEST_CASE("corners and edges of a box turn by a right angle", "[contact][feature_edges]") {
  MeshBuilder box;
  box.add_hexes({.id = 1});
  CHECK(sharpness_at_first(box) == 90.0);
}

TEST_CASE("sides around a tip are as sharp as the spike", "[contact][feature_edges]") {
  const double rise = GENERATE(4.0, 6.0, 12.0);
  const double turn = 2.0 * std::acos(lean_of(rise)) * 180.0 / M_PI;
  REQUIRE(turn > 145.0);
  CHECK(sharpness_at_first(sides_around_axis(rise)) == Approx(turn).margin(0.51));
}

TEST_CASE("a blunt tip is no spike", "[contact][feature_edges]") {
  // The rim between sides and base is sharper.
  const double of_rim = 180.0 - std::acos(lean_of(1.0)) * 180.0 / M_PI;
  CHECK(sharpness_at_first(sides_around_axis(1.0)) == Approx(of_rim).margin(0.51));
}
