// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/contact_history.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/base/state_archive.hpp"
#include "core/base/threads.hpp"

namespace contactsim {

ContactHistory::PointId ContactHistory::id_of(const ContactPoint& point) {
  std::uint32_t kind = point.first.is_node() ? 1 : 0;
  if (point.second.weights.isZero(0.0)) kind = 3;
  if (point.is_of_edges) kind = 2;
  return {kind, point.first_entity, point.second_entity, point.part};
}

bool ContactHistory::recall(const PointId& wanted, Entry& found) {
  const PointId::Key key = wanted.key();
  if (cursor_ > 0 && !(entries_[cursor_ - 1].key() < key))
    cursor_ = static_cast<std::size_t>(std::ranges::lower_bound(entries_, key, {}, &PointId::key) -
                                       entries_.begin());
  while (cursor_ < entries_.size() && entries_[cursor_].key() < key) ++cursor_;
  if (cursor_ < entries_.size() && entries_[cursor_].key() == key && entries_[cursor_].is_known()) {
    found = entries_[cursor_];
    return true;
  }
  const auto is_of_first = [&](const PointId& id) {
    return id.kind == wanted.kind && id.first == wanted.first;
  };
  const auto is_of_pair = [&](const PointId& id) { return is_of_first(id) && id.second == wanted.second; };
  if (find_mean(is_of_pair, found)) return true;
  // What load steps have pressed is known of these two alone: what else is before the first may be apart.
  const bool is_of_load_steps = !entries_.empty() && std::isnan(entries_.front().zero_gap);
  return !is_of_load_steps && find_mean(is_of_first, found);
}

/// The mean over area of the entries about the cursor that are wanted.
template <class IsWanted>
bool ContactHistory::find_mean(const IsWanted& is_wanted, Entry& found) const {
  std::size_t begin = cursor_, end = cursor_;
  while (begin > 0 && is_wanted(entries_[begin - 1])) --begin;
  while (end < entries_.size() && is_wanted(entries_[end])) ++end;
  double area = 0.0;
  for (std::size_t i = begin; i < end; ++i) area += entries_[i].area;
  if (!(area > 0.0)) return false;
  found = {};
  found.area = area;
  for (std::size_t i = begin; i < end; ++i) {
    const double share = entries_[i].area / found.area;
    found.pressure += share * entries_[i].pressure;
    found.traction += share * entries_[i].traction;
    found.held += share * entries_[i].held;
    found.left += share * entries_[i].left;
    found.zero_gap += share * entries_[i].zero_gap;
  }
  return true;
}

double ContactHistory::force_between(const ContactPoint& point) const {
  PointId id = id_of(point);
  id.part = 0;
  double force = 0.0;
  for (auto known = std::ranges::lower_bound(entries_, id.key(), {}, &PointId::key);
       known != entries_.end() && known->kind == id.kind && known->first == id.first &&
       known->second == id.second;
       ++known)
    force += known->pressure * known->area;
  return force;
}

void ContactHistory::remember(const ContactPoint& point, const Entry& entry) {
  entries_.push_back({id_of(point), entry});
}

std::span<ContactHistory::KnownPoint> ContactHistory::begin_points(std::size_t n_points) {
  entries_.resize(n_points);
  return entries_;
}

void ContactHistory::end(int n_threads) {
  const std::size_t n_steps = entries_.empty() ? 0 : entries_.size() - 1;
  const int descends = parallel_max(n_steps, n_threads, 0, [&](std::size_t i) {
    return entries_[i + 1].key() < entries_[i].key() ? 1 : 0;
  });
  if (descends != 0) std::ranges::stable_sort(entries_, {}, &PointId::key);
  cursor_ = 0;
}

void ContactHistory::remap(const ContactRemap& remap) {
  std::vector<KnownPoint> kept;
  for (KnownPoint known : entries_) {
    const auto after = [&](bool is_row, std::uint32_t entity) {
      if (known.kind == 2) return number_after(remap.edges, entity);
      return is_row ? number_after(remap.rows, entity) : number_after(remap.faces, entity);
    };
    const auto first = after(known.kind != 0, known.first);
    const OptionalIndex<std::uint32_t> second = known.kind == 3 ? known.second : after(false, known.second);
    if (!first || !second) continue;
    known.first = *first;
    known.second = *second;
    kept.push_back(known);
  }
  entries_ = std::move(kept);
  end();
}

void ContactHistory::archive(StateArchive& saved) {
  std::erase_if(entries_, [](const KnownPoint& point) { return !point.is_known(); });
  saved.rows("contact/points", entries_, [](KnownPoint& known, RowNumbers& row) {
    row(known.kind, known.first, known.second, known.part, known.pressure, known.traction, known.held,
        known.left, known.area);
  });
  // Of what load steps have pressed before alone.
  const std::string name = "contact/zero_gaps_of_points";
  const auto has_gap = [](const KnownPoint& known) { return known.zero_gap != 0.0; };
  if (saved.restores() ? saved.has(name) : std::ranges::any_of(entries_, has_gap))
    saved.fixed_rows(name, entries_, [](KnownPoint& known, RowNumbers& row) { row(known.zero_gap); });
  cursor_ = 0;
}

}  // namespace contactsim
