// SPDX-License-Identifier: BSD-3-Clause
#include "core/conditions/variable_name.hpp"

#include "support/catch.hpp"

using namespace contactsim;

TEST_CASE("a variable of a deck is split at its parentheses", "[core][variable_name]") {
  const VariableName picked = split_variable("Coordinates(X)");
  CHECK(picked.name == "coordinates");
  CHECK(picked.component == "x");
  const VariableName whole = split_variable("Stress");
  CHECK(whole.name == "stress");
  CHECK(whole.component.empty());
  CHECK(split_variable("stress(").name == "stress(");
  CHECK(split_variable("stress()").name == "stress");
  CHECK(split_variable("").name.empty());
}

TEST_CASE("components are found by their letters and by their numbers from one", "[core][variable_name]") {
  CHECK(find_component("x", 3) == 0u);
  CHECK(find_component("z", 3) == 2u);
  CHECK(find_component("3", 3) == 2u);
  CHECK(find_component("xy", 6) == 3u);
  CHECK(find_component("zx", 6) == 5u);
  CHECK(find_component("6", 6) == 5u);
  CHECK(find_component("1", 1) == 0u);
}

TEST_CASE("a component that a variable lacks is not found", "[core][variable_name]") {
  CHECK_FALSE(find_component("0", 3));
  CHECK_FALSE(find_component("4", 3));
  CHECK_FALSE(find_component("xy", 3));
  CHECK_FALSE(find_component("x", 6));
  CHECK_FALSE(find_component("x", 1));
  CHECK_FALSE(find_component("", 1));  // a scalar's component has no letters
}

TEST_CASE("components have the letters by which they are found", "[core][variable_name]") {
  for (const std::size_t n : {3, 6})
    for (std::size_t i = 0; i < n; ++i) CHECK(find_component(component_letters(i, n), n) == i);
  CHECK(component_letters(0, 1).empty());
}
