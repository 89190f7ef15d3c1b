// SPDX-License-Identifier: BSD-3-Clause
#include "campaigns/decks/definition_harm.hpp"

#include <cmath>
#include <optional>
#include <variant>

#include "core/base/diagnostics.hpp"
#include "core/functions/function.hpp"

namespace contactsim::test {

namespace {

std::string find_in(const TimeControl& control) {
  if (!std::isfinite(control.termination_time)) return "the termination time is no number";
  double last = -HUGE_VAL;
  for (const TimeSteppingBlock& period : control.time_stepping_blocks) {
    if (!(period.start_time > last)) return "start times do not rise";
    last = period.start_time;
    for (const ExplicitTimeParameters& given : period.explicit_parameters) {
      if (!(given.time_step_scale_factor > 0.0) || !(given.time_step_increase_factor > 0.0))
        return "a factor of the time step is not positive";
      if (given.step_interval < 1) return "the step interval is not positive";
    }
    for (const ImplicitTimeParameters& given : period.implicit_parameters) {
      if (given.time_increment && !(*given.time_increment > 0.0)) return "a time increment is not positive";
      if (given.n_time_steps && *given.n_time_steps < 1) return "a number of time steps is not positive";
    }
  }
  return std::isfinite(last) || control.time_stepping_blocks.empty() ? "" : "a start time is no number";
}

std::string find_in(const MaterialDefinition& material) {
  if (!(material.density > 0.0) && !std::isnan(material.density)) return "a density is not positive";
  for (const MaterialModel& model : material.models) {
    for (const Parameter& parameter : model.values.parameters()) {
      const double* value = std::get_if<double>(&model.values.at(parameter.phrase));
      if (value != nullptr && !std::isfinite(*value)) return "a material parameter is no number";
    }
  }
  return "";
}

std::string find_in(const FunctionDefinition& definition) {
  for (const FunctionValue& value : definition.values) {
    if (std::isinf(value.abscissa) || std::isinf(value.ordinate)) return "a point of a function is infinite";
  }
  Diagnostics diagnostics;
  const std::optional<Function> made = make_function(definition, diagnostics);
  if (!made) return diagnostics.has_errors() ? "" : "a function is not made, and no error says why";
  if (diagnostics.has_errors()) return "a function is made in spite of an error";
  if (made->inputs().empty()) {
    for (const double x : {0.0, 1.0, -1.0, 1e308}) static_cast<void>(made->evaluate(x));
  }
  return "";
}

}  // namespace

std::string find_definition_harm(const SimulationDefinition& definition) {
  for (const Procedure& procedure : definition.procedures) {
    if (!procedure.time_control) continue;
    if (std::string harm = find_in(*procedure.time_control); !harm.empty()) return harm;
  }
  for (const MaterialDefinition& material : definition.materials) {
    if (std::string harm = find_in(material); !harm.empty()) return harm;
  }
  for (const FunctionDefinition& function : definition.functions) {
    if (std::string harm = find_in(function); !harm.empty()) return harm;
  }
  return "";
}

}  // namespace contactsim::test
