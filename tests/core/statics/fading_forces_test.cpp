// SPDX-License-Identifier: BSD-3-Clause
#include "core/statics/fading_forces.hpp"

#include "core/base/state_archive.hpp"
#include "support/catch.hpp"

using namespace contactsim;

namespace {

Eigen::VectorXd three() { return Eigen::Vector3d(4.0, -2.0, 8.0); }

}  // namespace

TEST_CASE("forces fade evenly between two times", "[core][statics]") {
  FadingForces forces;
  CHECK(forces.empty());
  CHECK(forces.share(0.0) == 0.0);
  forces.begin(three(), 1.0, 3.0);
  CHECK_FALSE(forces.empty());
  CHECK(forces.share(0.5) == 1.0);
  CHECK(forces.share(1.0) == 1.0);
  CHECK(forces.share(2.5) == 0.25);
  CHECK(forces.share(3.0) == 0.0);
  CHECK(forces.share(9.0) == 0.0);
  Eigen::VectorXd left = Eigen::VectorXd::Ones(3);
  forces.take_off(forces.share(2.5), left);
  CHECK(left == Eigen::VectorXd(Eigen::Vector3d(0.0, 1.5, -1.0)));
}

TEST_CASE("forces that fade are saved where there are any", "[core][statics]") {
  FadingForces none;
  StateArchive nothing;
  none.archive(3, nothing);
  CHECK(nothing.take().find("run/out_of_balance") == nullptr);

  FadingForces forces, back;
  forces.begin(three(), 1.0, 3.0);
  StateArchive to;
  forces.archive(3, to);
  const SavedState saved = to.take();
  StateArchive from(saved);
  back.archive(3, from);
  CHECK(back.share(2.5) == 0.25);
  Eigen::VectorXd left = three();
  back.take_off(1.0, left);
  CHECK(left.isZero(0.0));
}
