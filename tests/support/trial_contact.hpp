// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <vector>

#include "core/statics/static_contact.hpp"

namespace contactsim::test {

/// Contact of load steps that is nothing but springs, which are at rest where nodes are at first, and of
/// stabilization, which holds nodes where the step begins.
class TrialContact final : public StaticContact, public ForceTerm {
 public:
  explicit TrialContact(Eigen::Matrix3Xd at_rest) : at_rest_(std::move(at_rest)), start_(at_rest_) {}

  std::vector<ContactSpring> springs;
  std::vector<std::uint32_t> stabilized;   ///< nodes
  double ground = 0.0;                     ///< of each of them, at a ramp of 1 [force/length]
  std::vector<StabilizationLevel> levels;  ///< that were asked for
  int n_trials = 0;

  ForceReport set_forces(const Motion& motion, Eigen::Matrix3Xd& forces) override {
    forces.setZero(3, at_rest_.cols());
    for (const ContactSpring& spring : springs) {
      spring.multiply(
          [&](const SpringEnd& end) -> Eigen::Vector3d {
            return motion.coordinates.col(end.node) - at_rest_.col(end.node);
          },
          [&](const SpringEnd& end, const Eigen::Vector3d& felt) { forces.col(end.node) -= felt; });
    }
    size_ = 0.0;
    if (levels.empty()) return {};
    for (const std::uint32_t node : stabilized) {
      const Eigen::Vector3d force =
          -ground * levels.back().ramp * (motion.coordinates.col(node) - start_.col(node));
      forces.col(node) += force;
      size_ += force.norm();
    }
    return {};
  }

  void begin_trials(const Motion& motion) override { start_ = motion.coordinates; }
  void try_forces(const Motion& motion, Eigen::Matrix3Xd& forces, Eigen::Matrix3Xd*) override {
    ++n_trials;
    set_forces(motion, forces);
  }
  bool hold_slip_limits(bool) override { return false; }
  void visit_springs(const std::function<void(const ContactSpring&)>& take) const override {
    for (const ContactSpring& spring : springs) take(spring);
  }
  MultiplierChange update_multipliers(double) override { return {}; }
  bool is_stabilized() const override { return !stabilized.empty(); }
  void stabilize(const StabilizationLevel& level) override { levels.push_back(level); }
  Stabilization stabilization() const override {
    return {levels.empty() ? 0.0 : levels.back().ramp, stabilized};
  }
  double stabilizing_force() const override { return size_; }
  double longest_motion() const override { return std::numeric_limits<double>::infinity(); }
  void give_up_trials() override {}
  ForceReport accept_trial(const Motion&, Eigen::Matrix3Xd&) override { return {}; }

 private:
  Eigen::Matrix3Xd at_rest_, start_;
  double size_ = 0.0;  // of the forces of stabilization [force]
};

/// A spring between two nodes that resists their motion apart.
inline ContactSpring spring_between(std::uint32_t a, std::uint32_t b, const Eigen::Matrix3d& stiffness) {
  ContactSpring spring;
  spring.ends = {{a, false, 0, Eigen::Matrix3d::Identity()}, {b, false, 1, Eigen::Matrix3d::Identity()}};
  spring.coupling.setZero();
  spring.coupling.topLeftCorner<2, 2>() << 1, -1, -1, 1;
  spring.stiffness = stiffness;
  return spring;
}

}  // namespace contactsim::test
