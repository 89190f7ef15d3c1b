// SPDX-License-Identifier: BSD-3-Clause
#include "contact/search/broad_phase.hpp"

#include <algorithm>

namespace contactsim {

std::optional<std::uint32_t> BroadPhase::build(std::span<const Box> boxes) {
  const auto unsound = std::find_if_not(boxes.begin(), boxes.end(), is_sound);
  if (unsound != boxes.end()) return static_cast<std::uint32_t>(unsound - boxes.begin());
  tree_ = make_box_tree(boxes);
  ++counts_.builds;
  fresh_effort_.reset();
  return std::nullopt;
}

void BroadPhase::note_refit() {
  ++counts_.refits;
  if (!fresh_effort_ && effort_ > 0.0) fresh_effort_ = effort_;
}

bool BroadPhase::is_slow() const {
  // A build takes as long as some forty visits to every box; searches that visit fewer pairs than there are
  // boxes, as between bodies apart, are never worth one.
  constexpr double growth = 1.2, min_effort = 1.0;
  return fresh_effort_ && effort_ > growth * std::max(*fresh_effort_, min_effort);
}

double BroadPhase::count_search(std::span<const FoundPairs> parts, std::size_t n_kept,
                                std::uint32_t n_partners) {
  std::uint64_t visits = 0, overlaps = 0;
  for (const FoundPairs& part : parts) {
    visits += part.visits;
    overlaps += part.overlaps;
  }
  counts_.visits += visits;
  counts_.overlaps += overlaps;
  counts_.candidates += n_kept;
  const std::uint64_t n_asked = tree_.n_boxes() + n_partners + overlaps;
  const double effort = n_asked > 0 ? static_cast<double>(visits) / static_cast<double>(n_asked) : 0.0;
  note_effort(effort);
  return effort;
}

}  // namespace contactsim
