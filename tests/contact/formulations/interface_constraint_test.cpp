// SPDX-License-Identifier: BSD-3-Clause
#include "contact/formulations/interface_constraint.hpp"

#include <Eigen/Geometry>

#include "core/base/state_archive.hpp"
#include "support/catch.hpp"
#include "support/two_cubes.hpp"

using namespace contactsim;
using Eigen::Vector3d;

namespace {

/// A warped quadrilateral, or a triangle that repeats its last corner.
FaceCorners some_face(bool is_triangle, double scale = 1.0) {
  FaceCorners x;
  x << 0.0, 1.0, 1.2, -0.1,  //
      0.0, 0.1, 0.9, 1.1,    //
      0.0, 0.2, -0.1, 0.3;
  if (is_triangle) x.col(3) = x.col(2);
  return scale * x;
}

Vector3d moment_of(const CornerVectors& x, const CornerVectors& forces) {
  Vector3d sum = Vector3d::Zero();
  for (int k = 0; k < 8; ++k) sum += Vector3d(x.col(k)).cross(Vector3d(forces.col(k)));
  return sum;
}

}  // namespace

TEST_CASE("axes of a face are a frame that turns with it", "[contact][interface_constraint]") {
  const FaceCorners x = some_face(GENERATE(false, true));
  const Eigen::Matrix3d axes = axes_of(x);
  CHECK((axes.transpose() * axes - Eigen::Matrix3d::Identity()).norm() < 1e-14);
  CHECK(axes.determinant() == Approx(1.0));
  CHECK(axes.col(2).dot(area_vector(x)) == Approx(area_vector(x).norm()));
  CHECK(axes.col(0).dot(Vector3d(x.col(2) - x.col(0))) > 0.0);
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(2.0, Vector3d(1, 2, -1).normalized()).toRotationMatrix();
  const FaceCorners turned = (turn * x).colwise() + Vector3d(5, -3, 2);
  CHECK((axes_of(turned) - turn * axes).norm() < 1e-13);
}

TEST_CASE("balanced forces leave neither a force nor a moment, and are those given on the first side",
          "[contact][interface_constraint]") {
  const bool is_triangle = GENERATE(false, true);
  const double scale = GENERATE(1e-3, 1.0, 1e4);
  CornerVectors arms, forces;
  arms << some_face(false, scale).colwise() + scale * Vector3d(0.2, -0.1, 0.3), some_face(is_triangle, scale);
  forces.setZero();
  forces.leftCols<4>() << 1, -2, 0.5, 3, 0, 1, 2, -1, 4, 4, -1, 2;
  forces.col(5) << 7, 0, 1;
  const CornerVectors given = forces;
  balance(arms, forces);
  CHECK(forces.leftCols<4>() == given.leftCols<4>());
  CHECK(forces.rowwise().sum().norm() < 1e-13 * given.norm());
  CHECK(moment_of(arms, forces).norm() < 1e-12 * scale * given.norm());
  // A point to take the arms from does not matter.
  CornerVectors others = given;
  balance(arms.colwise() + scale * Vector3d(0.5, 0.6, -0.4), others);
  CHECK((others - forces).norm() < 1e-12 * given.norm());
  // What is balanced stays as it is.
  CornerVectors again = forces;
  balance(arms, again);
  CHECK((again - forces).norm() < 1e-12 * given.norm());
}

TEST_CASE("a face that moves and turns carries a point along as if it were fixed to it",
          "[contact][interface_constraint]") {
  const bool is_triangle = GENERATE(false, true);
  const FaceCorners x = some_face(is_triangle);
  const Eigen::Vector4d weights =
      is_triangle ? Eigen::Vector4d(0.5, 0.2, 0.3, 0.0) : Eigen::Vector4d(0.4, 0.3, 0.2, 0.1);
  const Vector3d offset = GENERATE(Vector3d(0, 0, 0), Vector3d(0.1, -0.2, 0.5));
  const auto carried = carry_point(x, weights, offset);
  const Vector3d velocity(1, 2, 3), turning(0.3, -0.4, 0.2);
  Vector3d found = Vector3d::Zero();
  for (std::size_t k = 0; k < 4; ++k)
    found += carried[k] * (velocity + turning.cross(Vector3d(x.col(static_cast<Eigen::Index>(k)))));
  const Vector3d point = x * weights + offset;
  CHECK((found - velocity - turning.cross(point)).norm() < 1e-13);
  // So the forces that do the same work have the force and the moment of one at the point.
  const Vector3d force(2, -1, 4);
  Vector3d sum = Vector3d::Zero(), moment = Vector3d::Zero();
  for (std::size_t k = 0; k < 4; ++k) {
    const Vector3d own = carried[k].transpose() * force;
    sum += own;
    moment += Vector3d(x.col(static_cast<Eigen::Index>(k))).cross(own);
  }
  CHECK((sum - force).norm() < 1e-13);
  CHECK((moment - point.cross(force)).norm() < 1e-13);
}

