// SPDX-License-Identifier: BSD-3-Clause
#include "io/netcdf/netcdf_layout.hpp"

#include "support/catch.hpp"

using namespace contactsim;

TEST_CASE("definitions and attributes are found by their names", "[io][layout]") {
  const NetcdfLayout layout{
      {{"n", 4, false}, {"m", 2, true}}, {{"a", NetcdfType::int32, {"m", "n"}, {}}}, {}};
  CHECK(layout.length("n") == 4);
  CHECK(layout.length("none") == 0);
  CHECK(layout.find_dimension("m")->is_unlimited);
  CHECK(layout.find_variable("b") == nullptr);
  CHECK(layout.shape(*layout.find_variable("a")) == std::vector<std::size_t>{2, 4});
}

TEST_CASE("attributes give a number or a text", "[io][layout]") {
  const std::vector<NetcdfAttribute> attributes{
      {"i", NetcdfType::int32, std::vector<std::int64_t>{7, 8}},
      {"r", NetcdfType::float32, std::vector<double>{0.5}},
      {"none", NetcdfType::float64, std::vector<double>{}},
      {"t", NetcdfType::text, std::vector<char>{' ', 'a', ' ', '\0', 'b'}}};
  CHECK(first_number(find_attribute(attributes, "i")) == 7.0);
  CHECK(first_number(find_attribute(attributes, "r")) == 0.5);
  CHECK_FALSE(first_number(find_attribute(attributes, "none")));
  CHECK_FALSE(first_number(find_attribute(attributes, "t")));
  CHECK_FALSE(first_number(find_attribute(attributes, "missing")));
  CHECK(whole_text(find_attribute(attributes, "t")) == "a");
  CHECK_FALSE(whole_text(find_attribute(attributes, "i")));
}
