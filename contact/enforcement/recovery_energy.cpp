// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/recovery_energy.hpp"

#include <algorithm>
#include <limits>

#include "contact/interface_laws/pair_rules.hpp"
#include "core/base/state_archive.hpp"

namespace contactsim {

void RecoveryEnergy::begin_step(const PairRules& rules, IndexedSpan<PairIndex, const PairHistory> histories) {
  for (const PairIndex i : indices(pairs_)) {
    Pair& pair = pairs_[i];
    pair.has_begun = rules[i].is_active && !pair.is_active;
    pair.is_active = rules[i].is_active;
    // What a ramp puts in is known after the forces only.
    const bool is_ramped = rules.gap_offsets().ramp_progress(i) > 0.0;
    pair.taken =
        is_ramped ? std::numeric_limits<double>::infinity() : histories[i].impact + histories[i].ramped;
  }
}

double RecoveryEnergy::available(PairIndex pair) const {
  return std::max(0.0, pairs_[pair].taken + pairs_[pair].of_overlaps);
}

void RecoveryEnergy::archive(StateArchive& saved) {
  saved.fixed_rows("contact/pairs/recovery", pairs_,
                   [](Pair& pair, RowNumbers& row) { row(pair.is_active, pair.of_overlaps); });
}

}  // namespace contactsim
