// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "contact/mesh/pair_node_values.hpp"

namespace contactsim {

/// The pressures of a trial of a load step by which nodes slide in others, whatever presses them there
/// [force/length^2].
class SlipPressures {
 public:
  using Entry = PairNodeValues<double>::Entry;

  bool empty() const { return of_nodes_.empty(); }
  void set(std::vector<Entry> entries) {
    has_any_.clear();
    for (const Entry& entry : entries) {
      if (has_any_.size() <= entry.pair.value) has_any_.resize(entry.pair.value + 1, false);
      has_any_[entry.pair.value] = true;
    }
    of_nodes_.set(std::move(entries));
  }
  /// That of a node. One that was not pressed had none, but in a pair without any it has what presses it.
  double of(PairIndex pair, SurfaceNodeIndex row, double pressing) const {
    const bool has_any = pair.value < has_any_.size() && has_any_[pair.value];
    return of_nodes_.value_or(pair, row, has_any ? 0.0 : pressing);
  }

 private:
  PairNodeValues<double> of_nodes_;
  std::vector<bool> has_any_;  // of pairs
};

}  // namespace contactsim
