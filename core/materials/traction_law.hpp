// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace contactsim {

/// The trapezoidal law of traction over separation of Tvergaard and Hutchinson, J. Mech. Phys. Solids 41
/// (1993) 1119-1135. The separation u counts by lambda = sqrt((u_n / d_n)^2 + (u_t / d_t)^2), which is 1 at
/// failure; the traction rises to its peak at lambda_1, stays until lambda_2 and falls to nothing at 1. It is
/// the derivative of a potential, so that what is dissipated per area, peak d_n (1 - lambda_1 + lambda_2) /
/// 2, does not depend on the mix of modes. Back and again it goes along a straight line to the origin.
struct TractionLaw {
  double peak = 0.0;                      ///< of the normal traction, > 0 [force/length^2]
  double lambda_1 = 0.0, lambda_2 = 0.0;  ///< 0 < lambda_1 <= lambda_2 < 1 [1]
  double normal_length = 0.0;             ///< d_n: opening at failure, > 0 [length]
  double tangential_length = 0.0;         ///< d_t: sliding at failure, > 0 [length]
  double penetration_factor = 1.0;        ///< of the undamaged stiffness, in compression, > 0 [1]

  /// Of the undamaged interface against opening [force/length^3].
  double normal_stiffness() const { return peak / (lambda_1 * normal_length); }
  double tangential_stiffness() const {
    return peak * normal_length / (lambda_1 * tangential_length * tangential_length);
  }
  /// Dissipated when it has failed [energy/length^2].
  double toughness() const { return 0.5 * peak * normal_length * (1.0 - lambda_1 + lambda_2); }
};

}  // namespace contactsim
