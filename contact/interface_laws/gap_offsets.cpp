// SPDX-License-Identifier: BSD-3-Clause
#include "contact/interface_laws/gap_offsets.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <tuple>

#include "core/base/state_archive.hpp"

namespace contactsim {

namespace {

/// Joins what is known of one entity and pair from several partners.
void add(const StartGap& more, StartGap& gap) {
  const double area = gap.area + more.area;
  gap.mean =
      area > 0.0 ? (gap.mean * gap.area + more.mean * more.area) / area : std::min(gap.mean, more.mean);
  gap.smallest = std::min(gap.smallest, more.smallest);
  gap.area = area;
}

/// The gaps of what is still there, by its new numbers.
template <class AnIndex>
std::vector<StartGap> kept(const NewPositions<AnIndex>& positions, std::span<const StartGap> gaps) {
  std::vector<StartGap> after;
  for (StartGap gap : gaps) {
    const OptionalIndex<std::uint32_t> now = number_after(positions, gap.entity);
    if (!now) continue;
    gap.entity = *now;
    after.push_back(gap);
  }
  return after;
}

}  // namespace

void StartGaps::set(std::vector<StartGap> gaps) {
  const auto key = [](const StartGap& gap) { return std::tie(gap.entity, gap.pair); };
  std::ranges::stable_sort(gaps, {}, key);
  gaps_.clear();
  for (const StartGap& gap : gaps) {
    if (!gaps_.empty() && key(gaps_.back()) == key(gap)) {
      add(gap, gaps_.back());
    } else {
      gaps_.push_back(gap);
    }
  }
  begin_.assign(gaps_.empty() ? 0 : gaps_.back().entity + std::size_t{2}, 0);
  for (const StartGap& gap : gaps_) ++begin_[gap.entity + 1];
  for (std::size_t i = 1; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
}

std::array<const StartGap*, 2> StartGaps::find_both(std::uint32_t first, std::uint32_t second,
                                                    PairIndex pair) const {
  const StartGap* a = find(first, pair);
  const StartGap* b = first == second ? a : find(second, pair);
  return {a != nullptr ? a : b, b != nullptr ? b : a};
}

GapOffsets::GapOffsets(std::span<const SurfacePair> pairs) {
  for (const SurfacePair& pair : pairs) {
    Rule rule{pair.gap};
    rule.offset = pair.gap.contact_offset.value_or(0.0);
    rules_.push_back(rule);
  }
  set_reach();
}

bool GapOffsets::needs_start() const {
  return std::ranges::any_of(rules_, [](const Rule& rule) { return rule.settings.needs_start(); });
}

double GapOffsets::offset_for(const Rule& rule, const StartGap& gap) {
  if (rule.settings.initial_clearance) return gap.mean - *rule.settings.initial_clearance;
  return rule.offset - rule.overlap_share * overlap_of(rule, gap);
}

double GapOffsets::of(const StartGaps& gaps, PairIndex pair, std::uint32_t first,
                      std::uint32_t second) const {
  const Rule& rule = rules_[pair];
  if (!rule.settings.needs_start()) return rule.offset;
  const auto [a, b] = gaps.find_both(first, second, pair);
  return a == nullptr ? rule.offset : 0.5 * (offset_for(rule, *a) + offset_for(rule, *b));
}

double GapOffsets::ramped_depth(const ContactPoint& point) const {
  const Rule& rule = rules_[point.pair];
  if (!rule.settings.overlap_ramp_time) return 0.0;
  const bool is_of_node = !point.is_of_edges && point.first.is_node();
  const StartGaps& gaps = point.is_of_edges ? edges_ : is_of_node ? nodes_ : faces_;
  const auto [a, b] =
      gaps.find_both(point.first_entity, is_of_node ? point.first_entity : point.second_entity, point.pair);
  return a == nullptr ? 0.0 : 0.5 * (overlap_of(rule, *a) + overlap_of(rule, *b));
}

void GapOffsets::set_reach() {
  largest_shift_ = 0.0;
  for (Rule& rule : rules_) {
    rule.reach = std::max(0.0, rule.offset);
    largest_shift_ = std::max(largest_shift_, std::abs(rule.offset));
  }
  for (const StartGaps* gaps : {&faces_, &nodes_, &edges_}) {
    for (const StartGap& gap : gaps->all()) {
      Rule& rule = rules_[gap.pair];
      rule.reach = std::max(rule.reach, offset_for(rule, gap));
      largest_shift_ = std::max(largest_shift_, std::abs(offset_for(rule, gap)));
    }
  }
  largest_reach_ = 0.0;
  for (const Rule& rule : rules_) largest_reach_ = std::max(largest_reach_, rule.reach);
}

void GapOffsets::set_start(FoundStartGaps found, double time) {
  start_time_ = time;
  set_gaps(std::move(found));
  activate(time);
}

void GapOffsets::set_gaps(FoundStartGaps found) {
  faces_.set(std::move(found.faces));
  nodes_.set(std::move(found.nodes));
  edges_.set(std::move(found.edges));
  set_reach();
}

StartGapSummary GapOffsets::summarize_start(PairIndex pair) const {
  StartGapSummary summary;
  for (const StartGaps* gaps : {&faces_, &nodes_, &edges_}) {
    for (const StartGap& gap : gaps->all()) {
      if (gap.pair != pair) continue;
      ++summary.n;
      if (gaps == &edges_ || !(gap.mean * gap.mean > gap.area)) continue;
      ++summary.n_far;
      summary.widest = std::max(summary.widest, std::abs(gap.mean));
    }
  }
  return summary;
}

void GapOffsets::activate(double time) {
  for (Rule& rule : rules_) {
    if (!rule.settings.overlap_ramp_time) continue;
    const double before = rule.overlap_share;
    rule.overlap_share = 1.0 - std::min((time - start_time_) / *rule.settings.overlap_ramp_time, 1.0);
    rule.progress = before - rule.overlap_share;
  }
}

void GapOffsets::remap(const ContactRemap& remap) {
  set_gaps(
      {kept(remap.faces, faces_.all()), kept(remap.rows, nodes_.all()), kept(remap.edges, edges_.all())});
}

void GapOffsets::archive(StateArchive& saved) {
  if (!needs_start()) return;
  saved.numbers("contact/start_gaps/time", start_time_);
  const auto visit = [](StartGap& gap, RowNumbers& row) {
    row(gap.entity, gap.pair.value, gap.mean, gap.smallest, gap.area);
  };
  for (const auto& [name, gaps] :
       {std::pair("faces", &faces_), std::pair("nodes", &nodes_), std::pair("edges", &edges_)}) {
    std::vector<StartGap> all(gaps->all().begin(), gaps->all().end());
    saved.rows(std::string("contact/start_gaps/") + name, all, visit);
    if (saved.restores()) gaps->set(std::move(all));
  }
  set_reach();
}

}  // namespace contactsim
