// SPDX-License-Identifier: BSD-3-Clause
#include "contact/geometry/float_positions.hpp"

#include <vector>

#include "support/catch.hpp"

using namespace contactsim;

TEST_CASE("positions in single precision keep differences near their origin", "[contact][float_positions]") {
  FloatPositions positions;
  const Eigen::Vector3d far(1e6, -2e6, 3e6), step(1e-3, 2e-3, -4e-3);
  positions.begin(far);
  CHECK(positions.position(far).isZero(0.0));
  // Rounding of the sum in double precision: 3e6 x 2^-52.
  CHECK((positions.position(far + step).cast<double>() - step).norm() < 1e-9);
}

TEST_CASE("the rounding is a share of the farthest coordinate", "[contact][float_positions]") {
  FloatPositions positions;
  const std::vector<Eigen::Vector3f> of_items{{1, 2, 3}, {0, -5, 1}, {4, 0, 0}};
  positions.note_rounding(3, 8.0f, [&](std::uint32_t i) { return of_items[i]; });
  CHECK(positions.rounding() == 8.0f * 5.0f / 16777216.0f);
  positions.note_rounding(1, 4.0f, [&](std::uint32_t i) { return of_items[i]; });
  CHECK(positions.rounding() == 4.0f * 3.0f / 16777216.0f);
}
