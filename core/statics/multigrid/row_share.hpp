// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/threads.hpp"
#include "core/parallel/equal_shares.hpp"
#include "core/parallel/ranks.hpp"

namespace contactsim {

/// The block rows of a matrix, or its columns, that a rank works out: of large ones a range of about equal
/// work, of small ones all. A row is worked out by one rank in a fixed order: the same bits for any number.
class RowShare {
 public:
  /// All rows of a matrix without any.
  RowShare() = default;
  ///   first  [n_rows + 1] of a row's blocks
  ///   ranks  must outlive it
  RowShare(std::span<const std::size_t> first, Ranks& ranks)
      : end_(first.size() - 1), n_blocks_(first.back()) {
    if (!ranks.are_several() || n_blocks_ < least_blocks) return;
    std::vector<double> costs;
    for (std::size_t row = 0; row + 1 < first.size(); ++row)
      costs.push_back(static_cast<double>(first[row + 1] - first[row]));
    begins_ = equal_shares(costs, ranks.count());
    begin_ = begins_[static_cast<std::size_t>(ranks.rank())];
    end_ = begins_[static_cast<std::size_t>(ranks.rank()) + 1];
    ranks_ = &ranks;
  }

  /// Calls function(row) for those that are worked out here.
  template <class Function>
  void for_rows(const Function& function) const {
    parallel_for(end_ - begin_, threads_for(n_blocks_),
                 [&](std::size_t i) { function(static_cast<std::uint32_t>(begin_ + i)); });
  }

  /// Their part of a vector.
  ///   N  numbers of a row
  template <int N, class Vector>
  auto part(Vector& x) const {
    return x.segment(N * static_cast<Eigen::Index>(begin_), N * static_cast<Eigen::Index>(end_ - begin_));
  }

  /// Has all ranks know all of a vector, of which each has worked out the part of its rows.
  template <int N>
  void gather(Eigen::VectorXd& x) const {
    if (ranks_ == nullptr) return;
    std::vector<std::size_t> begins;
    for (const std::size_t begin : begins_) begins.push_back(std::size_t{N} * begin);
    ranks_->gather_items(std::span(x.data(), static_cast<std::size_t>(x.size())), begins);
  }

 private:
  /// A product with so many 3 x 3 blocks takes ten times what ranks of one machine need to gather its result.
  static constexpr std::size_t least_blocks = 20000;

  std::size_t begin_ = 0, end_ = 0;
  std::size_t n_blocks_ = 0;         // of all rows
  std::vector<std::size_t> begins_;  // [n_ranks + 1]
  Ranks* ranks_ = nullptr;           // null where all rows are worked out here
};

}  // namespace contactsim
