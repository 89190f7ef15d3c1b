// SPDX-License-Identifier: BSD-3-Clause
#include "core/mesh/stored_variables.hpp"

#include "support/catch.hpp"

using namespace contactsim;

TEST_CASE("a time lies between two stored ones, or at an end", "[core][mesh]") {
  const std::vector<double> times{1.0, 2.0, 4.0};
  const auto found = [&](double time) {
    const StoredTime at = find_stored_time(times, time);
    return std::vector{static_cast<double>(at.first), static_cast<double>(at.second), at.weight};
  };
  CHECK(found(0.0) == std::vector{0.0, 0.0, 0.0});
  CHECK(found(1.0) == std::vector{0.0, 1.0, 0.0});
  CHECK(found(2.5) == std::vector{1.0, 2.0, 0.25});
  CHECK(found(4.0) == std::vector{2.0, 2.0, 0.0});
  CHECK(found(9.0) == std::vector{2.0, 2.0, 0.0});
}

TEST_CASE("a stored variable is found by its name or its components", "[core][mesh]") {
  StoredVariableKind kind;
  kind.names = {"Vel_Z", "vel_y", "vel_x", "temp", "dx", "dy", "dz", "s_xx"};
  using Positions = std::vector<std::size_t>;
  CHECK(find_stored(kind, "VEL", 3) == Positions{2, 1, 0});
  CHECK(find_stored(kind, "d", 3) == Positions{4, 5, 6});
  CHECK(find_stored(kind, "Temp", 1) == Positions{3});
  CHECK_FALSE(find_stored(kind, "vel", 1));
  CHECK_FALSE(find_stored(kind, "temp", 3));
  CHECK_FALSE(find_stored(kind, "s", 6));
}
