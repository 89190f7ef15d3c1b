// SPDX-License-Identifier: BSD-3-Clause
#include "app/compare/comparison.hpp"

#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>

#include "support/catch.hpp"

using namespace contactsim;

TEST_CASE("a tolerance is relative to a scale, and absolute beside it", "[app][compare]") {
  const Tolerance tolerance{0.1, 0.5};
  CHECK_FALSE(tolerance.is_exceeded(10.0, 11.5, 10.0));
  CHECK(tolerance.is_exceeded(10.0, 11.6, 10.0));
  CHECK_FALSE(Tolerance{0.0, 0.0}.is_exceeded(1.0, 1.0));
  CHECK(Tolerance{0.0, 0.0}.is_exceeded(1.0, 1.0 + 1e-15));
}

TEST_CASE("what is not a number differs from what is one", "[app][compare]") {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  CHECK(Tolerance{}.is_exceeded(nan, 1.0));
  CHECK_FALSE(Tolerance{}.is_exceeded(nan, nan));
  CHECK(Tolerance{}.is_exceeded(infinity, 1.0));
  CHECK_FALSE(Tolerance{}.is_exceeded(infinity, infinity));
}

TEST_CASE("no line of a comparison is longer than 120 columns and no word is lost", "[app][compare]") {
  FileComparison comparison{"ownership", std::string(90, 'p'), "b", {}};
  std::string words;
  for (int i = 0; i < 60; ++i) words += "word" + std::to_string(i) + " ";
  comparison.differences.push_back({"moved", words + "end", {}});
  std::istringstream lines(format_comparison(comparison));
  std::string joined;
  for (std::string line; std::getline(lines, line);) {
    CHECK(line.size() <= 120);
    joined += line;
  }
  CHECK(joined.find("word59") != std::string::npos);
  CHECK(joined.find("end") != std::string::npos);
}

TEST_CASE("a comparison as JSON has its fields, and null for what is not finite", "[app][compare]") {
  FileComparison comparison{"summary", "a", "b", {}};
  CHECK(nlohmann::json::parse(format_comparison_json(comparison))["same"] == true);
  comparison.differences.push_back(
      {"value", "", {{"name", "x"}, {"first", 1.5}, {"second", std::numeric_limits<double>::infinity()}}});
  const auto json = nlohmann::json::parse(format_comparison_json(comparison));
  CHECK(json["same"] == false);
  CHECK(json["differences"][0]["kind"] == "value");
  CHECK(json["differences"][0]["first"] == 1.5);
  CHECK(json["differences"][0]["second"].is_null());
}
