// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/statics/held_directions.hpp"
#include "core/statics/static_contact.hpp"

namespace contactsim {

/// The springs of contact as the equations of load steps see them: on rigid bodies in the place of their
/// nodes, without what moves along held directions.
class StaticSprings {
 public:
  /// Takes those of the last trial of contact.
  ///   contact  null: there are none
  void find(const StaticContact* contact, const StaticBodies& bodies, const HeldDirections& held);
  const std::vector<ContactSpring>& all() const { return springs_; }
  /// Adds what they resist a motion with.
  ///   n  3 a node: where rotations begin in vectors of unknowns
  void add(Eigen::Index n, const Eigen::VectorXd& direction, Eigen::VectorXd& product) const;

 private:
  std::vector<ContactSpring> springs_;
};

}  // namespace contactsim
