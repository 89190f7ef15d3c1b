// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

#include "core/mesh/topology.hpp"

namespace contactsim {

/// What the owner of a block can do whose elements of second order no formulation moves: which elements to
/// make in their place, and by which words of common mesh generators. "" for linear shapes.
///   block_id  of the mesh
std::string linear_advice(Shape shape, std::int64_t block_id);

}  // namespace contactsim
