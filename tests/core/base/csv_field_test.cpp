// SPDX-License-Identifier: BSD-3-Clause
#include "core/base/csv_field.hpp"

#include "support/catch.hpp"

using namespace contactsim;

TEST_CASE("a field of CSV is quoted where a comma, a quote or a line end would be misread", "[core][csv]") {
  CHECK(csv_field("") == "");
  CHECK(csv_field("plain text") == "plain text");
  CHECK(csv_field("it's; a\tb") == "it's; a\tb");
  CHECK(csv_field("a, b") == "\"a, b\"");
  CHECK(csv_field("say \"x\"") == "\"say \"\"x\"\"\"");
  CHECK(csv_field("\"") == "\"\"\"\"");
  CHECK(csv_field("two\nlines") == "\"two\nlines\"");
  CHECK(csv_field("end\r") == "\"end\r\"");
}
