// SPDX-License-Identifier: BSD-3-Clause
#include "core/elements/solid/uniform_gradient.hpp"

#include <Eigen/Geometry>
#include <cmath>

#include "support/catch.hpp"
#include "support/lone_element.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

constexpr double corner_signs[8][3] = {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1},
                                       {-1, -1, 1},  {1, -1, 1},  {1, 1, 1},  {-1, 1, 1}};

const ElementFormulation& hex8() { return *find_solid_element(Shape::hex8, "mean_quadrature"); }

LoneElement distorted_hex(unsigned seed, const ElementProperties& properties = undamped_elastic()) {
  return {hex8(), properties, distorted(regular_element(Shape::hex8), 0.15, seed)};
}

/// Where the hourglass forces stand in the state of an elastic element.
std::size_t own_place(const LoneElement& element) { return element.block.layout.point_size; }

}  // namespace

TEST_CASE("a rotation in large steps turns the hourglass forces", "[core][elements]") {
  for (unsigned seed = 1; seed <= 4; ++seed) {
    LoneElement element = distorted_hex(seed);
    const Eigen::Matrix3Xd x = element.coordinates;
    const Eigen::Vector3d before(5.0, -2.0, 3.0);
    const std::size_t own = own_place(element);
    for (std::size_t i = 0; i < 3; ++i)
      element.state.values[own + 4 * i + 1].setConstant(before(static_cast<Eigen::Index>(i)));
    for (int i = 1; i <= 5; ++i) element.move_to(rotation_of(0.3 * i) * x, 1e-3);
    Eigen::Vector3d now;
    for (std::size_t i = 0; i < 3; ++i)
      now(static_cast<Eigen::Index>(i)) = element.state.at(element.block.layout, 0, own + 4 * i + 1);
    CHECK((now - rotation_of(1.5) * before).norm() < 1e-4);
  }
}

TEST_CASE("an hourglass motion is resisted, and a linear one is not taken for it", "[core][elements]") {
  for (unsigned seed = 1; seed <= 4; ++seed) {
    LoneElement bent = distorted_hex(seed), stretched = bent;
    const Eigen::Matrix3Xd x = bent.coordinates;
    Eigen::Matrix3Xd mode = Eigen::Matrix3Xd::Zero(3, 8);
    for (Eigen::Index node = 0; node < 8; ++node)
      mode(0, node) = corner_signs[node][1] * corner_signs[node][2];
    const ChunkStep resisted = bent.move_to(x + 1e-6 * mode, 1e-6);
    CHECK(resisted.hourglass_work > 0.0);
    CHECK(bent.forces().cwiseProduct(mode).sum() < 0.0);
    const Eigen::Matrix3d strain = 1e-6 * Eigen::Vector3d(1.0, -2.0, 3.0).asDiagonal();
    const ChunkStep linear = stretched.move_to(x + strain * x, 1e-6);
    CHECK(std::abs(linear.hourglass_work) < 1e-12 * stretched.stress_work());
  }
}

TEST_CASE("hourglass viscosity takes up work and keeps none", "[core][elements]") {
  ElementProperties viscous = undamped_elastic();
  viscous.hourglass_stiffness = 0.0;
  viscous.hourglass_viscosity = 0.05;
  LoneElement element = distorted_hex(1, viscous);
  const Eigen::Matrix3Xd x = element.coordinates;
  Eigen::Matrix3Xd bent = x;
  for (Eigen::Index node = 0; node < 8; ++node)
    bent(0, node) += 1e-6 * corner_signs[node][1] * corner_signs[node][2];
  CHECK(element.move_to(bent, 1e-6).hourglass_work == 0.0);  // no stiffness to scale the viscosity with
  viscous.hourglass_stiffness = 0.05;
  LoneElement damped = distorted_hex(1, viscous), elastic = distorted_hex(1);
  const double with = damped.move_to(bent, 1e-6).hourglass_work;
  CHECK(with > elastic.move_to(bent, 1e-6).hourglass_work);
  const std::size_t own = own_place(damped);
  for (std::size_t i = 0; i < 12; ++i)
    CHECK((damped.state.values[own + i] == elastic.state.values[own + i]).all());
}

