// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/materials/material_law.hpp"

namespace contactsim {

/// What a block's section, its material and the region say of its elements.
struct ElementProperties {
  MaterialLaw law;
  double density = 0.0;                   ///< of the undeformed material, > 0 [mass/length^3]
  double hourglass_stiffness = 0.05;      ///< >= 0 [1]
  double hourglass_viscosity = 0.0;       ///< >= 0 [1]
  double linear_bulk_viscosity = 0.06;    ///< >= 0 [1]
  double quadratic_bulk_viscosity = 1.2;  ///< >= 0 [1]
  double deviatoric_parameter = 1.0;      ///< of selective deviatoric elements, 0 to 1 [1]
};

}  // namespace contactsim
