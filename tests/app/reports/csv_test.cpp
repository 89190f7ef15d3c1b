// SPDX-License-Identifier: BSD-3-Clause
#include "app/reports/csv.hpp"

#include "core/base/csv_field.hpp"
#include "support/catch.hpp"

using namespace contactsim;

namespace {

using Fields = std::vector<std::string>;

}  // namespace

TEST_CASE("fields of CSV come back as they were written", "[app][csv]") {
  const Fields fields{"plain", "a, b", "say \"x\"", "two\nlines", "", "\"", " "};
  std::string line;
  for (const std::string& field : fields) line += (line.empty() ? "" : ",") + csv_field(field);
  const auto lines = split_csv(line + "\n");
  REQUIRE(lines.size() == 1);
  // Blanks around what is not quoted do not count.
  CHECK(lines[0].fields == Fields{"plain", "a, b", "say \"x\"", "two\nlines", "", "\"", ""});
}

TEST_CASE("lines of CSV know their numbers, empty ones are left out", "[app][csv]") {
  const auto lines = split_csv("a, b\r\n\n\"x\ny\", 2 \n c d ,3");
  REQUIRE(lines.size() == 3);
  CHECK(lines[0].fields == Fields{"a", "b"});
  CHECK(lines[1].number == 3);
  CHECK(lines[1].fields == Fields{"x\ny", "2"});
  CHECK(lines[2].number == 5);
  CHECK(lines[2].fields == Fields{"c d", "3"});
  CHECK(split_csv("").empty());
}
