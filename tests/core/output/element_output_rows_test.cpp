// SPDX-License-Identifier: BSD-3-Clause
// Rows of elements that output_table_test.cpp has no values of.
#include "support/row_values.hpp"

using namespace contactsim;
using namespace contactsim::test;

TEST_CASE("the deformation gradient is in the order xx yy zz xy yz zx yx zy xz", "[core][output]") {
  SampleRun run;
  Eigen::Matrix3d f;
  f << 1.2, 0.3, 0.05, 0.07, 0.9, 0.02, 0.1, -0.04, 1.1;
  run.deform(f, Eigen::Matrix3d::Zero());
  for (const std::size_t i : {0U, 8U})
    check_close(element(run, "deformation_gradient", i), {1.2, 0.9, 1.1, 0.3, 0.02, 0.1, 0.07, -0.04, 0.05});
}

TEST_CASE("principal rates of deformation know nothing of the spin", "[core][output]") {
  SampleRun run;
  Eigen::Matrix3d l;
  l << 1, 4, 0, 0, 1, 0, 0, 0, 2;  // symmetric part: 1 and 2 in the xy plane, principal values 3, 2 and -1
  run.deform(Eigen::Matrix3d::Identity(), l);
  check_close(element(run, "max_principal_rate_of_deformation", 4), {3});
  check_close(element(run, "min_principal_rate_of_deformation", 4), {-1});
}

TEST_CASE("the effective strain of a stretch that keeps the volume is its logarithm", "[core][output]") {
  SampleRun run;
  const double stretch = 1.3, across = 1.0 / std::sqrt(stretch);
  run.deform(Eigen::Vector3d(stretch, across, across).asDiagonal(), Eigen::Matrix3d::Zero());
  check_close(element(run, "effective_log_strain", 1), {std::log(stretch)});
  // A change of volume alone is no effective strain.
  run.deform(1.2 * Eigen::Matrix3d::Identity(), Eigen::Matrix3d::Zero());
  check_close(element(run, "effective_log_strain", 1), {0.0});
}

TEST_CASE("elements that are not cohesive have zeros for what cohesive ones have", "[core][output]") {
  const SampleRun run;
  check_close(element(run, "cohesive_separation", 0), {0, 0});
  check_close(element(run, "cohesive_traction", 0), {0, 0});
  check_close(element(run, "cohesive_damage", 0), {0});
  check_close(element(run, "cohesive_dissipation", 0), {0});
}