TEST_CASE("a constraint knows its corners and its rule", "[contact][interface_constraint]") {
  test::TwoCubes cubes(
      "capture tolerance = 1e-3\nfriction model = either\nend\n"
      "begin constant friction model slick\nfriction coefficient = 0.05\nend\n"
      "begin constant friction model rough\nfriction coefficient = 0.2\nend\n"
      "begin hybrid model either\ninitially close = slick\ninitially far = rough\n");
  test::ContactParts& parts = cubes.parts;
  InterfaceConstraint constraint;
  constraint.pair = {0};
  constraint.first_entity = 3;
  constraint.second = {1};
  constraint.nodes = {8, 9, 11, 10, 4, 5, 7, 6};
  const CornerVectors x = corners_of(parts.context(), constraint);
  for (std::size_t k = 0; k < 8; ++k)
    CHECK(x.col(static_cast<Eigen::Index>(k)) == parts.x.col(constraint.nodes[k].value));
  parts.rules.mark_close_node({0}, {3});
  CHECK(rule_of(parts.context(), constraint).friction == 0.2);
  constraint.is_node = true;
  CHECK(rule_of(parts.context(), constraint).friction == 0.05);
}

TEST_CASE("constraints go over to other numbers, and end with either side",
          "[contact][interface_constraint]") {
  InterfaceConstraint constraint;
  constraint.first_entity = 1;
  constraint.second = {2};
  constraint.nodes = {0, 1, 1, 0, 2, 2, 1, 1};
  constraint.is_node = GENERATE(false, true);
  ContactRemap remap;
  remap.faces = {std::nullopt, FaceIndex{4}, FaceIndex{0}};
  remap.rows = {std::nullopt, SurfaceNodeIndex{7}};
  remap.nodes = {ContactNodeIndex{5}, ContactNodeIndex{6}, ContactNodeIndex{8}};
  const InterfaceConstraint before = constraint;
  REQUIRE(keep_constraint(remap, constraint));
  CHECK(constraint.first_entity == (constraint.is_node ? 7 : 4));
  CHECK(constraint.second == FaceIndex{0});
  CHECK(constraint.nodes == std::array<ContactNodeIndex, 8>{5, 6, 6, 5, 8, 8, 6, 6});
  std::vector<InterfaceConstraint> all(3, before);
  all[0].second = {0};
  all[2].first_entity = 0;
  keep_constraints(remap, all);
  REQUIRE(all.size() == 1);
  CHECK(all[0].nodes == constraint.nodes);
}

TEST_CASE("a constraint is stored whole", "[contact][interface_constraint]") {
  InterfaceConstraint constraint;
  constraint.pair = {3};
  constraint.is_swapped = constraint.is_node = true;
  constraint.first_entity = 4;
  constraint.second = {5};
  constraint.nodes = {8, 7, 6, 5, 4, 3, 2, 1};
  constraint.springs << 1, 2, 3, 4, 5, 6, 7, 8;
  constraint.area = 0.25;
  constraint.share = 0.5;
  StateArchive saves;
  std::vector<InterfaceConstraint> one{constraint}, other;
  saves.rows("one", one, visit_constraint);
  const SavedState saved = saves.take();
  StateArchive restores(saved);
  restores.rows("one", other, visit_constraint);
  REQUIRE(other.size() == 1);
  CHECK(other[0].pair == PairIndex{3});
  CHECK((other[0].is_swapped && other[0].is_node));
  CHECK(other[0].first_entity == 4);
  CHECK(other[0].second == FaceIndex{5});
  CHECK(other[0].nodes == constraint.nodes);
  CHECK(other[0].springs == constraint.springs);
  CHECK(other[0].area == 0.25);
  CHECK(other[0].share == 0.5);
}
