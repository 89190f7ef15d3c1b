// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/contact_memory.hpp"

#include <algorithm>

#include "core/state_archive.hpp"

namespace contactsim {

ContactMemory::Place ContactMemory::place_of(const ContactRecord& point) {
  std::uint32_t kind = point.first.is_node() ? 1 : 0;
  if (point.second.weights.isZero(0.0)) kind = 3;
  if (point.is_of_edges) kind = 2;
  return {kind, point.first_place, point.second_place, point.part};
}

bool ContactMemory::recall(const ContactRecord& point, Entry& found) {
  const Place wanted = place_of(point);
  const Place::Key key = wanted.key();
  if (cursor_ > 0 && !(entries_[cursor_ - 1].key() < key))
    cursor_ =
        static_cast<std::size_t>(std::ranges::lower_bound(entries_, key, {}, &Place::key) - entries_.begin());
  while (cursor_ < entries_.size() && entries_[cursor_].key() < key) ++cursor_;
  if (cursor_ < entries_.size() && entries_[cursor_].key() == key) {
    found = entries_[cursor_];
    return true;
  }
  const auto is_of_first = [&](const Place& place) {
    return place.kind == wanted.kind && place.first == wanted.first;
  };
  const auto is_of_pair = [&](const Place& place) {
    return is_of_first(place) && place.second == wanted.second;
  };
  return find_mean(is_of_pair, found) || find_mean(is_of_first, found);
}

/// The mean over area of the entries about the cursor that are of a place.
template <class IsOfPlace>
bool ContactMemory::find_mean(const IsOfPlace& is_of_place, Entry& found) const {
  std::size_t begin = cursor_, end = cursor_;
  while (begin > 0 && is_of_place(entries_[begin - 1])) --begin;
  while (end < entries_.size() && is_of_place(entries_[end])) ++end;
  if (begin == end) return false;
  found = {};
  for (std::size_t i = begin; i < end; ++i) found.area += entries_[i].area;
  for (std::size_t i = begin; i < end; ++i) {
    const double share = entries_[i].area / found.area;
    found.pressure += share * entries_[i].pressure;
    found.traction += share * entries_[i].traction;
    found.held += share * entries_[i].held;
    found.left += share * entries_[i].left;
  }
  return true;
}

void ContactMemory::remember(const ContactRecord& point, const Entry& entry) {
  entries_.push_back({place_of(point), entry});
}

void ContactMemory::end() {
  if (!std::ranges::is_sorted(entries_, {}, &Place::key)) std::ranges::stable_sort(entries_, {}, &Place::key);
  cursor_ = 0;
}

void ContactMemory::renumber(const ContactRenumbering& places) {
  constexpr std::uint32_t gone = ContactRenumbering::gone;
  std::vector<PlacedEntry> kept;
  for (PlacedEntry known : entries_) {
    const auto& first = known.kind == 0 ? places.faces : known.kind == 2 ? places.edges : places.rows;
    known.first = first[known.first];
    if (known.kind != 3) known.second = (known.kind == 2 ? places.edges : places.faces)[known.second];
    if (known.first != gone && known.second != gone) kept.push_back(known);
  }
  entries_ = std::move(kept);
  end();
}

void ContactMemory::archive(StateArchive& saved) {
  saved.rows("contact/points", entries_, [](PlacedEntry& known, RowNumbers& row) {
    row(known.kind, known.first, known.second, known.part, known.pressure, known.traction, known.held,
        known.left, known.area);
  });
  cursor_ = 0;
}

}  // namespace contactsim
