// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact/mesh/contact_remap.hpp"
#include "contact/mesh/pair_set.hpp"
#include "core/base/contact_indices.hpp"

namespace contactsim {

class StateArchive;

/// Pairs of entities that ties hold, so that contact leaves them alone: for good once they have touched under
/// a GLUED MODEL, until it fails under a weld.
class ConstrainedPairs {
 public:
  /// Goes over to other faces and nodes: what is removed is held no more.
  void remap(const ContactRemap& remap);
  bool holds_faces(std::uint32_t first, std::uint32_t second) const { return faces_.has(first, second); }
  bool holds_node(std::uint32_t row, PairIndex pair) const { return nodes_.has(row, pair.value); }
  /// Return whether the pair is new.
  bool add_faces(std::uint32_t first, std::uint32_t second) { return faces_.add(first, second); }
  bool add_node(std::uint32_t row, PairIndex pair) { return nodes_.add(row, pair.value); }
  /// The same of a node, by its row and the pair, or of two faces.
  void add(bool is_node, std::uint32_t a, std::uint32_t b) { (is_node ? nodes_ : faces_).add(a, b); }
  void remove(bool is_node, std::uint32_t a, std::uint32_t b) { (is_node ? nodes_ : faces_).remove(a, b); }
  void archive(StateArchive& saved);

 private:
  PairSet faces_, nodes_;
};

}  // namespace contactsim
