// SPDX-License-Identifier: BSD-3-Clause
#include "app/compare/compare_heartbeats.hpp"

#include "core/base/errors.hpp"
#include "support/catch.hpp"

using namespace contactsim;
using Catch::Matchers::Contains;

namespace {

std::vector<std::string> texts(const std::string& first, const std::string& second,
                               Tolerance tolerance = {}) {
  std::vector<std::string> lines;
  for (const Difference& one :
       compare_heartbeats(read_heartbeat("a.csv", first), read_heartbeat("b.csv", second), tolerance))
    lines.push_back(one.text);
  return lines;
}

using Lines = std::vector<std::string>;

}  // namespace

TEST_CASE("the first time beyond the tolerance and the largest difference are reported", "[app][compare]") {
  const std::string a = "Time, f, g\n0, 0, 1\n1, 10, 1\n2, 20, 1\n3, 20, 1\n";
  const std::string b = "Time, f, g\n0, 0, 1\n1, 10.5, 1\n2, 23, 1\n3, 20, 1\n";
  CHECK(texts(a, a).empty());
  CHECK(texts(a, b) == Lines{"f: from time 1 on, 10 -> 10.5, by 0.5; at most by 3, at time 2"});
  CHECK(texts(a, b, {0.05, 0.0}) == Lines{"f: from time 2 on, 20 -> 23, by 3; at most by 3, at time 2"});
  CHECK(texts(a, b, {0.0, 3.0}).empty());
}

TEST_CASE("noise around zero is no difference beside the largest of the column", "[app][compare]") {
  CHECK(texts("Time,p\n0,1e-17\n1,5\n", "Time,p\n0,-3e-17\n1,5\n").empty());
}

TEST_CASE("columns and lines that one has alone are reported", "[app][compare]") {
  CHECK(texts("Time,f,g\n0,1,1\n", "Time,h,f\n0,1,1\n1,1,1\n") ==
        Lines{"only in the first: column g", "only in the second: column h",
              "only in the second: 1 line from time 1 on"});
  CHECK(texts("Time,f\n", "Time,f\n").empty());
}

TEST_CASE("units, comments and a second legend are no values", "[app][compare]") {
  const std::string plain = "TIME, f\n0, 1\n";
  CHECK(texts(plain, "% Sierra SPYHIS Output\nTIME, f\nTIME, f\n0, 1\n").empty());
  CHECK(texts(plain, "TIME, f\n[time], [force]\n0, 1\n").empty());
}

TEST_CASE("a number that became none is a difference, two of them are not", "[app][compare]") {
  CHECK(texts("Time,f\n0,nan\n", "Time,f\n0,nan\n").empty());
  CHECK(texts("Time,f\n0,1\n", "Time,f\n0,nan\n").size() == 1);
}

TEST_CASE("a line that was cut off is named", "[app][compare]") {
  CHECK_THROWS_WITH(read_heartbeat("a.csv", "Time, f\n0, 1\n1"), "a.csv: line 3: 1 value in place of 2");
  CHECK_THROWS_WITH(read_heartbeat("a.csv", "Time, f\n0, 1\n1, 2e"), "a.csv: line 3: '2e' is no number");
}
