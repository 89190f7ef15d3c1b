// SPDX-License-Identifier: BSD-3-Clause
#include "contact/interface_laws/start_reach.hpp"

#include <cstdint>

#include "core/base/state_archive.hpp"

namespace contactsim {

StartReach::StartReach(const SurfacePairs& pairs) : limits_(pairs.size()) {
  for (const PairIndex i : indices(pairs)) {
    exists_ = exists_ || pairs[i].search_distance;
    if (pairs[i].first != pairs[i].second) limits_[i].side_b = pairs[i].side_b;
  }
}

bool StartReach::has_any(PairIndex pair) const {
  return faces_.has_any(pair.value) || nodes_.has_any(pair.value) || edges_.has_any(pair.value);
}

bool StartReach::may_meet(PairIndex pair, const PairSet& near, std::uint32_t first, std::uint32_t second,
                          std::uint32_t surface_of_first) const {
  const Limit& limit = limits_[pair];
  if (!limit.is_set()) return true;
  if (!limit.side_b) return near.has(pair.value, first) || near.has(pair.value, second);
  return near.has(pair.value, limit.side_b == surface_of_first ? first : second);
}

bool StartReach::may_meet_node(PairIndex pair, std::uint32_t row, std::uint32_t face,
                               std::uint32_t surface_of_row) const {
  const Limit& limit = limits_[pair];
  if (!limit.is_set()) return true;
  if (!limit.side_b) return nodes_.has(pair.value, row) || faces_.has(pair.value, face);
  return limit.side_b == surface_of_row ? nodes_.has(pair.value, row) : faces_.has(pair.value, face);
}

void StartReach::remap(const ContactRemap& remap) {
  const auto go_over = [&](PairSet& near, std::span<const OptionalIndex<std::uint32_t>> positions,
                           std::size_t n_after) {
    near.remap({}, positions);
    std::vector<std::uint8_t> is_new(n_after, 1);
    for (const OptionalIndex<std::uint32_t> position : positions) {
      if (position) is_new[*position] = 0;
    }
    for (const PairIndex pair : indices(limits_)) {
      if (!limits_[pair].is_set()) continue;
      for (std::uint32_t i = 0; i < n_after; ++i) {
        if (is_new[i] != 0) near.add(pair.value, i);
      }
    }
  };
  if (!exists_) return;
  go_over(faces_, remap.faces, remap.n_faces_after);
  go_over(nodes_, remap.rows, remap.n_rows_after);
  go_over(edges_, remap.edges, remap.n_edges_after);
}

void StartReach::archive(StateArchive& saved) {
  if (!exists_) return;
  saved.fixed_rows("contact/start_reach/distance", limits_,
                   [](Limit& limit, RowNumbers& row) { row(limit.distance); });
  faces_.archive("contact/start_reach/faces", saved);
  nodes_.archive("contact/start_reach/nodes", saved);
  edges_.archive("contact/start_reach/edges", saved);
}

}  // namespace contactsim
