// SPDX-License-Identifier: BSD-3-Clause
#include "contact/formulations/contact_multipliers.hpp"

#include "core/base/state_archive.hpp"

namespace contactsim {

void ContactMultipliers::set(std::vector<Entry> entries) {
  entries_ = std::move(entries);
  std::ranges::sort(entries_, {}, key);
}

void ContactMultipliers::remap(const ContactRemap& remap) {
  std::vector<Entry> kept;
  for (Entry entry : entries_) {
    const OptionalIndex<SurfaceNodeIndex> row = remap.rows[entry.row];
    if (!row) continue;
    entry.row = *row;
    kept.push_back(entry);
  }
  set(std::move(kept));
}

void ContactMultipliers::archive(StateArchive& saved) {
  // Explicit runs have none, and their states nothing of them.
  const bool has_any = saved.restores() ? saved.has("contact/multipliers") : !entries_.empty();
  if (!has_any) return;
  saved.rows("contact/multipliers", entries_,
             [](Entry& entry, RowNumbers& row) { row(entry.pair.value, entry.row.value, entry.depth); });
  if (saved.restores()) set(std::move(entries_));
}

}  // namespace contactsim
