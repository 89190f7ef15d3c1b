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

double radians(double x) { return x * std::numbers::pi / 180.0; }
double degrees(double x) { return x * 180.0 / std::numbers::pi; }

double number(const ApreproValue& value) { return std::get<double>(value); }
const std::string& text(const ApreproValue& value) { return std::get<std::string>(value); }

double angle_between(double x1, double y1, double x2, double y2) {
  const double cosine = (x1 * x2 + y1 * y2) / (std::hypot(x1, y1) * std::hypot(x2, y2));
  return std::acos(std::clamp(cosine, -1.0, 1.0));
}

double round_half_away(double x) { return x < 0.0 ? -std::floor(0.5 - x) : std::floor(x + 0.5); }

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
  throw ApreproError{
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
  throw ApreproError{0, 0, fmt::format("cannot read '{}': {}", text(arguments[0]), file.problem)};
}

ApreproValue stop(Arguments arguments, ApreproState&) { throw ApreproError{0, 0, text(arguments[0])}; }

constexpr std::string_view no_arrays = "arrays are not supported";
constexpr std::string_view no_exodus = "meshes are not read while a deck is expanded";
constexpr std::string_view no_code = "text made by the deck is not run as deck";
constexpr std::string_view no_output = "the expanded deck is not written to files";
constexpr std::string_view no_clock = "the deck must mean the same tomorrow";

using F = ApreproFunction;
constexpr auto lower = &change_case<'A', 'Z', 'a' - 'A'>;
constexpr auto upper = &change_case<'a', 'z', 'A' - 'a'>;

