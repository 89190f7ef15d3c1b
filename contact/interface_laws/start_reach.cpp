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
  return faces_.has_any(pair) || nodes_.has_any(pair) || edges_.has_any(pair);
}

bool StartReach::may_meet_node(PairIndex pair, SurfaceNodeIndex row, FaceIndex face,
                               SurfaceIndex surface_of_row) const {
  const Limit& limit = limits_[pair];
  if (!limit.is_set()) return true;
  if (!limit.side_b) return nodes_.has(pair, row) || faces_.has(pair, face);
  return limit.side_b == surface_of_row ? nodes_.has(pair, row) : faces_.has(pair, face);
}

void StartReach::remap(const ContactRemap& remap) {
  const auto go_over = [&]<class AnIndex>(PairSet<PairIndex, AnIndex>& near,
                                          const NewPositions<AnIndex>& positions, std::size_t n_after) {
    near.remap(Unchanged{}, positions);
    IndexedVector<AnIndex, std::uint8_t> is_new(n_after, 1);
    for (const OptionalIndex<AnIndex> position : positions) {
      if (position) is_new[*position] = 0;
    }
    for (const PairIndex pair : indices(limits_)) {
      if (!limits_[pair].is_set()) continue;
      for (const AnIndex i : indices(is_new)) {
        if (is_new[i] != 0) near.add(pair, i);
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
