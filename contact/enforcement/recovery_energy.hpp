// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "contact/enforcement/pair_history.hpp"
#include "core/base/contact_indices.hpp"
#include "core/base/indexed_vector.hpp"

namespace contactsim {

class PairRules;
class StateArchive;

/// The energy that momentum balance may give to the bodies of each pair, to bring out what has penetrated:
/// what their impacts have lost so far, and what it takes to part sides that overlapped as the pair became
/// active. Beyond that what penetrates stays where it is: brought out by a share of its depth a step it would
/// throw slow bodies apart. The idea is that of returned_energy.hpp.
class RecoveryEnergy {
 public:
  explicit RecoveryEnergy(std::size_t n_pairs) : pairs_(n_pairs) {}

  /// To be called in each step, before its points are known.
  void begin_step(const PairRules& rules, IndexedSpan<PairIndex, const PairHistory> histories);
  /// Whether the pair became active in this step.
  bool has_begun(PairIndex pair) const { return pairs_[pair].has_begun; }
  /// Adds what it takes to part sides of such a pair [energy].
  void add_overlap(PairIndex pair, double energy) { pairs_[pair].of_overlaps += energy; }
  /// Infinite while an overlap is ramped [energy].
  double available(PairIndex pair) const;
  /// What add_overlap() has added so far [energy].
  double of_overlaps(PairIndex pair) const { return pairs_[pair].of_overlaps; }

  void archive(StateArchive& saved);

 private:
  struct Pair {
    bool is_active = false, has_begun = false;
    double taken = 0.0;        // by impacts, and put in by ramps [energy]
    double of_overlaps = 0.0;  // [energy]
  };
  IndexedVector<PairIndex, Pair> pairs_;
};

}  // namespace contactsim
