// SPDX-License-Identifier: BSD-3-Clause
#include "io/decompose/file_layout.hpp"

#include "support/catch.hpp"

using namespace contactsim;

namespace {

NetcdfLayout sample() {
  return {{{"time_step", 3, true}, {"n", 4, true}, {"none", 0, false}},
          {{"a", NetcdfType::float64, {"time_step", "n"}, {}},
           {"b", NetcdfType::int32, {"n"}, {}},
           {"c", NetcdfType::int32, {"none"}, {}}},
          {}};
}

}  // namespace

TEST_CASE("times alone grow in what is written, and nothing is empty", "[io][decompose]") {
  const NetcdfLayout layout = make_writable(sample());
  REQUIRE(layout.dimensions.size() == 2);
  CHECK(layout.dimensions[0].is_unlimited);
  CHECK_FALSE(layout.dimensions[1].is_unlimited);
  REQUIRE(layout.variables.size() == 2);
  CHECK(is_record(layout, layout.variables[0]));
  CHECK_FALSE(is_record(layout, layout.variables[1]));
}

TEST_CASE("wide integers and large variables need a large file", "[io][decompose]") {
  NetcdfLayout layout = make_writable(sample());
  CHECK_FALSE(needs_large_file(layout));
  layout.dimensions[1].length = std::size_t{1} << 29;
  // Two GiB of integers, four of reals a record.
  CHECK(needs_large_file(layout));
  layout.variables.erase(layout.variables.begin());
  CHECK_FALSE(needs_large_file(layout));
  layout.variables[0].type = NetcdfType::int64;
  CHECK(needs_large_file(layout));
}
