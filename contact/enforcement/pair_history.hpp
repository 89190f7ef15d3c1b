// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstdint>
#include <limits>

#include "core/base/indices.hpp"

namespace contactsim {

/// What a pair of surfaces has done in a run. A pair that never touched keeps all zero.
struct PairHistory {
  double contact_time = 0.0;  ///< time with at least one contact point that touches [time]
  double peak_force = 0.0;    ///< largest norm of the net force [force]
  Eigen::Vector3d impulse = Eigen::Vector3d::Zero();  ///< of the net force on `second` [force time]
  double work = 0.0;                                  ///< stored in its springs and lost [energy]
  double friction_work = 0.0;                         ///< lost to friction, >= 0 [energy]
  double taken = 0.0;            ///< by its forces from the bodies, < 0 given to them [energy]
  double stored_at_start = 0.0;  ///< part of work: in overlaps of the mesh, before the first step [energy]
  double ramped = 0.0;           ///< put in by overlaps that are ramped [energy]
  double impact = 0.0;           ///< lost where sides met without rebound [energy]

  /// What it holds and has lost beyond what it had, took and was given: energy from nowhere; < 0 destroyed
  /// [energy].
  double made() const { return work + std::max(impact, 0.0) - stored_at_start - taken - ramped; }

  double deepest = 0.0;        ///< penetration of what has touched [length]
  double deepest_share = 0.0;  ///< the same over the thickness of the thinner side [1]

  /// Contacts that ended deep, because a side got past the other; the first of them (NaN: none).
  std::uint64_t n_lost = 0;
  NodeIndex lost_node;                                           ///< of the mesh
  double lost_time = std::numeric_limits<double>::quiet_NaN();   ///< [time]
  double lost_depth = std::numeric_limits<double>::quiet_NaN();  ///< penetration [length]

  /// Under INFINITESIMAL_SLIDING: how far something that touches has slid off its face of the start, over the
  /// size of that face; what has lost its faces to deaths, and slides freely since.
  double slid_share = 0.0;       ///< [1]
  NodeIndex slid_node;           ///< of the mesh, that has slid farthest
  std::uint64_t n_released = 0;  ///< faces and nodes
  NodeIndex released_node;       ///< of the mesh, the first of them

  bool has_touched() const { return contact_time > 0.0 || peak_force > 0.0; }
};

}  // namespace contactsim
