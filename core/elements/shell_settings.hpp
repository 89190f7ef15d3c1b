// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace contactsim {

/// A point of integration through the thickness.
struct ShellLayer {
  double place = 0.0;   ///< from the middle, -1 at the bottom, 1 at the top, where the normal points [1]
  double weight = 1.0;  ///< share of the thickness; the weights of a shell sum to 1 [1]
};

/// What the section of a block says of its shells, beyond the thickness of each.
struct ShellSettings {
  std::vector<ShellLayer> layers;    ///< from bottom to top, at least one
  double offset = 0.0;               ///< of the middle from the nodes, along the normal, by the thickness [1]
  double membrane_hourglass = 0.05;  ///< share of the membrane stiffness, >= 0 [1]
  double bending_hourglass = 0.05;   ///< share of the bending stiffness, >= 0 [1]
  double shear_hourglass = 0.05;     ///< share of the transverse shear stiffness, >= 0 [1]
  double drilling =
      0.0;  ///< share of the shear stiffness that fibres turn about themselves against, >= 0 [1]
};

/// The rules that there are: gauss, lobatto, simpsons, trapezoid.
std::span<const std::string_view> layer_rules();

/// The layers of a rule (compared without case), from bottom to top; empty when the rule does not exist or
/// does not have so many points. The trapezoid's weights are corrected at its ends, such that bending of
/// an elastic shell is exact from three points on: with three it is Simpson's rule.
/// Source: Abramowitz and Stegun, Handbook of Mathematical Functions, 25.4; Gregory's correction.
std::vector<ShellLayer> make_layers(std::string_view rule, std::int64_t n_points);

}  // namespace contactsim
