// SPDX-License-Identifier: BSD-3-Clause
#include "parser/aprepro/values.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <numbers>
#include <utility>

namespace contactsim {

namespace {

constexpr const char* default_format = "%.10g";

struct Constant {
  const char* name;
  double value;
};

/// Source: SEACAS Aprepro, predefined variables.
constexpr std::array<Constant, 11> constants = {{
    {"PI", std::numbers::pi},
    {"PI_2", std::numbers::pi / 2.0},
    {"TAU", 2.0 * std::numbers::pi},
    {"SQRT2", std::numbers::sqrt2},
    {"DEG", 180.0 / std::numbers::pi},
    {"RAD", std::numbers::pi / 180.0},
    {"E", std::numbers::e},
    {"GAMMA", std::numbers::egamma},
    {"PHI", std::numbers::phi},
    {"TRUE", 1.0},
    {"FALSE", 0.0},
}};

/// Whether printf may be given the format: one conversion of a double, with a short width and precision.
bool is_safe_format(const std::string& format) {
  const std::size_t percent = format.find('%');
  if (percent == std::string::npos || format.find('%', percent + 1) != std::string::npos) return false;
  std::size_t at = format.find_first_not_of("-+ #0", percent + 1);
  const auto skip_digits = [&] {
    const std::size_t first = at;
    at = std::min(format.find_first_not_of("0123456789", at), format.size());
    return at - first <= 2;
  };
  if (at == std::string::npos || !skip_digits()) return false;
  if (at < format.size() && format[at] == '.') {
    ++at;
    if (!skip_digits()) return false;
  }
  constexpr std::size_t max_length = 256;
  return at < format.size() && std::string_view("eEfFgG").find(format[at]) != std::string_view::npos &&
         format.size() <= max_length && format.find('\0') == std::string::npos;
}

}  // namespace

std::optional<std::string> format_number(const std::string& format, double value) {
  if (!is_safe_format(format)) return std::nullopt;
  const int length = std::snprintf(nullptr, 0, format.c_str(), value);
  if (length < 0) return std::nullopt;
  std::string text(static_cast<std::size_t>(length) + 1, '\0');
  std::snprintf(text.data(), text.size(), format.c_str(), value);
  text.pop_back();
  return text;
}

ApreproVariables::ApreproVariables() {
  for (const Constant& constant : constants) variables_[constant.name].value = constant.value;
  variables_["_FORMAT"].value = default_format;
}

const ApreproValue* ApreproVariables::find(std::string_view name) {
  const auto found = variables_.find(name);
  if (found == variables_.end()) return nullptr;
  found->second.is_used = true;
  return &found->second.value;
}

ApreproVariables::Assigned ApreproVariables::assign(std::string_view name, ApreproValue value,
                                                    bool makes_immutable) {
  Variable& variable = variables_[std::string(name)];
  variable.is_used = true;
  if (variable.is_override) return Assigned::overridden;
  if (variable.is_immutable) return Assigned::immutable;
  variable.value = std::move(value);
  variable.is_immutable = makes_immutable && !name.starts_with('_');
  return Assigned::done;
}

void ApreproVariables::override_with(std::string_view name, ApreproValue value) {
  variables_[std::string(name)] = {std::move(value), true, true, false};
}

std::vector<std::string> ApreproVariables::unused_overrides() const {
  std::vector<std::string> unused;
  for (const auto& [name, variable] : variables_) {
    if (variable.is_override && !variable.is_used) unused.push_back(name);
  }
  return unused;
}

std::vector<std::string> ApreproVariables::names() const {
  std::vector<std::string> all;
  for (const auto& [name, variable] : variables_) all.push_back(name);
  return all;
}

std::string ApreproVariables::print(double value) const {
  const auto found = variables_.find("_FORMAT");
  const std::string* format = std::get_if<std::string>(&found->second.value);
  const auto text = format ? format_number(*format, value) : std::nullopt;
  return text ? *text : *format_number(default_format, value);
}

}  // namespace contactsim
