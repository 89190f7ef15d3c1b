// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/shared_points.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "core/parallel/equal_shares.hpp"

namespace contactsim {

namespace {

/// What a chunk of rows costs in which nothing is near, in contact points: an estimate, 10 ns for each of its
/// rows where a pair of faces takes 1.3 us (measured, two blocks of 48^3).
constexpr double empty_chunk = 2.0;

/// From so many contact points on a detection takes longer than two messages to all, of some 20 us each.
constexpr double least_shared = 32.0;

}  // namespace

bool SharedPoints::begin(std::size_t n_chunks) {
  are_shared_ = false;
  if (!ranks_.are_several()) return false;
  n_found_.resize(n_chunks, 0);
  std::vector<double> costs(n_found_.begin(), n_found_.end());
  for (double& cost : costs) cost += empty_chunk;
  are_shared_ = std::accumulate(costs.begin(), costs.end(), 0.0) >= least_shared;
  begins_ = equal_shares(costs, ranks_.count());
  const auto n_before = n_found_.begin() + static_cast<std::ptrdiff_t>(first_own());
  own_begin_ = own_end_ = std::accumulate(n_found_.begin(), n_before, std::size_t{0});
  return are_shared_;
}

void SharedPoints::add(std::size_t chunk, std::span<const ContactPoint> points) {
  if (!ranks_.are_several()) return;
  n_found_[chunk] = static_cast<std::uint32_t>(points.size());
  if (!are_shared_) return;
  const std::size_t begin = std::exchange(own_end_, own_end_ + points.size());
  if (points_.size() < own_end_) points_.resize(own_end_);
  std::ranges::copy(points, points_.begin() + static_cast<std::ptrdiff_t>(begin));
}

/// Chunks before those of this rank may have found more or less than in the last detection.
///   begin  where its points belong
void SharedPoints::move_own(std::size_t begin) {
  if (begin == own_begin_) return;
  const std::size_t end = begin + (own_end_ - own_begin_);
  if (points_.size() < end) points_.resize(end);
  const auto at = [this](std::size_t i) { return points_.begin() + static_cast<std::ptrdiff_t>(i); };
  if (begin < own_begin_) {
    std::copy(at(own_begin_), at(own_end_), at(begin));
  } else {
    std::copy_backward(at(own_begin_), at(own_end_), at(end));
  }
}

void SharedPoints::gather() {
  ranks_.gather_items(std::span(n_found_), begins_);
  first_point_.assign(1, 0);
  for (const std::uint32_t n : n_found_) first_point_.push_back(first_point_.back() + n);
  move_own(first_point_[first_own()]);
  points_.resize(first_point_.back());
  std::vector<std::size_t> first_of_rank;
  for (const std::size_t chunk : begins_) first_of_rank.push_back(first_point_[chunk]);
  ranks_.gather_items(std::span(points_), first_of_rank);
}

}  // namespace contactsim
