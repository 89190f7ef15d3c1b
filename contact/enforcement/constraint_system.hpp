// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "contact/enforcement/contact_history.hpp"
#include "contact/enforcement/point_carriers.hpp"
#include "contact/geometry/contact_point.hpp"
#include "contact/interface_laws/pair_rules.hpp"
#include "core/base/optional_index.hpp"
#include "core/base/threads.hpp"

namespace contactsim {

/// A contact point as a row of the constraints. Fourth numbers are 0.
struct ConstraintRow {
  NodeVector force = NodeVector::Zero();  ///< on the first side [force]
  NodeVector ahead = NodeVector::Zero();  ///< with momentum, from which the next pass starts [force]
  double start = 0.0;     ///< gap at the end of the step without forces, plus what may be left of it [length]
  double recovery = 0.0;  ///< part of its penetration that is to come out [length]
  double zero_gap = 0.0;  ///< at which it just touches [length]
  double softness = 0.0;  ///< gap per force of this point when all have its pressure, at most [length/force]
  double area = 0.0;      ///< of its point [length^2]
  std::uint32_t point = 0;                ///< in ConstraintSystem::points
  OptionalIndex<std::uint32_t> friction;  ///< in ConstraintSystem::frictions, of a point with friction
  OptionalIndex<std::uint32_t> light;     ///< its row among those with light carriers
  bool pulls = false;                     ///< it has touched and may not part
};

/// Rows of contact points between the same entities, which have the same carriers.
struct ConstraintGroup {
  NodeVector normal = NodeVector::Zero();  ///< unit, from the second side to the first [1]
  std::uint32_t first_row = 0, n_rows = 0;
  bool presses = false;  ///< along the normal alone, on plain carriers: its rows are PressingRows
  PointCarriers::Terms terms;
};

/// Friction of a contact point.
struct ConstraintFriction {
  const PairRule* rule = nullptr;
  double limit_per_force = 0.0;                    ///< of the tangential force; < 0: the rule says [1]
  Eigen::Vector3d held = Eigen::Vector3d::Zero();  ///< slip of earlier steps that friction holds [length]
  Eigen::Vector3d slip = Eigen::Vector3d::Zero();  ///< of the step without forces, in the plane [length]
  double softness = 0.0;                           ///< slip per tangential force [length/force]
};

/// A vector with a fourth number 0.
inline NodeVector node_vector(const Eigen::Vector3d& vector) {
  return {vector.x(), vector.y(), vector.z(), 0.0};
}

/// The part of a vector in the plane of a unit normal.
inline Eigen::Vector3d in_plane(const Eigen::Vector3d& vector, const Eigen::Vector3d& normal) {
  return vector - normal.dot(vector) * normal;
}

/// The contact points of a step and the rows of those that are constraints, group by group.
struct ConstraintSystem {
  std::vector<ContactPoint> points;  ///< in the order in which they were added, those without a row too
  std::vector<ConstraintGroup> groups;
  std::vector<ConstraintRow> rows;
  std::vector<PointCarriers::Weights> weights;  ///< [n_rows]
  std::vector<ContactHistory::PointId> ids;     ///< [n_rows] by which the step after knows them
  std::vector<ConstraintFriction> frictions;

  void clear();
  /// Whether a point has the entities and the normal of the last group, whose carriers are plain.
  bool is_of_last_group(const ContactPoint& point) const;
  /// Removes the rows that have no softness, and groups without rows.
  void remove_rigid_rows();

  const ContactPoint& point_of(const ConstraintRow& row) const { return points[row.point]; }
  /// Threads that are worth while for a loop over all rows.
  int n_threads() const { return threads_for(10 * rows.size()); }

  /// Calls visit(group, row) for each row of some groups, in their order.
  template <class Visit>
  static void visit_rows(std::span<const ConstraintGroup> groups, const Visit& visit) {
    for (const ConstraintGroup& group : groups) {
      for (std::uint32_t row = group.first_row; row < group.first_row + group.n_rows; ++row)
        visit(group, row);
    }
  }
  template <class Visit>
  void visit_rows(const Visit& visit) const {
    visit_rows(groups, visit);
  }
  /// The sums of visit(group, row, sums) over all rows: chunk by chunk, so that they have the same bits for
  /// any number of threads. Calls of different chunks are concurrent.
  template <class Sums, class Visit>
  Sums sum_rows(int n_threads, const Visit& visit) const;

  static constexpr std::size_t groups_per_chunk = 64;
};

template <class Sums, class Visit>
Sums ConstraintSystem::sum_rows(int n_threads, const Visit& visit) const {
  const std::size_t n_chunks = (groups.size() + groups_per_chunk - 1) / groups_per_chunk;
  std::vector<Sums> parts(n_chunks);
  parallel_for(n_chunks, n_threads, [&](std::size_t i) {
    const std::size_t begin = i * groups_per_chunk;
    const std::size_t n = std::min(groups_per_chunk, groups.size() - begin);
    visit_rows(std::span(groups).subspan(begin, n),
               [&](const ConstraintGroup& group, std::uint32_t row) { visit(group, row, parts[i]); });
  });
  Sums sums;
  for (const Sums& part : parts) sums += part;
  return sums;
}

}  // namespace contactsim
