// SPDX-License-Identifier: BSD-3-Clause
#include "core/base/saved_state.hpp"

#include <cstring>

#include "support/catch.hpp"

using namespace contactsim;

TEST_CASE("a saved array counts numbers of its type", "[core][saved_state]") {
  CHECK(size_of(SavedType::real64) == sizeof(double));
  CHECK(size_of(SavedType::real32) == sizeof(float));
  CHECK(size_of(SavedType::uint64) == sizeof(std::uint64_t));
  CHECK(size_of(SavedType::uint32) == sizeof(std::uint32_t));
  CHECK(size_of(SavedType::uint8) == sizeof(std::uint8_t));

  const std::vector<double> values{1.0, 2.0, 3.0};
  SavedState state;
  state.add_view("a/values", std::span(values));
  CHECK(state.arrays()[0].type == SavedType::real64);
  CHECK(state.arrays()[0].count() == 3);
}

TEST_CASE("a view follows the numbers, a copy keeps them", "[core][saved_state]") {
  std::vector<std::uint32_t> values{7, 8};
  SavedState state;
  state.add_view("view", std::span<const std::uint32_t>(values));
  state.add_copy("copy", std::span<const std::uint32_t>(values));
  values[1] = 9;
  const auto second = [&](std::string_view name) {
    std::uint32_t value = 0;
    std::memcpy(&value, state.find(name)->bytes.data() + sizeof(value), sizeof(value));
    return value;
  };
  CHECK(second("view") == 9);
  CHECK(second("copy") == 8);
}

TEST_CASE("a copy of a state has numbers of its own", "[core][saved_state]") {
  std::vector<float> values{1.0f, 2.0f};
  SavedState state("run.rsout.1");
  state.add_view("view", std::span<const float>(values));
  const SavedState copy = copy_of(state);
  values[0] = 3.0f;
  CHECK(copy.origin() == "run.rsout.1");
  REQUIRE(copy.arrays().size() == 1);
  CHECK(copy.arrays()[0].type == SavedType::real32);
  REQUIRE(copy.arrays()[0].count() == 2);
  float first = 0.0f;
  std::memcpy(&first, copy.find("view")->bytes.data(), sizeof(first));
  CHECK(first == 1.0f);
}

TEST_CASE("room for an array stays where it is while others are added", "[core][saved_state]") {
  SavedState state("run.rsout.1");
  const std::span<std::byte> room = state.add_room("first", SavedType::uint64, 2);
  REQUIRE(room.size() == 16);
  for (int i = 0; i < 100; ++i) state.add_room(std::to_string(i), SavedType::uint8, 1);
  CHECK(state.find("first")->bytes.data() == room.data());
  CHECK(state.origin() == "run.rsout.1");
}

TEST_CASE("arrays stand in the order in which they were added and are found by name", "[core][saved_state]") {
  SavedState state;
  state.add_room("b", SavedType::real32, 1);
  state.add_room("a", SavedType::uint8, 5);
  REQUIRE(state.arrays().size() == 2);
  CHECK(state.arrays()[0].name == "b");
  REQUIRE(state.find("a") != nullptr);
  CHECK(state.find("a")->count() == 5);
  CHECK(state.find("c") == nullptr);
}
