// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "core/mesh/topology.hpp"

namespace contactsim {

/// A family of Abaqus' element types that are one shape to us.
struct InpType {
  std::string_view begins_with;  ///< of the type's name, upper case: "C3D8" stands for C3D8R, C3D8I, ...
  int n_nodes, dimension;
  Shape shape;
};

/// The family of a type, null when it is not read.
const InpType* find_inp_type(std::string_view type);

/// The corners of the faces of a solid as Abaqus numbers them, S1 first; positions in the connectivity, from
/// 0. Empty for what has no faces.
std::span<const std::vector<int>> inp_faces(Shape shape);

}  // namespace contactsim
