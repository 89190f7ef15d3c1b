// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "contact/mesh/pair_lists.hpp"
#include "contact/search/box_tree.hpp"
#include "contact/search/bvh_pairs.hpp"
#include "contact/search/bvh_refit.hpp"

namespace contactsim {

/// A tree over boxes in the order that FCL's BVHModel<AABB<double>> gives them. Takes about as long as three
/// searches.
///   boxes  [n] sound, n < 2^30
BoxTree make_box_tree(std::span<const Box> boxes);

/// What a broad phase has done so far, for the log.
struct BroadPhaseCounts {
  std::uint64_t builds = 0;      ///< trees built, the first one included
  std::uint64_t refits = 0;      ///< trees fitted to moved boxes
  std::uint64_t visits = 0;      ///< pairs of tree nodes looked at
  std::uint64_t overlaps = 0;    ///< pairs of boxes that overlapped
  std::uint64_t candidates = 0;  ///< those of them that were kept
};

/// Finds which boxes of a moving set meet which of its own or of another set.
class BroadPhase {
 public:
  /// Ranks must outlive it; they search together.
  explicit BroadPhase(Ranks& ranks) : ranks_(&ranks) {}
  BroadPhase() : BroadPhase(one_rank()) {}

  /// Takes the boxes as they are now: fits the tree to them, or builds it anew at the first use, when their
  /// number has changed, or when searches have come to take a fifth more visits than after the last build.
  /// Returns the number of the first box that is not sound (see is_sound); the next search needs sound ones
  /// first.
  ///   n_boxes    < 2^30
  ///   box_of(i)  box i; called from several threads at once
  template <class BoxOf>
  [[nodiscard]] std::optional<std::uint32_t> update(std::uint32_t n_boxes, const BoxOf& box_of) {
    std::optional<std::uint32_t> unsound;
    if (needs_build(n_boxes)) {
      std::vector<Box> boxes(n_boxes);
      for (std::uint32_t i = 0; i < n_boxes; ++i) boxes[i] = box_of(i);
      unsound = build(boxes);
    } else {
      unsound = refit(tree_, box_of);
      if (!unsound) note_refit();
    }
    effort_ = 0.0;
    return unsound;
  }
  /// The same of boxes by typed positions.
  template <class AnIndex, class BoxOf>
  [[nodiscard]] std::optional<AnIndex> update(IndexRange<AnIndex> boxes, const BoxOf& box_of) {
    const auto unsound =
        update(static_cast<std::uint32_t>(boxes.size()), [&](std::uint32_t i) { return box_of(AnIndex{i}); });
    return unsound ? std::optional(AnIndex{*unsound}) : std::nullopt;
  }
  /// The same of boxes that are at hand.
  [[nodiscard]] std::optional<std::uint32_t> update(std::span<const Box> boxes) {
    return update(static_cast<std::uint32_t>(boxes.size()), [&](std::uint32_t i) { return boxes[i]; });
  }

  /// Lists the partners of each of these boxes among the others: all that overlap and for which
  /// keep(row, partner) holds. Boxes closer than one part in 10^7 of their coordinates may count as
  /// overlapping unless keep looks. The result is the same for any number of threads and ranks; keep is
  /// called from several at once.
  ///   partners  another broad phase, not this one
  ///   lists     overwritten, its memory reused; a row for each of these boxes
  template <class Keep>
  void find_pairs(BroadPhase& partners, const Keep& keep, PairTable& lists) {
    assert(&partners != this);
    const auto parts = find_bvh_pairs<false>(tree_, partners.tree_, keep, *ranks_);
    list_pairs(parts, tree_.n_boxes(), lists);
    partners.note_effort(count_search(parts, lists.partners.size(), partners.tree_.n_boxes()));
  }

  /// The same among these boxes, each pair once: partners have greater numbers than their row.
  template <class Keep>
  void find_pairs(const Keep& keep, PairTable& lists) {
    const auto parts = find_bvh_pairs<true>(tree_, tree_, keep, *ranks_);
    list_pairs(parts, tree_.n_boxes(), lists);
    count_search(parts, lists.partners.size(), 0);
  }

  /// Both into lists of typed positions, which keep is asked for.
  template <class Row, class Partner, class Keep>
  void find_pairs(BroadPhase& partners, const Keep& keep, PairLists<Row, Partner>& lists) {
    PairTable& table = lists;
    find_pairs(
        partners, [&](std::uint32_t row, std::uint32_t partner) { return keep(Row{row}, Partner{partner}); },
        table);
  }
  template <class Row, class Keep>
  void find_pairs(const Keep& keep, PairLists<Row, Row>& lists) {
    PairTable& table = lists;
    find_pairs([&](std::uint32_t row, std::uint32_t partner) { return keep(Row{row}, Row{partner}); }, table);
  }

  const BroadPhaseCounts& counts() const { return counts_; }
  /// The memory of the tree [bytes].
  std::size_t bytes() const { return tree_.bytes(); }

 private:
  bool needs_build(std::uint32_t n_boxes) const {
    return counts_.builds == 0 || n_boxes != tree_.n_boxes() || is_slow();
  }
  std::optional<std::uint32_t> build(std::span<const Box> boxes);
  void note_refit();
  /// Counts what a search took, and returns its visits per box and overlap [1].
  double count_search(std::span<const FoundPairs> parts, std::size_t n_kept, std::uint32_t n_partners);
  void note_effort(double effort) { effort_ = std::max(effort_, effort); }
  bool is_slow() const;

  Ranks* ranks_;
  BoxTree tree_;
  BroadPhaseCounts counts_;
  double effort_ = 0.0;  ///< visits per box and overlap since the last update, the greatest [1]
  std::optional<double> fresh_effort_;  ///< the same of the first searches after the last build [1]
};

}  // namespace contactsim
