// SPDX-License-Identifier: BSD-3-Clause
#include "parser/aprepro/values.hpp"

#include <algorithm>
#include <numbers>

#include "support/catch.hpp"

using namespace contactsim;

namespace {

using Assigned = ApreproVariables::Assigned;

double number_in(ApreproVariables& variables, const std::string& name) {
  const ApreproValue* value = variables.find(name);
  REQUIRE(value != nullptr);
  return std::get<double>(*value);
}

}  // namespace

TEST_CASE("a number goes through a printf format of one conversion", "[parser][aprepro]") {
  CHECK(format_number("%.10g", 0.1) == "0.1");
  CHECK(format_number("t%05.1f s", 2.25) == "t002.2 s");
  CHECK(format_number("%+E", 1.0) == "+1.000000E+00");
  CHECK(format_number("%-8.3g|", 2.0) == "2       |");
  CHECK(format_number("%#.0f", 3.0) == "3.");
  CHECK(format_number("%G", 1e-9) == "1E-09");
  CHECK(format_number("%99.99f", 1.0)->size() == 101);
}

TEST_CASE("formats that printf would read more from, or print much by, are none", "[parser][aprepro]") {
  for (const char* format : {"", "x", "%", "%d", "%s", "%n", "%*g", "%lg", "%Lg", "%g %g", "%%", "100%%",
                             "%100g", "%.100g", "%1.", "%5", "% ", "%a", "%.-3g"}) {
    INFO(format);
    CHECK_FALSE(format_number(format, 1.0));
  }
  CHECK_FALSE(format_number(std::string("%g\0", 3), 1.0));
  CHECK(format_number(std::string(254, 'x') + "%g", 1.0));
  CHECK_FALSE(format_number(std::string(255, 'x') + "%g", 1.0));
}

TEST_CASE("variables begin with the constants of Aprepro", "[parser][aprepro]") {
  ApreproVariables variables;
  CHECK(number_in(variables, "PI") == std::numbers::pi);
  CHECK(number_in(variables, "TAU") == 2.0 * std::numbers::pi);
  CHECK(number_in(variables, "DEG") * number_in(variables, "RAD") == Approx(1.0));
  CHECK(number_in(variables, "FALSE") == 0.0);
  CHECK(variables.find("pi") == nullptr);
  CHECK(variables.find("") == nullptr);
}

TEST_CASE("a variable is what it was last set to, of any type", "[parser][aprepro]") {
  ApreproVariables variables;
  CHECK(variables.assign("x", 2.0, false) == Assigned::done);
  CHECK(number_in(variables, "x") == 2.0);
  CHECK(variables.assign("x", std::string("steel"), false) == Assigned::done);
  CHECK(std::get<std::string>(*variables.find("x")) == "steel");
  CHECK(variables.assign("PI", 3.0, false) == Assigned::done);
  CHECK(number_in(variables, "PI") == 3.0);
}

TEST_CASE("an immutable variable keeps its value, but for names that begin with _", "[parser][aprepro]") {
  ApreproVariables variables;
  CHECK(variables.assign("x", 1.0, true) == Assigned::done);
  CHECK(variables.assign("x", 2.0, false) == Assigned::immutable);
  CHECK(number_in(variables, "x") == 1.0);
  CHECK(variables.assign("_x", 1.0, true) == Assigned::done);
  CHECK(variables.assign("_x", 2.0, true) == Assigned::done);
  CHECK(number_in(variables, "_x") == 2.0);
}

TEST_CASE("what the command line sets stays, and is known to be used or not", "[parser][aprepro]") {
  ApreproVariables variables;
  variables.override_with("read", 1.0);
  variables.override_with("set", 2.0);
  variables.override_with("b", 3.0);
  variables.override_with("a", std::string("x"));
  CHECK(variables.unused_overrides() == std::vector<std::string>{"a", "b", "read", "set"});
  CHECK(number_in(variables, "read") == 1.0);
  CHECK(variables.assign("set", 9.0, false) == Assigned::overridden);
  CHECK(number_in(variables, "set") == 2.0);
  CHECK(variables.unused_overrides() == std::vector<std::string>{"a", "b"});
}

TEST_CASE("names of variables are in alphabetical order, each once", "[parser][aprepro]") {
  ApreproVariables variables;
  variables.assign("zeta", 1.0, false);
  variables.assign("zeta", 2.0, false);
  variables.assign("PJ", 1.0, false);
  const std::vector<std::string> names = variables.names();
  CHECK(std::is_sorted(names.begin(), names.end()));
  CHECK(std::count(names.begin(), names.end(), "zeta") == 1);
  CHECK(std::find(names.begin(), names.end(), "PJ") - std::find(names.begin(), names.end(), "PI_2") == 1);
}

TEST_CASE("numbers print by _FORMAT, where it holds a format", "[parser][aprepro]") {
  ApreproVariables variables;
  CHECK(variables.print(1.0 / 3.0) == "0.3333333333");
  CHECK(variables.print(-0.0) == "-0");
  CHECK(variables.print(1e20) == "1e+20");
  variables.assign("_FORMAT", std::string("%.3f"), false);
  CHECK(variables.print(1.0 / 3.0) == "0.333");
  variables.assign("_FORMAT", std::string("%s"), false);
  CHECK(variables.print(0.5) == "0.5");
  variables.assign("_FORMAT", 3.0, false);
  CHECK(variables.print(0.5) == "0.5");
}
