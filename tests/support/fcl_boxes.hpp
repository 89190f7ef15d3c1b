// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "contact/mesh/pair_lists.hpp"
#include "contact/search/box_tree.hpp"

namespace contactsim::test {

/// Boxes in FCL's own broad phase, DynamicAABBTreeCollisionManager<double>: the second opinion on ours, and
/// what it is timed against.
class [[gnu::visibility("default")]] FclBoxes {
 public:
  explicit FclBoxes(std::span<const contactsim::Box> boxes);
  ~FclBoxes();
  FclBoxes(const FclBoxes&) = delete;
  FclBoxes& operator=(const FclBoxes&) = delete;

  /// Puts the same boxes at new places, for queries one by one.
  void move(std::span<const contactsim::Box> boxes);
  /// The same, and fits the tree to them.
  void update(std::span<const contactsim::Box> boxes);

  /// Adds the overlapping pairs of two sets, both trees descended together; in any order.
  void collide(const FclBoxes& partners, std::vector<RowPartner>& pairs) const;
  /// The same, one query for each of these boxes.
  void collide_one_by_one(const FclBoxes& partners, std::vector<RowPartner>& pairs) const;
  /// Adds the overlapping pairs among these boxes, each once, the smaller number first; in any order.
  void collide_self(std::vector<RowPartner> & pairs) const;

 private:
  struct Objects;
  std::unique_ptr<Objects> objects_;
};

}  // namespace contactsim::test
