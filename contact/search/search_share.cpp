// SPDX-License-Identifier: BSD-3-Clause
#include "contact/search/search_share.hpp"

#include <array>

namespace contactsim {

namespace {

/// From so many boxes on a search, of some 0.3 us a box, takes longer than two messages to all.
constexpr std::size_t least_shared = 1000;

}  // namespace

SearchShare::SearchShare(Ranks& ranks, std::size_t n_boxes)
    : ranks_(ranks), is_shared_(ranks.are_several() && n_boxes >= least_shared) {}

std::vector<FoundPairs> SearchShare::gather(std::vector<FoundPairs> own) const {
  if (!is_shared_) return own;
  FoundPairs found;
  for (const FoundPairs& part : own) {
    found.pairs.insert(found.pairs.end(), part.pairs.begin(), part.pairs.end());
    found.visits += part.visits;
    found.overlaps += part.overlaps;
  }
  std::vector<FoundPairs> all(1);
  all[0].pairs = ranks_.join(found.pairs);
  for (const auto& [visits, overlaps] : ranks_.of_all(std::array{found.visits, found.overlaps})) {
    all[0].visits += visits;
    all[0].overlaps += overlaps;
  }
  return all;
}

}  // namespace contactsim
