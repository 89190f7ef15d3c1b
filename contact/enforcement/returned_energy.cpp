// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/returned_energy.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace contactsim {

namespace {

/// As long as a pair has this share of the energy that its springs would hold they have all of their
/// force: what springs gain without work they mostly lose again without any.
constexpr double reserve = 0.3;

/// The share of a spring's force that one would have which has got longer in this step alone: without any
/// energy something must resist what presses on.
///   taken  by the point in half a step
double share_of_step(const ContactPoint& contact_point, double taken) {
  const double held = -contact_point.force * contact_point.gap;
  return held > 0.0 ? std::clamp(2.0 * taken / held, 0.0, 1.0) : 1.0;
}

/// A point without its friction.
ContactPoint without_friction(ContactPoint contact_point) {
  contact_point.tangential.setZero();
  return contact_point;
}

/// What a point takes from the bodies in the half step behind it.
struct PointWork {
  double taken = 0.0;   ///< [energy]
  double normal = 0.0;  ///< the same by its force along the normal alone [energy]
  /// What it takes too much in this half step and the next one, having met the other side in the step, or
  /// gives too much, because it will part in one like it: its force F = k d works along a step's way w and
  /// not along the depth d < w alone that it is in touch, F w > k d^2 / 2 + F w / 2. Where the first and the
  /// last step of a hit fall is chance; what pulls as well neither meets nor parts [energy].
  double excess = 0.0;
  double way = 0.0, depth = 0.0;  ///< in the step, of the spring [length]
  double growth = 0.0;            ///< of the way in the next step, by these forces [length]

  PointWork() = default;
  ///   acceleration  by which these forces open the point [length/time^2]
  PointWork(const ContactKinematics& kinematics, const PairWork& work, const ContactPoint& contact_point,
            double acceleration)
      : taken(work.work_behind(kinematics, contact_point)),
        normal(contact_point.tangential.isZero(0.0)
                   ? taken
                   : work.work_behind(kinematics, without_friction(contact_point))) {
    if (contact_point.pulls || !(contact_point.force > 0.0)) return;
    way = 2.0 * std::abs(normal) / contact_point.force;
    depth = -contact_point.gap;
    growth = std::max(0.0, acceleration) * work.step() * work.step();
    const double of_growth = meets() ? 0.0 : 0.5 * contact_point.force * growth;
    excess = std::max(0.0, std::abs(normal) + of_growth + 0.5 * contact_point.force * contact_point.gap);
  }

  bool meets() const { return normal > 0.0; }
  /// The factor of the force with which the work has a share of its excess less.
  double factor(double spared) const {
    if (!(excess > 0.0)) return 1.0;
    if (growth == 0.0) return 1.0 - spared * excess / (2.0 * std::abs(normal));
    return 1.0 - spared * (1.0 - exact_factor());
  }

 private:
  /// The factor f with which nothing is left of the excess. A force changes the way w of the next step by
  /// the growth a = F dt^2 / m, and the trapezoids of the steps within the hit know nothing of f: f solves
  ///   f w - (1 - f) (w - f a) = d where sides meet,  f (w + f a) - (1 - f) w = d where they part.
  double exact_factor() const {
    if (meets())
      return 2.0 * (way + depth) /
             (2.0 * way + growth +
              std::sqrt(std::max(0.0, 4.0 * way * way + growth * (growth - 4.0 * depth))));
    return (way + depth) / (way + std::sqrt(way * way + growth * (way + depth)));
  }
};

/// What the points of a pair hold, lose in the step, and take in its half behind them [energy].
struct PairEnergy {
  double stored = 0.0, lost = 0.0, taken = 0.0;
  double of_meeting = 0.0, of_parting = 0.0;  ///< excess of points that have just met, that will part

  void add(const ContactPoint& point, const PointWork& work) {
    stored += point.stored();
    lost += point.dissipated + point.damped;
    taken += work.taken;
    (work.meets() ? of_meeting : of_parting) += work.excess;
  }

  /// The factor of the forces.
  double factor(double energy, double least) const {
    if (std::isnan(energy)) return 1.0;
    const double needed = reserve * (stored + lost - taken);
    const double available = energy - least;
    if (!(needed > available)) return 1.0;
    // Springs that give energy back would be out of it with all of their length left: their forces fall as
    // the energy does. Springs that take it have the force F of ones that hold the energy E at their
    // stiffness k, F^2 = 2 k E, so that what presses on is stopped.
    const double share = std::max(0.0, available / needed);
    return taken > 0.0 ? std::sqrt(share) : share;
  }

  /// The share of their excess that points which meet, or part, are spared of, so that the pair has no energy
  /// left over, and has given none away, when all have parted. The next hit makes up for what this one
  /// leaves.
  double spared(double energy, bool meets) const {
    const double left_over = energy + taken - lost - stored - of_parting;
    const double share = meets ? left_over / of_meeting : -left_over / of_parting;
    return std::clamp(share, 0.0, 2.0);
  }
};

}  // namespace

void limit_returned_energy(const ContactKinematics& kinematics, const PairWork& work,
                           const EnergyLimits& limits, std::span<const double> accelerations,
                           std::span<ContactPoint> points) {
  IndexedVector<PairIndex, PairEnergy> pairs(limits.energy.size());
  std::vector<PointWork> works(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const ContactPoint& point = points[i];
    if (!point.touches() || std::isnan(limits.energy[point.pair])) continue;
    works[i] = PointWork(kinematics, work, point, accelerations[i]);
    pairs[point.pair].add(point, works[i]);
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    const PairIndex of = points[i].pair;
    const double available = limits.energy[of];
    const double held =
        std::max(pairs[of].factor(available, limits.least[of]), share_of_step(points[i], works[i].taken));
    const double factor = held * works[i].factor(pairs[of].spared(available, works[i].meets()));
    if (factor < 1.0) points[i].scale_forces(factor);
  }
}

}  // namespace contactsim
