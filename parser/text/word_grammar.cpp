// SPDX-License-Identifier: BSD-3-Clause
#include "parser/text/word_grammar.hpp"

#include <boost/spirit/home/x3.hpp>
#include <charconv>
#include <string>

namespace contactsim {

namespace {

namespace x3 = boost::spirit::x3;

template <class Range>
std::string_view view_of(const Range& range) {
  return {range.begin(), range.end()};
}

/// The number that was recognised. std::from_chars rounds correctly, which x3::real_parser does not.
const auto convert = [](auto& context) {
  std::string_view number = view_of(x3::_attr(context));
  if (number.front() == '+') number.remove_prefix(1);
  double& value = x3::_val(context);
  const char* end = number.data() + number.size();
  auto result = std::from_chars(number.data(), end, value);
  if (result.ptr != end) {  // it stopped at the d of 1.0d0
    std::string plain(number);
    plain[static_cast<std::size_t>(result.ptr - number.data())] = 'e';
    result = std::from_chars(plain.data(), plain.data() + plain.size(), value);
  }
  x3::_pass(context) = result.ec == std::errc();
};

const auto keep = [](auto& context) { x3::_val(context) = x3::_attr(context); };
const auto multiply = [](auto& context) { x3::_val(context) *= x3::_attr(context); };
const auto mark = [](auto& context) { x3::_val(context)[x3::_attr(context)] = true; };

/// Sets one of the parts of a variable to the text that was recognised.
template <auto part>
struct Set {
  template <class Context>
  void operator()(Context& context) const {
    x3::_val(context).*part = view_of(x3::_attr(context));
  }
};

template <auto part>
constexpr Set<part> set{};

// Numbers. x3::digit must not see other characters than those of ASCII.
const auto digit = x3::char_('0', '9');
const auto sign = x3::lit('+') | '-';
const auto exponent = (x3::lit('e') | 'E' | 'd' | 'D') >> -sign >> +digit;
const auto magnitude = ((+digit >> -('.' >> *digit)) | ('.' >> +digit)) >> -exponent;
const auto real = x3::rule<struct RealTag, double>{"real"} = x3::raw[-sign >> magnitude][convert];
const auto integer = x3::int_parser<std::int64_t>{};

// A letter behind a number is no exponent without digits: 1d is a day.
const x3::symbols<double> seconds({{"s", 1.0}, {"m", 60.0}, {"h", 3600.0}, {"d", 86400.0}});
const auto wall_time = x3::rule<struct WallTimeTag, double>{"wall time"} =
    real[keep] >> -x3::no_case[seconds][multiply];

const x3::symbols<std::size_t> axis({{"x", 0}, {"y", 1}, {"z", 2}});
const auto axes = x3::rule<struct AxesTag, std::array<bool, 3>>{"axes"} = *(x3::no_case[axis][mark] | '/');

const x3::symbols<Comparison> comparison({{"<", Comparison::less},
                                          {"<=", Comparison::less_equal},
                                          {"=", Comparison::equal},
                                          {"==", Comparison::equal},
                                          {">=", Comparison::greater_equal},
                                          {">", Comparison::greater}});

using Parts = VariableParts;
const auto closing = ')' >> x3::eoi;
const auto name = x3::raw[+(x3::char_ - '(')];
const auto component = x3::raw[*(x3::char_ - ',' - closing)];
const auto point = x3::raw[*(x3::char_ - closing)];
const auto group = '(' >> component[set<&Parts::component>] >> -(',' >> point[set<&Parts::point>]) >> closing;
const auto variable = x3::rule<struct VariableTag, Parts>{"variable"} =
    x3::eoi | (name[set<&Parts::name>] >> -group);

/// What the rule makes of the whole text.
template <class V, class Rule>
std::optional<V> match(std::string_view text, const Rule& rule) {
  V value{};
  auto first = text.begin();
  if (!x3::parse(first, text.end(), rule, value) || first != text.end()) return std::nullopt;
  return value;
}

}  // namespace

std::optional<double> find_real(std::string_view text) { return match<double>(text, real); }

bool is_number(std::string_view text) { return find_real(text).has_value(); }

std::optional<std::int64_t> find_integer(std::string_view text) { return match<std::int64_t>(text, integer); }

std::optional<double> find_wall_time(std::string_view text) { return match<double>(text, wall_time); }

std::optional<std::array<bool, 3>> find_axes(std::string_view text) {
  return match<std::array<bool, 3>>(text, axes);
}

std::optional<Comparison> find_comparison(std::string_view text) {
  return match<Comparison>(text, comparison);
}

std::optional<VariableParts> find_variable(std::string_view text) {
  return match<VariableParts>(text, variable);
}

}  // namespace contactsim
