// SPDX-License-Identifier: BSD-3-Clause
#include "core/rigid/rigid_body.hpp"

#include <cmath>

#include "support/catch.hpp"

using namespace contactsim;

namespace {

RigidBody body_of(const Eigen::Vector3d& principal) {
  RigidBody body;
  body.mass = 1.0;
  body.inertia = principal.asDiagonal();
  body.flexible = inverse_where_it_is(body.inertia);
  return body;
}

/// A body that no moment acts on.
struct Free {
  RigidBody body;
  Eigen::Vector3d spin;
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();
  Eigen::Vector3d turning = Eigen::Vector3d::Zero();

  void advance(int n_steps, double dt) {
    for (int i = 0; i < n_steps; ++i) {
      turning = turning_of(body, orientation, spin, dt);
      orientation = (turn_by(dt * turning) * orientation).normalized();
    }
  }
};

}  // namespace

TEST_CASE("a free symmetric top goes round its angular momentum at the rate of theory", "[core][rigid]") {
  // The axis goes round the angular momentum at the rate spin / (inertia across the axis).
  const Eigen::Vector3d spin(0.6, 0.0, 0.8);
  const auto error = [&](int n) {
    Free top{body_of({1.0, 1.0, 2.0}), spin};
    constexpr double time = 5.0;
    top.advance(n, time / n);
    const Eigen::Vector3d axis = top.orientation * Eigen::Vector3d::UnitZ();
    const Eigen::Vector3d expected = Eigen::AngleAxisd(time * spin.norm() / 1.0, spin.normalized()) *
                                     Eigen::Vector3d(Eigen::Vector3d::UnitZ());
    return (axis - expected).norm();
  };
  CHECK(error(1000) < 1e-5);
  CHECK(error(500) / error(1000) == Approx(4.0).epsilon(0.05));  // of second order
}

TEST_CASE("a tumbling body keeps its energy over many turns", "[core][rigid]") {
  Free body{body_of({1.0, 2.0, 3.0}), {0.01, 2.0, 0.0}};  // about the middle axis, which is unstable
  body.advance(1, 0.02);
  const double start = 0.5 * body.spin.dot(body.turning);
  double least = start, most = start;
  bool has_flipped = false;
  for (int i = 0; i < 50000; ++i) {
    body.advance(1, 0.02);
    const double energy = 0.5 * body.spin.dot(body.turning);
    least = std::min(least, energy);
    most = std::max(most, energy);
    has_flipped = has_flipped || (body.orientation * Eigen::Vector3d::UnitY()).y() < -0.9;
  }
  CHECK(has_flipped);
  CHECK(most - least < 1e-3 * start);
}

TEST_CASE("a turning that is partly given leaves the rest of the momentum alone", "[core][rigid]") {
  RigidBody body = body_of({1.0, 2.0, 3.0});
  RigidBodyState state;
  state.orientation = turn_by({0.3, -0.2, 0.5});
  const Eigen::Vector3d spin(0.4, 0.3, -0.2), given(0.0, 0.7, 0.0);
  const Eigen::Matrix3d free = Eigen::Vector3d(1.0, 0.0, 1.0).asDiagonal();
  const Eigen::Vector3d turning = turning_of(body, state, spin, 0.1, given, free);
  CHECK(turning.y() == 0.7);
  const Eigen::Vector3d found = inertia_amid(body, state.orientation, turning, 0.1) * turning;
  CHECK(found.x() == Approx(spin.x()));
  CHECK(found.z() == Approx(spin.z()));
}

TEST_CASE("rotation vectors turn by their length, however small", "[core][rigid]") {
  for (const double angle : {1e-9, 1e-4, 0.5, 3.0}) {
    const Eigen::Vector3d axis = Eigen::Vector3d(1.0, -2.0, 0.5).normalized();
    const Eigen::Quaterniond turn = turn_by(angle * axis);
    CHECK(turn.norm() == Approx(1.0).epsilon(1e-15));
    CHECK(turn.vec().norm() == Approx(std::sin(0.5 * angle)).epsilon(1e-14));
  }
  CHECK(turn_by(Eigen::Vector3d::Zero()).w() == 1.0);
}
