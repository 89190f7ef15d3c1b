// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace contactsim {

/// Constraints give way by this share of their softness, so that forces which move nothing stay bounded.
inline constexpr double constraint_compliance = 1e-6;

/// Share of the forces of the step before that those of a step begin with. Where passes leave the share r of
/// a slow mode of gaps g, a share w taken over makes g(n+1) = r ((2 + w) g(n) - (1 + 2 w) g(n-1) + w g(n-2)),
/// which for r near 1 stays bounded for w < 2/3 only.
inline constexpr double taken_over = 0.5;

/// Sums over the constraints of a pass.
struct ConstraintPass {
  double changed = 0.0;  ///< by how much forces changed [force]
  double all = 0.0;      ///< of forces [force]
  double uphill = 0.0;   ///< > 0: the acceleration has gone too far [force length]

  /// Gives a constraint its next force, and the one that the pass after starts from, by the momentum beyond.
  template <class Row, class Force>
  void take(Row& row, const Force& force, double momentum) {
    const Force step = force - row.force, over = row.ahead - force;
    changed += over.norm();
    all += force.norm();
    uphill += row.softness * over.dot(step);
    row.force = force;
    row.ahead = force + momentum * step;
  }
  ConstraintPass& operator+=(const ConstraintPass& other) {
    changed += other.changed;
    all += other.all;
    uphill += other.uphill;
    return *this;
  }
};

/// The areas of contact points that lean on each carrier, by its translation and by its rotation
/// [n_carriers x 2] [length^2].
using LeaningAreas = std::vector<std::array<double, 2>>;

/// What leans on a carrier: sums over its constraints.
struct CarrierLoad {
  double own = 0.0;     ///< softness by the carrier's side, times area and over the step
  double others = 0.0;  ///< the same by the other side
  double area = 0.0;    ///< [length^2]
};

}  // namespace contactsim
