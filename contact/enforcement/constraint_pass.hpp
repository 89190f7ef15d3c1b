// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "contact/enforcement/node_mobility.hpp"
#include "contact/enforcement/rigid_response.hpp"

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

  /// Gives a constraint its next force, and what the pass after looks at, by the momentum beyond.
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

/// Areas that constraints are scaled by.
struct ScalingAreas {
  LeaningAreas all;
  LeaningAreas rest;  ///< of constraints whose forces are not found together with a rigid body's motion
};

/// A constraint whose force is found together with the motion of a rigid body on one of its sides.
struct BodyTerm {
  static constexpr std::uint32_t none = 0xffffffff;

  std::uint32_t response = none;  ///< of the body
  std::uint32_t term = none;      ///< of the constraint that is the body's

  bool exists() const { return response != none; }
};

/// The term of the only rigid body among a constraint's terms, where that gives way more easily than the
/// rest, which gives way, too.
///   carrier_of, share_of  of a term; the share is that of the constraint's softness
template <class CarrierOf, class ShareOf>
BodyTerm choose_body(const NodeMobility& mobility, std::size_t n_terms, const CarrierOf& carrier_of,
                     const ShareOf& share_of, RigidResponses& responses) {
  BodyTerm chosen;
  double own = 0.0, others = 0.0;
  for (std::uint32_t i = 0; i < n_terms; ++i) {
    const bool is_body = mobility.is_body(carrier_of(i));
    if (is_body && chosen.term != BodyTerm::none) return {};
    if (is_body) chosen.term = i;
    (is_body ? own : others) += share_of(i);
  }
  if (!(others > 0.0) || !(own > others)) return {};
  chosen.response = responses.of(carrier_of(chosen.term));
  return chosen;
}

}  // namespace contactsim
