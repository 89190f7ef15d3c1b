// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <map>
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

/// What the user is told about interactions that do less than they say.
class PairWarnings {
 public:
  /// Both must outlive this.
  PairWarnings(const ContactDefinition& contact, const std::vector<ContactSurface>& surfaces)
      : contact_(contact), surfaces_(surfaces) {}

  void note(const PairKey& pair, const PairLayers::Overridden& overridden);
  /// Warnings "interaction-overridden" and "exclusion-without-effect".
  void add_to(const std::vector<PairExclusion>& exclusions, Diagnostics& diagnostics) const;

 private:
  using Case = std::tuple<bool, std::size_t, std::size_t>;  // is_by_exclusion, by, interaction

  void add_overridden(const Case& by, const std::vector<PairKey>& pairs,
                      const std::vector<PairExclusion>& exclusions, Diagnostics& diagnostics) const;

  const ContactDefinition& contact_;
  const std::vector<ContactSurface>& surfaces_;
  std::map<Case, std::vector<PairKey>> overridden_;
};

}  // namespace contactsim
