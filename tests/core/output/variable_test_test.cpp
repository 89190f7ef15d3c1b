// SPDX-License-Identifier: BSD-3-Clause
#include "core/output/variable_test.hpp"

#include <limits>
#include <string>

#include "support/catch.hpp"

using namespace contactsim;

TEST_CASE("a test compares a value with its own", "[core][output]") {
  struct Expected {
    Comparison comparison;
    std::string symbol;
    bool below, equal, above;
  };
  const auto [comparison, text, below, equal, above] = GENERATE(values<Expected>({
      {Comparison::less, "<", true, false, false},
      {Comparison::less_equal, "<=", true, true, false},
      {Comparison::equal, "=", false, true, false},
      {Comparison::greater_equal, ">=", false, true, true},
      {Comparison::greater, ">", false, false, true},
  }));
  const VariableTest test{{}, comparison, 2.0};
  CHECK(symbol(comparison) == text);
  CHECK(holds(test, 1.0) == below);
  CHECK(holds(test, 2.0) == equal);
  CHECK(holds(test, 3.0) == above);
  CHECK_FALSE(holds(test, std::numeric_limits<double>::quiet_NaN()));
}
