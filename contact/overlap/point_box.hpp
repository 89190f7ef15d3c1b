// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <limits>

#include "contact/search/box_tree.hpp"

namespace contactsim {

/// The box of no points.
inline Box empty_box() {
  constexpr double far = std::numeric_limits<double>::infinity();
  return {{far, far, far}, {-far, -far, -far}};
}

/// Widens a box to hold a point.
inline void add_point(const Eigen::Vector3d& x, Box& box) {
  for (std::size_t k = 0; k < 3; ++k) {
    box.lo[k] = std::min(box.lo[k], x[static_cast<Eigen::Index>(k)]);
    box.hi[k] = std::max(box.hi[k], x[static_cast<Eigen::Index>(k)]);
  }
}

/// Widens a box to hold another one.
inline void add_box(const Box& other, Box& box) {
  for (std::size_t k = 0; k < 3; ++k) {
    box.lo[k] = std::min(box.lo[k], other.lo[k]);
    box.hi[k] = std::max(box.hi[k], other.hi[k]);
  }
}

}  // namespace contactsim
