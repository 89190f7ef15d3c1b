// SPDX-License-Identifier: BSD-3-Clause
#include "core/base/tensor_lanes.hpp"

#include "support/catch.hpp"

using namespace contactsim;

namespace {

SymmetricLanes tensor(const std::array<double, 6>& components) {
  SymmetricLanes made;
  for (std::size_t i = 0; i < 6; ++i) made[i].setConstant(components[i]);
  return made;
}

TensorLanes matrix(const std::array<std::array<double, 3>, 3>& rows) {
  TensorLanes made;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) made[i][j].setConstant(rows[i][j]);
  return made;
}

}  // namespace

TEST_CASE("a deformation carries a symmetric tensor along as F a F^T", "[core][lanes]") {
  const SymmetricLanes a = tensor({1.0, 2.0, 3.0, 4.0, 5.0, 6.0});
  const TensorLanes f = matrix({{{1.0, 0.0, 0.0}, {0.0, 2.0, 0.0}, {1.0, 3.0, 2.0}}});
  // xx 1, yy 4 * 2, zz (1, 3, 2) a (1, 3, 2) = 25 + 60 + 54 = 139
  // xy 2 * 4, yz 2 * (4 + 3 * 2 + 2 * 5), zx 1 + 3 * 4 + 2 * 6
  const SymmetricLanes carried = transformed(a, f);
  const std::array<double, 6> expected{1.0, 8.0, 139.0, 8.0, 40.0, 25.0};
  for (std::size_t i = 0; i < 6; ++i)
    for (int lane = 0; lane < n_lanes; ++lane) CHECK(carried[i](lane) == expected[i]);
}

TEST_CASE("each lane is carried along by its own deformation", "[core][lanes]") {
  SymmetricLanes a = tensor({1.0, 1.0, 1.0, 0.0, 0.0, 0.0});
  TensorLanes f = matrix({{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}});
  for (int lane = 0; lane < n_lanes; ++lane) f[0][0](lane) = lane;
  const SymmetricLanes carried = transformed(a, f);
  for (int lane = 0; lane < n_lanes; ++lane) {
    CHECK(carried[0](lane) == lane * lane);
    CHECK(carried[1](lane) == 1.0);
  }
}

TEST_CASE("no eigenvalue exceeds its bound, and two equal small ones reach it", "[core][lanes]") {
  // 5, 1, 1: mean 7/3, deviator 8/3, -4/3, -4/3 of norm sqrt(96)/3, bound 7/3 + sqrt(2/3 * 96/9) = 5
  CHECK(bound_of_eigenvalues(tensor({5.0, 1.0, 1.0, 0.0, 0.0, 0.0}))(0) == Approx(5.0));
  // xy = 2 alone: eigenvalues 2, 0, -2, bound sqrt(2/3 * 8)
  CHECK(bound_of_eigenvalues(tensor({0.0, 0.0, 0.0, 2.0, 0.0, 0.0}))(0) == Approx(std::sqrt(16.0 / 3.0)));
}
