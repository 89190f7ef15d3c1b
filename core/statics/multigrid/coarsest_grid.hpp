// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Cholesky>

namespace contactsim {

/// The equations of the coarsest level, solved at once. Directions without stiffness are left out, those of a
/// negative one move as if it were positive.
class CoarsestGrid {
 public:
  CoarsestGrid() = default;
  explicit CoarsestGrid(const Eigen::MatrixXd& matrix);
  Eigen::VectorXd solve(const Eigen::VectorXd& right) const;

 private:
  Eigen::LDLT<Eigen::MatrixXd> factor_;
  Eigen::VectorXd inverses_;  // of the pivots
};

}  // namespace contactsim
