// SPDX-License-Identifier: BSD-3-Clause
#include "contact/interface_laws/pair_rules.hpp"

#include <algorithm>

#include "core/base/state_archive.hpp"
#include "core/interface_laws/interface_law_table.hpp"

namespace contactsim {

PairRules::PairRules(const SurfacePairs& pairs, std::vector<ActiveTimes> times, std::size_t n_surfaces)
    : gap_offsets_(pairs), start_reach_(pairs), table_(n_surfaces * n_surfaces), n_surfaces_(n_surfaces) {
  for (const PairIndex i : indices(pairs)) {
    PairRule rule;
    rule.pair = &pairs[i];
    rule.is_balanced = pairs[i].enforcement == Enforcement::momentum_balance;
    rule.law = row_of(*pairs[i].law).holding;
    rule.times = std::move(times[i.value]);
    rules_.push_back(std::move(rule));
    // Of two that take turns the interaction comes first; activate() tells whose turn it is.
    OptionalIndex<PairIndex>& known = entry(pairs[i].first, pairs[i].second);
    if (!known) known = entry(pairs[i].second, pairs[i].first) = i;
  }
}

void PairRule::take(const InterfaceLaw& taken) {
  law = taken.law;
  friction = taken.friction;
  activation_distance = taken.activation_distance();
  begin_gap = taken.pressure ? taken.pressure->begin_gap() : 0.0;
  interface_law = taken.is_simple() ? nullptr : &taken;
}

bool PairRule::may_act_apart() const {
  bool may = false;
  model.visit_models([&](const InterfaceLaw& of) { may = may || of.pull || of.rate_limit; });
  return may;
}

double PairRule::slip_limit(double force, double area, double rate) const {
  return interface_law == nullptr ? friction * force : interface_law->slip_limit(force, area, rate);
}

double PairRule::slip_limit_slope(double force, double area, double rate) const {
  constexpr double probe = 1e-3;
  return (slip_limit((1.0 + probe) * force, area, rate) - slip_limit(force, area, rate)) / (probe * force);
}

double PairRule::slip_limit(const ContactPoint& point, double dt) const {
  if (interface_law == nullptr) return friction * std::max(point.force, 0.0);
  const Eigen::Vector3d along = point.slip - point.normal.dot(point.slip) * point.normal;
  return slip_limit(std::max(point.force, 0.0), point.area, dt > 0.0 ? along.norm() / dt : 0.0);
}

void PairRules::set_laws(IndexedVector<PairIndex, PairInterfaceLaw> laws) {
  for (const PairIndex i : indices(laws)) {
    PairRule& rule = rules_[i];
    rule.model = std::move(laws[i]);
    rule.take(*rule.model.law);
    rule.model.visit_models([&](const InterfaceLaw& law) {
      if (!law.pressure) return;
      const double begin_gap = law.pressure->begin_gap();
      largest_begin_gap_ = std::max(largest_begin_gap_, begin_gap);
      largest_begin_shift_ = std::max(largest_begin_shift_, std::abs(begin_gap));
    });
    if (!rule.model.far) continue;
    rule.far = static_cast<std::uint32_t>(far_rules_.size());
    far_rules_.push_back(rule);
    far_rules_.back().take(*rule.model.far);
  }
}

void PairRules::activate(double time, bool is_on) {
  gap_offsets_.activate(time);
  for (PairRule& rule : rules_) {
    rule.is_active = is_on && rule.times.is_active(time);
    rule.has_changed = false;
    if (rule.far) far_rules_[*rule.far].is_active = rule.is_active;
    if (!rule.model.is_variant()) continue;
    const auto period =
        std::ranges::find_if(rule.model.periods, [&](const auto& p) { return p.times.is_active(time); });
    const InterfaceLaw* law = period == rule.model.periods.end() ? rule.model.law.get() : period->law.get();
    if (law == rule.now) continue;
    rule.has_changed = true;
    rule.now = law;
    rule.take(*law);
  }
  // Of two pairs of the same surfaces the one whose periods these are has its turn; both begin anew.
  for (const PairIndex i : indices(rules_)) {
    const SurfacePair& pair = *rules_[i].pair;
    if (!rules_[i].is_active || (pair.periods.active.empty() && pair.periods.inactive.empty())) continue;
    OptionalIndex<PairIndex>& known = entry(pair.first, pair.second);
    if (known == i) continue;
    rules_[i].has_changed = rules_[*known].has_changed = true;
    known = entry(pair.second, pair.first) = i;
  }
}

bool PairRules::have_changed() const {
  return std::ranges::any_of(rules_, [](const PairRule& rule) { return rule.has_changed; });
}

bool PairRules::has_friction() const {
  bool has = false;
  for (const PairRule& rule : rules_) {
    has = has || rule.friction > 0.0;
    rule.model.visit_models(
        [&](const InterfaceLaw& law) { has = has || law.friction > 0.0 || law.rate_limit.has_value(); });
  }
  return has;
}

double PairRules::max_activation_distance(PairIndex pair) const {
  double activation_distance = 0.0;
  rules_[pair].model.visit_models([&](const InterfaceLaw& law) {
    activation_distance = std::max(
        {activation_distance, law.activation_distance(), law.pressure ? law.pressure->begin_gap() : 0.0});
  });
  return activation_distance;
}

void PairRules::archive(StateArchive& saved) {
  close_faces_.archive("contact/close_faces", saved);
  close_nodes_.archive("contact/close_nodes", saved);
  close_edges_.archive("contact/close_edges", saved);
  gap_offsets_.archive(saved);
  start_reach_.archive(saved);
}

void PairRules::remap(const ContactRemap& remap) {
  close_faces_.remap(Unchanged{}, remap.faces);
  close_nodes_.remap(Unchanged{}, remap.rows);
  close_edges_.remap(Unchanged{}, remap.edges);
  gap_offsets_.remap(remap);
  start_reach_.remap(remap);
}

bool PairRules::are_close(PairIndex pair, FaceIndex first, FaceIndex second) const {
  return close_faces_.has(pair, first) && close_faces_.has(pair, second);
}

bool PairRules::are_close_edges(PairIndex pair, EdgeIndex first, EdgeIndex second) const {
  return close_edges_.has(pair, first) && close_edges_.has(pair, second);
}

bool PairRules::is_close(PairIndex pair, SurfaceNodeIndex row) const { return close_nodes_.has(pair, row); }

}  // namespace contactsim
