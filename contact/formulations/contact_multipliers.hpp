// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstdint>
#include <vector>

#include "contact/mesh/contact_mesh.hpp"
#include "contact/mesh/contact_remap.hpp"
#include "core/base/contact_indices.hpp"

namespace contactsim {

class StateArchive;

/// The augmented Lagrange multipliers of load steps, as depths: the penalty presses at a depth d as it would
/// by itself at d + m. A multiplier grows by what still penetrates until nothing does, and the penalty is
/// exact for every law of pressure and depth that only grows. They stand at the nodes of one side of a pair,
/// so that they survive when faces meet others. Source: Simo and Laursen, Comput. Struct. 42 (1992) 97-116;
/// Wriggers, Computational Contact Mechanics (2006), 6.3.
class ContactMultipliers {
 public:
  struct Entry {
    PairIndex pair;
    SurfaceNodeIndex row;
    double depth = 0.0;  ///< > 0 [length]
  };

  bool empty() const { return entries_.empty(); }
  /// Of a surface node in a pair, 0 without one [length].
  double of_node(PairIndex pair, SurfaceNodeIndex row) const {
    const auto found = std::ranges::lower_bound(entries_, key_of(pair, row), {}, key);
    return found != entries_.end() && key(*found) == key_of(pair, row) ? found->depth : 0.0;
  }
  /// Takes these instead.
  void set(std::vector<Entry> entries);
  /// Goes over to other surface nodes.
  void remap(const ContactRemap& remap);
  void archive(StateArchive& saved);

 private:
  static std::uint64_t key_of(PairIndex pair, SurfaceNodeIndex row) {
    return (std::uint64_t{pair.value} << 32) | row.value;
  }
  static std::uint64_t key(const Entry& entry) { return key_of(entry.pair, entry.row); }

  std::vector<Entry> entries_;  // by pair and row
};

}  // namespace contactsim
