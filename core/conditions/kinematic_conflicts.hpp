// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "core/base/diagnostics.hpp"
#include "core/conditions/prescribed_motion.hpp"

namespace contactsim {

/// Reports every two conditions that drive one node at one time in directions that are not at right angles,
/// at the later of them, with the first such node. Two that hold a node do not disturb each other.
///   name_of  a node, or what the nodes of the motions stand for, as messages call it
void check_conflicts(std::span<const PrescribedMotion> motions,
                     const std::function<std::string(NodeIndex)>& name_of, Diagnostics& diagnostics);

/// The nodes of both, ascending.
std::vector<NodeIndex> shared_nodes(const PrescribedMotion& a, const PrescribedMotion& b);

/// Whether some unit vectors of the two are neither parallel nor at right angles. Precondition: no axis.
bool are_oblique(const PrescribedMotion& a, const PrescribedMotion& b);

}  // namespace contactsim
