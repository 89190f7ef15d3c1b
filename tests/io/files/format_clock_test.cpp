// SPDX-License-Identifier: BSD-3-Clause
#include "io/files/format_clock.hpp"

#include "support/catch.hpp"

using namespace contactsim;

TEST_CASE("a time of day has the form that is asked for", "[io][files]") {
  constexpr std::time_t noon = 1'000'000'000;  // 2001-09-09, in every time zone
  CHECK(format_clock(noon, "%Y/%m") == "2001/09");
  CHECK(format_clock(noon, "[%H:%M:%S]").size() == 10);
  CHECK(format_clock(noon, "") == "");
  CHECK(format_clock(noon, std::string(255, 'x')) == std::string(255, 'x'));
  CHECK(format_clock(noon, std::string(256, 'x')) == "");
}
