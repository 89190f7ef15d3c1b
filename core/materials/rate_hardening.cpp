// SPDX-License-Identifier: BSD-3-Clause
#include "core/materials/rate_hardening.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace contactsim {

template struct PlasticLaw<RateHardening>;

namespace {

/// The two parts of the flow stress that have a factor, by the first word of their lines.
constexpr std::array parts{"yield", "hardening"};

std::string line_of(const char* part, const char* what) { return fmt::format("{} rate {}", part, what); }

RateFactor::Kind kind_of(const ParameterValues& values, const char* part) {
  return static_cast<RateFactor::Kind>(values.count(line_of(part, "multiplier")));
}

RateFactor factor_of(const ParameterValues& values, const char* part) {
  RateFactor factor;
  factor.kind = kind_of(values, part);
  if (factor.kind == RateFactor::Kind::johnson_cook) {
    factor.constant = values.real(line_of(part, "constant"));
    factor.reference_rate = values.real(fmt::format("{} reference rate", part));
  } else if (factor.kind == RateFactor::Kind::power_law_breakdown) {
    factor.coefficient = values.real(line_of(part, "coefficient"));
    factor.exponent = values.real(line_of(part, "exponent"));
  }
  return factor;
}

/// The hardening of a law, whatever it is.
template <class... Hardenings>
std::optional<RateHardening::AtRest> hardening_of(const MaterialLaw& law,
                                                  std::variant<Hardenings...>* /*kinds*/) {
  std::optional<RateHardening::AtRest> found;
  const auto look = [&](const auto* plastic) {
    if (plastic != nullptr) found = plastic->hardening;
  };
  (look(law.get_if<PlasticLaw<Hardenings>>()), ...);
  return found;
}

/// Whether a hardening takes no part by a back stress, and does not fall.
struct IsGrowthIsotropic {
  bool operator()(const LinearHardening& linear) const {
    return linear.kinematic_modulus == 0.0 && linear.isotropic_modulus >= 0.0;
  }
  bool operator()(const MultilinearHardening& multilinear) const { return multilinear.beta == 1.0; }
  bool operator()(const PowerHardening&) const { return true; }
  bool operator()(const VoceHardening&) const { return true; }
};

}  // namespace

// Johnson and Cook: 1 + C ln(rate / reference), from the reference on. Power-law breakdown: 1 + asinh(p) with
// p = (rate / g)^(1/n), so that dp / d rate = p / (n rate).
RateFactor::Value RateFactor::at(const Lanes& rate) const {
  if (kind == Kind::johnson_cook) {
    const Lanes relative = rate / reference_rate;
    return {1.0 + constant * relative.max(1.0).log(), (relative > 1.0).select(constant / rate, 0.0)};
  }
  if (kind == Kind::power_law_breakdown) {
    const Lanes power = (rate / coefficient).max(0.0).pow(1.0 / exponent);
    const Lanes root = (1.0 + power * power).sqrt();
    // asinh(p) = ln(p + sqrt(1 + p^2)), whose derivative is 1 / sqrt(1 + p^2).
    return {1.0 + (power + root).log(), (rate > 0.0).select(power / (exponent * rate * root), 0.0)};
  }
  return {Lanes::Ones(), Lanes::Zero()};
}

FlowStress RateHardening::at(const Lanes& eqps, const Lanes& increment, double dt) const {
  // Within a step rate = increment / dt, so that each factor's slope over the increment is that over the rate
  // divided by dt.
  const FlowStress slow =
      std::visit([&](const auto& hardening) { return hardening.at(eqps, increment, dt); }, at_rest);
  const Lanes rate = increment / dt;
  const RateFactor::Value yield = of_yield.at(rate), growth = of_growth.at(rate);
  const Lanes grown = slow.value - yield_stress;
  return {yield_stress * yield.factor + grown * growth.factor,
          (yield_stress * yield.slope + grown * growth.slope) / dt + slow.slope * growth.factor};
}

std::vector<Parameter> rate_parameters() {
  std::vector<Parameter> lines;
  for (const char* part : parts) {
    const std::string of = part == parts[0] ? "the yield stress" : "the growth of the flow stress";
    lines.push_back(parameter::word(line_of(part, "multiplier"),
                                    {"rate_independent", "johnson_cook", "power_law_breakdown"},
                                    fmt::format("Factor of {} by the plastic strain rate", of)));
    lines.push_back(parameter::non_negative(line_of(part, "constant"),
                                            "Of johnson_cook: growth per logarithm of the rate [1]"));
    lines.push_back(parameter::positive(fmt::format("{} reference rate", part),
                                        "Of johnson_cook: below it the factor is 1 [1/time]"));
    lines.push_back(
        parameter::positive(line_of(part, "coefficient"),
                            "Of power_law_breakdown: 1 + asinh((rate / this)^(1 / exponent)) [1/time]"));
    lines.push_back(parameter::positive(line_of(part, "exponent"), "Of power_law_breakdown [1]"));
    lines.push_back(parameter::word(fmt::format("{} temperature multiplier", part),
                                    {"temperature_independent", "johnson_cook"},
                                    "Materials stay at their reference temperature, where the factor is 1"));
  }
  for (const char* of_heat : {"thermal softening model", "reference temperature", "melting temperature",
                              "temperature exponent", "beta_tq", "specific heat"})
    lines.push_back(parameter::ignored(of_heat, "materials stay at their reference temperature"));
  return lines;
}

bool has_rate_factor(const ParameterValues& values) {
  return std::ranges::any_of(
      parts, [&](const char* part) { return kind_of(values, part) != RateFactor::Kind::rate_independent; });
}

std::vector<std::string> missing_rate_parameters(const ParameterValues& values) {
  std::vector<std::string> missing;
  const auto need = [&](std::string phrase) {
    if (!values.has(phrase)) missing.push_back(std::move(phrase));
  };
  for (const char* part : parts) {
    const RateFactor::Kind kind = kind_of(values, part);
    if (kind == RateFactor::Kind::johnson_cook) {
      need(line_of(part, "constant"));
      need(fmt::format("{} reference rate", part));
    } else if (kind == RateFactor::Kind::power_law_breakdown) {
      need(line_of(part, "coefficient"));
      need(line_of(part, "exponent"));
    }
  }
  return missing;
}

void warn_of_idle_rates(const MaterialInput& input) {
  for (const char* part : parts) {
    if (kind_of(input.values, part) != RateFactor::Kind::rate_independent) continue;
    for (const std::string& phrase : {line_of(part, "constant"), fmt::format("{} reference rate", part),
                                      line_of(part, "coefficient"), line_of(part, "exponent")}) {
      if (!input.values.has(phrase)) continue;
      input.diagnostics.add_warning("rate-without-multiplier", {}, fmt::format("'{}' has no effect", phrase),
                                    fmt::format("'{}' chooses a factor", line_of(part, "multiplier")));
    }
  }
}

std::optional<MaterialLaw> make_rate_law(const MaterialInput& input, const MaterialLaw& at_rest) {
  const auto hardening = hardening_of(at_rest, static_cast<RateHardening::AtRest*>(nullptr));
  if (!hardening || !std::visit(IsGrowthIsotropic{}, *hardening))
    throw std::invalid_argument("rate multipliers go with isotropic hardening that does not fall: beta = 1");
  return PlasticLaw<RateHardening>{input.moduli(),
                                   {*hardening, input.values.real("yield stress"),
                                    factor_of(input.values, parts[0]), factor_of(input.values, parts[1])}};
}

}  // namespace contactsim
