// SPDX-License-Identifier: BSD-3-Clause
#include "core/statics/sparse_factor.hpp"

#include <Eigen/Dense>
#include <vector>

#include "support/catch.hpp"

using namespace contactsim;

namespace {

/// A matrix with 4 on its diagonal and -1 beside it, and another number in its last place.
///   above  what stands above the diagonal
Eigen::MatrixXd banded(Eigen::Index n, double above, double last) {
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    matrix(i, i) = 4.0;
    if (i + 1 < n) matrix(i + 1, i) = -1.0;
    if (i + 1 < n) matrix(i, i + 1) = above;
  }
  matrix(n - 1, n - 1) = last;
  return matrix;
}

/// All factors that there are here.
std::vector<std::unique_ptr<SparseFactor>> factors(bool is_symmetric) {
  std::vector<std::unique_ptr<SparseFactor>> all;
  all.push_back(make_eigen_factor(is_symmetric));
  if (auto mumps = make_mumps_factor(is_symmetric)) all.push_back(std::move(mumps));
  return all;
}

}  // namespace

TEST_CASE("factors solve equations, and again with other numbers", "[core][statics]") {
  const Eigen::VectorXd wanted = Eigen::VectorXd::LinSpaced(30, -1.0, 2.0);
  for (const bool is_symmetric : {true, false}) {
    for (const auto& factor : factors(is_symmetric)) {
      for (const double last : {4.0, 7.0}) {
        const Eigen::MatrixXd whole = banded(30, is_symmetric ? -1.0 : 0.5, last);
        const Eigen::MatrixXd given =
            is_symmetric ? Eigen::MatrixXd(whole.triangularView<Eigen::Lower>()) : whole;
        REQUIRE(factor->factorise(given.sparseView()));
        CHECK(factor->n_negative() == 0);
        CHECK((factor->solve(whole * wanted) - wanted).norm() < 1e-13);
      }
    }
  }
}

TEST_CASE("factors count the directions of a negative stiffness", "[core][statics]") {
  for (const auto& factor : factors(true)) {
    const Eigen::MatrixXd lower = banded(10, -1.0, -3.0).triangularView<Eigen::Lower>();
    REQUIRE(factor->factorise(lower.sparseView()));
    CHECK(factor->n_negative() == 1);
  }
}
