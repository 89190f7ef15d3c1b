// SPDX-License-Identifier: BSD-3-Clause
#include "core/conditions/kinematic_conflicts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace contactsim {

namespace {

/// Cosine above which two directions are not at right angles: decks write unit vectors to some seven digits.
constexpr double tolerance = 1e-6;

bool have_right_angle(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::abs(a.dot(b)) <= tolerance;
}

/// An axis drives the plane at right angles to it.
bool constrains_plane(const PrescribedMotion& motion) {
  return std::holds_alternative<Axis>(motion.direction);
}

bool are_apart(const Axis& axis, const PrescribedMotion& other) {
  const auto units = unit_vectors(other.direction);
  return std::all_of(units.begin(), units.end(), [&](const Eigen::Vector3d& unit) {
    return axis.direction.cross(unit).norm() <= tolerance;
  });
}

/// Whether all that one drives is at right angles to all that the other drives.
bool are_apart(const PrescribedMotion& a, const PrescribedMotion& b) {
  if (constrains_plane(a) && constrains_plane(b)) return false;
  if (constrains_plane(a)) return are_apart(std::get<Axis>(a.direction), b);
  if (constrains_plane(b)) return are_apart(std::get<Axis>(b.direction), a);
  const auto units_a = unit_vectors(a.direction), units_b = unit_vectors(b.direction);
  return std::all_of(units_a.begin(), units_a.end(), [&](const Eigen::Vector3d& unit) {
    return std::all_of(units_b.begin(), units_b.end(),
                       [&](const Eigen::Vector3d& other) { return have_right_angle(unit, other); });
  });
}

/// Holds in slanted directions are made one when they act at the same times.
bool may_share_nodes(const PrescribedMotion& a, const PrescribedMotion& b) {
  if (!a.times.overlaps(b.times) || are_apart(a, b)) return true;
  const bool both_fixed = a.type == MotionType::fixed && b.type == MotionType::fixed;
  return both_fixed && (!are_oblique(a, b) || a.times == b.times);
}

void report(const PrescribedMotion& first, const PrescribedMotion& second, const std::string& name,
            std::size_t n_shared, Diagnostics& diagnostics) {
  const std::string more = n_shared > 1 ? fmt::format(" and {} more", n_shared - 1) : std::string();
  diagnostics.add_error(second.label.location,
                        fmt::format("{} and {} both drive {}{} in one direction at one time",
                                    second.label.what, to_string(first.label), name, more),
                        "take the nodes out of one of them, or give them other periods");
}

}  // namespace

std::vector<NodeIndex> shared_nodes(const PrescribedMotion& a, const PrescribedMotion& b) {
  std::vector<NodeIndex> shared;
  std::set_intersection(a.nodes.begin(), a.nodes.end(), b.nodes.begin(), b.nodes.end(),
                        std::back_inserter(shared));
  return shared;
}

bool are_oblique(const PrescribedMotion& a, const PrescribedMotion& b) {
  for (const Eigen::Vector3d& unit : unit_vectors(a.direction)) {
    for (const Eigen::Vector3d& other : unit_vectors(b.direction)) {
      const bool is_parallel = unit.cross(other).norm() <= tolerance;
      if (!is_parallel && !have_right_angle(unit, other)) return true;
    }
  }
  return false;
}

void check_conflicts(std::span<const PrescribedMotion> motions,
                     const std::function<std::string(NodeIndex)>& name_of, Diagnostics& diagnostics) {
  for (std::size_t second = 1; second < motions.size(); ++second) {
    for (std::size_t first = 0; first < second; ++first) {
      if (may_share_nodes(motions[first], motions[second])) continue;
      const auto shared = shared_nodes(motions[first], motions[second]);
      if (shared.empty()) continue;
      report(motions[first], motions[second], name_of(shared.front()), shared.size(), diagnostics);
    }
  }
}

}  // namespace contactsim
