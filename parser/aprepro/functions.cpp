// SPDX-License-Identifier: BSD-3-Clause
#include "parser/aprepro/functions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <numbers>

namespace contactsim {

namespace {

using Arguments = ApreproFunction::Arguments;
using Numbers = std::span<const double>;

double radians(double x) { return x * std::numbers::pi / 180.0; }
double degrees(double x) { return x * 180.0 / std::numbers::pi; }

double number(const ApreproValue& value) { return std::get<double>(value); }
const std::string& text(const ApreproValue& value) { return std::get<std::string>(value); }

double angle_between(Numbers a) {
  const double cosine = (a[0] * a[2] + a[1] * a[3]) / (std::hypot(a[0], a[1]) * std::hypot(a[2], a[3]));
  return std::acos(std::clamp(cosine, -1.0, 1.0));
}

double round_half_away(Numbers a) { return a[0] < 0.0 ? -std::floor(0.5 - a[0]) : std::floor(a[0] + 0.5); }

/// Random bits to [0, 1), the same on every machine: 53 of the generator's 64 bits.
ApreproValue random_between(Arguments arguments, ApreproState& state) {
  const double share = static_cast<double>(state.random() >> 11) * 0x1p-53;
  const double low = number(arguments[0]), high = number(arguments[1]);
  return low + (high - low) * share;
}

ApreproValue seed_random(Arguments arguments, ApreproState& state) {
  const double seed = std::clamp(std::abs(number(arguments[0])), 0.0, 9e15);
  state.random.seed(static_cast<std::uint64_t>(seed));
  return 0.0;
}

template <char first, char last, int shift>
ApreproValue change_case(Arguments arguments, ApreproState&) {
  std::string changed = text(arguments[0]);
  for (char& c : changed) {
    if (c >= first && c <= last) c = static_cast<char>(c + shift);
  }
  return changed;
}

std::vector<std::string> split_words(const std::string& line, const std::string& delimiters) {
  std::vector<std::string> words;
  std::size_t begin = line.find_first_not_of(delimiters);
  while (begin != std::string::npos) {
    const std::size_t end = line.find_first_of(delimiters, begin);
    words.push_back(line.substr(begin, end - begin));
    begin = line.find_first_not_of(delimiters, end);
  }
  return words;
}

ApreproValue count_words(Arguments arguments, ApreproState&) {
  return static_cast<double>(split_words(text(arguments[0]), text(arguments[1])).size());
}

ApreproValue get_word(Arguments arguments, ApreproState&) {
  const auto words = split_words(text(arguments[1]), text(arguments[2]));
  const double n = number(arguments[0]);
  const bool exists = n >= 1.0 && n < static_cast<double>(words.size()) + 1.0;
  return exists ? words[static_cast<std::size_t>(n) - 1] : std::string();
}

ApreproValue extract(Arguments arguments, ApreproState&) {
  const std::string& from = text(arguments[0]);
  const std::size_t begin = from.find(text(arguments[1]));
  if (begin == std::string::npos) return std::string();
  const std::string& last = text(arguments[2]);
  const std::size_t end = last.empty() ? std::string::npos : from.find(last, begin);
  return from.substr(begin, end == std::string::npos ? end : end - begin);
}

ApreproValue to_number(Arguments arguments, ApreproState&) {
  const std::string& from = text(arguments[0]);
  const std::size_t begin = std::min(from.find_first_not_of(" \t\n+"), from.size());
  double value = 0.0;
  std::from_chars(from.data() + begin, from.data() + from.size(), value);
  return value;
}

ApreproValue to_text(Arguments arguments, ApreproState& state) {
  const double value = number(arguments[0]);
  return value == 0.0 ? std::string("0") : state.variables.print(value);
}

ApreproValue print_integer(Arguments arguments, ApreproState&) {
  return *format_number("%.0f", std::trunc(number(arguments[0])));
}

ApreproValue print_with_format(Arguments arguments, ApreproState&) {
  const auto printed = format_number(text(arguments[1]), number(arguments[0]));
  if (printed) return *printed;
  throw ExpressionError{
      0, 0, fmt::format("'{}' is not a format for one number, such as \"%.4e\"", text(arguments[1]))};
}

ApreproValue get_environment(Arguments arguments, ApreproState&) {
  const char* value = std::getenv(text(arguments[0]).c_str());
  return std::string(value != nullptr ? value : "");
}

ApreproValue read_file(Arguments arguments, ApreproState& state) {
  TextFile file = state.read_file(text(arguments[0]));
  constexpr std::size_t cost_of_opening = 4096;
  state.work += file.text.size() + cost_of_opening;
  if (file.failure == TextFile::Failure::none) return std::move(file.text);
  throw ExpressionError{0, 0, fmt::format("cannot read '{}': {}", text(arguments[0]), file.problem)};
}

ApreproValue stop(Arguments arguments, ApreproState&) { throw ExpressionError{0, 0, text(arguments[0])}; }

constexpr std::string_view no_arrays = "arrays are not supported";
constexpr std::string_view no_exodus = "meshes are not read while a deck is expanded";
constexpr std::string_view no_code = "text made by the deck is not run as deck";
constexpr std::string_view no_output = "the expanded deck is not written to files";
constexpr std::string_view no_clock = "the deck must mean the same tomorrow";

using F = ApreproFunction;
constexpr auto lower = &change_case<'A', 'Z', 'a' - 'A'>;
constexpr auto upper = &change_case<'a', 'z', 'A' - 'a'>;

/// Those that functions of the deck do not have, or understand differently.
/// Source: SEACAS Aprepro, tables of mathematical and string functions.
const std::array own_functions = {
    F{"DUMP", "", "", no_output, {}},
    F{"IO", "x", "n", "x truncated to an integer, as text", print_integer},
    F{"Units", "s", "s", "units are not supported, give numbers in one consistent set", {}},
    F{"Vangle", "x1, y1, x2, y2", "nnnn", "Angle between two plane vectors in radians", angle_between},
    F{"Vangled", "x1, y1, x2, y2", "nnnn", "Angle between two plane vectors in degrees",
      +[](Numbers a) { return degrees(angle_between(a)); }},
    F{"acosd", "x", "n", "Inverse cosine in degrees", +[](Numbers a) { return degrees(std::acos(a[0])); }},
    F{"asind", "x", "n", "Inverse sine in degrees", +[](Numbers a) { return degrees(std::asin(a[0])); }},
    F{"atan2d", "y, x", "nn", "Angle of the point (x, y) in degrees",
      +[](Numbers a) { return degrees(std::atan2(a[0], a[1])); }},
    F{"atand", "x", "n", "Inverse tangent in degrees", +[](Numbers a) { return degrees(std::atan(a[0])); }},
    F{"cbrt", "x", "n", "Cube root", +[](Numbers a) { return std::cbrt(a[0]); }},
    F{"cols", "a", "n", no_arrays, {}},
    F{"cosd", "x", "n", "Cosine of degrees", +[](Numbers a) { return std::cos(radians(a[0])); }},
    F{"csv_array", "file", "s", no_arrays, {}},
    F{"d2r", "x", "n", "Degrees to radians", +[](Numbers a) { return radians(a[0]); }},
    F{"dim", "x, y", "nn", "x - min(x, y)", +[](Numbers a) { return a[0] - std::min(a[0], a[1]); }},
    F{"dist", "x1, y1, x2, y2", "nnnn", "Distance of two points of the plane",
      +[](Numbers a) { return std::hypot(a[0] - a[2], a[1] - a[3]); }},
    F{"error", "text", "s", "Stops with the text as error", stop},
    F{"execute", "text", "s", no_code, {}},
    F{"exodus_info", "file, text", "ss", no_exodus, {}},
    F{"exodus_meta", "file", "s", no_exodus, {}},
    F{"expm1", "x", "n", "exp(x) - 1", +[](Numbers a) { return std::expm1(a[0]); }},
    F{"extract", "s, from, to", "sss", "Part of s from the text `from` up to the text `to`", extract},
    F{"file_to_string", "path", "s", "What the file holds", read_file},
    F{"format", "x, form", "ns", "x as text by a printf format, such as \"%.4e\"", print_with_format},
    F{"get_date", "", "", no_clock, {}},
    F{"get_iso_date", "", "", no_clock, {}},
    F{"get_time", "", "", no_clock, {}},
    F{"get_word", "n, s, delimiters", "nss", "Word number n of s, from 1", get_word},
    F{"getenv", "name", "s", "The environment variable, \"\" when it is not set", get_environment},
    F{"hypot", "x, y", "nn", "sqrt(x^2 + y^2)", +[](Numbers a) { return std::hypot(a[0], a[1]); }},
    F{"identity", "n", "n", no_arrays, {}},
    F{"import", "path", "s", "use include", {}},
    F{"int", "x", "n", "x truncated towards 0, as [x]", +[](Numbers a) { return std::trunc(a[0]); }},
    F{"lgamma", "x", "n", "log(|Gamma(x)|)", +[](Numbers a) { return std::lgamma(a[0]); }},
    F{"log1p", "x", "n", "log(1 + x)", +[](Numbers a) { return std::log1p(a[0]); }},
    F{"make_array", "rows, columns", "nn", no_arrays, {}},
    F{"max", "x, y", "nn", "The larger one", +[](Numbers a) { return std::max(a[0], a[1]); }},
    F{"min", "x, y", "nn", "The smaller one", +[](Numbers a) { return std::min(a[0], a[1]); }},
    F{"nint", "x", "n", "Nearest integer, halves away from 0", round_half_away},
    F{"output", "path", "s", no_output, {}},
    F{"output_append", "path", "s", no_output, {}},
    F{"polarX", "r, a", "nn", "r * cosd(a)", +[](Numbers a) { return a[0] * std::cos(radians(a[1])); }},
    F{"polarY", "r, a", "nn", "r * sind(a)", +[](Numbers a) { return a[0] * std::sin(radians(a[1])); }},
    F{"r2d", "x", "n", "Radians to degrees", +[](Numbers a) { return degrees(a[0]); }},
    F{"rand", "low, high", "nn", "Evenly distributed number, the same on every run", random_between},
    F{"rescan", "text", "s", no_code, {}},
    F{"rows", "a", "n", no_arrays, {}},
    F{"sign", "x, y", "nn", "|x| with the sign of y",
      +[](Numbers a) { return a[1] >= 0.0 ? std::abs(a[0]) : -std::abs(a[0]); }},
    F{"sind", "x", "n", "Sine of degrees", +[](Numbers a) { return std::sin(radians(a[0])); }},
    F{"srand", "seed", "n", "Starts the numbers of rand() anew from a seed", seed_random},
    F{"strtod", "s", "s", "The number that s begins with, 0 if none", to_number},
    F{"tand", "x", "n", "Tangent of degrees", +[](Numbers a) { return std::tan(radians(a[0])); }},
    F{"tgamma", "x", "n", "Gamma(x)", +[](Numbers a) { return std::tgamma(a[0]); }},
    F{"to_lower", "s", "s", "s in small letters", lower},
    F{"to_string", "x", "n", "x as {x} prints it", to_text},
    F{"to_upper", "s", "s", "s in capitals", upper},
    F{"tolower", "s", "s", "s in small letters", lower},
    F{"tostring", "x", "n", "x as {x} prints it", to_text},
    F{"toupper", "s", "s", "s in capitals", upper},
    F{"transpose", "a", "n", no_arrays, {}},
    F{"version", "", "", "Version of this Aprepro",
      +[](Arguments, ApreproState&) { return ApreproValue(std::string("contactsim")); }},
    F{"word_count", "s, delimiters", "ss", "Number of words in s", count_words},
};

std::vector<F> join_functions() {
  std::vector<F> joined(own_functions.begin(), own_functions.end());
  for (const ExpressionFunction& row : expression_functions()) {
    if (!has_dialect(row.dialects, ExpressionDialects::aprepro)) continue;
    joined.push_back({row.name, row.parameters, std::string_view("nnnn").substr(0, row.max_arguments),
                      row.help, row.body});
  }
  std::sort(joined.begin(), joined.end(), [](const F& a, const F& b) { return a.name < b.name; });
  return joined;
}

}  // namespace

std::span<const ApreproFunction> aprepro_functions() {
  static const std::vector<F> functions = join_functions();
  return functions;
}

const ApreproFunction* find_aprepro_function(std::string_view name) {
  const auto functions = aprepro_functions();
  const auto found = std::lower_bound(functions.begin(), functions.end(), name,
                                      [](const F& row, std::string_view value) { return row.name < value; });
  return found != functions.end() && found->name == name ? &*found : nullptr;
}

}  // namespace contactsim
