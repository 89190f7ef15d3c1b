// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "contact/mesh/contact_remap.hpp"
#include "core/base/contact_indices.hpp"
#include "core/base/state_archive.hpp"

namespace contactsim {

/// Values of surface nodes, each in a pair of surfaces.
template <class Value>
class PairNodeValues {
 public:
  struct Entry {
    PairIndex pair;
    SurfaceNodeIndex row;
    Value value;
  };

  bool empty() const { return entries_.empty(); }
  Value value_or(PairIndex pair, SurfaceNodeIndex row, const Value& otherwise) const {
    const Value* found = find(pair, row);
    return found == nullptr ? otherwise : *found;
  }
  /// Takes these instead, none twice.
  void set(std::vector<Entry> entries) {
    entries_ = std::move(entries);
    std::ranges::sort(entries_, {}, key);
  }
  /// Goes over to other surface nodes.
  void remap(const ContactRemap& remap) {
    std::vector<Entry> kept;
    for (Entry entry : entries_) {
      const OptionalIndex<SurfaceNodeIndex> row = remap.rows[entry.row];
      if (!row) continue;
      entry.row = *row;
      kept.push_back(entry);
    }
    set(std::move(kept));
  }
  /// States without values have nothing of them.
  void archive(const std::string& name, StateArchive& saved) {
    const bool has_any = saved.restores() ? saved.has(name) : !entries_.empty();
    if (!has_any) return;
    saved.rows(name, entries_,
               [](Entry& entry, RowNumbers& row) { row(entry.pair.value, entry.row.value, entry.value); });
    if (saved.restores()) set(std::move(entries_));
  }

 private:
  /// Null without one.
  const Value* find(PairIndex pair, SurfaceNodeIndex row) const {
    const auto found = std::ranges::lower_bound(entries_, key_of(pair, row), {}, key);
    return found != entries_.end() && key(*found) == key_of(pair, row) ? &found->value : nullptr;
  }
  static std::uint64_t key_of(PairIndex pair, SurfaceNodeIndex row) {
    return (std::uint64_t{pair.value} << 32) | row.value;
  }
  static std::uint64_t key(const Entry& entry) { return key_of(entry.pair, entry.row); }

  std::vector<Entry> entries_;  // by pair and row
};

}  // namespace contactsim
