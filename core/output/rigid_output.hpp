// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/output/output_variables.hpp"

namespace contactsim {

/// The global variables of the rigid bodies of a model, each a number: displx_<body>, velx_, ax_ of the
/// centre; rotdx_, rotvx_, rotax_ of the rotation; reactx_ and rreactx_ of what holds or drives it; fextx_
/// and mextx_ of the forces on its nodes; the same along y and z; qvec1_ to qvec4_, the quaternion of its
/// orientation, scalar first. Source: Sierra/SM, rigid body output.
std::vector<OutputVariable> rigid_variables(const Model& model);

}  // namespace contactsim
