// SPDX-License-Identifier: BSD-3-Clause
#include "app/report/element_life.hpp"

#include <cmath>

#include "support/catch.hpp"
#include "support/mesh_builder.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// death_status of a bar of three cubes, a row for each stored time.
struct BarLife {
  explicit BarLife(const std::vector<std::vector<double>>& status, const std::string& name = "death_status") {
    for (std::size_t i = 0; i < status.size(); ++i) stored.times.push_back(static_cast<double>(i));
    stored.element.names = {"other", name};
    stored.element.read = [status](std::size_t variable, std::size_t time) {
      return variable == 1 ? status.at(time) : std::vector<double>(3, 0.0);
    };
    life = find_element_life(stored, mesh, {});
  }
  Mesh mesh = MeshBuilder().add_hexes({.id = 1, .cells = {3, 1, 1}}).build();
  StoredVariables stored;
  ElementLife life;
};

using Times = std::vector<std::uint32_t>;

constexpr double not_known = std::numeric_limits<double>::quiet_NaN();

}  // namespace

TEST_CASE("an element is dead from the first stored time at which its status is 0", "[app][report]") {
  const BarLife bar({{1, 1, 1}, {1, 0.5, 1}, {1, 0, 1}, {0, 0, 1}});
  CHECK(bar.life.dead_from == Times{3, 2, 4});
}

TEST_CASE("the dead stay dead, whatever is stored of them", "[app][report]") {
  CHECK(BarLife({{1, 1, 1}, {1, -1, 1}, {1, 1, 1}}).life.dead_from == Times{3, 1, 3});
}

TEST_CASE("faces that deaths expose are known with their time, each once", "[app][report]") {
  const BarLife bar({{1, 1, 1}, {1, 0, 1}, {0, 0, 1}});
  REQUIRE(bar.life.exposed.size() == 2);
  const auto& [first, first_time] = *bar.life.exposed.begin();
  CHECK(first == ElementSide({0}, 2));  // towards x
  CHECK(first_time == 1);
  const auto& [second, second_time] = *bar.life.exposed.rbegin();
  CHECK(second == ElementSide({2}, 4));
  CHECK(second_time == 1);
}

TEST_CASE("who is dead from the start exposes faces from then on", "[app][report]") {
  const BarLife bar({{0, 1, 1}});
  CHECK(bar.life.dead_from == Times{0, 1, 1});
  REQUIRE(bar.life.exposed.size() == 1);
  CHECK(bar.life.exposed.begin()->first == ElementSide({1}, 4));
  CHECK(bar.life.exposed.begin()->second == 0);
}

TEST_CASE("where no element dies, or nothing tells, there is nothing to know", "[app][report]") {
  CHECK(BarLife({{1, 1, 1}, {1, 0.1, 1}}).life.dead_from.empty());
  CHECK(BarLife({{not_known, 1, 1}}).life.dead_from.empty());
  CHECK(BarLife({}).life.dead_from.empty());
  CHECK(BarLife({{0, 0, 0}}, "status").life.dead_from.empty());
}
