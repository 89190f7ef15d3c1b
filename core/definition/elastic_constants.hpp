// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

namespace contactsim {

/// The constants of isotropic elasticity; a model that is used has exactly two of them.
struct ElasticConstants {
  std::optional<double> youngs_modulus;  ///< > 0 [force/length^2]
  std::optional<double> poissons_ratio;  ///< > -1, < 0.5 [1]
  std::optional<double> shear_modulus;   ///< > 0 [force/length^2]
  std::optional<double> bulk_modulus;    ///< > 0 [force/length^2]
  std::optional<double> lambda;          ///< Lame's first constant [force/length^2]
};

}  // namespace contactsim
