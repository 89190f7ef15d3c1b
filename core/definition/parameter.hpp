// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <initializer_list>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "core/base/names.hpp"

/// Parameters of laws of materials and of interfaces. A law describes its own; whoever reads decks, checks
/// them or explains them goes by the descriptions and knows no law.
namespace contactsim {

/// What the line of a parameter holds.
enum class ParameterKind : std::uint8_t {
  real,               ///< any number
  positive,           ///< a number > 0
  non_negative,       ///< a number >= 0
  poissons_ratio,     ///< a number > -1 and < 0.5
  count,              ///< a whole number > 0
  word,               ///< one of Parameter::words
  function,           ///< the name of a function
  coordinate_system,  ///< the name of a coordinate system
  friction_model,     ///< the name of a friction model
  models_by_period,   ///< <friction model> DURING PERIODS <period> ..., on any number of lines
  ignored,            ///< anything: it cannot change the answer, `help` says why
  refused             ///< anything: it would change the answer, `help` says what to do instead
};

/// A friction model in some time stepping blocks.
struct PeriodModel {
  DeckName model;
  std::vector<DeckName> periods;
  bool operator==(const PeriodModel&) const = default;
};

/// What a parameter is: a number, a count or the position of a word, a name, models by period; or nothing.
using ParameterValue = std::variant<std::monostate, double, std::int64_t, DeckName, std::vector<PeriodModel>>;

/// A parameter of a law: the line of the deck that gives it.
struct Parameter {
  std::string phrase;  ///< keyword words in lower case: "yield stress"
  ParameterKind kind = ParameterKind::real;
  std::string help;                     ///< one line; dimensions in brackets, "Initial yield stress [1]"
  bool is_required = false;             ///< the law says nothing without it
  ParameterValue by_default = {};       ///< nothing: none
  std::string default_text = {};        ///< what stands for a default that depends on others; "": as above
  std::vector<std::string> words = {};  ///< of ParameterKind::word
  std::string spelling = {};            ///< a further phrase; "": none
  std::string stands_for = {};          ///< phrase of the parameter that it gives; "": itself
  double factor = 1.0;                  ///< that parameter over the number given [1]

  /// The same parameter, with one thing more said of it.
  Parameter required() const { return with(&Parameter::is_required, true); }
  Parameter otherwise(ParameterValue value) const { return with(&Parameter::by_default, std::move(value)); }
  Parameter or_spelled(std::string other) const { return with(&Parameter::spelling, std::move(other)); }
  /// Of a default that depends on other parameters.
  Parameter shown_as(std::string text) const { return with(&Parameter::default_text, std::move(text)); }
  /// Of a parameter that gives another one, times a factor.
  Parameter for_other(std::string other, double times) const {
    return with(&Parameter::stands_for, std::move(other)).with(&Parameter::factor, times);
  }

 private:
  template <class T>
  Parameter with(T Parameter::*member, T value) const {
    Parameter made = *this;
    made.*member = std::move(value);
    return made;
  }
};

/// How parameters are written in the description of a law: parameter::real("beta", help).otherwise(1.0).
namespace parameter {
/// Makes parameters of a kind.
template <ParameterKind kind>
inline constexpr auto make = [](std::string phrase, std::string help) {
  return Parameter{std::move(phrase), kind, std::move(help)};
};
inline constexpr auto real = make<ParameterKind::real>;
inline constexpr auto positive = make<ParameterKind::positive>;
inline constexpr auto non_negative = make<ParameterKind::non_negative>;
inline constexpr auto poissons_ratio = make<ParameterKind::poissons_ratio>;
inline constexpr auto count = make<ParameterKind::count>;
inline constexpr auto function = make<ParameterKind::function>;
inline constexpr auto coordinate_system = make<ParameterKind::coordinate_system>;
inline constexpr auto friction_model = make<ParameterKind::friction_model>;
inline constexpr auto models_by_period = make<ParameterKind::models_by_period>;
inline constexpr auto ignored = make<ParameterKind::ignored>;
inline constexpr auto refused = make<ParameterKind::refused>;
/// The first word is the default unless `has_default` is false.
inline Parameter word(std::string phrase, std::vector<std::string> words, std::string help,
                      bool has_default = true) {
  Parameter made{std::move(phrase), ParameterKind::word, std::move(help)};
  made.words = std::move(words);
  if (has_default) made.by_default = std::int64_t{0};
  return made;
}
}  // namespace parameter

/// Several lists as one, in order.
inline std::vector<Parameter> joined(std::initializer_list<std::vector<Parameter>> lists) {
  std::vector<Parameter> all;
  for (const std::vector<Parameter>& list : lists) all.insert(all.end(), list.begin(), list.end());
  return all;
}

}  // namespace contactsim
