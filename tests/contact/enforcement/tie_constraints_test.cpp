// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/tie_constraints.hpp"

#include <Eigen/Geometry>

#include "support/catch.hpp"
#include "support/two_cubes.hpp"

using namespace contactsim;
using Eigen::Vector3d;

namespace {

constexpr double tied_dt = 0.1;

/// Ties between two cubes as constraints of a step, found by hand instead of by MomentumBalance.
struct TiedCubes {
  test::TwoCubes cubes;
  ModelFreeDirections free;
  NodeMobility mobility;
  TieConstraints ties{mobility};
  State state;

  /// Begins a step in which nodes go by their velocities.
  void begin() {
    cubes.parts.kinematics.move_nodes(cubes.parts.motion(tied_dt));
    free.update(cubes.model, 0.0);
    state = cubes.state(tied_dt);
    mobility.begin(cubes.model, free, cubes.parts.kinematics, state);
    ties.begin(cubes.parts.kinematics, tied_dt);
  }
  void solve(int n_passes = 1) {
    LightCarriers light;
    mobility.begin_passes();
    LeaningAreas areas(mobility.n_carriers(), {0.0, 0.0});
    ties.add_areas(areas);
    light.begin(mobility.n_carriers());
    ties.set_softness(areas, light, 0.0);
    ties.push_forces();
    mobility.end_pass();
    for (int i = 0; i < n_passes; ++i) {
      ties.pass(0.0, light);
      mobility.end_pass();
    }
    ties.finish();
  }
  /// The velocity of a contact node after the step's forces.
  Vector3d velocity(std::uint32_t node) const {
    Vector3d v = cubes.parts.kinematics.v({node});
    for (std::uint32_t i = 0; i < mobility.n_carriers(); ++i) {
      if (!mobility.is_body(i) && mobility.mesh_nodes()[i] == node) v += mobility.change(i).head<3>();
    }
    return v;
  }
  Vector3d at_end(std::uint32_t node) const {
    return cubes.parts.kinematics.x({node}) + tied_dt * velocity(node);
  }
};

/// A corner of the upper cube tied to a point of the lower one's top, 1 apart.
Tie corner_tie(const Eigen::Vector4d& weights = Eigen::Vector4d::Constant(0.25)) {
  Tie tie;
  tie.is_node = true;
  tie.first_entity = 8;
  tie.nodes = {8, 8, 8, 8, 4, 5, 7, 6};
  tie.n_points = 1;
  tie.points[0].area = 2.0;
  tie.points[0].weights_1 = Eigen::Vector4d::UnitX();
  tie.points[0].weights_2 = weights;
  return tie;
}

/// Has a point be tied where it is.
void tie_here(const TiedCubes& cubes, Tie& tie) {
  CornerVectors x;
  for (int k = 0; k < 8; ++k)
    x.col(k) = cubes.cubes.parts.kinematics.x(tie.nodes[static_cast<std::size_t>(k)]);
  const Eigen::Matrix3d axes = axes_of(x.rightCols<4>());
  tie.points[0].offset = axes.transpose() * (x.leftCols<4>() * tie.points[0].weights_1 -
                                             x.rightCols<4>() * tie.points[0].weights_2);
}

}  // namespace

TEST_CASE("a tied point is where it was tied at the end of a step, and nothing is pushed but its sides",
          "[contact][tie_constraints]") {
  TiedCubes cubes;
  cubes.begin();
  Tie tie = corner_tie({0.4, 0.3, 0.2, 0.1});
  tie_here(cubes, tie);
  cubes.cubes.parts.v.col(8) << 0.3, -0.2, 0.5;
  cubes.begin();
  cubes.ties.add(tie);
  CHECK_FALSE(cubes.ties.empty());
  cubes.solve(200);
  // The top turns by the forces, and takes the point along.
  CornerVectors end;
  for (int k = 0; k < 8; ++k) end.col(k) = cubes.at_end(tie.nodes[static_cast<std::size_t>(k)].value);
  const Vector3d apart = end.col(0) - end.rightCols<4>() * tie.points[0].weights_2;
  const Vector3d wanted = axes_of(end.rightCols<4>()) * tie.points[0].offset;
  CHECK((apart - wanted).norm() < 2e-3 * wanted.norm());  // of second order in the turn
  Vector3d momentum = Vector3d::Zero(), moment = Vector3d::Zero();
  for (std::uint32_t i = 0; i < cubes.mobility.n_carriers(); ++i) {
    const Vector3d own = cubes.mobility.change(i).head<3>();
    momentum += own;
    moment += Vector3d(cubes.cubes.parts.x.col(cubes.mobility.mesh_nodes()[i])).cross(own);
  }
  CHECK(momentum.norm() < 1e-14);
  CHECK(moment.norm() < 1e-14);
  CHECK(tie.points[0].force.norm() > 0.0);
}

