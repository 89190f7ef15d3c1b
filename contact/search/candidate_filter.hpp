// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>

#include "contact/interface_laws/pair_rules.hpp"
#include "contact/mesh/adjacent_faces.hpp"
#include "contact/search/shell_sides.hpp"
#include "core/base/bytes_of.hpp"
#include "core/base/optional_index.hpp"
#include "core/mesh/mesh.hpp"

namespace contactsim {

/// Which of the faces, surface nodes and edges whose boxes overlap may touch: by surfaces, sides, elements
/// and rigid bodies, wherever they are.
class CandidateFilter {
 public:
  /// All must outlive this.
  ///   is_once  there is one search only
  ///   body_of  [n_nodes] the rigid body of each node of the mesh, if any, or empty: what belongs to one
  ///            body never meets
  CandidateFilter(const ContactMesh& contact_mesh, const Mesh& mesh, const PairRules& rules, bool is_once,
                  std::span<const OptionalIndex<std::uint32_t>> body_of);

  /// To be called when faces and nodes of the contact mesh have changed.
  void renew();
  /// The memory of what is known of faces [bytes].
  std::size_t bytes() const { return bytes_of(element_spans_); }
  /// Whether candidates are those of the first search, as they are until this is called: later searches have
  /// none for pairs with ties alone, since what was near at the start is tied.
  void set_first_search(bool is_first) { is_first_search_ = is_first; }

  /// The pair with FACE_FACE of two faces, if there is one.
  OptionalIndex<PairIndex> pair_of_faces(FaceIndex first, FaceIndex second) const;
  /// Whether only faces that face each other can touch in a pair: nothing holds any others together, now or
  /// later.
  bool has_to_face(PairIndex pair) const { return has_to_face_[pair] != 0; }
  /// Precondition: the pair is that of the faces.
  bool faces_may_meet(PairIndex pair, FaceIndex first, FaceIndex second) const;
  bool node_may_meet(SurfaceNodeIndex row, FaceIndex face) const;
  bool edges_may_meet(EdgeIndex first, EdgeIndex second) const;

  /// Whether a face or a surface node takes part in a pair by its side of a shell.
  template <class Item>
  bool takes_part(const SurfacePair& pair, const Item& item) const {
    return !pair.is_polar() || contactsim::takes_part(pair, item, contact_mesh_, mesh_);
  }

 private:
  /// Whether a sharp edge is none in a pair: both its faces stand for one round surface.
  bool is_smoothed(const ContactEdge& edge, PairIndex pair) const;
  /// The rigid body that has all of these contact nodes, if one has.
  OptionalIndex<std::uint32_t> rigid_body_of(std::span<const ContactNodeIndex> nodes) const;
  bool are_of_one_rigid_body(std::span<const ContactNodeIndex> a, std::span<const ContactNodeIndex> b) const {
    const OptionalIndex<std::uint32_t> body = rigid_body_of(a);
    return body && body == rigid_body_of(b);
  }
  /// Whether faces without a common node are of elements that have one: they face away from each other, as
  /// the opposite skins of a plate one element thick, and would meet through their own material. For lofts
  /// adjacent_ says so.
  bool are_skins_of_one(FaceIndex first, FaceIndex second) const;
  bool has_element_of(ContactNodeIndex node, const ContactFace& face) const;
  /// Between which numbers those of some nodes of the mesh are: elements whose spans are apart share none.
  struct NodeSpan {
    NodeIndex lowest, highest;
  };
  void set_spans();

  const ContactMesh& contact_mesh_;
  const Mesh& mesh_;
  const PairRules& rules_;
  AdjacentFaces adjacent_;
  std::span<const OptionalIndex<std::uint32_t>> body_of_;  // [n_nodes], or empty
  IndexedVector<PairIndex, std::uint8_t> has_to_face_;     // [n_pairs]
  IndexedVector<FaceIndex, NodeSpan> element_spans_;       // [n_faces] of the element behind a face
  bool is_first_search_ = true;
};

}  // namespace contactsim
