// SPDX-License-Identifier: BSD-3-Clause
#include "contact/surfaces/surface_pairs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <tuple>

#include "contact/surfaces/surface_meetings.hpp"
#include "core/definition/contact.hpp"

#include "core/interface_laws/interface_law_table.hpp"

namespace contactsim {

std::shared_ptr<const FrictionLaw> frictionless_law() {
  static const auto frictionless = std::make_shared<const FrictionLaw>();
  return frictionless;
}

namespace {

/// What all pairs of one interaction, or of the defaults, have in common.
SurfacePair common_pair(const PairSettings& settings, const ContactDefinition& contact) {
  SurfacePair pair;
  const FrictionLaw* law = settings.friction_model
                               ? find_friction_law(contact.friction_models, settings.friction_model->text)
                               : nullptr;
  if (law != nullptr) pair.law = std::make_shared<const FrictionLaw>(*law);
  pair.formulation = settings.formulation.value_or(pair.formulation);
  pair.behavior = settings.behavior.value_or(pair.behavior);
  pair.normal_tolerance = settings.normal_tolerance;
  pair.tangential_tolerance = settings.tangential_tolerance;
  pair.overlap_normal_tolerance = settings.overlap_normal_tolerance;
  pair.overlap_tangential_tolerance = settings.overlap_tangential_tolerance;
  pair.capture_tolerance = settings.capture_tolerance;
  pair.tracking_distance = settings.tracking_distance;
  pair.gap = settings.gap;
  pair.gap_closure = settings.gap_closure;
  pair.adjusted_nodes = settings.adjusted_nodes;
  pair.penalty_scale = settings.penalty_scale.value_or(1.0) * contact.enforcement.penalty_scale;
  if (settings.penalty_stiffness) pair.penalty_stiffness = settings.penalty_stiffness->given;
  pair.enforcement = settings.enforcement.value_or(Enforcement::momentum_balance);
  if (pair.penalty_stiffness) pair.enforcement = Enforcement::penalty;
  pair.damping_fraction = settings.damping_fraction.value_or(0.0);
  return pair;
}

/// The settings of the blocks that all pairs share: what pairs and their defaults leave out.
PairSettings shared_settings(const ContactDefinition& contact) {
  PairSettings shared;
  shared.enforcement = contact.enforcement.enforcement;
  if (contact.search.tolerance == SearchOptions::Tolerance::user_defined) {
    shared.normal_tolerance = contact.search.normal_tolerance;
    shared.tangential_tolerance = contact.search.tangential_tolerance;
    shared.capture_tolerance = contact.search.capture_tolerance;
  }
  shared.overlap_normal_tolerance = contact.overlap_removal.normal_tolerance;
  shared.overlap_tangential_tolerance = contact.overlap_removal.tangential_tolerance;
  return shared;
}

bool has_periods(const ActivePeriods& periods) {
  return !periods.active.empty() || !periods.inactive.empty();
}

/// The periods in which these do not act. Precondition: there are some.
ActivePeriods rest_of(const ActivePeriods& periods) {
  if (periods.active.empty()) return {periods.inactive, {}};
  ActivePeriods rest;
  std::ranges::copy_if(periods.active, std::back_inserter(rest.inactive), [&](const DeckName& name) {
    return std::ranges::find(periods.inactive, name) == periods.inactive.end();
  });
  return rest;
}

/// Gathers pairs; what is added later overrides.
class PairMaker {
 public:
  PairMaker(const ContactDefinition& contact, const ContactSurfaces& surfaces, Diagnostics& diagnostics);

  void add_defaults(const InteractionDefaults& defaults);
  /// Adds contact.interactions[index].
  void add_interaction(std::size_t index);
  std::vector<SurfacePair> take();

 private:
  struct Entry {
    SurfacePair pair;
    std::optional<std::size_t> interaction;  ///< position; absent: the defaults
    std::optional<SurfacePair> otherwise;    ///< by the defaults, outside the interaction's periods
  };
  using Overridden = std::map<std::size_t, std::vector<PairKey>>;  ///< by the earlier interaction

  void warn_of_overridden(std::size_t index, const Overridden& overridden);
  std::string interaction_name(std::size_t index) const;

