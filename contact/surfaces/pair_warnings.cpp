// SPDX-License-Identifier: BSD-3-Clause
#include "contact/surfaces/pair_warnings.hpp"

#include <fmt/format.h>

namespace contactsim {

std::string name_of_interaction(const ContactDefinition& contact, std::size_t index) {
  const std::string& name = contact.interactions[index].name.text;
  return name.empty() ? fmt::format("interaction {}", index + 1) : name;
}

void PairWarnings::note(const PairKey& pair, const PairLayers::Overridden& overridden) {
  overridden_[{overridden.is_by_exclusion, overridden.by, overridden.interaction}].push_back(pair);
}

void PairWarnings::note_both_sides(std::size_t interaction, SurfaceIndex surface) {
  both_sides_[interaction].insert(surface);
}

void PairWarnings::note_nodes(std::size_t interaction, SurfaceIndex surface) {
  nodes_[interaction].insert(surface);
}

void PairWarnings::add_to(const std::vector<PairExclusion>& exclusions, Diagnostics& diagnostics) const {
  for (const auto& [by, pairs] : overridden_) add_overridden(by, pairs, exclusions, diagnostics);
  for (const auto& [interaction, surfaces] : both_sides_) add_both_sides(interaction, surfaces, diagnostics);
  for (const auto& [interaction, surfaces] : nodes_) add_nodes(interaction, surfaces, diagnostics);
  for (const auto& [line, pair] : weighted_) {
    diagnostics.add_warning(
        "node-face-weighted", pair.location,
        fmt::format("'{}' asks for NODE_FACE; in load steps faces press each other at the "
                    "nodes of the finer side, by weighted gaps, as with FACE_FACE",
                    pair.interaction));
  }
  for (const PairExclusion& exclusion : exclusions) {
    if (exclusion.has_effect) continue;
    diagnostics.add_warning(
        "exclusion-without-effect", exclusion.location,
        fmt::format("'{}' takes out pairs that do not meet without it either", exclusion.name),
        "no interaction names them, nor does GENERAL or SELF CONTACT");
  }
}

void PairWarnings::add_overridden(const Case& by, const std::vector<PairKey>& pairs,
                                  const std::vector<PairExclusion>& exclusions,
                                  Diagnostics& diagnostics) const {
  const auto& [is_by_exclusion, winner, loser] = by;
  const auto& [a, b] = pairs.front();
  const std::string more = pairs.size() > 1 ? fmt::format(" and {} more", pairs.size() - 1) : "";
  const std::string place = to_string(contact_.interactions[loser].name.location);
  diagnostics.add_warning(
      "interaction-overridden",
      is_by_exclusion ? exclusions[winner].location : contact_.interactions[winner].name.location,
      fmt::format("'{}' overrides '{}' for the pair of '{}' and '{}'{}",
                  is_by_exclusion ? exclusions[winner].name : name_of_interaction(contact_, winner),
                  name_of_interaction(contact_, loser), surfaces_[a].name, surfaces_[b].name, more),
      is_by_exclusion ? fmt::format("exclusions win in any order; the interaction stands at {}", place)
                      : "the earlier one stands at " + place);
}

void PairWarnings::add_both_sides(std::size_t interaction, const std::set<SurfaceIndex>& surfaces,
                                  Diagnostics& diagnostics) const {
  diagnostics.add_warning("one-sided-self", contact_.interactions[interaction].name.location,
                          fmt::format("'{}' has {} on both sides; both give faces and nodes",
                                      name_of_interaction(contact_, interaction), list(surfaces)),
                          "a surface meets itself both ways: SURFACES with its name alone says so");
}

void PairWarnings::add_nodes(std::size_t interaction, const std::set<SurfaceIndex>& surfaces,
                             Diagnostics& diagnostics) const {
  diagnostics.add_warning("node-set-face-face", contact_.interactions[interaction].name.location,
                          fmt::format("'{}' asks for FACE_FACE of {}, a surface of nodes; NODE_FACE is taken",
                                      name_of_interaction(contact_, interaction), list(surfaces)),
                          "write CONSTRAINT FORMULATION = NODE_FACE, or make it a surface of faces");
}

std::string PairWarnings::list(const std::set<SurfaceIndex>& surfaces) const {
  const std::string more = surfaces.size() > 1 ? fmt::format(" and {} more", surfaces.size() - 1) : "";
  return fmt::format("'{}'{}", surfaces_[*surfaces.begin()].name, more);
}

}  // namespace contactsim
