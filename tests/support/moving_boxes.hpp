// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "contact/mesh/pair_lists.hpp"
#include "contact/search/box_tree.hpp"

namespace contactsim::test {

/// Boxes of quads and triangles of random size that fly about in a cube, on numbers that no float can hold.
class MovingBoxes {
 public:
  /// The same seed gives the same boxes.
  MovingBoxes(std::uint32_t n, std::uint32_t seed);

  /// Moves every box by its own velocity; those that leave the cube come back in.
  void step();
  const std::vector<contactsim::Box>& boxes() const { return boxes_; }

 private:
  std::vector<contactsim::Box> boxes_;
  std::vector<std::array<double, 3>> velocities_;
};

/// The overlapping pairs of all rows with all partners, one test each.
PairTable sweep(const std::vector<contactsim::Box>& rows, const std::vector<contactsim::Box>& partners);

/// The overlapping pairs among the boxes, each once, partners with the greater number.
PairTable sweep(const std::vector<contactsim::Box>& boxes);

/// Pairs in any order as lists.
PairTable in_rows(std::vector<RowPartner> pairs, std::size_t n_rows);

}  // namespace contactsim::test
