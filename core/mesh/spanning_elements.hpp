// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>

#include "core/mesh/mesh.hpp"

namespace contactsim {

/// Elements of more than half of the model's extent and more than twenty times that of most elements of their
/// block.
struct SpanningElements {
  std::size_t n = 0;
  ElementIndex first;
  double extent = 0.0;  ///< of the first: the largest difference of its nodes in one coordinate [length]
  double usual = 0.0;   ///< median of its block [length]
};

/// Those of a mesh; nothing when there are none. Time proportional to the number of elements.
std::optional<SpanningElements> find_spanning_elements(const Mesh& mesh);

}  // namespace contactsim
