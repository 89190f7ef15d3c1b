// SPDX-License-Identifier: BSD-3-Clause
#include "core/statics/sparse_factor.hpp"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseLU>

namespace contactsim {

namespace {

class SymmetricEigenFactor final : public SparseFactor {
 public:
  bool factorise(const Matrix& matrix) override {
    factor_.compute(matrix);
    return factor_.info() == Eigen::Success;
  }
  Eigen::VectorXd solve(const Eigen::VectorXd& right) const override { return factor_.solve(right); }
  std::int64_t n_negative() const override { return (factor_.vectorD().array() < 0.0).count(); }

 private:
  Eigen::SimplicialLDLT<Matrix, Eigen::Lower> factor_;
};

class GeneralEigenFactor final : public SparseFactor {
 public:
  bool factorise(const Matrix& matrix) override {
    factor_.compute(matrix);
    return factor_.info() == Eigen::Success;
  }
  Eigen::VectorXd solve(const Eigen::VectorXd& right) const override { return factor_.solve(right); }
  std::int64_t n_negative() const override { return 0; }

 private:
  Eigen::SparseLU<Matrix> factor_;
};

}  // namespace

std::unique_ptr<SparseFactor> make_eigen_factor(bool is_symmetric) {
  if (is_symmetric) return std::make_unique<SymmetricEigenFactor>();
  return std::make_unique<GeneralEigenFactor>();
}

std::unique_ptr<SparseFactor> make_sparse_factor(bool is_symmetric) {
  auto factor = make_mumps_factor(is_symmetric);
  return factor ? std::move(factor) : make_eigen_factor(is_symmetric);
}

}  // namespace contactsim
