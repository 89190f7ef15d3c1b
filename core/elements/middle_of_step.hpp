// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/elements/solid_kernel.hpp"

namespace contactsim {

/// Uniform-gradient elements in the middle of a step; see uniform_gradient.hpp for what Geometry is.
template <class Geometry>
struct MiddleOfStep {
  static constexpr std::size_t n = Geometry::n_nodes;
  NodeVectors<n> x;               ///< coordinates [length]
  NodeVectors<n> gradient;        ///< of the volume [length^2]
  Lanes volume, per_volume;       ///< and one over it
  Lanes gradient_norm;            ///< B:B [length^4]
  Lanes largest_eigenvalue;       ///< bound for that of B B^T [length^4]
  TensorLanes velocity_gradient;  ///< [1/time]

  explicit MiddleOfStep(const SolidMotion<n>& motion) {
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t a = 0; a < n; ++a) x[i][a] = motion.x[i][a] - 0.5 * motion.dt * motion.v[i][a];
    }
    gradient = Geometry::volume_gradient(x);
    volume = dot(x[0], gradient[0]);
    per_volume = 1.0 / volume;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j)
        velocity_gradient[i][j] = dot(motion.v[i], gradient[j]) * per_volume;
    }
    const SymmetricLanes gradient_squares = squares(gradient);
    gradient_norm = trace(gradient_squares);
    largest_eigenvalue = bound_of_eigenvalues(gradient_squares);
  }

  Lanes dilatation() const {
    return velocity_gradient[0][0] + velocity_gradient[1][1] + velocity_gradient[2][2];
  }
};

}  // namespace contactsim
