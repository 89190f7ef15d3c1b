// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/dynamics/rank_share.hpp"
#include "core/elements/force_term.hpp"

namespace contactsim {

/// The forces of elements in load steps that ranks share: each brings its own chunks to the end of a trial
/// and sums up at the nodes that it follows, and all get the forces of all nodes, since unknowns and what
/// solves for them are whole on each rank.
class SharedElements final : public ForceTerm {
 public:
  /// Both must outlive this.
  ///   own  the forces of elements, of the same share
  SharedElements(ForceTerm& own, RankShare& share) : own_(own), share_(share) {}

  ForceReport set_forces(const Motion& motion, Eigen::Matrix3Xd& forces) override {
    const ForceReport report = own_.set_forces(motion, forces);
    share_.gather_nodes(forces);
    return report;
  }
  void set_moments(const Motion& motion, Eigen::Matrix3Xd& moments) override {
    own_.set_moments(motion, moments);
    share_.gather_nodes(moments);
  }

 private:
  ForceTerm& own_;
  RankShare& share_;
};

}  // namespace contactsim