/// Source: SEACAS Aprepro, tables of mathematical and string functions.
const std::array functions = {
    F{"DUMP", "", "", no_output, {}},
    F{"IO", "x", "n", "x truncated to an integer, as text", F::General(print_integer)},
    F{"Units", "s", "s", "units are not supported, give numbers in one consistent set", {}},
    F{"Vangle", "x1, y1, x2, y2", "nnnn", "Angle between two plane vectors in radians",
      F::OfFour(angle_between)},
    F{"Vangled", "x1, y1, x2, y2", "nnnn", "Angle between two plane vectors in degrees",
      F::OfFour([](double a, double b, double c, double d) { return degrees(angle_between(a, b, c, d)); })},
    F{"abs", "x", "n", "Absolute value", F::OfOne([](double x) { return std::abs(x); })},
    F{"acos", "x", "n", "Inverse cosine in radians", F::OfOne([](double x) { return std::acos(x); })},
    F{"acosd", "x", "n", "Inverse cosine in degrees",
      F::OfOne([](double x) { return degrees(std::acos(x)); })},
    F{"acosh", "x", "n", "Inverse hyperbolic cosine", F::OfOne([](double x) { return std::acosh(x); })},
    F{"asin", "x", "n", "Inverse sine in radians", F::OfOne([](double x) { return std::asin(x); })},
    F{"asind", "x", "n", "Inverse sine in degrees", F::OfOne([](double x) { return degrees(std::asin(x)); })},
    F{"asinh", "x", "n", "Inverse hyperbolic sine", F::OfOne([](double x) { return std::asinh(x); })},
    F{"atan", "x", "n", "Inverse tangent in radians", F::OfOne([](double x) { return std::atan(x); })},
    F{"atan2", "y, x", "nn", "Angle of the point (x, y) in radians",
      F::OfTwo([](double y, double x) { return std::atan2(y, x); })},
    F{"atan2d", "y, x", "nn", "Angle of the point (x, y) in degrees",
      F::OfTwo([](double y, double x) { return degrees(std::atan2(y, x)); })},
    F{"atand", "x", "n", "Inverse tangent in degrees",
      F::OfOne([](double x) { return degrees(std::atan(x)); })},
    F{"atanh", "x", "n", "Inverse hyperbolic tangent", F::OfOne([](double x) { return std::atanh(x); })},
    F{"cbrt", "x", "n", "Cube root", F::OfOne([](double x) { return std::cbrt(x); })},
    F{"ceil", "x", "n", "Smallest integer not below x", F::OfOne([](double x) { return std::ceil(x); })},
    F{"cols", "a", "n", no_arrays, {}},
    F{"cos", "x", "n", "Cosine of radians", F::OfOne([](double x) { return std::cos(x); })},
    F{"cosd", "x", "n", "Cosine of degrees", F::OfOne([](double x) { return std::cos(radians(x)); })},
    F{"cosh", "x", "n", "Hyperbolic cosine", F::OfOne([](double x) { return std::cosh(x); })},
    F{"csv_array", "file", "s", no_arrays, {}},
    F{"d2r", "x", "n", "Degrees to radians", F::OfOne([](double x) { return radians(x); })},
    F{"dim", "x, y", "nn", "x - min(x, y)", F::OfTwo([](double x, double y) { return x - std::min(x, y); })},
    F{"dist", "x1, y1, x2, y2", "nnnn", "Distance of two points of the plane",
      F::OfFour([](double a, double b, double c, double d) { return std::hypot(a - c, b - d); })},
    F{"erf", "x", "n", "Error function", F::OfOne([](double x) { return std::erf(x); })},
    F{"erfc", "x", "n", "1 - erf(x)", F::OfOne([](double x) { return std::erfc(x); })},
    F{"error", "text", "s", "Stops with the text as error", F::General(stop)},
    F{"execute", "text", "s", no_code, {}},
    F{"exodus_info", "file, text", "ss", no_exodus, {}},
    F{"exodus_meta", "file", "s", no_exodus, {}},
    F{"exp", "x", "n", "e to the power x", F::OfOne([](double x) { return std::exp(x); })},
    F{"expm1", "x", "n", "exp(x) - 1", F::OfOne([](double x) { return std::expm1(x); })},
    F{"extract", "s, from, to", "sss", "Part of s from the text `from` up to the text `to`",
      F::General(extract)},
    F{"file_to_string", "path", "s", "What the file holds", F::General(read_file)},
    F{"floor", "x", "n", "Largest integer not above x", F::OfOne([](double x) { return std::floor(x); })},
    F{"fmod", "x, y", "nn", "Remainder of x/y", F::OfTwo([](double x, double y) { return std::fmod(x, y); })},
    F{"format", "x, form", "ns", "x as text by a printf format, such as \"%.4e\"",
      F::General(print_with_format)},
    F{"get_date", "", "", no_clock, {}},
    F{"get_iso_date", "", "", no_clock, {}},
    F{"get_time", "", "", no_clock, {}},
    F{"get_word", "n, s, delimiters", "nss", "Word number n of s, from 1", F::General(get_word)},
    F{"getenv", "name", "s", "The environment variable, \"\" when it is not set",
      F::General(get_environment)},
    F{"hypot", "x, y", "nn", "sqrt(x^2 + y^2)",
      F::OfTwo([](double x, double y) { return std::hypot(x, y); })},
    F{"identity", "n", "n", no_arrays, {}},
    F{"import", "path", "s", "use include", {}},
    F{"int", "x", "n", "x truncated towards 0, as [x]", F::OfOne([](double x) { return std::trunc(x); })},
    F{"lgamma", "x", "n", "log(|Gamma(x)|)", F::OfOne([](double x) { return std::lgamma(x); })},
    F{"ln", "x", "n", "Natural logarithm", F::OfOne([](double x) { return std::log(x); })},
    F{"log", "x", "n", "Natural logarithm", F::OfOne([](double x) { return std::log(x); })},
    F{"log10", "x", "n", "Logarithm to base 10", F::OfOne([](double x) { return std::log10(x); })},
    F{"log1p", "x", "n", "log(1 + x)", F::OfOne([](double x) { return std::log1p(x); })},
    F{"make_array", "rows, columns", "nn", no_arrays, {}},
    F{"max", "x, y", "nn", "The larger one", F::OfTwo([](double x, double y) { return std::max(x, y); })},
    F{"min", "x, y", "nn", "The smaller one", F::OfTwo([](double x, double y) { return std::min(x, y); })},
    F{"nint", "x", "n", "Nearest integer, halves away from 0", F::OfOne(round_half_away)},
    F{"output", "path", "s", no_output, {}},
    F{"output_append", "path", "s", no_output, {}},
    F{"polarX", "r, a", "nn", "r * cosd(a)",
      F::OfTwo([](double r, double a) { return r * std::cos(radians(a)); })},
    F{"polarY", "r, a", "nn", "r * sind(a)",
      F::OfTwo([](double r, double a) { return r * std::sin(radians(a)); })},
    F{"pow", "x, y", "nn", "x to the power y, as x ^ y",
      F::OfTwo([](double x, double y) { return std::pow(x, y); })},
    F{"r2d", "x", "n", "Radians to degrees", F::OfOne([](double x) { return degrees(x); })},
    F{"rand", "low, high", "nn", "Evenly distributed number, the same on every run",
      F::General(random_between)},
    F{"rescan", "text", "s", no_code, {}},
    F{"rows", "a", "n", no_arrays, {}},
    F{"sign", "x, y", "nn", "|x| with the sign of y",
      F::OfTwo([](double x, double y) { return y >= 0.0 ? std::abs(x) : -std::abs(x); })},
    F{"sin", "x", "n", "Sine of radians", F::OfOne([](double x) { return std::sin(x); })},
    F{"sind", "x", "n", "Sine of degrees", F::OfOne([](double x) { return std::sin(radians(x)); })},
    F{"sinh", "x", "n", "Hyperbolic sine", F::OfOne([](double x) { return std::sinh(x); })},
    F{"sqrt", "x", "n", "Square root", F::OfOne([](double x) { return std::sqrt(x); })},
    F{"srand", "seed", "n", "Starts the numbers of rand() anew from a seed", F::General(seed_random)},
    F{"strtod", "s", "s", "The number that s begins with, 0 if none", F::General(to_number)},
    F{"tan", "x", "n", "Tangent of radians", F::OfOne([](double x) { return std::tan(x); })},
    F{"tand", "x", "n", "Tangent of degrees", F::OfOne([](double x) { return std::tan(radians(x)); })},
    F{"tanh", "x", "n", "Hyperbolic tangent", F::OfOne([](double x) { return std::tanh(x); })},
    F{"tgamma", "x", "n", "Gamma(x)", F::OfOne([](double x) { return std::tgamma(x); })},
    F{"to_lower", "s", "s", "s in small letters", F::General(lower)},
    F{"to_string", "x", "n", "x as {x} prints it", F::General(to_text)},
    F{"to_upper", "s", "s", "s in capitals", F::General(upper)},
    F{"tolower", "s", "s", "s in small letters", F::General(lower)},
    F{"tostring", "x", "n", "x as {x} prints it", F::General(to_text)},
    F{"toupper", "s", "s", "s in capitals", F::General(upper)},
    F{"transpose", "a", "n", no_arrays, {}},
    F{"version", "", "", "Version of this Aprepro",
      F::General([](Arguments, ApreproState&) { return ApreproValue(std::string("contactsim")); })},
    F{"word_count", "s, delimiters", "ss", "Number of words in s", F::General(count_words)},
};

}  // namespace

std::span<const ApreproFunction> aprepro_functions() { return functions; }

const ApreproFunction* find_aprepro_function(std::string_view name) {
  const auto found = std::lower_bound(functions.begin(), functions.end(), name,
                                      [](const F& row, std::string_view value) { return row.name < value; });
  return found != functions.end() && found->name == name ? &*found : nullptr;
}

}  // namespace contactsim
