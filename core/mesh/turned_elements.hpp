// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/mesh/mesh.hpp"

namespace contactsim {

/// The solids and shells that are sound in a mesh and would not be if its nodes stood elsewhere: solids
/// without volume, or inside out as a whole or at a corner where they were not; shells that are folded, or
/// turned over. Ascending.
///   coordinates  [3 x n_nodes] where the nodes would stand [length]
std::vector<ElementIndex> find_turned_elements(const Mesh& mesh, const Eigen::Matrix3Xd& coordinates);

}  // namespace contactsim
