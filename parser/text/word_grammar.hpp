// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "core/definition/death.hpp"

/// What may stand in one word of a command, as rules over its characters. Each function takes the whole text
/// or nothing; letters may be small or large.
namespace contactsim {

/// A finite number as decks write it (1, 1., .9, -50, +2, 1e-4, 1.0d0): the double nearest to it.
///   real     = [ sign ] ( digits [ "." [ digits ] ] | "." digits ) [ exponent ]
///   exponent = ( "e" | "d" ) [ sign ] digits
///   sign     = "+" | "-"
std::optional<double> find_real(std::string_view text);

/// Whether the text is such a number.
bool is_number(std::string_view text);

/// A whole number of 64 bits.
///   integer = [ sign ] digits
std::optional<std::int64_t> find_integer(std::string_view text);

/// A time of the clock in seconds: 90, 90s, 700m, 12h, 1d.
///   wall_time = real [ "s" | "m" | "h" | "d" ]
std::optional<double> find_wall_time(std::string_view text);

/// Which of the axes X, Y, Z the letters name: "xz", "x/y/z".
///   axes = { "x" | "y" | "z" | "/" }
std::optional<std::array<bool, 3>> find_axes(std::string_view text);

///   comparison = "<" | "<=" | "=" | "==" | ">=" | ">"
std::optional<Comparison> find_comparison(std::string_view text);

/// "stress(xx,1)" taken apart; the parts are views of the text.
struct VariableParts {
  std::string_view name;                      ///< before the parentheses
  std::optional<std::string_view> component;  ///< the first in parentheses, may be empty
  std::optional<std::string_view> point;      ///< what follows the first comma there
};

///   variable = name [ "(" component [ "," point ] ")" ]       the last ")" of the word closes
std::optional<VariableParts> find_variable(std::string_view text);

}  // namespace contactsim
