// SPDX-License-Identifier: BSD-3-Clause
#include "core/elements/solid/material_point.hpp"

#include <Eigen/LU>

#include "core/materials/elastic.hpp"
#include "core/materials/neo_hookean.hpp"
#include "support/catch.hpp"
#include "support/lone_element.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Eigen::Matrix3d;

namespace {

constexpr ElasticModuli point_moduli{160.0, 80.0};

Matrix3d stress_at(std::span<const Lanes> point) {
  Matrix3d stress;
  stress << point[0](2), point[3](2), point[5](2), point[3](2), point[1](2), point[4](2), point[5](2),
      point[4](2), point[2](2);
  return stress;
}

/// Hooke's stress of a strain.
Matrix3d hooke_of(const Matrix3d& strain) {
  return point_moduli.lambda() * strain.trace() * Matrix3d::Identity() + 2.0 * point_moduli.shear * strain;
}

StepMotion motion_along(const Matrix3d& gradient) {
  TensorLanes lanes;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j)
      lanes[i][j] = Lanes::Constant(gradient(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)));
  }
  return split_motion(lanes, 1.0);
}

}  // namespace

TEST_CASE("half of a step's strain counts before its rotation, half after", "[core][elements]") {
  std::vector<Lanes> point(6, Lanes::Zero());
  const Matrix3d before = (Matrix3d() << 3, 1, 0, 1, -2, 4, 0, 4, 5).finished();
  for (const auto& [place, value] : {std::pair{0, 3.0}, {1, -2.0}, {2, 5.0}, {3, 1.0}, {4, 4.0}, {5, 0.0}})
    point[static_cast<std::size_t>(place)].setConstant(value);
  const Matrix3d turn = rotation_of(0.7), one = Matrix3d::Identity();
  const Matrix3d strain = (Matrix3d() << 0.01, 0.003, 0, 0.003, -0.02, 0.004, 0, 0.004, 0.01).finished();
  const StepMotion motion = motion_along(2.0 * (turn - one) * (turn + one).inverse() + strain);
  const PointStep step = update_point(ElasticLaw{point_moduli}, motion, point);
  const Matrix3d half = 0.5 * hooke_of(strain);
  const Matrix3d expected = turn * (before + half) * turn.transpose() + half;
  CHECK(stress_at(point).isApprox(expected, 1e-13));
  CHECK(step.stress[3](2) == point[3](2));
  CHECK(step.work(2) == Approx(0.5 * ((before + expected).array() * strain.array()).sum()).epsilon(1e-12));
}

TEST_CASE("a turn alone turns stress and tensors of the material, without work", "[core][elements]") {
  const MaterialLaw law = NeoHookeanLaw{point_moduli};
  std::vector<Lanes> point(6 + law.kind().n_state, Lanes::Zero());
  law.start(std::span(point).subspan(6));
  const Matrix3d strain = (Matrix3d() << 0.1, 0.03, 0, 0.03, -0.2, 0.04, 0, 0.04, 0.1).finished();
  update_point(law, motion_along(strain), point);
  const Matrix3d before = stress_at(point), tensor = stress_at(std::span(point).subspan(6));
  REQUIRE(before.norm() > 1.0);
  const Matrix3d turn = rotation_of(2.0), one = Matrix3d::Identity();
  const PointStep step = update_point(law, motion_along(2.0 * (turn - one) * (turn + one).inverse()), point);
  CHECK(stress_at(point).isApprox(turn * before * turn.transpose(), 1e-11));
  CHECK(stress_at(std::span(point).subspan(6)).isApprox(turn * tensor * turn.transpose(), 1e-11));
  CHECK(std::abs(step.work(0)) < 1e-11);
}
