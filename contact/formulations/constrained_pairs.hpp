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
  bool holds_faces(FaceIndex first, FaceIndex second) const { return faces_.has(first, second); }
  bool holds_node(SurfaceNodeIndex row, PairIndex pair) const { return nodes_.has(row, pair); }
  /// Return whether the pair is new.
  bool add_faces(FaceIndex first, FaceIndex second) { return faces_.add(first, second); }
  bool add_node(SurfaceNodeIndex row, PairIndex pair) { return nodes_.add(row, pair); }
  void remove_faces(FaceIndex first, FaceIndex second) { faces_.remove(first, second); }
  void remove_node(SurfaceNodeIndex row, PairIndex pair) { nodes_.remove(row, pair); }
  void archive(StateArchive& saved);

 private:
  PairSet<FaceIndex, FaceIndex> faces_;
  PairSet<SurfaceNodeIndex, PairIndex> nodes_;
};

}  // namespace contactsim
