// SPDX-License-Identifier: BSD-3-Clause
#include "core/interface_laws/interface_law_row.hpp"

namespace contactsim {

std::optional<LawCurve> InterfaceLawInput::curve(const std::string& prefix) const {
  return make_law_curve(values.name(prefix + " function"), scale(prefix), functions, diagnostics);
}

std::optional<Function> InterfaceLawInput::function(const std::string& prefix) const {
  return make_named_function(values.name(prefix + " function"), functions, diagnostics);
}

std::vector<Parameter> scaled_function(const std::string& prefix, const std::string& meaning,
                                       bool is_required) {
  Parameter function = parameter::function(prefix + " function", "Function " + meaning);
  function.is_required = is_required;
  return {std::move(function),
          parameter::real(prefix + " scale factor", "Multiplies the function [1]").otherwise(1.0)};
}

Parameter envelope_exponent() {
  return parameter::positive(
             "failure envelope exponent",
             "Exponent p of the failure envelope (normal part)^p + (tangential part)^p = 1 [1]")
      .otherwise(2.0);
}

std::vector<Parameter> failure_parameters() {
  return {parameter::count("failure decay cycles", "Steps [1] over which the force fades after failure")
              .otherwise(std::int64_t{1}),
          parameter::friction_model("failed model", "Friction model after failure").shown_as("frictionless")};
}

}  // namespace contactsim
