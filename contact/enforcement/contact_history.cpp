// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/contact_history.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "core/base/state_archive.hpp"

namespace contactsim {

ContactHistory::PointId ContactHistory::id_of(const ContactPoint& point) {
  std::uint32_t kind = point.first.is_node() ? 1 : 0;
  if (point.second.weights.isZero(0.0)) kind = 3;
  if (point.is_of_edges) kind = 2;
  return {kind, point.first_entity, point.second_entity, point.part};
}

bool ContactHistory::recall(const ContactPoint& point, Entry& found) {
  const PointId wanted = id_of(point);
  const PointId::Key key = wanted.key();
  if (cursor_ > 0 && !(entries_[cursor_ - 1].key() < key))
    cursor_ = static_cast<std::size_t>(std::ranges::lower_bound(entries_, key, {}, &PointId::key) -
                                       entries_.begin());
  while (cursor_ < entries_.size() && entries_[cursor_].key() < key) ++cursor_;
  if (cursor_ < entries_.size() && entries_[cursor_].key() == key) {
    found = entries_[cursor_];
    return true;
  }
  if (find_mean_of_pair(wanted, found)) return true;
  // What load steps have pressed is known of these two alone: what else is before them may be apart.
  const bool is_of_load_steps = !entries_.empty() && std::isnan(entries_.front().zero_gap);
  return !is_of_load_steps && find_mean_of_entities(wanted, found);
}

class ContactHistory::Mean {
 public:
  ///   sign  -1 where the sides of the entry stand the other way round
  void add(const Entry& entry, double sign) {
    sum_.area += entry.area;
    sum_.pressure += entry.area * entry.pressure;
    sum_.traction += sign * entry.area * entry.traction;
    sum_.held += sign * entry.area * entry.held;
    sum_.left += entry.area * entry.left;
    sum_.zero_gap += entry.area * entry.zero_gap;
    ++n_;
  }
  bool take(Entry& found) const {
    if (n_ == 0) return false;
    const double per_area = 1.0 / sum_.area;
    found = {per_area * sum_.pressure,
             per_area * sum_.traction,
             per_area * sum_.held,
             per_area * sum_.left,
             sum_.area,
             per_area * sum_.zero_gap};
    return true;
  }

 private:
  Entry sum_;
  std::size_t n_ = 0;
};

std::pair<std::size_t, std::size_t> ContactHistory::with_first(std::uint32_t kind,
                                                               std::uint32_t first) const {
  const auto key_of = [](const KnownPoint& known) { return known.key().first; };
  const std::uint64_t key = std::uint64_t{kind} << 32 | first;
  const auto found = std::ranges::equal_range(entries_, key, {}, key_of);
  return {static_cast<std::size_t>(found.begin() - entries_.begin()),
          static_cast<std::size_t>(found.end() - entries_.begin())};
}

std::span<const std::uint32_t> ContactHistory::with_second(std::uint32_t kind, std::uint32_t second) {
  const auto key_of = [&](std::uint32_t i) {
    return std::uint64_t{entries_[i].kind} << 32 | entries_[i].second;
  };
  if (by_second_.empty()) {
    by_second_.resize(entries_.size());
    std::iota(by_second_.begin(), by_second_.end(), 0u);
    std::ranges::stable_sort(by_second_, {}, key_of);
  }
  const auto found = std::ranges::equal_range(by_second_, std::uint64_t{kind} << 32 | second, {}, key_of);
  return {found.begin(), found.end()};
}

bool ContactHistory::find_mean_of_pair(const PointId& wanted, Entry& found) const {
  const auto is_wanted = [&](const PointId& id) {
    return id.kind == wanted.kind && id.first == wanted.first && id.second == wanted.second;
  };
  std::size_t begin = cursor_, end = cursor_;
  while (begin > 0 && is_wanted(entries_[begin - 1])) --begin;
  while (end < entries_.size() && is_wanted(entries_[end])) ++end;
  Mean mean;
  for (std::size_t i = begin; i < end; ++i) mean.add(entries_[i], 1.0);
  return mean.take(found);
}

bool ContactHistory::find_mean_of_entities(const PointId& wanted, Entry& found) {
  Mean mean;
  const auto add_first = [&](std::uint32_t entity, double sign) {
    const auto [begin, end] = with_first(wanted.kind, entity);
    for (std::size_t i = begin; i < end; ++i) mean.add(entries_[i], sign);
  };
  const auto add_second = [&](std::uint32_t entity, double sign) {
    for (const std::uint32_t i : with_second(wanted.kind, entity)) mean.add(entries_[i], sign);
  };
  add_first(wanted.first, 1.0);
  const bool has_like_sides = wanted.kind == 0 || wanted.kind == 2;
  if (has_like_sides) {
    add_second(wanted.second, 1.0);
    add_first(wanted.second, -1.0);
    add_second(wanted.first, -1.0);
  }
  return mean.take(found);
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

void ContactHistory::end() {
  if (!std::ranges::is_sorted(entries_, {}, &PointId::key))
    std::ranges::stable_sort(entries_, {}, &PointId::key);
  by_second_.clear();
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
  saved.rows("contact/points", entries_, [](KnownPoint& known, RowNumbers& row) {
    row(known.kind, known.first, known.second, known.part, known.pressure, known.traction, known.held,
        known.left, known.area);
  });
  // Of what load steps have pressed before alone.
  const std::string name = "contact/zero_gaps_of_points";
  const auto has_gap = [](const KnownPoint& known) { return known.zero_gap != 0.0; };
  if (saved.restores() ? saved.has(name) : std::ranges::any_of(entries_, has_gap))
    saved.fixed_rows(name, entries_, [](KnownPoint& known, RowNumbers& row) { row(known.zero_gap); });
  by_second_.clear();
  cursor_ = 0;
}

}  // namespace contactsim
