// SPDX-License-Identifier: BSD-3-Clause
#include "core/materials/hardening_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>

#include "core/materials/linear_hardening.hpp"
#include "core/materials/multilinear_hardening.hpp"
#include "core/materials/power_hardening.hpp"
#include "core/materials/rate_hardening.hpp"
#include "core/materials/voce_hardening.hpp"

namespace contactsim {

template struct PlasticLaw<LinearHardening>;
template struct PlasticLaw<PowerHardening>;
template struct PlasticLaw<VoceHardening>;

namespace {

constexpr const char* by_choice = "decoupled_flow_stress";

/// Words of the hardenings of which something is true.
template <class IsMeant>
std::vector<std::string> words_of(const IsMeant& is_meant) {
  std::vector<std::string> words;
  for (const HardeningRow& row : hardening_rows()) {
    if (is_meant(row)) words.push_back(row.word);
  }
  return words;
}

std::vector<std::string> all_words() {
  return words_of([](const HardeningRow&) { return true; });
}

bool has_parameter(const HardeningRow& row, std::string_view phrase) {
  return std::ranges::find(row.parameters, phrase, &Parameter::phrase) != row.parameters.end();
}

/// The parameters of all hardenings, each once, with what each means by it. Which are required depends on
/// the hardening that is chosen.
std::vector<Parameter> all_hardening_parameters() {
  std::vector<Parameter> all;
  for (const HardeningRow& row : hardening_rows()) {
    for (Parameter one : row.parameters) {
      one.is_required = false;
      one.help = fmt::format("Of {}: {}", row.word, one.help);
      const auto known = std::ranges::find(all, one.phrase, &Parameter::phrase);
      if (known == all.end()) {
        all.push_back(std::move(one));
      } else {
        known->help += "; o" + one.help.substr(1);
      }
    }
  }
  return all;
}

std::vector<Parameter> j2_parameters() {
  std::vector<std::string> words = all_words();
  Parameter isotropic =
      parameter::word("isotropic hardening model", words, fmt::format("The same, of {}", by_choice), false);
  words.push_back(by_choice);
  return joined({{parameter::word("hardening model", words, "How the flow stress grows", false).required(),
                  std::move(isotropic), yield_stress()},
                 all_hardening_parameters(),
                 rate_parameters()});
}

bool is_by_choice(const ParameterValues& values) {
  return values.has("hardening model") && values.word("hardening model") == by_choice;
}

/// How the flow stress grows; null when the deck does not say so.
const HardeningRow* chosen_hardening(const ParameterValues& values) {
  const char* phrase = is_by_choice(values) ? "isotropic hardening model" : "hardening model";
  return values.has(phrase) ? &hardening_rows()[static_cast<std::size_t>(values.count(phrase))] : nullptr;
}

std::vector<std::string> missing_in_j2(const ParameterValues& values) {
  std::vector<std::string> missing = missing_rate_parameters(values);
  if (const HardeningRow* chosen = chosen_hardening(values)) {
    for (std::string& phrase : missing_parameters(chosen->parameters, values))
      missing.push_back(std::move(phrase));
  } else if (is_by_choice(values)) {
    missing.emplace_back("isotropic hardening model");
  }
  return missing;
}

std::optional<MaterialLaw> make_j2_law(const MaterialInput& input) {
  const HardeningRow& chosen = *chosen_hardening(input.values);
  if (!has_parameter(chosen, "beta") && input.values.real("beta") != 1.0) {
    const auto with_beta = words_of([](const HardeningRow& row) { return has_parameter(row, "beta"); });
    throw std::invalid_argument(
        fmt::format("beta other than 1 goes with {} hardening only", fmt::join(with_beta, " and ")));
  }
  std::optional<MaterialLaw> law = chosen.make(input);
  if (!law) return law;
  warn_of_idle_rates(input);
  if (!has_rate_factor(input.values)) return law;
  if (!is_by_choice(input.values))
    throw std::invalid_argument(fmt::format("rate multipliers go with hardening model = {}", by_choice));
  return make_rate_law(input, *law);
}

}  // namespace

std::span<const HardeningRow> hardening_rows() {
  static const std::vector<HardeningRow> rows{
      linear_hardening(),
      power_hardening(),
      voce_hardening(),
      multilinear_hardening(),
  };
  return rows;
}

MaterialRow material_of(const HardeningRow& hardening) {
  return {hardening.models,
          hardening.help,
          joined({{yield_stress()}, hardening.parameters}),
          {hardening.law},
          hardening.make};
}

MaterialRow j2_material() {
  std::vector<const LawKind*> laws;
  for (const HardeningRow& row : hardening_rows()) laws.push_back(row.law);
  laws.push_back(&law_kind<PlasticLaw<RateHardening>>);
  return {
      {"j2_plasticity"}, fmt::format("Plasticity with hardening by choice: {}", fmt::join(all_words(), ", ")),
      j2_parameters(),   std::move(laws),
      make_j2_law,       ElasticNeed::two,
      missing_in_j2};
}

}  // namespace contactsim