TEST_CASE("sides that move and turn as one need no force", "[contact][tie_constraints]") {
  TiedCubes cubes;
  cubes.begin();
  Tie tie = corner_tie();
  tie_here(cubes, tie);
  const Vector3d turning(0.2, -0.1, 0.4);
  for (Eigen::Index i = 0; i < 16; ++i)
    cubes.cubes.parts.v.col(i) = Vector3d(1, 2, 3) + turning.cross(Vector3d(cubes.cubes.parts.x.col(i)));
  cubes.begin();
  cubes.ties.add(tie);
  cubes.solve(5);
  CHECK(tie.points[0].force.norm() < 1e-12);
}

TEST_CASE("a tied point in the plane of its face is found in one pass", "[contact][tie_constraints]") {
  TiedCubes cubes;
  cubes.cubes.parts.x.rightCols(8).colwise() += Vector3d(0.5, 0.5, -1.0);
  cubes.begin();
  Tie tie = corner_tie();
  tie_here(cubes, tie);
  cubes.cubes.parts.v.col(8) << 0.3, -0.2, 0.5;
  cubes.begin();
  cubes.ties.add(tie);
  cubes.solve();
  // The corner is as soft as 1 / 0.5, the face as 1 / 2: F = - v / (dt 2.5).
  const Vector3d force = -Vector3d(0.3, -0.2, 0.5) / (tied_dt * 2.5);
  CornerVectors x;
  for (int k = 0; k < 8; ++k)
    x.col(k) = cubes.cubes.parts.kinematics.x(tie.nodes[static_cast<std::size_t>(k)]);
  CHECK((axes_of(x.rightCols<4>()) * tie.points[0].force).isApprox(force, 1e-5));
}

TEST_CASE("passes begin with half of the force of the step before, in axes that turn with the face",
          "[contact][tie_constraints]") {
  TiedCubes cubes;
  cubes.cubes.parts.x.rightCols(8).colwise() += Vector3d(0.5, 0.5, -1.0);
  cubes.begin();
  Tie tie = corner_tie();
  tie_here(cubes, tie);
  tie.points[0].force << 1, 2, 3;
  cubes.begin();
  cubes.ties.add(tie);
  cubes.solve(0);
  CHECK(tie.points[0].force.isApprox(Vector3d(0.5, 1.0, 1.5)));
}

TEST_CASE("points without area and points between held sides hold nothing", "[contact][tie_constraints]") {
  TiedCubes cubes;
  Tie tie = corner_tie();
  const bool is_held = GENERATE(false, true);
  if (is_held) {
    cubes.cubes.hold({{4}, {5}, {6}, {7}, {8}}, Components{{true, true, true}});
  } else {
    tie.points[0].area = 0.0;
  }
  cubes.begin();
  tie_here(cubes, tie);
  cubes.cubes.parts.v.col(8) << 0.3, -0.2, 0.5;
  cubes.begin();
  cubes.ties.add(tie);
  CHECK(cubes.ties.empty() == !is_held);
  cubes.solve(3);
  CHECK(cubes.ties.empty());
  CHECK(tie.points[0].force.isZero(0.0));
}

TEST_CASE("a rigid side carries a tied point as it is", "[contact][tie_constraints]") {
  TiedCubes cubes;
  cubes.cubes.make_rigid();
  cubes.begin();
  // The lower cube's corner is tied to the bottom of the rigid one, 1 above it.
  Tie tie = corner_tie();
  tie.nodes = {7, 7, 7, 7, 8, 10, 11, 9};
  tie_here(cubes, tie);
  cubes.cubes.parts.v.col(7) << 0.3, -0.2, 0.5;
  cubes.begin();
  cubes.ties.add(tie);
  cubes.solve(200);
  REQUIRE(cubes.mobility.n_carriers() == 2);
  // The point is at the corner itself, and the body's velocity there is that of the corner.
  const std::uint32_t body = cubes.mobility.is_body(0) ? 0 : 1;
  const Vector3d arm = Vector3d(cubes.cubes.parts.x.col(7)) - cubes.state.rigid[0].position;
  const Vector3d moves = cubes.mobility.change(body).head<3>() + cubes.mobility.turning(body).cross(arm);
  CHECK((moves - cubes.velocity(7)).norm() < 1e-5);
  // The moment of momentum of the body is that of the force at the arm.
  const Vector3d impulse = 8.0 * cubes.mobility.change(body).head<3>();
  const Vector3d spin = Vector3d(4, 4, 2).cwiseProduct(cubes.mobility.turning(body));
  CHECK((spin - arm.cross(impulse)).norm() < 1e-12);
}
