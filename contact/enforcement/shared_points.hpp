// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "contact/geometry/contact_point.hpp"
#include "core/parallel/ranks.hpp"

namespace contactsim {

/// The contact points of a formulation, which several ranks detect together: each those of some chunks of
/// rows that follow each other, about as many as any other rank by what the last detection has found. All
/// ranks have all of them then, in the order of the rows, with the bits of one process.
class SharedPoints {
 public:
  /// Ranks must outlive it.
  explicit SharedPoints(Ranks& ranks) : ranks_(ranks) {}

  /// Begins a detection of chunks of rows. Returns whether ranks share it: not where there is one rank alone,
  /// or so little to detect that telling the others takes longer.
  bool begin(std::size_t n_chunks);
  /// The chunks of this rank.
  std::size_t first_own() const { return begins_[rank()]; }
  std::size_t end_own() const { return begins_[rank() + 1]; }
  /// Takes what was found in a chunk, those of this rank in their order; of all, where they are not shared.
  void add(std::size_t chunk, std::span<const ContactPoint> points);
  /// Sends them to all ranks, and gets theirs.
  void gather();
  std::span<const ContactPoint> of(std::size_t chunk) const {
    return std::span(points_).subspan(first_point_[chunk], n_found_[chunk]);
  }

 private:
  std::size_t rank() const { return static_cast<std::size_t>(ranks_.rank()); }
  void move_own(std::size_t begin);

  Ranks& ranks_;
  bool are_shared_ = false;
  std::vector<std::uint32_t> n_found_;    // [n_chunks] in the last detection
  std::vector<std::size_t> begins_;       // [n_ranks + 1] chunks
  std::vector<std::size_t> first_point_;  // [n_chunks + 1] in points_
  std::vector<ContactPoint> points_;
  std::size_t own_begin_ = 0, own_end_ = 0;  // in points_, where those of this rank are likely to be
};

}  // namespace contactsim
