// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact/formulations/interface_constraint.hpp"
#include "core/interface_laws/interface_law.hpp"

namespace contactsim {

/// How far a tie of a weld is in its failure envelope: (N / normal)^2 + (T / tangential)^2, more than 1
/// outside; N of tension only.
double weld_envelope(const WeldLaw& weld, const InterfaceConstraint& constraint, const CornerForces& forces);

/// What a weld that fails passes on: forces on its envelope; of what is pressed together only those along
/// the surface, for the rest is contact's from now on.
CornerForces forces_at_failure(const WeldLaw& weld, const InterfaceConstraint& constraint,
                               CornerForces forces);

}  // namespace contactsim
