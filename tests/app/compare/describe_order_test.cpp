// SPDX-License-Identifier: BSD-3-Clause
#include "app/compare/describe_order.hpp"

#include <algorithm>
#include <numeric>

#include "support/catch.hpp"

using namespace contactsim;

namespace {

/// What is reported when ten things, a to j, stand in another order.
std::string order_of(const std::string& second) {
  std::vector<std::string> names;
  std::vector<std::size_t> places;
  std::string first = second;
  std::ranges::sort(first);
  for (const char name : first) {
    names.emplace_back(1, name);
    places.push_back(second.find(name));
  }
  return describe_order(names, places);
}

}  // namespace

TEST_CASE("another order is described by what moves", "[app][compare]") {
  CHECK(order_of("cab") == "a, b, c -> c, a, b");
  CHECK(order_of("abhdefgcij") == "'c' and 'h', 3 and 8 of 10, change places");
  CHECK(order_of("abdefghcij") == "'c' goes from place 3 to 8 of 10");
  CHECK(order_of("abhcdefgij") == "'h' goes from place 8 to 3 of 10");
  CHECK(order_of("hijabcdefg") == "'h' to 'j', 3 surfaces, go from place 8 to 1 of 10");
  CHECK(order_of("abefghicdj") == "'c' to 'd', 2 surfaces, go from place 3 to 8 of 10");
  CHECK(order_of("jihgfedcba") == "'a' to 'j', 1 to 10 of 10, stand the other way round");
  CHECK(order_of("bacdefghji") == "2 of 10 go elsewhere: 'a' 1 -> 2, 'i' 9 -> 10");
}

TEST_CASE("of many that go elsewhere the first ten are reported", "[app][compare]") {
  std::vector<std::string> names;
  std::vector<std::size_t> places(40);
  for (std::size_t i = 0; i < 40; ++i) {
    names.push_back("s" + std::to_string(i));
    places[i] = i * 7 % 40;
  }
  const std::string text = describe_order(names, places);
  CHECK_THAT(text, Catch::Contains(" of 40 go elsewhere: ") && Catch::EndsWith(" more"));
  CHECK(std::ranges::count(text, '>') == 10);
}
