// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/shared_points.hpp"

#include <algorithm>
#include <numeric>

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
  own_.clear();
  return are_shared_;
}

void SharedPoints::add(std::size_t chunk, std::span<const ContactPoint> points) {
  if (!ranks_.are_several()) return;
  n_found_[chunk] = static_cast<std::uint32_t>(points.size());
  if (are_shared_) own_.insert(own_.end(), points.begin(), points.end());
}

void SharedPoints::gather() {
  ranks_.gather_items(std::span(n_found_), begins_);
  first_point_.assign(1, 0);
  for (const std::uint32_t n : n_found_) first_point_.push_back(first_point_.back() + n);
  points_.resize(first_point_.back());
  std::ranges::copy(own_, points_.begin() + static_cast<std::ptrdiff_t>(first_point_[first_own()]));
  std::vector<std::size_t> first_of_rank;
  for (const std::size_t chunk : begins_) first_of_rank.push_back(first_point_[chunk]);
  ranks_.gather_items(std::span(points_), first_of_rank);
}

}  // namespace contactsim
