// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/close_window.hpp"

#include <algorithm>

namespace contactsim {

namespace {

/// For how many steps close candidates are found, in ranges of motion over a face's radius: in narrower ones
/// hardly fewer are close, in wider ones most are.
constexpr double steps_wanted = 8.0, narrow_range = 0.01, wide_range = 0.1;

/// Fewer steps do not pay.
constexpr double least_steps = 3.0;

/// By which what closes may grow meanwhile.
constexpr double more_closing = 1.5;

double mean_radius(const ContactKinematics& kinematics) {
  const std::size_t n = kinematics.n_bounded();
  double sum = 0.0;
  for (std::size_t i = 0; i < n; ++i)
    sum += static_cast<double>(kinematics.bound(kinematics.bounded(i)).radius());
  return n == 0 ? 0.0 : sum / static_cast<double>(n);
}

}  // namespace

void CloseWindow::choose(ContactStepContext& context) {
  context.candidates = CandidateUse::all;
  if (!are_few_ || context.is_static || !(context.dt > 0.0)) return;
  const ContactKinematics& kinematics = context.kinematics;
  const double speed = kinematics.largest_speed(), soon = 2.0 * speed * context.ahead();
  const double reach = context.rules.largest_reach();
  if (are_known_ && kinematics.path() - path_ <= range_.motion && soon <= range_.soon &&
      reach <= range_.reach) {
    context.candidates = CandidateUse::close;
    return;
  }
  are_known_ = false;
  if (mean_radius_ == 0.0) mean_radius_ = mean_radius(kinematics);
  const double step = speed * context.dt, wide = wide_range * mean_radius_;
  if (!(least_steps * step <= wide)) return;
  range_ = {std::clamp(steps_wanted * step, narrow_range * mean_radius_, wide), more_closing * soon, reach};
  path_ = kinematics.path();
  are_known_ = true;
  context.candidates = CandidateUse::renew_close;
  context.close_range = range_;
}

bool CloseWindow::note(std::size_t n_close, std::size_t n_candidates) {
  return are_few_ = 2 * n_close <= n_candidates;
}

}  // namespace contactsim
