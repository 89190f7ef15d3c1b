// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "core/definition/parameter_values.hpp"

namespace contactsim {

/// The constants of isotropic elasticity; a model that is used has exactly two of them.
struct ElasticConstants {
  std::optional<double> youngs_modulus;  ///< > 0 [force/length^2]
  std::optional<double> poissons_ratio;  ///< > -1, < 0.5 [1]
  std::optional<double> shear_modulus;   ///< > 0 [force/length^2]
  std::optional<double> bulk_modulus;    ///< > 0 [force/length^2]
  std::optional<double> lambda;          ///< Lame's first constant [force/length^2]

  int n_given() const {
    return youngs_modulus.has_value() + poissons_ratio.has_value() + shear_modulus.has_value() +
           bulk_modulus.has_value() + lambda.has_value();
  }
};

/// The lines that give them, which all models have.
const std::vector<Parameter>& elastic_parameters();

/// Those of a model. Precondition: its parameters are these and others.
ElasticConstants elastic_constants_of(const ParameterValues& values);

}  // namespace contactsim
