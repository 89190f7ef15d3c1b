// SPDX-License-Identifier: BSD-3-Clause
#include "contact/search/search_share.hpp"

#include <algorithm>

namespace contactsim {

namespace {

/// From so many boxes on a search, of some 0.3 us a box, takes longer than two messages to all.
constexpr std::size_t least_shared = 1000;

/// What a rank says of its parts.
struct Found {
  std::size_t n_pairs = 0;
  std::uint64_t visits = 0, overlaps = 0;
};

}  // namespace

SearchShare::SearchShare(Ranks& ranks, std::size_t n_boxes)
    : ranks_(ranks), is_shared_(ranks.are_several() && n_boxes >= least_shared) {}

std::vector<FoundPairs> SearchShare::gather(std::vector<FoundPairs> own) const {
  if (!is_shared_) return own;
  Found found;
  for (const FoundPairs& part : own) {
    found.n_pairs += part.pairs.size();
    found.visits += part.visits;
    found.overlaps += part.overlaps;
  }
  const std::vector<Found> of_ranks = ranks_.of_all(found);
  std::vector<std::size_t> begins{0};
  for (const Found& of_rank : of_ranks) begins.push_back(begins.back() + of_rank.n_pairs);
  std::vector<FoundPairs> all(1);
  all[0].pairs.resize(begins.back());
  auto next =
      all[0].pairs.begin() + static_cast<std::ptrdiff_t>(begins[static_cast<std::size_t>(ranks_.rank())]);
  for (const FoundPairs& part : own) next = std::ranges::copy(part.pairs, next).out;
  ranks_.gather_items(std::span(all[0].pairs), begins);
  for (const Found& of_rank : of_ranks) {
    all[0].visits += of_rank.visits;
    all[0].overlaps += of_rank.overlaps;
  }
  return all;
}

}  // namespace contactsim
