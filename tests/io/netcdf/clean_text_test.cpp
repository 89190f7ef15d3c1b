// SPDX-License-Identifier: BSD-3-Clause
#include "io/netcdf/clean_text.hpp"

#include "support/catch.hpp"

using namespace contactsim;

TEST_CASE("stored text loses its padding and its unprintable characters", "[io][text]") {
  CHECK(clean_text("") == "");
  CHECK(clean_text("    ") == "");
  CHECK(clean_text(std::string_view("ab\0cd", 5)) == "ab");
  CHECK(clean_text("  My Block   ") == "My Block");
  CHECK(clean_text("a\tb\x01\x7f") == "a_b__");
  CHECK(clean_text("Gr\xc3\xb6\xc3\x9f"
                   "e") ==
        "Gr\xc3\xb6\xc3\x9f"
        "e");
}
