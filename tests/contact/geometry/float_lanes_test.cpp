// SPDX-License-Identifier: BSD-3-Clause
#include "contact/geometry/float_lanes.hpp"

#include <limits>
#include <vector>

#include "support/catch.hpp"

using namespace contactsim;

namespace {

struct EightNumbers {
  std::array<float, 8> numbers{};
};

}  // namespace

TEST_CASE("records of lanes are read number by number", "[contact][float_lanes]") {
  std::vector<EightNumbers> records(n_float_lanes);
  for (std::size_t i = 0; i < n_float_lanes; ++i) {
    for (std::size_t k = 0; k < 8; ++k) records[i].numbers[k] = static_cast<float>(100 * i + k);
  }
  for (std::size_t n = 0; n <= n_float_lanes; ++n) {
    RecordLanes<EightNumbers> lanes;
    lanes.fill(n, [&](std::size_t lane) -> const EightNumbers& { return records.at(lane < n ? lane : 99); });
    for (std::size_t k = 0; k < 8; ++k) {
      const FloatLanes number = lanes[k];
      for (std::size_t i = 0; i < n; ++i) REQUIRE(number[i] == records[i].numbers[k]);
    }
    const VectorLanes vector = lanes.vector(5);
    for (std::size_t i = 0; i < n; ++i) {
      REQUIRE(vector.x[i] == records[i].numbers[5]);
      REQUIRE(vector.z[i] == records[i].numbers[7]);
    }
  }
}

TEST_CASE("what is true of lanes becomes bits, and nothing is of what is not a number",
          "[contact][float_lanes]") {
  FloatLanes::Numbers numbers;
  for (std::size_t lane = 0; lane < n_float_lanes; ++lane) numbers[lane] = static_cast<float>(lane);
  FloatLanes a(numbers);
  CHECK((a > 2.0f).bits() == 0xfff8u);
  CHECK((a < 0.0f).bits() == 0u);
  CHECK((a >= 0.0f).bits() == 0xffffu);
  CHECK((a == 0.0f || a == 15.0f).bits() == 0x8001u);
  CHECK(first_lane((a > 2.0f).bits()) == 3);
  numbers[3] = std::numeric_limits<float>::quiet_NaN();
  a = FloatLanes(numbers);
  CHECK((a > 2.0f || a <= 2.0f).bits() == 0xfff7u);
}

TEST_CASE("the taxicab length of vectors is no less than their length", "[contact][float_lanes]") {
  const VectorLanes v = VectorLanes::all(Eigen::Vector3f(3.0f, -4.0f, 12.0f));
  CHECK(taxicab(v)[7] == 19.0f);
  CHECK(v.dot(v)[7] == 169.0f);
}
