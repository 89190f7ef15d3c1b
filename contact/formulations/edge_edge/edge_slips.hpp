// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <utility>
#include <vector>

#include "contact/mesh/contact_remap.hpp"

namespace contactsim {

class StateArchive;

/// The slip that friction holds at the contact points of edges, of those alone that hold some.
class EdgeSlips {
 public:
  /// A contact point of two edges, which have one or two.
  struct Place {
    EdgeIndex first, second;
    std::uint8_t part = 0;
    auto operator<=>(const Place&) const = default;
  };

  /// [length]; zero where none is held
  Eigen::Vector3d find(const Place& place) const;
  void clear() { entries_.clear(); }
  /// Adds the slip of a place behind all that are known.
  void add(const Place& place, const Eigen::Vector3d& slip);
  /// Goes over to other edges. Of two that have changed their order the slip would be seen from the other
  /// side: it is forgotten.
  void remap(const ContactRemap& remap);
  void archive(StateArchive& saved);

 private:
  struct Entry {
    Place place;
    Eigen::Vector3d slip;  // [length]
  };
  std::vector<Entry> entries_;  // ascending
};

}  // namespace contactsim
