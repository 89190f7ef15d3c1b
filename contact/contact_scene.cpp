// SPDX-License-Identifier: BSD-3-Clause
#include "contact/contact_scene.hpp"

#include <algorithm>

namespace contactsim {

PairRules::PairRules(std::span<const SurfacePair> pairs, std::vector<ActiveTimes> times,
                     std::size_t n_surfaces)
    : table_(n_surfaces * n_surfaces, none), n_surfaces_(n_surfaces) {
  for (std::uint32_t i = 0; i < pairs.size(); ++i) {
    PairRule rule;
    rule.pair = &pairs[i];
    if (std::holds_alternative<Tied>(pairs[i].law)) rule.law = ContactLaw::tied;
    if (std::holds_alternative<Glued>(pairs[i].law)) rule.law = ContactLaw::glued;
    if (const auto* coulomb = std::get_if<ConstantFriction>(&pairs[i].law))
      rule.friction = coulomb->coefficient;
    rule.times = std::move(times[i]);
    rules_.push_back(std::move(rule));
    table_[pairs[i].first * n_surfaces + pairs[i].second] = i;
    table_[pairs[i].second * n_surfaces + pairs[i].first] = i;
  }
}

void PairRules::activate(double time, bool is_on) {
  for (PairRule& rule : rules_) rule.is_active = is_on && rule.times.is_active(time);
}

bool PairRules::has_friction() const {
  return std::any_of(rules_.begin(), rules_.end(), [](const PairRule& rule) { return rule.friction > 0.0; });
}

}  // namespace contactsim