TEST_CASE("bulk viscosity resists and shortens the stable step", "[core][elements]") {
  ElementProperties properties = undamped_elastic();
  LoneElement free = distorted_hex(2, properties);
  properties.linear_bulk_viscosity = 0.06;
  properties.quadratic_bulk_viscosity = 1.2;
  LoneElement damped = distorted_hex(2, properties);
  const Eigen::Matrix3Xd closed = 0.999 * free.coordinates;
  const ChunkStep slow = damped.move_to(closed, 1e-6), fast = free.move_to(closed, 1e-6);
  CHECK(slow.stable_step < fast.stable_step);
  CHECK(slow.viscous_work > 0.0);
  CHECK(fast.viscous_work == 0.0);
  const Eigen::Matrix3Xd extra = damped.forces() - free.forces();
  CHECK(extra(0, 1) > 0.0);  // the far side is pushed outwards more
  CHECK(extra(0, 0) < 0.0);
}

TEST_CASE("the stable step of a cube is near its limit", "[core][elements]") {
  LoneElement cube(hex8(), undamped_elastic(), regular_element(Shape::hex8));
  CHECK(cube.stay().stable_step >= 0.97 * stable_limit(cube));
  for (unsigned seed = 1; seed <= 8; ++seed) {
    LoneElement element = distorted_hex(seed);
    CHECK(element.stay().stable_step >= 0.8 * stable_limit(element));
  }
}

TEST_CASE("the stable step of flat and warped elements is near its limit", "[core][elements]") {
  for (const Shape shape : {Shape::hex8, Shape::wedge6, Shape::pyramid5}) {
    for (unsigned seed = 1; seed <= 8; ++seed) {
      LoneElement element(*find_solid_element(shape, "mean_quadrature"), undamped_elastic(),
                          flat_and_warped(shape, seed));
      CHECK(element.stay().stable_step >= 0.8 * stable_limit(element));
    }
  }
}

TEST_CASE("a thin slice of a ball far from its pole is integrated in steps below its limit",
          "[core][elements]") {
  Eigen::Matrix3Xd x(3, 8);  // 0.2 thick, 12 wide, slanting by 36 degrees, warped by 0.7
  x << 19.9869, 32.5, 32.5, 19.9869, 19.9869, 32.5, 32.5, 19.9869,             //
      12.5254, 12.5254, 19.9869, 19.9869, 12.5254, 12.5254, 19.9869, 19.9869,  //
      6.0896, 14.2706, 17.8140, 8.9212, 6.2660, 14.4141, 17.9433, 9.0862;
  LoneElement slice(hex8(), undamped_elastic(), x);
  const double step = slice.stay().stable_step, limit = stable_limit(slice);
  CHECK(step <= limit);
  CHECK(step >= 0.95 * limit);
}

TEST_CASE("the patterns of wedges and pyramids strain nothing and are resisted", "[core][elements]") {
  const auto check = [](Shape shape, const Eigen::RowVectorXd& mode) {
    LoneElement element(*find_solid_element(shape, "mean_quadrature"), undamped_elastic(),
                        regular_element(shape));
    for (Eigen::Index i = 0; i < 3; ++i) {
      LoneElement bent = element;
      Eigen::Matrix3Xd there = bent.coordinates;
      there.row(i) += 1e-7 * mode;
      CHECK(bent.move_to(there).hourglass_work > 0.0);
      CHECK(bent.stress().norm() < 1e-4 * 1e-7 * 1e11);  // of second order in the motion
      CHECK(bent.forces().row(i).dot(mode) < 0.0);
    }
  };
  check(Shape::wedge6, Eigen::RowVectorXd{{1, -1, 0, -1, 1, 0}});
  check(Shape::wedge6, Eigen::RowVectorXd{{1, 1, -2, -1, -1, 2}});
  check(Shape::pyramid5, Eigen::RowVectorXd{{1, -1, 1, -1, 0}});
}
