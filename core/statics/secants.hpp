// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <Eigen/QR>
#include <cstddef>
#include <vector>

namespace contactsim {

/// What the last steps of a search have shown of the stiffness: friction that slides, normals that turn and
/// faces whose overlaps change are not in a symmetric one. A step of Newton's is turned such that the
/// residual is least over what these steps span. Source: Fang and Saad, Numer. Linear Algebra Appl. 16 (2009)
/// 197-221, Anderson's family of type II.
class Secants {
 public:
  /// Takes a step and by what it has changed the residual.
  void add(const Eigen::VectorXd& step, const Eigen::VectorXd& change) {
    if (steps_.size() == most) {
      steps_.erase(steps_.begin());
      changes_.erase(changes_.begin());
    }
    steps_.push_back(step);
    changes_.push_back(change);
  }
  void clear() {
    steps_.clear();
    changes_.clear();
  }
  /// Takes out of a residual what a combination of the steps removes. Returns that combination, 0 without
  /// steps.
  Eigen::VectorXd take_out(Eigen::VectorXd& residual) const {
    const auto n = static_cast<Eigen::Index>(steps_.size());
    if (n == 0) return Eigen::VectorXd::Zero(residual.size());
    Eigen::MatrixXd changes(residual.size(), n);
    for (Eigen::Index i = 0; i < n; ++i) changes.col(i) = changes_[static_cast<std::size_t>(i)];
    const Eigen::VectorXd shares = changes.colPivHouseholderQr().solve(-residual);
    residual += changes * shares;
    Eigen::VectorXd step = Eigen::VectorXd::Zero(residual.size());
    for (Eigen::Index i = 0; i < n; ++i) step += shares(i) * steps_[static_cast<std::size_t>(i)];
    return step;
  }

 private:
  static constexpr std::size_t most = 5;
  std::vector<Eigen::VectorXd> steps_, changes_;
};

}  // namespace contactsim
