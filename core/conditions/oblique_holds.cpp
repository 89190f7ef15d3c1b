// SPDX-License-Identifier: BSD-3-Clause
#include "core/conditions/oblique_holds.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "core/conditions/kinematic_conflicts.hpp"

namespace contactsim {

namespace {

/// Adds holds one by one; those that are added are parallel or at right angles wherever they share nodes.
class HoldSeparator {
 public:
  void add(DrivenNodes driven) {
    if (driven.drive == Drive::hold) split(driven);
    if (!driven.nodes.empty()) separated_.push_back(std::move(driven));
  }
  std::vector<DrivenNodes> take() { return std::move(separated_); }

 private:
  /// Takes away the nodes that an earlier hold shares at a slant, and adds what is left to hold there.
  void split(DrivenNodes& driven) {
    for (std::size_t i = 0; i < separated_.size(); ++i) {
      const bool is_apart = separated_[i].drive != Drive::hold || !are_oblique(separated_[i], driven);
      auto shared = is_apart ? std::vector<NodeIndex>{} : shared_nodes(separated_[i], driven);
      if (shared.empty()) continue;
      std::vector<NodeIndex> own;
      std::set_difference(driven.nodes.begin(), driven.nodes.end(), shared.begin(), shared.end(),
                          std::back_inserter(own));
      driven.nodes = std::move(own);
      add_rest(separated_[i].direction, driven, shared);
    }
  }

  /// The part of each direction at right angles to the earlier ones.
  void add_rest(const Direction& earlier, const DrivenNodes& driven, const std::vector<NodeIndex>& shared) {
    constexpr double smallest = 1e-6;
    std::vector<Eigen::Vector3d> held = unit_vectors(earlier);
    for (const Eigen::Vector3d& unit : unit_vectors(driven.direction)) {
      Eigen::Vector3d rest = unit;
      for (const Eigen::Vector3d& other : held) rest -= rest.dot(other) * other;
      if (rest.norm() < smallest) continue;
      rest.normalize();
      held.push_back(rest);
      DrivenNodes part = driven;
      part.direction = rest;
      part.nodes = shared;
      add(std::move(part));
    }
  }

  std::vector<DrivenNodes> separated_;
};

}  // namespace

std::vector<DrivenNodes> separate_oblique_holds(std::vector<DrivenNodes> driven) {
  HoldSeparator separator;
  for (DrivenNodes& one : driven) separator.add(std::move(one));
  return separator.take();
}

}  // namespace contactsim
