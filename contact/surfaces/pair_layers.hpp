// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "contact/surfaces/surface_pairs.hpp"
#include "core/definition/condition_lines.hpp"

namespace contactsim {

/// The periods that both leave; nothing if there are none.
std::optional<ActivePeriods> common_periods(const ActivePeriods& a, const ActivePeriods& b);

/// The periods that these leave out; nothing if there are none.
std::optional<ActivePeriods> other_periods(const ActivePeriods& periods);

/// What a deck says about one pair of surfaces: the defaults, then interactions, in its order. At any time
/// the last one that is in its periods holds. Exclusions beat all of them, wherever they stand. Source:
/// Abaqus, *CONTACT EXCLUSIONS.
class PairLayers {
 public:
  /// An interaction that never acts, because others always do.
  struct Overridden {
    std::size_t interaction = 0;
    std::size_t by = 0;            ///< position of the later interaction, or of the exclusion
    bool is_by_exclusion = false;  ///< and not by an interaction
  };

  /// interaction  position; absent: the defaults
  void add(SurfacePair pair, std::optional<std::size_t> interaction);
  /// exclusion  its position
  void exclude(const ActivePeriods& periods, std::size_t exclusion);

  bool is_empty() const { return layers_.empty(); }
  /// Positions of the exclusions that name the pair.
  std::vector<std::size_t> exclusions() const;
  std::vector<Overridden> overridden() const;
  /// The pairs that act at some time, later ones first, each with the periods that are left to it.
  std::vector<SurfacePair> take();

 private:
  struct Layer {
    SurfacePair pair;
    std::optional<std::size_t> interaction;
  };
  struct Exclusion {
    ActivePeriods periods;
    std::size_t position = 0;
  };
  /// What of some periods no exclusion takes; nothing if they take all.
  std::optional<ActivePeriods> not_excluded(const ActivePeriods& periods) const;
  Overridden overrider_of(std::size_t layer) const;

  std::vector<Layer> layers_;
  std::vector<Exclusion> exclusions_;
};

}  // namespace contactsim
