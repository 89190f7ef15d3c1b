// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/elements/solid/base_vectors.hpp"

namespace contactsim {

/// An amount of each hourglass mode, [component][mode].
template <class Geometry>
using ModeVectors = std::array<std::array<Lanes, Geometry::n_modes>, 3>;

/// Hourglass modes summed with vectors at the nodes.
template <class Geometry>
ModeVectors<Geometry> mode_sums(const BaseVectors<Geometry>& sums) {
  return {Geometry::mode_sums(sums[0]), Geometry::mode_sums(sums[1]), Geometry::mode_sums(sums[2])};
}

/// Uniform-gradient elements in the middle of a step.
template <class Geometry>
struct MidpointKinematics {
  static constexpr std::size_t n = Geometry::n_base;
  NodeVectors<n> x;                            ///< base sums of the coordinates [length]
  NodeVectors<Geometry::n_gradient> gradient;  ///< of the volume, by them [length^2]
  Lanes volume, per_volume;                    ///< and one over it
  Lanes gradient_norm;                         ///< B:B [length^4]
  Lanes largest_eigenvalue;                    ///< bound for that of B B^T [length^4]
  TensorLanes velocity_gradient;               ///< [1/time]
  ModeVectors<Geometry> x_modes;               ///< the modes summed with the coordinates [length]
  Lanes mode_bound;  ///< of the squares of hourglass_rates, summed, over those of the velocities [1]

  explicit MidpointKinematics(const SolidMotion<n>& motion) {
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t a = 0; a < n; ++a) x[i][a] = motion.x[i][a] - 0.5 * motion.dt * motion.v[i][a];
    }
    gradient = Geometry::volume_gradient(x);
    volume = dot(gradient[0], x[0]);
    per_volume = 1.0 / volume;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j)
        velocity_gradient[i][j] = dot(gradient[j], motion.v[i]) * per_volume;
    }
    SymmetricLanes gradient_squares = squares(gradient);
    for (Lanes& square : gradient_squares.components) square *= Geometry::base_norm;
    gradient_norm = trace(gradient_squares);
    largest_eigenvalue = bound_of_eigenvalues(gradient_squares);
    x_modes = mode_sums<Geometry>(x);
    bound_modes(gradient_squares);
  }

  Lanes dilatation() const {
    return velocity_gradient[0][0] + velocity_gradient[1][1] + velocity_gradient[2][2];
  }

 private:
  /// The modes are orthogonal and give 1. What is taken off them for the linear motion adds, by the
  /// triangle inequality, at most the norm of B^T x_modes / (V mode_norm) to the root: nothing for
  /// parallelepipeds.
  ///   gradient_squares  B B^T [length^4]
  void bound_modes(const SymmetricLanes& gradient_squares) {
    if constexpr (Geometry::n_modes == 0) {
      mode_bound.setZero();
    } else {
      const Lanes linear = contract(gradient_squares, squares(x_modes)).max(0.0).sqrt();
      const Lanes root = 1.0 + linear * per_volume * (1.0 / Geometry::mode_norm);
      mode_bound = root * root;
    }
  }
};

}  // namespace contactsim
