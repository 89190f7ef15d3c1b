// SPDX-License-Identifier: BSD-3-Clause
#include "core/statics/sparse_factor.hpp"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseLU>

namespace contactsim {

namespace {

template <class Factor>
class EigenFactor final : public SparseFactor {
 public:
  bool factorise(const Matrix& matrix) override {
    factor_.compute(matrix);
    return factor_.info() == Eigen::Success;
  }
  Eigen::VectorXd solve(const Eigen::VectorXd& right) const override { return factor_.solve(right); }
  std::int64_t n_negative() const override {
    if constexpr (requires { factor_.vectorD(); }) return (factor_.vectorD().array() < 0.0).count();
    return 0;
  }

 private:
  Factor factor_;
};

}  // namespace

std::unique_ptr<SparseFactor> make_eigen_factor(bool is_symmetric) {
  using Matrix = SparseFactor::Matrix;
  if (is_symmetric) return std::make_unique<EigenFactor<Eigen::SimplicialLDLT<Matrix, Eigen::Lower>>>();
  return std::make_unique<EigenFactor<Eigen::SparseLU<Matrix>>>();
}

std::unique_ptr<SparseFactor> make_sparse_factor(bool is_symmetric) {
  auto factor = make_mumps_factor(is_symmetric);
  return factor ? std::move(factor) : make_eigen_factor(is_symmetric);
}

}  // namespace contactsim
