// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/conditions/prescribed_motion.hpp"

namespace contactsim {

/// Makes holds whose directions are at slanted angles act together at the nodes that they share, such as the
/// edge where two planes of symmetry meet: there the later one holds what is left of its directions at right
/// angles to the earlier ones. The other conditions stay as they are.
/// Precondition: check_conflicts found nothing.
std::vector<PrescribedMotion> separate_skew_supports(std::vector<PrescribedMotion> motions);

}  // namespace contactsim
