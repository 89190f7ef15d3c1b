// SPDX-License-Identifier: BSD-3-Clause
#include <omp.h>

#include <Eigen/Dense>

#include "core/statics/sparse_factor.hpp"
#include "support/catch.hpp"

using namespace contactsim;

namespace {

/// The stiffness of a square net of springs held at its rim, n x n nodes.
SparseFactor::Matrix net(int n, bool is_lower) {
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < n * n; ++i) {
    entries.emplace_back(i, i, 4.0);
    for (const int other : {i % n > 0 ? i - 1 : -1, i >= n ? i - n : -1}) {
      if (other < 0) continue;
      entries.emplace_back(i, other, -1.0);
      if (!is_lower) entries.emplace_back(other, i, -1.0);
    }
  }
  SparseFactor::Matrix matrix(n * n, n * n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

}  // namespace

// What factors of all kinds do is in sparse_factor_test.cpp.
TEST_CASE("MUMPS has the same bits for any number of threads, and again", "[core][statics]") {
  if (!has_mumps()) return;
  const Eigen::VectorXd right = Eigen::ArrayXd::LinSpaced(900, 0.0, 70.0).sin();
  const int n_threads = omp_get_max_threads();
  for (const bool is_symmetric : {true, false}) {
    std::vector<Eigen::VectorXd> found;
    for (const int n : {1, 2, 3}) {
      omp_set_num_threads(n);
      const auto factor = make_mumps_factor(is_symmetric);
      REQUIRE(factor->factorise(net(30, is_symmetric)));
      found.push_back(factor->solve(right));
      CHECK(factor->solve(right) == found.back());
    }
    omp_set_num_threads(n_threads);
    CHECK(found[0] == found[1]);
    CHECK(found[0] == found[2]);
    CHECK((net(30, false) * found[0] - right).norm() < 1e-12 * right.norm());
  }
}

TEST_CASE("many equations, which Scotch orders, have the same bits again, whatever was factorised before",
          "[core][statics]") {
  if (!has_mumps()) return;
  const Eigen::VectorXd right = Eigen::ArrayXd::LinSpaced(110 * 110, 0.0, 70.0).sin();
  for (const bool is_symmetric : {true, false}) {
    std::vector<Eigen::VectorXd> found;
    for (int i = 0; i < 4; ++i) {
      const auto factor = make_mumps_factor(is_symmetric);
      if (i == 2) REQUIRE(factor->factorise(net(120, is_symmetric)));
      REQUIRE(factor->factorise(net(110, is_symmetric)));
      found.push_back(factor->solve(right));
      CHECK(found.back() == found.front());
    }
  }
}

TEST_CASE("MUMPS tells a singular matrix, and takes the next one of another size", "[core][statics]") {
  if (!has_mumps()) return;
  for (const bool is_symmetric : {true, false}) {
    const auto factor = make_mumps_factor(is_symmetric);
    SparseFactor::Matrix singular(3, 3);
    singular.insert(0, 0) = 1.0;
    singular.insert(2, 2) = 1.0;
    singular.insert(1, 1) = 0.0;
    CHECK_FALSE(factor->factorise(singular));
    REQUIRE(factor->factorise(net(4, is_symmetric)));
    const Eigen::VectorXd right = Eigen::VectorXd::Ones(16);
    CHECK((net(4, false) * factor->solve(right) - right).norm() < 1e-13);
  }
}

TEST_CASE("only a symmetric factor counts negative directions", "[core][statics]") {
  if (!has_mumps()) return;
  const SparseFactor::Matrix negative = -1.0 * net(3, false);
  const auto symmetric = make_mumps_factor(true), general = make_mumps_factor(false);
  REQUIRE(symmetric->factorise(SparseFactor::Matrix(negative.triangularView<Eigen::Lower>())));
  REQUIRE(general->factorise(negative));
  CHECK(symmetric->n_negative() == 9);
  CHECK(general->n_negative() == 0);
}
