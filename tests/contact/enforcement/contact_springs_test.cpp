// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/contact_springs.hpp"

#include <Eigen/Geometry>
#include <map>

#include "support/catch.hpp"
#include "support/lofted_meshes.hpp"
#include "support/two_cubes.hpp"

using namespace contactsim;
using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

/// What each node of the mesh feels of a spring, by its displacement and by its rotation.
struct Felt {
  std::map<std::uint32_t, Vector3d> force, moment;
};

/// What nodes feel when some move and turn.
template <class MotionOf, class TurnOf>
Felt felt_by(const ContactSpring& spring, const MotionOf& motion_of, const TurnOf& turn_of) {
  Felt felt;
  spring.multiply(
      [&](const SpringEnd& end) -> Vector3d { return end.turns ? turn_of(end.node) : motion_of(end.node); },
      [&](const SpringEnd& end, const Vector3d& own) {
        (end.turns ? felt.moment : felt.force).try_emplace(end.node, Vector3d::Zero()).first->second += own;
      });
  return felt;
}

Vector3d no_turn(std::uint32_t) { return Vector3d::Zero(); }

/// Two cubes, and the springs of what is between them.
struct SprungCubes {
  test::TwoCubes cubes;
  ContactSprings springs{cubes.model, cubes.parts.kinematics, cubes.parts.rules};

  explicit SprungCubes(const std::string& more = "") : cubes(more) {}
  static std::string rough() {
    return "friction model = rough\nend\nbegin constant friction model rough\nfriction coefficient = 0.2\n";
  }
  static ContactPoint pressed() {
    ContactPoint point = test::TwoCubes::corner_over_face();
    point.force = 10.0;
    point.stiffness = 100.0;
    point.gap = -0.1;
    return point;
  }
};

Felt felt_of_corner(const ContactSpring& spring, const Vector3d& motion) {
  return felt_by(
      spring, [&](std::uint32_t node) { return node == 8 ? motion : Vector3d(0, 0, 0); }, no_turn);
}

}  // namespace

TEST_CASE("a contact point resists along its normal, and both sides feel it", "[contact][contact_springs]") {
  const SprungCubes cubes;
  const ContactSpring spring = cubes.springs.spring_of(SprungCubes::pressed());
  const Felt felt = felt_of_corner(spring, {5, 7, 0.01});
  CHECK(felt.force.at(8).isApprox(Vector3d(0, 0, 1)));
  for (const std::uint32_t node : {4, 5, 6, 7}) CHECK(felt.force.at(node).isApprox(Vector3d(0, 0, -0.25)));
  CHECK(felt.force.size() == 5);
  CHECK(felt.moment.empty());
  // What moves alike feels nothing.
  const Felt rigid = felt_by(
      spring, [](std::uint32_t) { return Vector3d(1, 2, 3); }, no_turn);
  for (const auto& [node, force] : rigid.force) CHECK(force.norm() < 1e-12);
}

TEST_CASE("without friction a point has no spring along the surface", "[contact][contact_springs]") {
  CHECK_FALSE(SprungCubes().springs.friction_spring_of(SprungCubes::pressed(), 0.1, false));
}

TEST_CASE("what sticks resists along the surface, nodes in load steps by a tenth",
          "[contact][contact_springs]") {
  const SprungCubes cubes(SprungCubes::rough());
  ContactPoint point = SprungCubes::pressed();
  point.elastic_slip << 0.01, 0, 0;
  point.tangential << -0.1, 0, 0;
  const auto spring = cubes.springs.friction_spring_of(point, 0.1, false);
  REQUIRE(spring);
  CHECK(felt_of_corner(*spring, {0.3, 0.4, 7}).force.at(8).isApprox(10.0 * Vector3d(0.3, 0.4, 0)));
  point.first.nodes = {8, 9, 11, 10};
  const auto of_faces = cubes.springs.friction_spring_of(point, 0.1, false);
  REQUIRE(of_faces);
  CHECK(felt_of_corner(*of_faces, {0.3, 0.4, 7}).force.at(8).isApprox(100.0 * Vector3d(0.3, 0.4, 0)));
}

TEST_CASE("what slides resists across its way, and is dragged by more where its gap closes",
          "[contact][contact_springs]") {
  const SprungCubes cubes(SprungCubes::rough());
  ContactPoint point = SprungCubes::pressed();
  point.tangential << -2.0, 0, 0;  // 0.2 x 10
  point.elastic_slip << 0.02, 0, 0;
  point.slip << 0.03, 0, 0;
  const bool holds_limit = GENERATE(false, true);
  const auto spring = cubes.springs.friction_spring_of(point, 0.1, holds_limit);
  REQUIRE(spring);
  // Across by the force over the way: 2 / 0.05.
  CHECK(felt_of_corner(*spring, {0, 0.1, 0}).force.at(8).isApprox(Vector3d(0, 4, 0)));
  CHECK(felt_of_corner(*spring, {0.1, 0, 0}).force.at(8).norm() < 1e-12);
  // A gap that closes by 0.01 presses by 1 more, and drags by 0.2 more: along -x on the corner.
  const Vector3d closed = felt_of_corner(*spring, {0, 0, -0.01}).force.at(8);
  if (holds_limit) {
    CHECK(closed.norm() < 1e-12);
  } else {
    CHECK((-closed).isApprox(Vector3d(-0.2, 0, 0), 1e-6));
  }
}

