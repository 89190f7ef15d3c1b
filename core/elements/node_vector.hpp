// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>

namespace contactsim {

/// A vector of a node, x y z and a number that means nothing: one load takes it, see fours.hpp.
using NodeVector = Eigen::Vector4d;

/// Position of a node in the chunk of elements that it belongs to.
using ChunkNode = std::uint16_t;

}  // namespace contactsim
