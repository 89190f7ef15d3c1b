// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/rigid_response.hpp"

#include <algorithm>
#include <vector>

#include "support/catch.hpp"

using namespace contactsim;

namespace {

/// A point that pushes along z only, and whose force falls with its velocity.
struct Point {
  Eigen::Vector3d arm;
  double last = 0.0, gap_rate = 0.0, rate = 1.0;

  double force(const RigidVector& motion) const {
    const double velocity = (rigid_lever(1.0, arm) * motion).z();
    return std::max(0.0, last - rate * (gap_rate + velocity));
  }
  void answer(RigidResponse& body) const {
    const double now = force(body.velocity());
    Eigen::Matrix3d slope = Eigen::Matrix3d::Zero();
    if (now > 0.0) slope(2, 2) = rate;
    body.add(rigid_lever(1.0, arm), Eigen::Vector3d(0, 0, now - last), slope);
  }
};

}  // namespace

TEST_CASE("a body moves by the forces that come with its motion, however light it is",
          "[contact][enforcement]") {
  const double lightness = GENERATE(1e-3, 1.0, 1e6, 1e12);
  const bool is_held = GENERATE(false, true);
  const std::vector<Point> points{{{1, 1, 0}, 0.5, -1.0, 2.0},
                                  {{-1, 1, 0.1}, 0.0, -0.2, 1.0},
                                  {{-1, -1, 0}, 1.0, 0.7, 3.0},
                                  {{1, -0.5, 0}, 0.0, 0.4, 1.0},
                                  {{0.2, 0.1, 0}, 0.0, -0.5, 1e3}};
  RigidMatrix mobility = lightness * RigidMatrix::Identity();
  mobility(3, 4) = mobility(4, 3) = 0.5 * lightness;
  if (is_held) mobility.topLeftCorner<3, 3>().setZero();
  RigidResponse body;
  body.begin(mobility);
  int n_steps = 0;
  do {
    for (const Point& point : points) point.answer(body);
  } while (!body.step() && ++n_steps < 20);
  CHECK(n_steps < 10);
  RigidVector impulse = RigidVector::Zero();
  double size = 0.0;
  for (const Point& point : points) {
    const double change = point.force(body.velocity()) - point.last;
    impulse += rigid_lever(1.0, point.arm).transpose() * Eigen::Vector3d(0, 0, change);
    size += std::abs(change);
  }
  // Of a light body the velocity is what the points allow: the sum of forces is round-off, times its
  // mobility.
  CHECK((mobility * impulse - body.velocity()).norm() < 1e-9 * (body.velocity().norm() + lightness * size));
}
