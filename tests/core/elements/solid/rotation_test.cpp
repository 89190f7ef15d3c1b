// SPDX-License-Identifier: BSD-3-Clause
#include "core/elements/solid/rotation.hpp"

#include <Eigen/LU>

#include "support/catch.hpp"
#include "support/lone_element.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Eigen::Matrix3d;

namespace {

TensorLanes lanes_of(const Matrix3d& tensor) {
  TensorLanes lanes;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j)
      lanes[i][j] = Lanes::Constant(tensor(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)));
  }
  return lanes;
}

Matrix3d tensor_of(const TensorLanes& lanes) {
  Matrix3d tensor;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      tensor(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = lanes[i][j](5);
      CHECK((lanes[i][j] == lanes[i][j](5)).all());
    }
  }
  return tensor;
}

}  // namespace

TEST_CASE("the strain is the symmetric part of the step's gradient", "[core][elements]") {
  Matrix3d gradient;
  gradient << 1, 2, 3, 4, 5, 6, 7, 8, 9;
  const StepMotion motion = split_motion(lanes_of(gradient), 0.5);
  const std::array<double, 6> expected{0.5, 2.5, 4.5, 1.5, 3.5, 2.5};  // xx yy zz xy yz zx
  for (std::size_t i = 0; i < 6; ++i) CHECK(motion.strain.strain[i](0) == expected[i]);
  CHECK(tensor_of(motion.strain.gradient) == 0.5 * gradient);
  CHECK(motion.strain.dt == 0.5);
}

TEST_CASE("a turn of a body along chords is found exactly, and has no strain", "[core][elements]") {
  for (const double angle : {0.0, 1e-9, 0.1, 1.5, 3.0}) {
    // x goes from r to R r: the gradient by the places in the middle is 2 (R - 1) (R + 1)^-1.
    const Matrix3d turn = rotation_of(angle), one = Matrix3d::Identity();
    const Matrix3d gradient = 2.0 * (turn - one) * (turn + one).inverse();
    const StepMotion motion = split_motion(lanes_of(gradient / 0.25), 0.25);
    CHECK((tensor_of(motion.rotation) - turn).norm() < 1e-13);
    for (std::size_t i = 0; i < 6; ++i) CHECK(std::abs(motion.strain.strain[i](0)) < 1e-13);
  }
}

TEST_CASE("the rotation is one, whatever the gradient", "[core][elements]") {
  Matrix3d gradient;
  gradient << 3, -20, 0.1, 7, 0, 1e3, -5, 2, 0;
  const Matrix3d rotation = tensor_of(split_motion(lanes_of(gradient), 1.0).rotation);
  CHECK((rotation.transpose() * rotation).isIdentity(1e-12));
  CHECK(rotation.determinant() == Approx(1.0).epsilon(1e-12));
  const Matrix3d stretch = gradient + gradient.transpose();
  CHECK(tensor_of(split_motion(lanes_of(stretch), 1.0).rotation).isIdentity(0.0));
}
