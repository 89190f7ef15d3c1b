// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "core/base/indices.hpp"

namespace contactsim {

/// The directions in which a fixed or prescribed node may still be pushed.
struct FreeDirections {
  NodeIndex node;
  Eigen::Matrix3d projection;  ///< on them; 0 of a node that is held along all axes [1]
};

}  // namespace contactsim
