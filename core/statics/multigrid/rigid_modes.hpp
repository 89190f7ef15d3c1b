// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/statics/multigrid/group_columns.hpp"

namespace contactsim {

/// The displacements of nodes that move and turn as one rigid body about their centre: along x, y and z, and
/// about these axes.
///   coordinates  [3 x n_nodes]
///   returns      [3 n_nodes x 6], turns of a size that is that of a displacement of 1 at the farthest node
Modes make_rigid_modes(const Eigen::Matrix3Xd& coordinates);

}  // namespace contactsim
