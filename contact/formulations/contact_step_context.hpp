// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact/formulations/constrained_pairs.hpp"
#include "contact/formulations/contact_multipliers.hpp"
#include "contact/formulations/held_slips.hpp"
#include "contact/formulations/penetration_depths.hpp"
#include "contact/formulations/slip_pressures.hpp"
#include "contact/interface_laws/pair_rules.hpp"
#include "contact/mesh/contact_kinematics.hpp"

namespace contactsim {

class WeightedGaps;

/// Rows of candidates that are worked on as one piece. Fixed, so that sums do not depend on the number of
/// threads.
inline constexpr std::size_t rows_per_chunk = 256;

/// How far things may move from where they are until candidates may meet that are not close now.
struct CloseRange {
  double motion = 0.0;  ///< of each contact node [length]
  double soon = 0.0;    ///< by which sides may close within the time that is looked ahead [length]
  double reach = 0.0;   ///< PairRules::largest_reach() [length]
};

/// Which candidates a narrow phase looks at: all, all to find those that are close, or these alone.
enum class CandidateUse : std::uint8_t { all, renew_close, close };

/// A step of contact: what the loops over contact points read.
struct ContactStepContext {
  const ContactKinematics& kinematics;
  const PairRules& rules;
  const ConstrainedPairs& constrained;
  double dt = 0.0;                            ///< of the step that ended, 0 at the start [time]
  double first_dt = 0.0;                      ///< of the step to come, at the start [time]
  const PenetrationDepths* depths = nullptr;  ///< of the last step; null: nothing is known of it
  /// Which pairs are looked at: those enforced by momentum balance, or by penalty. For the former the
  /// velocities are those that the coming step would have without contact.
  bool balances = false;
  double coming_dt = 0.0;  ///< the coming step, for balances [time]
  /// Of load steps, whose forces are those of one state: nothing looks ahead.
  bool is_static = false;
  bool is_trial = false;                            ///< nothing is remembered of what is found
  const ContactMultipliers* multipliers = nullptr;  ///< null without any
  const HeldSlips* held_slips = nullptr;            ///< of weighted nodes in the last step; null without any
  /// By which weighted nodes have limits of friction; null: by what presses them.
  const SlipPressures* slip_pressures = nullptr;
  const WeightedGaps* weighted_gaps = nullptr;  ///< that press faces; null: each of their points does
  CandidateUse candidates = CandidateUse::all;
  CloseRange close_range = {};  ///< for which candidates are found that are close

  /// What closes within this time counts as about to touch: the next step must be small enough for the
  /// penalty of what it brings into touch [time].
  double ahead() const {
    constexpr double steps = 2.0;
    if (is_static) return 0.0;
    return steps * (balances ? coming_dt : dt > 0.0 ? dt : first_dt);
  }
  /// Whether a pair's contact points are looked for now.
  bool enforces(const PairRule& rule) const { return rule.is_active && rule.is_balanced == balances; }
};

}  // namespace contactsim
