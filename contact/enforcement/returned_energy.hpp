// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "contact/enforcement/pair_work.hpp"

namespace contactsim {

/// What springs may give back.
struct EnergyLimits {
  /// At the end of the half step before these forces: had at the start and taken, without what is
  /// lost; < 0 given out from nowhere; NaN: no limit [energy]
  IndexedSpan<PairIndex, const double> energy;
  /// The least of it so far, <= 0: it is no debt, for paying it back would let through what presses
  /// on [energy]
  IndexedSpan<PairIndex, const double> least;
};

/// Keeps the springs of the penalty from giving back more energy than they took. Where faces slide off one
/// another, or the normal of a contact point turns, springs get longer without any work: a vertex in a fold
/// would be shot out by it. The forces of a pair whose springs hold much more than the pair has taken and not
/// lost are lowered by one factor: those that give energy back as it runs out, those that take it to what
/// springs of that energy would have. Springs that keep the energy are left alone. Points that have met in
/// the step, or will part in the next one, are spared of what they would take or give too much, so that a hit
/// leaves the pair no energy, wherever its steps fall, and of however few: three are the least that the
/// stable step leaves. Source: time-domain passivity control, Hannaford and Ryu, IEEE Trans. Robot. Autom. 18
/// (2002) 1-10; energy that contact makes: Armero and Petocz, Comput. Methods Appl. Mech. Eng. 158 (1998)
/// 269-300.
///   accelerations  [n_points] by which these forces open the points in the next step, where they alone move
///                  the sides [length/time^2]
///   points         of the step, not yet added to the work
void limit_returned_energy(const ContactKinematics& kinematics, const PairWork& work,
                           const EnergyLimits& limits, std::span<const double> accelerations,
                           std::span<ContactPoint> points);

}  // namespace contactsim
