// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <utility>

#include "contact/interface_laws/pair_rules.hpp"
#include "contact/mesh/contact_remap.hpp"
#include "contact/mesh/pair_lists.hpp"

namespace contactsim {

/// Candidates of the first search, which pairs that slide infinitesimally keep: later searches find no others
/// for them. Faces and surface nodes that deaths have exposed or released meet whatever they may.
class FirstPartners {
 public:
  /// Keeps the candidates of the first search.
  void keep(FacePairLists lists) { face_pairs_ = std::move(lists); }
  void keep(NodeFaceLists lists) { node_faces_ = std::move(lists); }
  /// Removes from the candidates of a later search what pairs that slide infinitesimally did not have in the
  /// first one.
  void restrict(const ContactMesh& contact_mesh, const PairRules& rules, FacePairLists& lists) const;
  void restrict(const ContactMesh& contact_mesh, const PairRules& rules, NodeFaceLists& lists) const;
  /// Whether the first search found a candidate of a pair.
  bool has_any(PairIndex pair, const ContactMesh& contact_mesh, const PairRules& rules) const;

  /// Has a face, or a surface node, meet whatever it may.
  void release(FaceIndex face, const ContactMesh& contact_mesh) {
    mark(face, contact_mesh.faces.size(), is_free_face_);
  }
  void release(SurfaceNodeIndex row, const ContactMesh& contact_mesh) {
    mark(row, contact_mesh.surface_nodes.size(), is_free_row_);
  }
  /// Goes over to other faces and surface nodes.
  ///   releases_new  what was not there before meets whatever it may
  void remap(const ContactRemap& remap, bool releases_new);
  void archive(StateArchive& saved);

 private:
  template <class AnIndex>
  static void mark(AnIndex entity, std::size_t n, IndexedVector<AnIndex, std::uint8_t>& marks) {
    marks.resize(n, 0);
    marks[entity] = 1;
  }

  FacePairLists face_pairs_;  // of the first search
  NodeFaceLists node_faces_;
  // 1 of what has no first partners; empty before anything was released.
  IndexedVector<FaceIndex, std::uint8_t> is_free_face_;
  IndexedVector<SurfaceNodeIndex, std::uint8_t> is_free_row_;
};

}  // namespace contactsim
