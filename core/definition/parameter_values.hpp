// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "core/definition/parameter.hpp"

namespace contactsim {

/// What a deck gives for the parameters of a law, with their defaults for the rest. Parameters are asked for
/// by their phrases, when a law is made; a phrase that the law does not have is an error of the program:
/// std::logic_error.
class ParameterValues {
 public:
  ParameterValues() = default;
  /// All at their defaults. The parameters must outlive this.
  explicit ParameterValues(std::span<const Parameter> parameters);

  std::span<const Parameter> parameters() const { return parameters_; }
  bool knows(std::string_view phrase) const;
  void set(std::string_view phrase, ParameterValue value) { values_[position(phrase)] = std::move(value); }
  /// Adds to models by period.
  void add(std::string_view phrase, PeriodModel model);

  const ParameterValue& at(std::string_view phrase) const { return values_[position(phrase)]; }
  bool has(std::string_view phrase) const { return !std::holds_alternative<std::monostate>(at(phrase)); }
  /// std::logic_error when there is none, as all that follow.
  double real(std::string_view phrase) const { return get<double>(phrase); }
  std::int64_t count(std::string_view phrase) const { return get<std::int64_t>(phrase); }
  const DeckName& name(std::string_view phrase) const { return get<DeckName>(phrase); }
  const std::string& word(std::string_view phrase) const;
  const std::vector<PeriodModel>& models(std::string_view phrase) const {
    return get<std::vector<PeriodModel>>(phrase);
  }
  std::optional<double> find_real(std::string_view phrase) const {
    return has(phrase) ? std::optional(real(phrase)) : std::nullopt;
  }
  std::optional<DeckName> find_name(std::string_view phrase) const {
    return has(phrase) ? std::optional(name(phrase)) : std::nullopt;
  }
  /// What parameters of a kind name; of friction models also those by period.
  std::vector<DeckName> names(ParameterKind kind) const;

  /// Of the same law with equal values; where names stand does not matter.
  bool operator==(const ParameterValues& other) const {
    return parameters_.data() == other.parameters_.data() && values_ == other.values_;
  }

 private:
  std::size_t position(std::string_view phrase) const;
  template <class T>
  const T& get(std::string_view phrase) const {
    const T* value = std::get_if<T>(&at(phrase));
    if (value == nullptr) throw_without_value(phrase);
    return *value;
  }
  [[noreturn]] static void throw_without_value(std::string_view phrase);

  std::span<const Parameter> parameters_;
  std::vector<ParameterValue> values_;  ///< [n_parameters]
};

/// Phrases of the parameters that are required and not given.
std::vector<std::string> missing_parameters(std::span<const Parameter> parameters,
                                            const ParameterValues& values);

}  // namespace contactsim
