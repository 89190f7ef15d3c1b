// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "contact/surfaces/contact_surface.hpp"
#include "contact/surfaces/pair_layers.hpp"
#include "contact/surfaces/surface_meetings.hpp"
#include "core/base/diagnostics.hpp"
#include "core/definition/contact.hpp"

namespace contactsim {

/// Something that takes pairs out: an interaction with NO_INTERACTION, a line EXCLUDE SURFACES.
struct PairExclusion {
  std::string name;
  DeckLocation location;
  bool has_effect = false;  ///< some pair of it would meet without it
};

/// The name of an interaction, or "interaction 3".
std::string name_of_interaction(const ContactDefinition& contact, std::size_t index);

/// Warnings about interactions that do less than they say.
class PairWarnings {
 public:
  /// Both must outlive this.
  PairWarnings(const ContactDefinition& contact, const SurfaceList& surfaces)
      : contact_(contact), surfaces_(surfaces) {}

  void note(const PairKey& pair, const PairLayers::Overridden& overridden);
  /// An interaction puts a surface on both sides of NODE_FACE.
  void note_both_sides(std::size_t interaction, SurfaceIndex surface);
  /// An interaction asks for FACE_FACE of a surface without faces.
  void note_nodes(std::size_t interaction, SurfaceIndex surface);
  /// A pair of load steps that asks for NODE_FACE is pressed by weighted gaps of faces.
  void note_weighted(const SurfacePair& pair) { weighted_.try_emplace(pair.location.line, pair); }
  /// Warnings "interaction-overridden", "exclusion-without-effect", "one-sided-self", "node-set-face-face"
  /// and "node-face-weighted".
  void add_to(const std::vector<PairExclusion>& exclusions, Diagnostics& diagnostics) const;

 private:
  using Case = std::tuple<bool, std::size_t, std::size_t>;  // is_by_exclusion, by, interaction

  void add_overridden(const Case& by, const std::vector<PairKey>& pairs,
                      const std::vector<PairExclusion>& exclusions, Diagnostics& diagnostics) const;

  void add_both_sides(std::size_t interaction, const std::set<SurfaceIndex>& surfaces,
                      Diagnostics& diagnostics) const;
  void add_nodes(std::size_t interaction, const std::set<SurfaceIndex>& surfaces,
                 Diagnostics& diagnostics) const;
  std::string list(const std::set<SurfaceIndex>& surfaces) const;

  const ContactDefinition& contact_;
  const SurfaceList& surfaces_;
  std::map<Case, std::vector<PairKey>> overridden_;
  std::map<std::size_t, std::set<SurfaceIndex>> both_sides_, nodes_;  // by interaction
  std::map<int, SurfacePair> weighted_;                               // by line, the first pair of each
};

}  // namespace contactsim
