// SPDX-License-Identifier: BSD-3-Clause
#include "contact/surfaces/pair_layers.hpp"

#include <algorithm>
#include <utility>

namespace contactsim {

namespace {

bool is_in(const std::vector<DeckName>& names, const DeckName& name) {
  return std::ranges::find(names, name) != names.end();
}

bool is_always(const ActivePeriods& periods) { return periods.active.empty() && periods.inactive.empty(); }

/// What is left of the first ones without the others; nothing if nothing is.
std::optional<ActivePeriods> without(const std::optional<ActivePeriods>& periods,
                                     const ActivePeriods& taken) {
  const auto rest = other_periods(taken);
  return periods && rest ? common_periods(*periods, *rest) : std::nullopt;
}

}  // namespace

std::optional<ActivePeriods> common_periods(const ActivePeriods& a, const ActivePeriods& b) {
  if (is_always(a)) return b;
  if (is_always(b)) return a;
  ActivePeriods common{a.active.empty() ? b.active : a.active, a.inactive};
  for (const DeckName& name : b.inactive) {
    if (!is_in(common.inactive, name)) common.inactive.push_back(name);
  }
  if (common.active.empty()) return common;
  std::erase_if(common.active, [&](const DeckName& name) {
    return is_in(common.inactive, name) || (!b.active.empty() && !is_in(b.active, name));
  });
  if (common.active.empty()) return std::nullopt;  // an empty list would mean all
  common.inactive.clear();
  return common;
}

std::optional<ActivePeriods> other_periods(const ActivePeriods& periods) {
  if (is_always(periods)) return std::nullopt;
  if (periods.active.empty()) return ActivePeriods{periods.inactive, {}};
  ActivePeriods others{{}, periods.active};
  std::erase_if(others.inactive, [&](const DeckName& name) { return is_in(periods.inactive, name); });
  return others;
}

void PairLayers::add(SurfacePair pair, std::optional<std::size_t> interaction) {
  layers_.push_back({std::move(pair), interaction});
}

void PairLayers::exclude(const ActivePeriods& periods, std::size_t exclusion) {
  exclusions_.push_back({periods, exclusion});
}

std::vector<std::size_t> PairLayers::exclusions() const {
  std::vector<std::size_t> positions;
  for (const Exclusion& exclusion : exclusions_) positions.push_back(exclusion.position);
  return positions;
}

std::optional<ActivePeriods> PairLayers::not_excluded(const ActivePeriods& periods) const {
  std::optional<ActivePeriods> left = periods;
  for (const Exclusion& exclusion : exclusions_) left = without(left, exclusion.periods);
  return left;
}

std::vector<PairLayers::Overridden> PairLayers::overridden() const {
  std::vector<Overridden> found;
  std::optional<ActivePeriods> left = not_excluded({});
  for (std::size_t i = layers_.size(); i-- > 0;) {
    const Layer& layer = layers_[i];
    const bool acts = left && common_periods(*left, layer.pair.periods);
    if (!acts && layer.interaction) found.push_back(overrider_of(i));
    left = without(left, layer.pair.periods);
  }
  return found;
}

/// The next layer above it that has periods in common with it, or the first such exclusion.
PairLayers::Overridden PairLayers::overrider_of(std::size_t layer) const {
  const ActivePeriods& periods = layers_[layer].pair.periods;
  const std::size_t own = *layers_[layer].interaction;
  for (std::size_t i = layer + 1; not_excluded(periods) && i < layers_.size(); ++i) {
    if (common_periods(periods, layers_[i].pair.periods)) return {own, *layers_[i].interaction, false};
  }
  const auto first = std::ranges::find_if(exclusions_, [&](const Exclusion& exclusion) {
    return common_periods(periods, exclusion.periods).has_value();
  });
  return {own, first->position, true};
}

std::vector<SurfacePair> PairLayers::take() {
  std::vector<SurfacePair> pairs;
  std::optional<ActivePeriods> left = not_excluded({});
  for (auto layer = layers_.rbegin(); left && layer != layers_.rend(); ++layer) {
    const ActivePeriods own = layer->pair.periods;
    const auto acting = common_periods(*left, own);
    left = without(left, own);
    if (!acting || layer->pair.behavior == InteractionBehavior::no_interaction) continue;
    layer->pair.periods = *acting;
    pairs.push_back(std::move(layer->pair));
  }
  layers_.clear();
  return pairs;
}

}  // namespace contactsim
