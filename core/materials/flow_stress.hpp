// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "core/base/lanes.hpp"
#include "core/materials/state_variable.hpp"

/// Hardening of the plastic law: how large the equivalent stress may be, and what follows it. A hardening is
/// a class with
///   has_back_stress    whether the yield surface moves
///   variables          of the state, the back stress and the equivalent plastic strain
///   kinematic_modulus  growth of the back stress per plastic strain [force/length^2]
///   at                 the flow stress after a plastic increment
///   min_slope          of all slopes that `at` may give [force/length^2]
/// or, in place of the last three, overloads of return_to (plastic_return.hpp) that do not iterate.
namespace contactsim {

/// A flow stress and its slope over the plastic increment.
struct FlowStress {
  Lanes value;  ///< >= 0 [force/length^2]
  Lanes slope;  ///< [force/length^2]
};

/// The state of a hardening without a back stress.
inline constexpr std::array plastic_strain_only{StateVariable{"eqps", 0, 1, "equivalent plastic strain [1]"}};

/// The state of a hardening with one.
inline constexpr std::array plastic_strain_and_back_stress{
    StateVariable{"eqps", 6, 1, "equivalent plastic strain [1]"},
    StateVariable{"back_stress", 0, 6, "centre of the yield surface [force/length^2]"}};

}  // namespace contactsim
