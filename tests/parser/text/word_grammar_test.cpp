// SPDX-License-Identifier: BSD-3-Clause
#include "parser/text/word_grammar.hpp"

#include <bit>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <random>
#include <string>

#include "support/catch.hpp"

using namespace contactsim;

namespace {

/// Reads characters one by one.
struct Characters {
  std::string text;
  std::size_t at = 0;

  bool skip(std::string_view set) {
    const bool fits = at < text.size() && set.find(text[at]) != std::string_view::npos;
    if (fits) ++at;
    return fits;
  }
  int digits() {
    int n = 0;
    while (skip("0123456789")) ++n;
    return n;
  }
};

/// The form character by character, the value by strtod, which rounds correctly.
std::optional<double> slow_real(const std::string& text) {
  Characters line{text};
  line.skip("+-");
  int n_digits = line.digits();
  if (line.skip(".")) n_digits += line.digits();
  if (n_digits == 0) return std::nullopt;
  const bool is_zero = text.substr(0, line.at).find_first_of("123456789") == std::string::npos;
  if (line.skip("eEdD")) {
    line.text[line.at - 1] = 'e';
    line.skip("+-");
    if (line.digits() == 0) return std::nullopt;
  }
  if (line.at != text.size()) return std::nullopt;
  const double value = std::strtod(line.text.c_str(), nullptr);
  const bool is_too_small = value == 0.0 && !is_zero;
  return std::isfinite(value) && !is_too_small ? std::optional(value) : std::nullopt;
}

std::optional<std::int64_t> slow_integer(const std::string& text) {
  Characters line{text};
  line.skip("+-");
  if (line.digits() == 0 || line.at != text.size()) return std::nullopt;
  errno = 0;
  const long long value = std::strtoll(text.c_str(), nullptr, 10);
  return errno == 0 ? std::optional<std::int64_t>(value) : std::nullopt;
}

/// Texts that are numbers or nearly so.
class RandomNumbers {
 public:
  std::string next() {
    std::string text = one_of({"", "", "-", "+"}) + digits(20);
    if (chance(2)) text += "." + digits(20);
    if (chance(2)) text += one_of({"e", "E", "d", "D"}) + one_of({"", "-", "+"}) + digits(3);
    if (chance(3)) {
      const std::string characters = "0123456789+-.eEdDx \xe9";
      const auto at = static_cast<std::size_t>(below(static_cast<int>(text.size()) + 1));
      text.insert(at, 1, characters[static_cast<std::size_t>(below(static_cast<int>(characters.size())))]);
    }
    return text;
  }

 private:
  int below(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }
  bool chance(int n) { return below(n) == 0; }
  std::string one_of(const std::vector<std::string>& texts) {
    return texts[static_cast<std::size_t>(below(static_cast<int>(texts.size())))];
  }
  std::string digits(int n_most) {
    std::string text;
    for (int n = below(n_most + 1); n > 0; --n) text += static_cast<char>('0' + below(10));
    return text;
  }

  std::mt19937 random_{20240607};
};

}  // namespace

TEST_CASE("a real number is the double nearest to what is written", "[parser][word]") {
  CHECK(find_real("1") == 1.0);
  CHECK(find_real("1.") == 1.0);
  CHECK(find_real(".9") == 0.9);
  CHECK(find_real("+2") == 2.0);
  CHECK(find_real("-50") == -50.0);
  CHECK(find_real("1.0E+06") == 1e6);
  CHECK(find_real("1.0d0") == 1.0);
  CHECK(find_real("2.5D-3") == 2.5e-3);
  CHECK(find_real("0.1234567890123456789") == 0.1234567890123456789);
  CHECK(find_real("2.2250738585072011e-308") == 2.2250738585072011e-308);
  CHECK(find_real("9007199254740993") == 9007199254740992.0);  // 2^53 + 1: ties go to even
  CHECK(std::signbit(find_real("-0.0").value()));
}

TEST_CASE("what is no finite number in its whole length is none", "[parser][word]") {
  for (const char* text :
       {"",    "+",   ".",    "e5",    "1e",     "1e+", "1d", "--1", "+-1", "1.2.3", "0x10",
        "nan", "inf", "-inf", "1e999", "1e-999", "12h", "1 ", " 1",  "1,2", "\xe9"}) {
    INFO(text);
    CHECK_FALSE(is_number(text));
  }
}

