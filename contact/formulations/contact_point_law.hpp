// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "contact/geometry/contact_point.hpp"
#include "contact/geometry/face_face.hpp"

/// What all kinds of contact points share.
namespace contactsim {

/// What touched in the last step may be this much deeper than what did not, and as much deeper than it was.
inline constexpr double known_depth = 1.5;

/// The penetration up to which something counts as what touched in the last step: no limit of its own ends a
/// contact that keeps getting deeper.
///   depth   of what did not touch [length]
///   before  penetration in the last step [length]
///   closed  by which the gap has shrunk since [length]
inline double depth_of_known(double depth, double before, double closed) {
  return known_depth * std::max(depth, before + closed);
}

/// A contact that has ended though its sides did not part: one of them has got past the other.
struct LostContact {
  PairIndex pair;
  ContactNodeIndex node;  ///< contact node of one of the sides
  double depth = 0.0;     ///< penetration in the step before [length]
};

/// A penetration beyond this share of the thinner element's thickness does not end in one step by parting.
inline constexpr double deep_share = 0.5;

/// What was behind the other side one step ago by no more than this share of an element's thickness met it in
/// front: facets of a round surface change that much.
inline constexpr double shallow_depth = 0.02;

/// Where momentum is balanced, a gap up to this share of an element's thickness counts as closed: what lies
/// on something else stays in contact through round-off, and a stack falls as one.
inline constexpr double closed_share = 1e-3;

/// Contact that was found once is not let go for its depth [length].
inline constexpr double any_depth = 1e100;

/// max(x, 0) without a branch: whether things come closer or part is chance.
inline double above_zero(float x) { return 0.5f * (x + std::abs(x)); }

/// The stiffness that a damped spring counts as for the stable step.
///   fraction  of critical damping [1]
/// Source: Belytschko, Liu, Moran & Elkhodary, Nonlinear Finite Elements (2014), eq. 6.2.20.
double damped_stiffness(double stiffness, double fraction);

/// A node before something that pushes it.
struct NodePenaltyInput {
  PairPenalty penalty;
  double damping_fraction = 0.0;  ///< of critical damping [1]
  double area = 0.0;              ///< of the node against the normal [length^2]
  Eigen::Vector3d velocity;       ///< of the node relative to the other side [length/time]
  double dt = 0.0;                ///< [time]
  double coming_dt = 0.0;         ///< > 0: momentum is balanced, the gap alone makes no force [time]
  Eigen::Vector3d last_velocity;  ///< the same as velocity in the step before [length/time]
  bool is_static = false;         ///< of a load step: stiffness is that of now
};

/// Fills in stiffness, and where the node is behind the other side, or it pulls, area, force, damping and
/// slip. Damping never pulls: what it takes from a separating node ends with the spring's force.
///   point  has its normal and gap, and whether it pulls
void push_node(const NodePenaltyInput& push, ContactPoint& point);

}  // namespace contactsim
