// SPDX-License-Identifier: BSD-3-Clause
#include "core/conditions/active_times.hpp"

#include "support/catch.hpp"

using namespace contactsim;

namespace {

std::vector<TimeSteppingBlock> periods() {
  std::vector<TimeSteppingBlock> blocks(3);
  const char* names[] = {"p1", "p2", "p3"};
  for (std::size_t i = 0; i < 3; ++i) {
    blocks[i].name.text = names[i];
    blocks[i].start_time = static_cast<double>(i);
  }
  return blocks;
}

/// At which of the times -1 0 0.5 1 1.5 2 9 the periods are active, as a row of 0 and 1.
std::string pattern(const std::vector<DeckName>& active, const std::vector<DeckName>& inactive) {
  const ActiveTimes times = make_active_times({active, inactive}, periods());
  std::string text;
  for (const double time : {-1.0, 0.0, 0.5, 1.0, 1.5, 2.0, 9.0}) text += times.is_active(time) ? '1' : '0';
  return text;
}

}  // namespace

TEST_CASE("a condition acts from the start of its periods to the start of the next", "[core][conditions]") {
  CHECK(pattern({}, {}) == "1111111");
  CHECK(pattern({{"P1", {}}}, {}) == "1110000");
  CHECK(pattern({{"p2", {}}}, {}) == "0001100");
  CHECK(pattern({{"p3", {}}, {"p1", {}}}, {}) == "1110011");
  CHECK(pattern({}, {{"p2", {}}}) == "1110011");
  CHECK(pattern({{"p1", {}}, {"p2", {}}}, {{"p1", {}}}) == "0001100");
  CHECK(pattern({{"elsewhere", {}}}, {}) == "0000000");
}

TEST_CASE("two times overlap when they share a moment, not at a mere end", "[core][conditions]") {
  const auto of = [](const char* name) { return make_active_times({{{name, {}}}, {}}, periods()); };
  CHECK(ActiveTimes().overlaps(of("p2")));
  CHECK(of("p2").overlaps(ActiveTimes()));
  CHECK_FALSE(of("p1").overlaps(of("p2")));
  CHECK_FALSE(of("p1").overlaps(of("p3")));
  const ActiveTimes first_two = make_active_times({{}, {{"p3", {}}}}, periods());
  CHECK(first_two.intervals().size() == 1);
  CHECK(first_two.overlaps(of("p2")));
  CHECK_FALSE(first_two.overlaps(of("p3")));
}
