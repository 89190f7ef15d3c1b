// SPDX-License-Identifier: BSD-3-Clause
#include "core/statics/multigrid/row_share.hpp"

#include <stdexcept>

#include "support/catch.hpp"
#include "support/thread_ranks.hpp"

using namespace contactsim;
using contactsim::test::ThreadRanks;

namespace {

/// [n_rows + 1] of rows that have more blocks the later they come.
std::vector<std::size_t> growing_rows(std::size_t n_rows) {
  std::vector<std::size_t> first{0};
  for (std::size_t row = 0; row < n_rows; ++row) first.push_back(first.back() + row % 100 + row / 100);
  return first;
}

/// How often ranks work out each row, and what all of them know then.
std::vector<double> work_out(int n_ranks, const std::vector<std::size_t>& first) {
  const auto n = static_cast<Eigen::Index>(first.size() - 1);
  std::vector<int> n_times(static_cast<std::size_t>(n_ranks) * first.size(), 0);
  Eigen::VectorXd known;
  ThreadRanks(n_ranks).run([&](Ranks& ranks) {
    const RowShare share(first, ranks);
    Eigen::VectorXd x = Eigen::VectorXd::Constant(2 * n, -1.0);
    share.for_rows([&](std::uint32_t row) {
      ++n_times[static_cast<std::size_t>(ranks.rank()) * first.size() + row];
      x(2 * row) = row;
      x(2 * row + 1) = 0.5;
    });
    share.part<2>(x) *= 3.0;
    share.gather<2>(x);
    for (Eigen::Index row = 0; row < n; ++row) {
      if (x(2 * row) != 3.0 * static_cast<double>(row) || x(2 * row + 1) != 1.5)
        throw std::logic_error("a rank does not know a row");
    }
  });
  std::vector<double> sums(first.size() - 1, 0.0);
  for (std::size_t i = 0; i < n_times.size(); ++i) {
    if (i % first.size() < sums.size()) sums[i % first.size()] += n_times[i];
  }
  return sums;
}

}  // namespace

TEST_CASE("each row of a large matrix is worked out by one rank, and known to all", "[core][statics]") {
  const std::vector<std::size_t> first = growing_rows(1000);
  for (const int n_ranks : {2, 3, 7}) CHECK(work_out(n_ranks, first) == std::vector<double>(1000, 1.0));
}

TEST_CASE("all ranks work out all rows of a small matrix, and of one that is empty", "[core][statics]") {
  CHECK(work_out(3, growing_rows(50)) == std::vector<double>(50, 3.0));
  CHECK(work_out(2, {0}).empty());
}

TEST_CASE("more ranks than rows leave some without any", "[core][statics]") {
  CHECK(work_out(7, {0, 30000, 60000}) == std::vector<double>(2, 1.0));
}
