// SPDX-License-Identifier: BSD-3-Clause
#include "core/statics/multigrid/rigid_modes.hpp"

#include "support/catch.hpp"

using namespace contactsim;

TEST_CASE("modes of a body are its displacements and turns about its centre", "[core][statics]") {
  // The mean is (1 1 1); the farthest node is 3 from there.
  Eigen::Matrix3Xd x(3, 4);
  x << 4, -2, 1, 1, 1, 1, 3, -1, 1, 1, 1, 1;
  const Modes modes = make_rigid_modes(x);
  REQUIRE(modes.rows() == 12);
  for (Eigen::Index node = 0; node < 4; ++node) CHECK(modes.block<3, 3>(3 * node, 0).isIdentity(0.0));
  // About z the node at (3 0 0) from the centre goes along y, by 1.
  CHECK(modes.block<3, 1>(0, 5).isApprox(Eigen::Vector3d(0, 1, 0)));
  CHECK(modes.block<3, 1>(3, 5).isApprox(Eigen::Vector3d(0, -1, 0)));
  CHECK(modes.block<3, 1>(6, 5).isApprox(Eigen::Vector3d(-2.0 / 3.0, 0, 0)));
  CHECK(modes.block<3, 1>(6, 3).isApprox(Eigen::Vector3d(0, 0, 2.0 / 3.0)));
  CHECK(modes.block<3, 1>(0, 4).isApprox(Eigen::Vector3d(0, 0, -1)));
  CHECK(modes.block<3, 1>(0, 3).isZero(0.0));
}

TEST_CASE("modes keep all distances, and do not depend on where the body is or how large",
          "[core][statics]") {
  Eigen::Matrix3Xd x(3, 6);
  for (Eigen::Index i = 0; i < x.size(); ++i) x(i) = std::sin(1.9 * static_cast<double>(i * i));
  const Modes modes = make_rigid_modes(x);
  for (Eigen::Index mode = 0; mode < 6; ++mode) {
    const Eigen::Matrix3Xd way = modes.col(mode).reshaped(3, 6);
    for (Eigen::Index a = 0; a < 6; ++a) {
      for (Eigen::Index b = 0; b < a; ++b)
        CHECK(std::abs((x.col(a) - x.col(b)).dot(way.col(a) - way.col(b))) < 1e-15);
    }
  }
  const Modes other = make_rigid_modes((1e3 * x).colwise() + Eigen::Vector3d(5e3, 0, -7e3));
  CHECK((other - modes).norm() < 1e-12);
}

TEST_CASE("one node moves and does not turn", "[core][statics]") {
  const Modes modes = make_rigid_modes(Eigen::Vector3d(3, 4, 5));
  CHECK(modes.leftCols<3>().isIdentity(0.0));
  CHECK(modes.rightCols<3>().isZero(0.0));
}