TEST_CASE("what slides without any force has no spring", "[contact][contact_springs]") {
  const SprungCubes cubes(SprungCubes::rough());
  ContactPoint point = SprungCubes::pressed();
  point.slip << 0.03, 0, 0;
  CHECK_FALSE(cubes.springs.friction_spring_of(point, 0.1, false));
}

TEST_CASE("ties resist by their stiffness in every direction, constraints by springs of each corner",
          "[contact][contact_springs]") {
  const SprungCubes cubes;
  Tie tie;
  tie.nodes = {8, 8, 8, 8, 4, 5, 7, 6};
  Eigen::Matrix<double, 8, 1> weights;
  weights << 1, 0, 0, 0, -0.5, -0.5, 0, 0;
  tie.stiffness = 50.0 * weights * weights.transpose();
  const Felt felt = felt_of_corner(cubes.springs.spring_of(tie), {0.1, 0.2, 0.3});
  CHECK(felt.force.at(8).isApprox(Vector3d(5, 10, 15)));
  CHECK(felt.force.at(4).isApprox(Vector3d(-2.5, -5, -7.5)));
  CHECK_FALSE(felt.force.contains(7));
  InterfaceConstraint constraint;
  constraint.nodes = tie.nodes;
  constraint.springs << 20, 0, 0, 0, 5, 0, 0, 0;
  const Felt held = felt_of_corner(cubes.springs.spring_of(constraint), {0.1, 0.2, 0.3});
  CHECK(held.force.at(8).isApprox(Vector3d(2, 4, 6)));
  CHECK(held.force.at(4).isZero(0.0));
  CHECK_FALSE(held.force.contains(5));
}

TEST_CASE("points that stand off a node turn with it", "[contact][contact_springs]") {
  SprungCubes cubes;
  cubes.cubes.model.inertia = Eigen::RowVectorXd::Zero(16);
  cubes.cubes.model.inertia(8) = 0.02;
  ContactPoint point = SprungCubes::pressed();
  point.first.radius = 0.5;
  const ContactSpring spring = cubes.springs.spring_between(point, 100.0 * Matrix3d::Identity());
  // A turn about y moves what is below the node along -x.
  const auto still = [](std::uint32_t) { return Vector3d(0, 0, 0); };
  const Felt felt = felt_by(spring, still, [](std::uint32_t) { return Vector3d(0, 0.01, 0); });
  CHECK(felt.force.at(8).isApprox(100.0 * Vector3d(-0.005, 0, 0)));
  CHECK(felt.moment.at(8).isApprox(Vector3d(0, 0, -0.5).cross(Vector3d(-0.5, 0, 0))));
  cubes.cubes.model.inertia.setZero();  // a particle does not turn
  CHECK(felt_by(cubes.springs.spring_of(point), still, no_turn).moment.empty());
}

TEST_CASE("points of lofts turn with the mid surface around their node", "[contact][contact_springs]") {
  test::MeshBuilder b;
  test::add_plate(b, {.id = 1, .cells = {2, 2}, .u = {2, 0, 0}, .v = {0, 2, 0}}, 0.2);
  test::ContactParts parts(b, test::general_contact());
  const ContactMesh& contact_mesh = parts.contact_mesh;
  parts.kinematics.turn_by(LoftSpins(contact_mesh.loft, 9, RigidNodes{}));
  parts.move();
  Model model;
  model.mesh = &parts.mesh;
  const ContactSprings springs(model, parts.kinematics, parts.rules);
  ContactPoint point;
  std::uint32_t above = static_cast<std::uint32_t>(contact_mesh.n_mesh_points());
  while (contact_mesh.mesh_nodes[{above}] != NodeIndex{4} || parts.kinematics.x({above}).z() < 0.0) ++above;
  point.first.nodes.fill({above});
  point.first.weights = Eigen::Vector4d::UnitX();
  point.normal = Vector3d::UnitX();
  const ContactSpring spring = springs.spring_between(point, 100.0 * Matrix3d::Identity());
  // The plate turns as a whole: the point goes along as a point of a rigid body.
  const Vector3d turning(0.01, -0.02, 0.03), middle = parts.x.col(4), place = parts.kinematics.x({above});
  Vector3d sum = Vector3d::Zero(), moment = Vector3d::Zero();
  const Felt felt = felt_by(
      spring,
      [&](std::uint32_t node) -> Vector3d { return turning.cross(Vector3d(parts.x.col(node)) - middle); },
      no_turn);
  for (const auto& [node, force] : felt.force) {
    sum += force;
    moment += (Vector3d(parts.x.col(node)) - middle).cross(force);
  }
  const Vector3d moved = turning.cross(place - middle);
  CHECK((sum - 100.0 * moved).norm() < 1e-12);
  CHECK((moment - (place - middle).cross(100.0 * moved)).norm() < 1e-12);
}
