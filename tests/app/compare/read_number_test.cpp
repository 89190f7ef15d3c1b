// SPDX-License-Identifier: BSD-3-Clause
#include "app/compare/read_number.hpp"

#include <cmath>

#include "support/catch.hpp"

using namespace contactsim;

TEST_CASE("a text is a number as a whole or not at all", "[app][compare]") {
  CHECK(read_number("-1.5e-3") == -1.5e-3);
  CHECK(read_number("+2") == 2.0);
  CHECK(std::isnan(read_number("nan").value()));
  for (const char* text : {"", "1x", "x", "1 ", "+-1", "0x"}) CHECK_FALSE(read_number(text));
  CHECK(read_integer("-12") == -12);
  CHECK_FALSE(read_integer("1.5"));
}
