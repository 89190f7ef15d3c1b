// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/elements/solid_kernel.hpp"

namespace contactsim {

/// Sum over the nodes of a_i b_j.
template <std::size_t n>
Lanes dot(const std::array<Lanes, n>& a, const std::array<Lanes, n>& b) {
  Lanes sum = a[0] * b[0];
  for (std::size_t k = 1; k < n; ++k) sum += a[k] * b[k];
  return sum;
}

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
    bound_eigenvalue();
  }

  Lanes dilatation() const {
    return velocity_gradient[0][0] + velocity_gradient[1][1] + velocity_gradient[2][2];
  }

 private:
  /// The largest eigenvalue of a symmetric 3 x 3 tensor lies at most sqrt(2/3) times the deviator's norm
  /// above the mean.
  void bound_eigenvalue() {
    const auto& b = gradient;
    const SymmetricLanes product{{dot(b[0], b[0]), dot(b[1], b[1]), dot(b[2], b[2]), dot(b[0], b[1]),
                                  dot(b[1], b[2]), dot(b[2], b[0])}};
    gradient_norm = trace(product);
    const SymmetricLanes spread = deviator(product);
    largest_eigenvalue = gradient_norm / 3.0 + (2.0 / 3.0 * contract(spread, spread)).sqrt();
  }
};

}  // namespace contactsim
