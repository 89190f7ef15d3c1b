// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "contact/mesh/pair_node_values.hpp"

namespace contactsim {

/// The slip that the tangential springs of weighted nodes hold from load step to load step: of the side whose
/// nodes they are along the other [length].
using HeldSlips = PairNodeValues<Eigen::Vector3d>;

}  // namespace contactsim
