// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace contactsim {

/// The value of an expression. Truth is a number, 0 or 1. Numbers are finite.
using ApreproValue = std::variant<double, std::string>;

/// A number through a printf format of one conversion (e, f, g or their capitals), such as "%.10g" or
/// "t%05.1f". Nothing when the format is of another kind, or asks for more than two digits of width or
/// precision.
std::optional<std::string> format_number(const std::string& format, double value);

/// The variables of a deck, and Aprepro's constants.
class ApreproVariables {
 public:
  ApreproVariables();

  /// The value of a name, null when it has none. Marks the name as used.
  const ApreproValue* find(std::string_view name);

  enum class Assigned { done, immutable, overridden };
  /// Sets a variable, unless it is immutable; an immutable one keeps its value. `makes_immutable` holds for
  /// names that do not begin with _.
  Assigned assign(std::string_view name, ApreproValue value, bool makes_immutable);

  /// Sets a variable for good, as the command line does.
  void override_with(std::string_view name, ApreproValue value);

  /// The names set by override_with() that were neither read nor assigned, in alphabetical order.
  std::vector<std::string> unused_overrides() const;

  /// All names with a value, in alphabetical order.
  std::vector<std::string> names() const;

  /// A number as {expr} prints it, by the format in the variable _FORMAT ("%.10g" at first, and where it
  /// holds no format).
  std::string print(double value) const;

 private:
  struct Variable {
    ApreproValue value;
    bool is_immutable = false;
    bool is_override = false;
    bool is_used = false;
  };
  std::map<std::string, Variable, std::less<>> variables_;
};

}  // namespace contactsim
