// SPDX-License-Identifier: BSD-3-Clause
#include "contact/returned_energy.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace contactsim {

namespace {

/// As long as a pair has this share of the energy that its springs would hold they have all of their
/// force: what springs gain without work they mostly lose again without any.
constexpr double reserve = 0.3;

/// What the points of a pair hold, lose in the step, and take in its half behind them [energy].
struct PairEnergy {
  double stored = 0.0, lost = 0.0, taken = 0.0;
  bool ends = true;  ///< all points will have parted after the coming step

  /// The factor of the forces. A step ends a contact somewhere between the depth that it has and touch, which
  /// makes or destroys energy by chance: the last force gives back no more than what is left, in this half
  /// step and the next one.
  double factor(double energy, double least) const {
    if (std::isnan(energy)) return 1.0;
    if (ends && taken < 0.0) return std::clamp(energy / (-2.0 * taken), 0.0, 1.0);
    const double needed = reserve * (stored + lost - taken);
    const double available = energy - least;
    if (!(needed > available)) return 1.0;
    // Springs that give energy back would be out of it with all of their length left: their forces fall as
    // the energy does. Springs that take it have the force F of ones that hold the energy E at their
    // stiffness k, F^2 = 2 k E, so that what presses on is stopped.
    const double share = std::max(0.0, available / needed);
    return taken > 0.0 ? std::sqrt(share) : share;
  }
};

/// The share of a spring's force that one would have which has got longer in this step alone: without any
/// energy something must resist what presses on.
///   taken  by the point in half a step
double share_of_step(const ContactRecord& record, double taken) {
  const double held = -record.force * record.gap;
  return held > 0.0 ? std::clamp(2.0 * taken / held, 0.0, 1.0) : 1.0;
}

/// Whether a point will have parted after another step like the last one.
bool parts_next(const ContactRecord& record, double taken) {
  return -2.0 * taken > -record.force * record.gap;
}

void scale(double factor, ContactRecord& record) {
  record.force *= factor;
  record.tangential *= factor;
  record.dissipated *= factor;
  record.damped *= factor;
  record.beyond_spring *= factor;
}

}  // namespace

void limit_returned_energy(const MovingSurface& surface, const PairWork& work, std::span<const double> energy,
                           std::span<const double> least, std::span<ContactRecord> points) {
  std::vector<PairEnergy> pairs(energy.size());
  std::vector<double> taken(points.size(), 0.0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const ContactRecord& point = points[i];
    if (!point.touches() || std::isnan(energy[point.pair])) continue;
    taken[i] = work.work_behind(surface, point);
    PairEnergy& pair = pairs[point.pair];
    pair.stored += point.stored();
    pair.lost += point.dissipated + point.damped;
    pair.taken += taken[i];
    pair.ends = pair.ends && parts_next(point, taken[i]);
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double factor = pairs[points[i].pair].factor(energy[points[i].pair], least[points[i].pair]);
    if (factor < 1.0) scale(std::max(factor, share_of_step(points[i], taken[i])), points[i]);
  }
}

}  // namespace contactsim
