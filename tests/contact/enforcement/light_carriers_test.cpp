// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/light_carriers.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <vector>

#include "support/catch.hpp"

using namespace contactsim;

namespace {

/// A point that pushes along z only, and whose force falls with its velocity.
struct Point {
  Eigen::Vector3d arm;
  double last = 0.0, closing = 0.0, rate = 1.0;
  std::uint32_t body = 0;

  LightAnswer answer(const Eigen::Vector3d& velocity) const {
    const double now = std::max(0.0, last + rate * (closing - velocity.z()));
    LightAnswer answer{{0, 0, now}, {0, 0, now - last}, Eigen::Matrix3d::Zero(), rate};
    if (now > 0.0) answer.rate(2, 2) = rate;
    return answer;
  }
};

/// Bodies on points, some of which stand between the first two.
struct LightBodies {
  std::vector<Point> points{{{1, 1, 0}, 0.5, 1.0, 2.0, 0},     {{-1, 1, 0.1}, 0.0, 0.2, 1.0, 0},
                            {{-1, -1, 0}, 1.0, -0.7, 3.0, 0},  {{1, -0.5, 0}, 0.0, -0.4, 1.0, 1},
                            {{0.2, 0.1, 0}, 0.0, 0.5, 1e3, 1}, {{-0.3, 0.6, 0}, 0.2, 0.3, 2.0, 1}};
  LightCarriers light;

  explicit LightBodies(const CarrierMobility& mobility) {
    light.begin(3);
    light.add(0, mobility);
    light.add(2, mobility);
    for (const Point& point : points)
      light.add_row(std::vector<LightShare>{{point.body, Eigen::Matrix3d::Identity(), point.arm}});
    points.push_back({{0.4, 0.4, 0}, 0.0, 0.6, 5.0, 0});
    light.add_row(std::vector<LightShare>{{0, Eigen::Matrix3d::Identity(), {0.4, 0.4, 0}},
                                          {1, -Eigen::Matrix3d::Identity(), {-0.4, 0.1, 0}}});
  }
};

}  // namespace

TEST_CASE("light bodies move by the forces that come with their motion, however light they are",
          "[contact][enforcement]") {
  const double lightness = GENERATE(1e-3, 1.0, 1e6, 1e9);
  const int n_held = GENERATE(0, 1, 3);  // directions of translation
  CarrierMobility mobility{lightness * Eigen::Matrix3d::Identity(), lightness * Eigen::Matrix3d::Identity()};
  mobility.rotation(0, 1) = mobility.rotation(1, 0) = 0.5 * lightness;
  for (int i = 0; i < n_held; ++i) mobility.translation(2 - i, 2 - i) = 0.0;
  LightBodies bodies(mobility);
  bodies.light.solve([&](std::uint32_t row, const Eigen::Vector3d& velocity) {
    return bodies.points[row].answer(velocity);
  });
  Eigen::Vector3d force[2] = {Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
  Eigen::Vector3d moment[2] = {Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
  double size = 0.0;
  CAPTURE(lightness, n_held);
  const auto push = [&](std::size_t body, const Eigen::Vector3d& arm, const Eigen::Vector3d& change) {
    force[body] += change;
    moment[body] += arm.cross(change);
  };
  for (std::uint32_t row = 0; row < bodies.points.size(); ++row) {
    const Point& point = bodies.points[row];
    const LightAnswer answer = point.answer(bodies.light.velocity(row));
    const Eigen::Vector3d& change = answer.change;
    size += point.last + answer.force.norm();
    push(point.body, point.arm, change);
    if (row == 6) push(1, {-0.4, 0.1, 0}, -change);
  }
  // Of a light body the velocity is what the points allow: the forces add up to round-off, times its
  // mobility.
  for (std::uint32_t row = 0; row < bodies.points.size(); ++row) {
    const Point& point = bodies.points[row];
    const auto moves = [&](std::size_t body, const Eigen::Vector3d& arm) {
      return Eigen::Vector3d(mobility.translation * force[body] +
                             (mobility.rotation * moment[body]).cross(arm));
    };
    Eigen::Vector3d expected = moves(point.body, point.arm);
    if (row == 6) expected -= moves(1, {-0.4, 0.1, 0});
    const Eigen::Vector3d velocity = bodies.light.velocity(row);
    CHECK((velocity - expected).norm() < 1e-8 * velocity.norm() + 1e-13 * lightness * size);
  }
}

TEST_CASE("a light line that cannot turn about itself moves alike in every frame, whatever turns it so",
          "[contact][enforcement]") {
  // Points off the axis are rubbed: what is missing of the moment about the axis stays missing.
  const std::vector<Eigen::Vector3d> arms{{1.0, 0.1, 0.0}, {-0.7, 0.0, 0.1}, {0.2, -0.1, 0.0}};
  const std::vector<Eigen::Vector3d> closing{{0.3, 0.2, 1.0}, {-0.1, 0.5, 0.4}, {0.2, -0.6, 0.8}};
  constexpr double lightness = 1e4, rate = 3.0;
  const auto velocities = [&](const Eigen::Matrix3d& frame) {
    const Eigen::Matrix3d across = Eigen::Vector3d(0, 1, 1).asDiagonal();
    LightCarriers light;
    light.begin(1);
    light.add(0, {lightness * Eigen::Matrix3d::Identity(), lightness * frame * across * frame.transpose()});
    for (const Eigen::Vector3d& arm : arms)
      light.add_row(std::vector<LightShare>{{0, Eigen::Matrix3d::Identity(), frame * arm}});
    light.solve([&](std::uint32_t row, const Eigen::Vector3d& velocity) {
      const Eigen::Vector3d force = rate * (frame * closing[row] - velocity);
      return LightAnswer{force, force, rate * Eigen::Matrix3d::Identity(), rate};
    });
    Eigen::Matrix3d all;
    for (std::uint32_t row = 0; row < 3; ++row) all.col(row) = frame.transpose() * light.velocity(row);
    return all;
  };
  const Eigen::Matrix3d plain = velocities(Eigen::Matrix3d::Identity());
  CHECK(plain.norm() < 10.0);
  for (const double angle : {0.3, 1.1, 2.5}) {
    const Eigen::AngleAxisd turn(angle, Eigen::Vector3d(1, -2, 0.5).normalized());
    CHECK((velocities(turn.toRotationMatrix()) - plain).norm() < 1e-9);
  }
}
