// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "contact/formulations/interface_constraint.hpp"
#include "contact/geometry/contact_point.hpp"
#include "contact/mesh/contact_kinematics.hpp"

namespace contactsim {

/// The work that the contact forces of each pair of surfaces take from the bodies: a force works along the
/// half step before its time and the half step behind it, as the integrator counts it, so that the sum over
/// the pairs is the energy of contact. What a pair has taken and neither holds nor lost it has destroyed;
/// what it gave and never held it has made.
class PairWork {
 public:
  explicit PairWork(std::size_t n_pairs) : taken_(n_pairs, 0.0), coming_(n_pairs, 0.0) {}

  /// Begins a step: the forces of the step before work along its first half.
  ///   dt  of the step [time]
  void begin_step(const ContactKinematics& kinematics, double dt);
  /// Takes a force of the step over.
  void add(const ContactKinematics& kinematics, const ContactPoint& point);
  void add(const ContactKinematics& kinematics, const InterfaceConstraint& constraint,
           const CornerForces& forces);
  double step() const { return 2.0 * half_; }
  /// What add() would count for a contact point: the work along the half step behind its time [energy].
  double work_behind(const ContactKinematics& kinematics, const ContactPoint& point) const;
  /// The contact nodes have other numbers from now on: forces of the step before are over.
  void forget_forces() { forces_.clear(); }

  /// Taken from the bodies since the start, < 0 given to them [energy]
  IndexedSpan<PairIndex, const double> taken() const { return taken_; }
  void archive(StateArchive& saved);

 private:
  /// A force on a contact node, with its moment about the node.
  struct NodeForce {
    PairIndex pair;
    ContactNodeIndex node;
    Eigen::Vector3d force = Eigen::Vector3d::Zero();   ///< [force]
    Eigen::Vector3d moment = Eigen::Vector3d::Zero();  ///< [force length]
  };
  void add(const ContactKinematics& kinematics, const NodeForce& force);

  IndexedVector<PairIndex, double> taken_,
      coming_;                     // until now; in the half step to come, as far as forces know it
  std::vector<NodeForce> forces_;  // of the last step, whose work is not known before its second half
  double half_ = 0.0;              // of the step [time]
};

}  // namespace contactsim
