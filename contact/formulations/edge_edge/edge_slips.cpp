// SPDX-License-Identifier: BSD-3-Clause
#include "contact/formulations/edge_edge/edge_slips.hpp"

#include <algorithm>
#include <cassert>

#include "core/base/state_archive.hpp"

namespace contactsim {

Eigen::Vector3d EdgeSlips::find(const Place& place) const {
  const auto found = std::ranges::lower_bound(entries_, place, {}, &Entry::place);
  return found != entries_.end() && found->place == place ? found->slip : Eigen::Vector3d(0.0, 0.0, 0.0);
}

void EdgeSlips::add(const Place& place, const Eigen::Vector3d& slip) {
  assert(entries_.empty() || entries_.back().place < place);
  if (!slip.isZero(0.0)) entries_.push_back({place, slip});
}

void EdgeSlips::remap(const ContactRemap& remap) {
  std::vector<Entry> kept;
  for (const Entry& entry : entries_) {
    const auto first = remap.edges[entry.place.first], second = remap.edges[entry.place.second];
    if (first && second && *first < *second)
      kept.push_back({{*first, *second, entry.place.part}, entry.slip});
  }
  std::ranges::sort(kept, {}, &Entry::place);
  entries_ = std::move(kept);
}

void EdgeSlips::archive(StateArchive& saved) {
  saved.rows("contact/edges/elastic_slip", entries_, [](Entry& entry, RowNumbers& row) {
    row(entry.place.first, entry.place.second, entry.place.part, entry.slip);
  });
}

}  // namespace contactsim