  const ContactDefinition& contact_;
  const std::vector<ContactSurface>& surfaces_;
  Diagnostics& diagnostics_;
  SurfaceMeetings meetings_;
  PairSettings defaults_;
  std::map<PairKey, Entry> entries_;
};

PairMaker::PairMaker(const ContactDefinition& contact, const ContactSurfaces& surfaces,
                     Diagnostics& diagnostics)
    : contact_(contact),
      surfaces_(surfaces.surfaces),
      diagnostics_(diagnostics),
      meetings_(surfaces.surfaces),
      defaults_(shared_settings(contact)) {
  if (contact.interaction_defaults) defaults_ = with_defaults(contact.interaction_defaults->pair, defaults_);
}

void PairMaker::add_defaults(const InteractionDefaults& defaults) {
  std::vector<std::uint32_t> members = meetings_.positions_of(defaults.surfaces);
  if (defaults.surfaces.empty()) {
    for (std::uint32_t i = 0; i < surfaces_.size(); ++i) members.push_back(i);
  }
  SurfacePair pair = common_pair(defaults_, contact_);
  pair.location = defaults.name.location;
  pair.is_from_defaults = true;
  const auto add = [&](std::uint32_t a, std::uint32_t b) {
    const Meeting meeting{std::min(a, b), std::max(a, b)};
    if (!meetings_.can_meet(meeting)) return;
    Entry& entry = entries_[{meeting.first, meeting.second}];
    entry.pair = pair;
    entry.pair.interaction = a == b ? "self contact" : "general contact";
    meetings_.settle(meeting, entry.pair);
  };
  for (std::size_t i = 0; i < members.size(); ++i) {
    if (defaults.self_contact) add(members[i], members[i]);
    for (std::size_t j = i + 1; defaults.general_contact && j < members.size(); ++j) {
      if (members[i] != members[j]) add(members[i], members[j]);
    }
  }
}

void PairMaker::add_interaction(std::size_t index) {
  const Interaction& interaction = contact_.interactions[index];
  SurfacePair pair = common_pair(with_defaults(interaction.pair, defaults_), contact_);
  if (interaction.friction_coefficient) {
    FrictionLaw coulomb = make_friction_law("constant friction");
    coulomb.values.set("friction coefficient", *interaction.friction_coefficient);
    pair.law = std::make_shared<const FrictionLaw>(std::move(coulomb));
  }
  pair.interaction = interaction_name(index);
  pair.location = interaction.name.location;
  pair.periods = interaction.periods;
  const auto meetings = meetings_.meetings_of(interaction);
  Overridden overridden;
  bool is_served = meetings.empty();
  for (const auto& [key, meeting] : meetings) {
    is_served = is_served || meetings_.has_empty_side(meeting);
    if (!meetings_.can_meet(meeting)) continue;
    is_served = true;
    const bool is_known = entries_.contains(key);
    Entry& entry = entries_[key];
    if (entry.interaction) overridden[*entry.interaction].push_back(key);
    std::optional<SurfacePair> otherwise = std::move(entry.otherwise);
    if (!entry.interaction && is_known) otherwise = std::move(entry.pair);
    if (otherwise && has_periods(pair.periods)) otherwise->periods = rest_of(pair.periods);
    entry = {pair, index, std::move(otherwise)};
    meetings_.settle(meeting, entry.pair);
  }
  warn_of_overridden(index, overridden);
  if (is_served) return;
  diagnostics_.add_error(interaction.name.location, "none of the surfaces of the interaction can meet",
                         "a node set meets faces only, an analytic plane faces and nodes only");
}

std::string PairMaker::interaction_name(std::size_t index) const {
  const std::string& name = contact_.interactions[index].name.text;
  return name.empty() ? fmt::format("interaction {}", index + 1) : name;
}

void PairMaker::warn_of_overridden(std::size_t index, const Overridden& overridden) {
  for (const auto& [earlier, keys] : overridden) {
    const auto& [a, b] = keys.front();
    const std::string more = keys.size() > 1 ? fmt::format(" and {} more", keys.size() - 1) : "";
    diagnostics_.add_warning(
        "interaction-overridden", contact_.interactions[index].name.location,
        fmt::format("'{}' overrides '{}' for the pair of '{}' and '{}'{}", interaction_name(index),
                    interaction_name(earlier), surfaces_[a].name, surfaces_[b].name, more),
        "the earlier one stands at " + to_string(contact_.interactions[earlier].name.location));
  }
}

std::vector<SurfacePair> PairMaker::take() {
  std::vector<SurfacePair> pairs;
  for (auto& [key, entry] : entries_) {
    const bool goes_on = entry.otherwise && has_periods(entry.pair.periods) &&
                         entry.otherwise->behavior != InteractionBehavior::no_interaction;
    if (goes_on) pairs.push_back(std::move(*entry.otherwise));
    if (entry.pair.behavior != InteractionBehavior::no_interaction) pairs.push_back(std::move(entry.pair));
  }
  // What stands in for an interaction outside its periods comes after it.
  std::stable_sort(pairs.begin(), pairs.end(), [](const SurfacePair& a, const SurfacePair& b) {
    return std::tie(a.first, a.second, a.is_from_defaults) < std::tie(b.first, b.second, b.is_from_defaults);
  });
  return pairs;
}

}  // namespace

std::vector<SurfacePair> make_surface_pairs(const ContactDefinition& contact, const ContactSurfaces& surfaces,
                                            Diagnostics& diagnostics) {
  PairMaker maker(contact, surfaces, diagnostics);
  if (contact.interaction_defaults) maker.add_defaults(*contact.interaction_defaults);
  for (std::size_t i = 0; i < contact.interactions.size(); ++i) maker.add_interaction(i);
  std::vector<SurfacePair> pairs = maker.take();
  if (pairs.empty() && !diagnostics.has_errors()) {
    diagnostics.add_warning("contact-without-pairs", contact.name.location,
                            "no two contact surfaces meet, so that nothing can touch",
                            "write GENERAL CONTACT = ON in INTERACTION DEFAULTS, or an INTERACTION");
  }
  return pairs;
}

}  // namespace contactsim
