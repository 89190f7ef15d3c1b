// SPDX-License-Identifier: BSD-3-Clause
#include "core/definition/parameter_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace contactsim {

ParameterValues::ParameterValues(std::span<const Parameter> parameters) : parameters_(parameters) {
  for (const Parameter& one : parameters) values_.push_back(one.by_default);
}

bool ParameterValues::knows(std::string_view phrase) const {
  return std::ranges::find(parameters_, phrase, &Parameter::phrase) != parameters_.end();
}

std::size_t ParameterValues::position(std::string_view phrase) const {
  const auto found = std::ranges::find(parameters_, phrase, &Parameter::phrase);
  if (found == parameters_.end())
    throw std::logic_error(fmt::format("a law asks for a parameter '{}' that it does not have", phrase));
  return static_cast<std::size_t>(found - parameters_.begin());
}

void ParameterValues::add(std::string_view phrase, PeriodModel model) {
  ParameterValue& value = values_[position(phrase)];
  if (!std::holds_alternative<std::vector<PeriodModel>>(value)) value = std::vector<PeriodModel>{};
  std::get<std::vector<PeriodModel>>(value).push_back(std::move(model));
}

void ParameterValues::throw_without_value(std::string_view phrase) {
  throw std::logic_error(fmt::format("the parameter '{}' has no such value", phrase));
}

const std::string& ParameterValues::word(std::string_view phrase) const {
  return parameters_[position(phrase)].words.at(static_cast<std::size_t>(count(phrase)));
}

std::vector<DeckName> ParameterValues::names(ParameterKind kind) const {
  std::vector<DeckName> names;
  for (std::size_t i = 0; i < values_.size(); ++i) {
    if (const auto* name = std::get_if<DeckName>(&values_[i]); name != nullptr && parameters_[i].kind == kind)
      names.push_back(*name);
    const auto* models = std::get_if<std::vector<PeriodModel>>(&values_[i]);
    if (models == nullptr || kind != ParameterKind::friction_model) continue;
    for (const PeriodModel& one : *models) names.push_back(one.model);
  }
  return names;
}

std::vector<std::string> missing_parameters(std::span<const Parameter> parameters,
                                            const ParameterValues& values) {
  std::vector<std::string> missing;
  for (const Parameter& one : parameters) {
    if (one.is_required && !values.has(one.phrase)) missing.push_back(one.phrase);
  }
  return missing;
}

}  // namespace contactsim
