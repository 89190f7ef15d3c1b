// SPDX-License-Identifier: BSD-3-Clause
#include "support/moving_boxes.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace contactsim::test {

MovingBoxes::MovingBoxes(std::uint32_t n, std::uint32_t seed) : boxes_(n), velocities_(n) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(0.0, 1.0), size(0.0, 0.2), speed(-0.05, 0.05);
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      boxes_[i].lo[axis] = place(random);
      boxes_[i].hi[axis] = boxes_[i].lo[axis] + size(random);
      velocities_[i][axis] = speed(random);
    }
  }
}

void MovingBoxes::step() {
  for (std::size_t i = 0; i < boxes_.size(); ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      double& lo = boxes_[i].lo[axis];
      double& hi = boxes_[i].hi[axis];
      const double move = velocities_[i][axis] - std::floor(lo + velocities_[i][axis]);
      lo += move;
      hi += move;
    }
  }
}

PairTable sweep(const std::vector<contactsim::Box>& rows, const std::vector<contactsim::Box>& partners) {
  PairTable lists;
  for (const contactsim::Box& row : rows) {
    for (std::uint32_t j = 0; j < partners.size(); ++j) {
      if (do_overlap(row, partners[j])) lists.partners.push_back(j);
    }
    lists.begin.push_back(lists.partners.size());
  }
  return lists;
}

PairTable sweep(const std::vector<contactsim::Box>& boxes) {
  PairTable lists;
  for (std::uint32_t i = 0; i < boxes.size(); ++i) {
    for (std::uint32_t j = i + 1; j < boxes.size(); ++j) {
      if (do_overlap(boxes[i], boxes[j])) lists.partners.push_back(j);
    }
    lists.begin.push_back(lists.partners.size());
  }
  return lists;
}

PairTable in_rows(std::vector<RowPartner> pairs, std::size_t n_rows) {
  std::sort(pairs.begin(), pairs.end(), [](const RowPartner& a, const RowPartner& b) {
    return std::tie(a.row, a.partner) < std::tie(b.row, b.partner);
  });
  PairTable lists;
  std::size_t next = 0;
  for (std::uint32_t row = 0; row < n_rows; ++row) {
    for (; next < pairs.size() && pairs[next].row == row; ++next)
      lists.partners.push_back(pairs[next].partner);
    lists.begin.push_back(lists.partners.size());
  }
  return lists;
}

}  // namespace contactsim::test
