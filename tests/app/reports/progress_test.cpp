// SPDX-License-Identifier: BSD-3-Clause
#include "app/reports/progress.hpp"

#include "support/catch.hpp"

using contactsim::progress_line;

TEST_CASE("the progress line says how much is done and how long the rest takes", "[app][progress]") {
  CHECK(progress_line(0.0, 0.0) == "   0 % [..............................] ");
  CHECK(progress_line(0.5, 90.0) == "  50 % [###############...............] 1:30 left");
  CHECK(progress_line(1.02, 10.0) == " 100 % [##############################] 0:00 left");
  CHECK(progress_line(0.01, 100.0) == "   1 % [..............................] 2:45:00 left");
}
