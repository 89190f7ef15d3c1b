// SPDX-License-Identifier: BSD-3-Clause
#include "core/conditions/skew_supports.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "core/conditions/kinematic_conflicts.hpp"

namespace contactsim {

namespace {

/// Adds holds one by one; those that are added are parallel or at right angles wherever they share nodes.
class SkewSupportSeparator {
 public:
  void add(PrescribedMotion motion) {
    if (motion.type == MotionType::fixed) split(motion);
    if (!motion.nodes.empty()) separated_.push_back(std::move(motion));
  }
  std::vector<PrescribedMotion> take() { return std::move(separated_); }

 private:
  /// Takes away the nodes that an earlier hold shares at a slant, and adds what is left to hold there.
  void split(PrescribedMotion& motion) {
    for (std::size_t i = 0; i < separated_.size(); ++i) {
      const bool is_apart = separated_[i].type != MotionType::fixed || !are_oblique(separated_[i], motion);
      auto shared = is_apart ? std::vector<NodeIndex>{} : shared_nodes(separated_[i], motion);
      if (shared.empty()) continue;
      std::vector<NodeIndex> own;
      std::set_difference(motion.nodes.begin(), motion.nodes.end(), shared.begin(), shared.end(),
                          std::back_inserter(own));
      motion.nodes = std::move(own);
      add_rest(separated_[i].direction, motion, shared);
    }
  }

  /// The part of each direction at right angles to the earlier ones.
  void add_rest(const Direction& earlier, const PrescribedMotion& motion,
                const std::vector<NodeIndex>& shared) {
    constexpr double smallest = 1e-6;
    std::vector<Eigen::Vector3d> held = unit_vectors(earlier);
    for (const Eigen::Vector3d& unit : unit_vectors(motion.direction)) {
      Eigen::Vector3d rest = unit;
      for (const Eigen::Vector3d& other : held) rest -= rest.dot(other) * other;
      if (rest.norm() < smallest) continue;
      rest.normalize();
      held.push_back(rest);
      PrescribedMotion part = motion;
      part.direction = rest;
      part.nodes = shared;
      add(std::move(part));
    }
  }

  std::vector<PrescribedMotion> separated_;
};

}  // namespace

std::vector<PrescribedMotion> separate_skew_supports(std::vector<PrescribedMotion> motions) {
  SkewSupportSeparator separator;
  for (PrescribedMotion& motion : motions) separator.add(std::move(motion));
  return separator.take();
}

}  // namespace contactsim
