// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "core/conditions/condition_scope.hpp"
#include "core/elements/model_block.hpp"

namespace contactsim {

/// Makes the elements of the region's MASS SCALING blocks so heavy that each of them, at rest, allows the
/// target time step: a stable step grows with the root of the mass, so that the factor is (target / step)^2,
/// bounded by ALLOWABLE MASS INCREASE RATIO. It stays as it is from the start on. Inertias of shells and
/// beams grow alike. Warned of: what is added ("mass-scaled"), what stays below the target
/// ("mass-scaling-bounded"), nothing to do
/// ("mass-scaling-idle"). Source: Sierra/SM 5.22, MASS SCALING.
///   blocks  of the region's model
void scale_masses(const ConditionScope& scope, std::span<ModelBlock> blocks);

}  // namespace contactsim
