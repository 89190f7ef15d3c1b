// SPDX-License-Identifier: BSD-3-Clause
#include "core/statics/multigrid/multigrid.hpp"

#include <omp.h>

#include "support/block_products.hpp"
#include "support/catch.hpp"
#include "support/elastic_grid.hpp"
#include "support/thread_ranks.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

Eigen::VectorXd some_vector(Eigen::Index size, double frequency) {
  return (frequency * Eigen::ArrayXd::LinSpaced(size, 0.0, static_cast<double>(size))).sin();
}

/// Conjugate gradients to 1e-6 of the load. Returns the iterations.
int solve(const ElasticGrid& grid, const BlockMatrix<3, 3>& matrix, const Preconditioner& preconditioner,
          Eigen::VectorXd& x) {
  Eigen::VectorXd left = grid.load(), z, product;
  const double target = 1e-6 * left.norm();
  x = Eigen::VectorXd::Zero(left.size());
  preconditioner.apply(left, z);
  Eigen::VectorXd direction = z;
  double z_left = z.dot(left);
  int n = 0;
  for (; left.norm() > target && n < 400; ++n) {
    multiply(matrix, direction, product);
    const double way = z_left / direction.dot(product);
    x += way * direction;
    left -= way * product;
    preconditioner.apply(left, z);
    const double now = z.dot(left);
    direction = z + now / z_left * direction;
    z_left = now;
  }
  return n;
}

int iterations(const ElasticGrid& grid) {
  const BlockMatrix<3, 3> matrix = grid.stiffness();
  const Multigrid multigrid(matrix, grid.modes());
  Eigen::VectorXd x;
  return solve(grid, matrix, multigrid, x);
}

}  // namespace

TEST_CASE("a V-cycle is symmetric and positive", "[core][statics]") {
  const ElasticGrid grid{.cells = {9, 7, 8}};
  const BlockMatrix<3, 3> matrix = grid.stiffness();
  const Multigrid multigrid(matrix, grid.modes());
  REQUIRE(multigrid.n_levels() == 2);
  const Eigen::Index size = 3 * Eigen::Index{grid.n_nodes()};
  for (const double frequency : {0.01, 0.3, 2.9}) {
    const Eigen::VectorXd a = some_vector(size, frequency), b = some_vector(size, 1.7 * frequency);
    Eigen::VectorXd of_a, of_b;
    multigrid.apply(a, of_a);
    multigrid.apply(b, of_b);
    CHECK(a.dot(of_a) > 0.0);
    CHECK(std::abs(a.dot(of_b) - b.dot(of_a)) < 1e-10 * a.norm() * of_b.norm());
  }
}

TEST_CASE("coarse levels can move a free body rigidly, without energy", "[core][statics]") {
  const ElasticGrid grid{.cells = {6, 5, 7}, .is_held = false};
  const BlockMatrix<3, 3> matrix = grid.stiffness();
  const Modes modes = grid.modes();
  const Multigrid multigrid(matrix, modes);
  for (Eigen::Index i = 0; i < 6; ++i) {
    Eigen::VectorXd moved, force;
    multiply(multigrid.prolongator(), Eigen::VectorXd(multigrid.coarse_modes().col(i)), moved);
    CHECK((moved - modes.col(i)).norm() < 1e-10 * modes.col(i).norm());
    multiply(matrix, moved, force);
    CHECK(std::abs(moved.dot(force)) < 1e-12 * moved.squaredNorm());
  }
}

TEST_CASE("iterations of a V-cycle do not grow with the mesh", "[core][statics]") {
  const int coarse = iterations({.cells = {8, 8, 8}}), fine = iterations({.cells = {16, 16, 16}});
  CHECK(coarse <= 12);
  CHECK(fine <= coarse + 2);
}

TEST_CASE("three levels take hardly more iterations than two", "[core][statics]") {
  const ElasticGrid bar{.cells = {60, 5, 5}}, longer{.cells = {240, 5, 5}};
  const BlockMatrix<3, 3> matrix = bar.stiffness(), longer_matrix = longer.stiffness();
  const Multigrid two(matrix, bar.modes()), three(longer_matrix, longer.modes());
  REQUIRE(two.n_levels() == 2);
  REQUIRE(three.n_levels() == 3);
  Eigen::VectorXd x;
  CHECK(solve(longer, longer_matrix, three, x) <= solve(bar, matrix, two, x) + 2);
}

TEST_CASE("nearly incompressible and stretched solids are solved too", "[core][statics]") {
  CHECK(iterations({.cells = {8, 8, 8}, .poisson = 0.49}) < 60);
  CHECK(iterations({.cells = {8, 8, 8}, .poisson = 0.499}) < 200);
  CHECK(iterations({.cells = {8, 8, 8}, .cell_size = {10.0, 1.0, 1.0}}) < 60);
  CHECK(iterations({.cells = {8, 8, 8}, .cell_size = {0.1, 1.0, 1.0}}) < 120);
}

TEST_CASE("lines, sheets and single elements are no exception", "[core][statics]") {
  CHECK(iterations({.cells = {1, 1, 1}}) < 15);
  CHECK(iterations({.cells = {1, 1, 40}}) < 60);
  CHECK(iterations({.cells = {30, 30, 1}}) < 15);
}

TEST_CASE("a V-cycle has the same bits with one thread and two", "[core][statics]") {
  const ElasticGrid grid{.cells = {14, 14, 14}};
  const BlockMatrix<3, 3> matrix = grid.stiffness();
  const int n_threads = omp_get_max_threads();
  Eigen::VectorXd x[2];
  for (const int n : {1, 2}) {
    omp_set_num_threads(n);
    const Multigrid multigrid(matrix, grid.modes());
    multigrid.apply(grid.load(), x[n - 1]);
  }
  omp_set_num_threads(n_threads);
  CHECK(threads_for(matrix.n_blocks()) == std::min(n_threads, 9));
  CHECK(x[0] == x[1]);
}

TEST_CASE("ranks that share the rows of a V-cycle have the bits of one process", "[core][statics]") {
  const ElasticGrid grid{.cells = {14, 14, 14}};
  const BlockMatrix<3, 3> matrix = grid.stiffness();
  Eigen::VectorXd alone;
  const Multigrid of_one(matrix, grid.modes());
  of_one.apply(grid.load(), alone);
  for (const int count : {2, 3, 7}) {
    CAPTURE(count);
    std::vector<Eigen::VectorXd> x(static_cast<std::size_t>(count));
    ThreadRanks(count).run([&](Ranks& ranks) {
      const Multigrid multigrid(matrix, grid.modes(), ranks);
      multigrid.apply(grid.load(), x[static_cast<std::size_t>(ranks.rank())]);
    });
    for (const Eigen::VectorXd& of_rank : x) CHECK(of_rank == alone);
  }
}

TEST_CASE("nodes without elements stay where they are", "[core][statics]") {
  const ElasticGrid grid{.cells = {3, 3, 3}};
  BlockMatrix<3, 3> matrix = grid.stiffness();
  matrix.first.push_back(matrix.first.back());
  ++matrix.n_columns;
  Modes modes = Modes::Zero(3 * Eigen::Index{matrix.n_rows()}, 6);
  modes.topRows(modes.rows() - 3) = grid.modes();
  const Multigrid multigrid(matrix, modes);
  Eigen::VectorXd z;
  multigrid.apply(Eigen::VectorXd::Ones(modes.rows()), z);
  CHECK(z.tail<3>().isZero(0.0));
  CHECK(z.allFinite());
}
