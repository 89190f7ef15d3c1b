// SPDX-License-Identifier: BSD-3-Clause
#include "contact/surfaces/surface_pairs.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <tuple>
#include <utility>

#include "contact/surfaces/idle_pair_settings.hpp"
#include "contact/surfaces/pair_layers.hpp"
#include "contact/surfaces/pair_warnings.hpp"
#include "contact/surfaces/surface_meetings.hpp"
#include "core/definition/contact.hpp"
#include "core/interface_laws/interface_law_table.hpp"

namespace contactsim {

std::shared_ptr<const FrictionLaw> frictionless_law() {
  static const auto frictionless = std::make_shared<const FrictionLaw>();
  return frictionless;
}

namespace {

/// What has a stiffness or a pressure of its own is elastic, whatever ENFORCEMENT says; in quasi-static
/// procedures multipliers make a stiffness exact.
void set_enforcement(const PairSettings& settings, const ContactDefinition& contact, SurfacePair& pair) {
  using enum Enforcement;
  const Enforcement own = contact.enforcement.is_static ? augmented_lagrange : momentum_balance;
  pair.enforcement = settings.enforcement == penalty ? penalty : own;
  if (contact.enforcement.is_static && !has_pressure(*pair.law, contact.friction_models)) return;
  if (pair.penalty_stiffness || has_pressure(*pair.law, contact.friction_models))
    pair.enforcement = Enforcement::penalty;
}

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
  pair.sides.fill(settings.sides.value_or(ShellSides::both));
  pair.separates = settings.separation.value_or(true);
  pair.tracking_distance = settings.tracking_distance;
  pair.search_distance = settings.search_distance;
  pair.gap = settings.gap;
  pair.gap_closure = settings.gap_closure;
  pair.adjusted_nodes = settings.adjusted_nodes;
  pair.smoothing_choice = settings.smoothing.value_or(SmoothingChoice{});
  pair.penalty_scale = settings.penalty_scale.value_or(1.0) * contact.enforcement.penalty_scale;
  if (settings.penalty_stiffness) pair.penalty_stiffness = settings.penalty_stiffness->given;
  set_enforcement(settings, contact, pair);
  pair.damping_fraction = contact.enforcement.is_static ? 0.0 : settings.damping_fraction.value_or(0.0);
  if (contact.enforcement.is_static) pair.stabilization = settings.stabilization;
  return pair;
}

/// Of a surface with itself: nothing says which of two folds should move.
void close_no_gaps(SurfacePair& pair) {
  pair.gap_closure.reset();
  pair.adjusted_nodes.reset();
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

/// Gathers pairs; what is added later overrides, and exclusions win.
class PairMaker {
 public:
  PairMaker(const ContactDefinition& contact, const ContactSurfaces& surfaces, Diagnostics& diagnostics);

  void add_defaults(const InteractionDefaults& defaults);
  /// Adds contact.interactions[index].
  void add_interaction(std::size_t index);
  void add_exclusion(const SurfaceExclusion& exclusion);
  SurfacePairs take();

 private:
  SurfacePair pair_of(std::size_t index) const;
  void settle(const Meeting& meeting, SurfacePair& pair);
  /// Notes what a settled pair is not that its interaction asks for.
  void note_what_differs(std::size_t index, const Meeting& meeting, const SurfacePair& settled);

  const ContactDefinition& contact_;
  const SurfaceList& surfaces_;
  Diagnostics& diagnostics_;
  SurfaceMeetings meetings_;
  PairSettings defaults_;
  std::map<PairKey, PairLayers> layers_;
  std::vector<PairExclusion> exclusions_;
  PairWarnings warnings_;
};

PairMaker::PairMaker(const ContactDefinition& contact, const ContactSurfaces& surfaces,
                     Diagnostics& diagnostics)
    : contact_(contact),
      surfaces_(surfaces.surfaces),
      diagnostics_(diagnostics),
      meetings_(surfaces.surfaces),
      defaults_(shared_settings(contact)),
      warnings_(contact, surfaces.surfaces) {
  if (contact.interaction_defaults) defaults_ = with_defaults(contact.interaction_defaults->pair, defaults_);
}

/// In load steps faces press each other at the nodes of the finer side, by weighted gaps, whatever the
/// formulation: the forces of nodes that meet faces one by one jump as they go from face to face, so that no
/// equilibrium is found. Ties do not go anywhere.
void PairMaker::settle(const Meeting& meeting, SurfacePair& pair) {
  const InterfaceLawRow& law = row_of(*pair.law);
  const bool is_weighted = contact_.enforcement.is_static &&
                           pair.formulation == ConstraintFormulation::node_face && !law.holds_at_start &&
                           law.select == nullptr;
  if (is_weighted) pair.formulation = ConstraintFormulation::face_face;
  meetings_.settle(meeting, pair);
  if (is_weighted && pair.formulation == ConstraintFormulation::face_face) warnings_.note_weighted(pair);
}

void PairMaker::add_defaults(const InteractionDefaults& defaults) {
  std::vector<SurfaceIndex> members = meetings_.positions_of(defaults.surfaces);
  if (defaults.surfaces.empty()) {
    for (const SurfaceIndex surface : indices(surfaces_)) members.push_back(surface);
  }
  SurfacePair pair = common_pair(defaults_, contact_);
  pair.location = defaults.name.location;
  pair.is_from_defaults = true;
  const auto add = [&](SurfaceIndex a, SurfaceIndex b) {
    const Meeting meeting{std::min(a, b), std::max(a, b)};
    if (!meetings_.can_meet(meeting)) return;
    pair.interaction = a == b ? "self contact" : "general contact";
    SurfacePair own = pair;
    if (a == b) close_no_gaps(own);
    settle(meeting, own);
    layers_[{meeting.first, meeting.second}].add(std::move(own), std::nullopt);
  };
  for (std::size_t i = 0; i < members.size(); ++i) {
    if (defaults.self_contact) add(members[i], members[i]);
    for (std::size_t j = i + 1; defaults.general_contact && j < members.size(); ++j) {
      if (members[i] != members[j]) add(members[i], members[j]);
    }
  }
}

SurfacePair PairMaker::pair_of(std::size_t index) const {
  const Interaction& interaction = contact_.interactions[index];
  const PairSettings settings = with_defaults(interaction.pair, defaults_);
  SurfacePair pair = common_pair(settings, contact_);
  if (interaction.friction_coefficient) {
    FrictionLaw coulomb = make_friction_law("constant friction");
    coulomb.values.set("friction coefficient", *interaction.friction_coefficient);
    pair.law = std::make_shared<const FrictionLaw>(std::move(coulomb));
    set_enforcement(settings, contact_, pair);
  }
  pair.interaction = name_of_interaction(contact_, index);
  pair.location = interaction.name.location;
  pair.periods = interaction.periods;
  return pair;
}

void PairMaker::add_interaction(std::size_t index) {
  const Interaction& interaction = contact_.interactions[index];
  const SurfacePair pair = pair_of(index);
  // One that the defaults alone switch off takes nothing from others.
  const bool excludes = interaction.pair.behavior == InteractionBehavior::no_interaction;
  if (excludes) exclusions_.push_back({pair.interaction, pair.location});
  const auto meetings = meetings_.meetings_of(interaction);
  bool is_served = meetings.empty(), closes_itself = false;
  const bool moves_nodes = interaction.pair.gap_closure || interaction.pair.adjusted_nodes;
  for (const auto& [key, meeting] : meetings) {
    const bool has_empty_side = meetings_.has_empty_side(meeting);
    is_served = is_served || has_empty_side;
    if (excludes && has_empty_side) exclusions_.back().has_effect = true;  // that is reported of the surface
    if (!meetings_.can_meet(meeting)) continue;
    is_served = true;
    if (excludes) {
      layers_[key].exclude(pair.periods, exclusions_.size() - 1);
      continue;
    }
    SurfacePair own = pair;
    if (meeting.first == meeting.second) {
      if (moves_nodes) closes_itself = true;
      close_no_gaps(own);
    }
    settle(meeting, own);
    note_what_differs(index, meeting, own);
    layers_[key].add(std::move(own), index);
  }
  if (closes_itself)
    diagnostics_.add_error(interaction.name.location, "the interaction moves nodes of a surface onto itself",
                           "nothing says which of two folds should move: name two surfaces");
  if (is_served) return;
  diagnostics_.add_error(interaction.name.location, "none of the surfaces of the interaction can meet",
                         "a node set meets faces only, an analytic plane faces and nodes only");
}

void PairMaker::note_what_differs(std::size_t index, const Meeting& meeting, const SurfacePair& settled) {
  if (settled.formulation == ConstraintFormulation::face_face) return;
  if (meeting.has_sides && meeting.first == meeting.second) warnings_.note_both_sides(index, meeting.first);
  if (contact_.interactions[index].pair.formulation != ConstraintFormulation::face_face) return;
  for (const SurfaceIndex surface : {meeting.first, meeting.second}) {
    if (surfaces_[surface].kind == SurfaceKind::node) warnings_.note_nodes(index, surface);
  }
}

void PairMaker::add_exclusion(const SurfaceExclusion& exclusion) {
  exclusions_.push_back({"EXCLUDE SURFACES", exclusion.location});
  for (const auto& [key, meeting] : meetings_.meetings_of(exclusion)) {
    if (meetings_.has_empty_side(meeting)) exclusions_.back().has_effect = true;
    if (meetings_.can_meet(meeting)) layers_[key].exclude({}, exclusions_.size() - 1);
  }
}

SurfacePairs PairMaker::take() {
  SurfacePairs pairs;
  for (auto& [key, layers] : layers_) {
    if (!layers.is_empty()) {
      for (const std::size_t exclusion : layers.exclusions()) exclusions_[exclusion].has_effect = true;
    }
    for (const auto& overridden : layers.overridden()) warnings_.note(key, overridden);
    std::ranges::move(layers.take(), std::back_inserter(pairs));
  }
  warnings_.add_to(exclusions_, diagnostics_);
  // What stands in for an interaction outside its periods comes after it.
  std::stable_sort(pairs.begin(), pairs.end(), [](const SurfacePair& a, const SurfacePair& b) {
    return std::tie(a.first, a.second, a.is_from_defaults) < std::tie(b.first, b.second, b.is_from_defaults);
  });
  return pairs;
}

}  // namespace

SurfacePairs make_surface_pairs(const ContactDefinition& contact, const ContactSurfaces& surfaces,
                                Diagnostics& diagnostics) {
  PairMaker maker(contact, surfaces, diagnostics);
  if (contact.interaction_defaults) {
    maker.add_defaults(*contact.interaction_defaults);
    for (const SurfaceExclusion& exclusion : contact.interaction_defaults->exclusions)
      maker.add_exclusion(exclusion);
  }
  for (std::size_t i = 0; i < contact.interactions.size(); ++i) maker.add_interaction(i);
  warn_of_idle_pair_settings(contact, diagnostics);
  SurfacePairs pairs = maker.take();
  if (pairs.empty() && !diagnostics.has_errors()) {
    diagnostics.add_warning("contact-without-pairs", contact.name.location,
                            "no two contact surfaces meet, so that nothing can touch",
                            "write GENERAL CONTACT = ON in INTERACTION DEFAULTS, or an INTERACTION");
  }
  return pairs;
}

}  // namespace contactsim
