// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>

#include "core/elements/force_term.hpp"

namespace contactsim {

/// Seconds of the clock since some time that does not change.
inline double clock_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// A force term that counts the time it takes.
class TimedForce final : public ForceTerm {
 public:
  /// The term must outlive this.
  explicit TimedForce(ForceTerm& term) : term_(term) {}

  ForceReport set_forces(const Motion& motion, Eigen::Matrix3Xd& forces) override {
    const double start = clock_seconds();
    const ForceReport report = term_.set_forces(motion, forces);
    seconds_ += clock_seconds() - start;
    return report;
  }
  void set_moments(const Motion& motion, Eigen::Matrix3Xd& moments) override {
    const double start = clock_seconds();
    term_.set_moments(motion, moments);
    seconds_ += clock_seconds() - start;
  }
  std::optional<ForceReport> balance(const State& state, Eigen::Matrix3Xd& forces) override {
    const double start = clock_seconds();
    const auto report = term_.balance(state, forces);
    seconds_ += clock_seconds() - start;
    return report;
  }
  double seconds() const { return seconds_; }

 private:
  ForceTerm& term_;
  double seconds_ = 0.0;
};

}  // namespace contactsim
