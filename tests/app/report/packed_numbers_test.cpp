// SPDX-License-Identifier: BSD-3-Clause
#include "app/report/packed_numbers.hpp"

#include <random>

#include "support/catch.hpp"
#include "support/unpacked_numbers.hpp"

using namespace contactsim;
using contactsim::test::unpack_numbers;

TEST_CASE("packed numbers come back, whatever the table", "[app][report]") {
  std::mt19937_64 random(7);
  const auto [n_rows, n_columns] =
      GENERATE(std::pair{1, 1}, std::pair{1, 300}, std::pair{5, 64}, std::pair{7, 3}, std::pair{0, 4});
  const bool in_time = GENERATE(false, true);
  std::vector<std::int64_t> values(static_cast<std::size_t>(n_rows * n_columns));
  for (auto& value : values) value = static_cast<std::int64_t>(random() >> 33) - (1 << 30);
  const std::string text = pack_numbers(values, static_cast<std::size_t>(n_columns), in_time);
  CHECK(text.size() % 4 == 0);
  CHECK(text.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/=") ==
        std::string::npos);
  CHECK(unpack_numbers(text, static_cast<std::size_t>(n_columns), in_time) == values);
}

TEST_CASE("what is alike in space or time packs to little", "[app][report]") {
  std::vector<std::int64_t> ramp(40'000), moving;
  for (std::size_t i = 0; i < ramp.size(); ++i) ramp[i] = static_cast<std::int64_t>(3 * i);
  CHECK(pack_numbers(ramp, ramp.size(), false).size() < 300);
  std::mt19937 random(3);
  for (std::size_t i = 0; i < 1000; ++i) moving.push_back(static_cast<std::int64_t>(random() % 1000));
  const std::size_t once = pack_numbers(moving, 1000, true).size();
  for (std::size_t i = 0; i < 9000; ++i) moving.push_back(moving[i] + 5);
  CHECK(pack_numbers(moving, 1000, true).size() < once + 200);
}

TEST_CASE("a range of numbers is cut in equal steps", "[app][report]") {
  const Quantiser scale(-1.0, 3.0, 4.0);
  CHECK(scale.step == 1.0);
  CHECK(scale.code(-1.0) == 0);
  CHECK(scale.code(0.6) == 2);
  CHECK(scale.code(3.0) == 4);
  CHECK(Quantiser(2.0, 2.0, 4.0).code(2.0) == 0);
}

TEST_CASE("a bent scale keeps small values beside great ones", "[app][report]") {
  const Quantiser scale(-1e3, 1e12, 4094.0, 1.0);
  CHECK(scale.code(-1e3) == 0);
  CHECK(scale.code(1e12) == 4094);
  for (const double value : {-900.0, -0.5, 0.0, 0.02, 7.0, 1e5, 3e11}) {
    const double shown = std::sinh(scale.first + scale.step * static_cast<double>(scale.code(value)));
    CHECK(shown == Approx(value).epsilon(0.005).margin(0.005));
  }
}
