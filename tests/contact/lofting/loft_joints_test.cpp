// SPDX-License-Identifier: BSD-3-Clause
#include "contact/lofting/loft_joints.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/catch.hpp"
#include "support/loft_shape.hpp"
#include "support/mesh_builder.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Eigen::Vector3d;

namespace {

/// Two square sheets that share the edge from (0, 0, 0) to (0, 1, 0), at an angle inside [degrees].
Mesh fold(double angle, int cells) {
  const double half = 0.5 * angle * std::numbers::pi / 180.0;
  const Vector3d left(-std::sin(half), 0, -std::cos(half)), right(std::sin(half), 0, -std::cos(half));
  return MeshBuilder()
      .add_shells({.id = 1, .cells = {cells, cells}, .u = left, .v = {0, 1, 0}})
      .add_shells({.id = 2, .cells = {cells, cells}, .u = right, .v = {0, 1, 0}})
      .build();
}

std::vector<LoftFacet> joints_of(const LoftGeometry& loft) {
  std::vector<LoftFacet> joints;
  std::ranges::copy_if(loft.facets, std::back_inserter(joints),
                       [](const LoftFacet& facet) { return facet.part == LoftPart::joint; });
  return joints;
}

/// How often a ray leaves the facets' bodies less how often it enters them: 0 beside them, > 0 from within.
int crossings(const LoftGeometry& loft, const Vector3d& from, const Vector3d& way) {
  int sum = 0;
  for (const LoftFacet& facet : loft.facets) {
    const auto x = corners_of(loft, facet);
    for (int k = 1; k < 3; ++k) {
      const Vector3d a = x.col(0), b = x.col(k), c = x.col(k + 1);
      const double d = (b - a).cross(c - a).dot(way);
      if (std::abs(d) < 1e-14) continue;
      const double s = (b - a).cross(c - a).dot(a - from) / d;
      const Vector3d at = from + s * way;
      const Vector3d n = (b - a).cross(c - a);
      const bool is_in = (b - a).cross(at - a).dot(n) > 0 && (c - b).cross(at - b).dot(n) > 0 &&
                         (a - c).cross(at - c).dot(n) > 0;
      if (s > 0 && is_in) sum += d > 0 ? 1 : -1;
    }
  }
  return sum;
}

}  // namespace

TEST_CASE("a joint spans the wedge outside a sharp fold, from skin to skin", "[contact][loft]") {
  const double angle = GENERATE(20.0, 60.0, 90.0, 119.0);
  const LoftGeometry loft = loft_of(fold(angle, 1), {.thickness = 0.2});
  const auto joints = joints_of(loft);
  REQUIRE(joints.size() == 3);
  CHECK((normal_of(loft, joints[0]) - Vector3d::UnitZ()).norm() < 1e-12);
  const double turn = (180.0 - angle) * std::numbers::pi / 180.0;
  CHECK(facet_area(loft, joints[0]) == Approx(0.2 * std::sin(0.5 * turn)));
  for (std::size_t i = 1; i < 3; ++i) {
    CHECK(std::abs(normal_of(loft, joints[i]).y()) == Approx(1.0));
    const Vector3d middle = corners_of(loft, joints[i]).rowwise().mean();
    CHECK(normal_of(loft, joints[i]).y() * (middle.y() - 0.5) > 0.0);
  }
}

TEST_CASE("nothing gets into a fold but through its skin", "[contact][loft]") {
  const double angle = GENERATE(30.0, 60.0, 90.0, 120.0, 150.0);
  const int cells = GENERATE(1, 3);
  const LoftGeometry loft = loft_of(fold(angle, cells), {.thickness = 0.2});
  // Within the mesh surface's reach of the ridge, but outside the bricks: under the joint.
  for (const double y : {0.013, 0.31, 0.77}) {
    const Vector3d inside(0.001, y, 0.02 * std::sin(0.5 * angle * std::numbers::pi / 180.0));
    for (const Vector3d& way : {Vector3d(0.011, 0.007, 1), Vector3d(0.3, 0.02, 1), Vector3d(-0.4, -0.03, 1)})
      CHECK(crossings(loft, inside, way) >= 1);
    const Vector3d above(0.001, y, 0.3);
    CHECK(crossings(loft, above, {0.3, 0.02, 1}) == 0);
  }
}

TEST_CASE("where three sheets meet a triangle closes the corner", "[contact][loft]") {
  const int cells = GENERATE(1, 2);
  const Mesh mesh = MeshBuilder()
                        .add_shells({.id = 1, .cells = {cells, cells}, .u = {-1, 0, 0}, .v = {0, -1, 0}})
                        .add_shells({.id = 2, .cells = {cells, cells}, .u = {0, -1, 0}, .v = {0, 0, -1}})
                        .add_shells({.id = 3, .cells = {cells, cells}, .u = {0, 0, -1}, .v = {-1, 0, 0}})
                        .build();
  const LoftGeometry loft = loft_of(mesh, {.thickness = 0.2});
  const auto joints = joints_of(loft);
  REQUIRE(joints.size() == static_cast<std::size_t>(3 * cells + 1 + 3));
  const Vector3d diagonal = Vector3d::Ones().normalized();
  CHECK(std::ranges::count_if(joints, [&](const LoftFacet& facet) {
          return (normal_of(loft, facet) - diagonal).norm() < 1e-12;
        }) == 1);
  CHECK(crossings(loft, {0.01, 0.012, 0.009}, {1, 1.1, 0.9}) == 1);
}

TEST_CASE("smooth sheets, T-junctions and steps in thickness need no joints", "[contact][loft]") {
  CHECK(joints_of(loft_of(fold(150.0, 2), {.thickness = 0.2})).empty());
  const Mesh tee = MeshBuilder()
                       .add_shells({.id = 1, .cells = {2, 1}, .u = {2, 0, 0}, .v = {0, 1, 0}})
                       .add_shells({.id = 2, .origin = {1, 0, 0}, .u = {0, 0, 1}, .v = {0, 1, 0}})
                       .build();
  CHECK(joints_of(loft_of(tee, {.thickness = 0.2})).empty());
}