TEST_CASE("an integer has 64 bits and one sign", "[parser][word]") {
  CHECK(find_integer("42") == 42);
  CHECK(find_integer("+007") == 7);
  CHECK(find_integer("-9223372036854775808") == std::numeric_limits<std::int64_t>::min());
  CHECK(find_integer("9223372036854775807") == std::numeric_limits<std::int64_t>::max());
  for (const char* text : {"", "+", "9223372036854775808", "2.5", "1e3", "+-5", "--5", "7 "}) {
    INFO(text);
    CHECK_FALSE(find_integer(text).has_value());
  }
}

TEST_CASE("numbers are what a slow reader finds, bit by bit", "[parser][word]") {
  RandomNumbers numbers;
  int n_reals = 0, n_integers = 0, n_others = 0;
  for (int i = 0; i < 100000; ++i) {
    const std::string text = numbers.next();
    const auto real = find_real(text), slow = slow_real(text);
    const auto integer = find_integer(text);
    const bool is_same =
        real.has_value() == slow.has_value() &&
        (!real || std::bit_cast<std::uint64_t>(*real) == std::bit_cast<std::uint64_t>(*slow));
    if (!is_same || integer != slow_integer(text)) FAIL("differs: '" << text << "'");
    (integer ? n_integers : real ? n_reals : n_others) += 1;
  }
  CHECK(n_reals > 10000);
  CHECK(n_integers > 5000);
  CHECK(n_others > 10000);
}

TEST_CASE("a time of the clock may have a unit", "[parser][word]") {
  CHECK(find_wall_time("90") == 90.0);
  CHECK(find_wall_time("90S") == 90.0);
  CHECK(find_wall_time("700m") == 42000.0);
  CHECK(find_wall_time("1.5h") == 5400.0);
  CHECK(find_wall_time("1d") == 86400.0);
  CHECK(find_wall_time("1d1") == 10.0);
  CHECK(find_wall_time("1d0d") == 86400.0);
  for (const char* text : {"", "h", "1w", "1hh", "1 h"}) CHECK_FALSE(find_wall_time(text).has_value());
}

TEST_CASE("axes are letters with slashes between them", "[parser][word]") {
  using Axes = std::array<bool, 3>;
  CHECK(find_axes("x") == Axes{true, false, false});
  CHECK(find_axes("zX") == Axes{true, false, true});
  CHECK(find_axes("X/y/Z") == Axes{true, true, true});
  CHECK_FALSE(find_axes("xw").has_value());
}

TEST_CASE("a comparison is one of five", "[parser][word]") {
  CHECK(find_comparison("<") == Comparison::less);
  CHECK(find_comparison("<=") == Comparison::less_equal);
  CHECK(find_comparison("=") == Comparison::equal);
  CHECK(find_comparison("==") == Comparison::equal);
  CHECK(find_comparison(">=") == Comparison::greater_equal);
  CHECK(find_comparison(">") == Comparison::greater);
  CHECK_FALSE(find_comparison("above").has_value());
  CHECK_FALSE(find_comparison("").has_value());
}

TEST_CASE("a variable has a component and a point in parentheses", "[parser][word]") {
  struct Case {
    std::string text, name;
    std::optional<std::string_view> component, point;
  };
  const Case written = GENERATE(values<Case>({{"stress", "stress", {}, {}},
                                              {"stress(xx)", "stress", "xx", {}},
                                              {"stress(xx,1)", "stress", "xx", "1"},
                                              {"stress(:,*)", "stress", ":", "*"},
                                              {"a()", "a", "", {}},
                                              {"a(,)", "a", "", ""},
                                              {"a(b,1,2)", "a", "b", "1,2"},
                                              {"a(b(c))", "a", "b(c)", {}},
                                              {"a)", "a)", {}, {}},
                                              {"", "", {}, {}}}));
  INFO(written.text);
  const auto parts = find_variable(written.text);
  REQUIRE(parts.has_value());
  CHECK(parts->name == written.name);
  CHECK(parts->component == written.component);
  CHECK(parts->point == written.point);
}

TEST_CASE("a variable has a name, and its parentheses close the word", "[parser][word]") {
  for (const char* text : {"(xx)", "a(", "a(xx", "a(xx)b", "("}) {
    INFO(text);
    CHECK_FALSE(find_variable(text).has_value());
  }
}
