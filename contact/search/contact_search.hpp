// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "contact/interface_laws/pair_rules.hpp"
#include "contact/mesh/adjacent_faces.hpp"
#include "contact/mesh/contact_kinematics.hpp"
#include "contact/mesh/contact_remap.hpp"
#include "contact/search/broad_phase.hpp"
#include "contact/search/faces_turned_away.hpp"
#include "contact/search/shell_sides.hpp"
#include "core/base/optional_index.hpp"
#include "core/definition/contact_options.hpp"
#include "core/mesh/mesh.hpp"

namespace contactsim {

/// In load steps candidates are up to this share of the thinner element's thickness apart, at least: how wide
/// open a face is beside its nodes weighs in the gaps of these.
inline constexpr double load_step_reach = 1.0;

/// Says when to search and what is found. Boxes have a margin, a share of the size of their face; nothing new
/// can touch until two sides together have moved as far as the margins of their smallest faces. The boxes
/// hold the last step's motion too, so that nothing gets past another between two searches.
class ContactSearch {
 public:
  /// All must outlive this.
  ///   body_of  [n_nodes] the rigid body of each node of the mesh, if any, or empty: what belongs to one
  ///            body never meets
  ContactSearch(const ContactMesh& contact_mesh, const Mesh& mesh, const PairRules& rules,
                const SearchOptions& search, const DashOptions& dash,
                std::span<const OptionalIndex<std::uint32_t>> body_of = {});

  /// Goes over to other faces and nodes, which stand where `faces` of the constructor stood already. A search
  /// has to follow.
  void remap(const ContactRemap& remap);

  /// Takes notice of other reaches of the pairs. A search has to follow.
  void renew_reaches() { set_surface_margins(); }
  /// Has searches reach at least as far as these gaps [n_pairs] [length]. A search has to follow.
  void reach_at_least(IndexedVector<PairIndex, double> gaps) {
    least_reach_ = std::move(gaps);
    set_surface_margins();
  }
  /// Searches reach as far as what is held at the start may be apart, the first ones do; or only as far as
  /// what may touch before the next search. A search has to follow.
  void reach_for_start(bool does);
  /// Whether that makes a difference.
  bool has_start_reach() const { return has_start_reach_; }

  /// Whether anything has moved far enough since the last search, or none was made.
  bool is_due(const ContactKinematics& kinematics) const;

  /// A search is one call each of those below that are wanted, faces first, then finish(). All pairs are
  /// sorted, the same for any number of threads. They throw SolveError naming a node that is nowhere.
  ///   depths  how deep each face, surface node or edge is in something already, or nothing [length]

  /// Finds pairs of faces that may meet before the next search, and the boxes of faces that nodes meet.
  ///   partners  [n_faces] faces of greater number
  void find_face_pairs(const ContactKinematics& kinematics, const Motion& motion,
                       std::span<const float> depths, FacePairLists& partners);
  /// Finds faces that surface nodes may meet before the next search.
  ///   faces  [n_surface_nodes]
  void find_node_faces(const ContactKinematics& kinematics, const Motion& motion,
                       std::span<const float> depths, NodeFaceLists& faces);
  /// Finds pairs of edges that may meet before the next search.
  ///   partners  [n_edges] edges of greater number
  void find_edge_pairs(const ContactKinematics& kinematics, const Motion& motion,
                       std::span<const float> depths, EdgePairLists& partners);
  /// Ends a search: margins count from here.
  void finish(const ContactKinematics& kinematics);

  /// Whether some pair keeps the partners of the first search.
  bool keeps_first_partners() const { return has_small_sliding_; }
  /// Whether a pair has any of them.
  bool has_first_partners(PairIndex pair) const;
  /// Keeps these of the first search alone.
  void keep_face_partners(FacePairLists lists) { first_face_partners_ = std::move(lists); }
  /// Has faces, or surface nodes, that kept their partners meet whatever they may, as what is new does.
  void release_face(FaceIndex face) { release(face, contact_mesh_.faces.size(), is_new_face_); }
  void release_row(SurfaceNodeIndex row) { release(row, contact_mesh_.surface_nodes.size(), is_new_row_); }

  void archive(StateArchive& saved);

  /// How far beyond touch what a contact node may meet is looked for [length].
  double margin_of(ContactNodeIndex node) const { return node_margin_[node]; }
  /// Whether a face or a surface node takes part in a pair by its side of a shell.
  template <class Item>
  bool takes_part(const SurfacePair& pair, const Item& item) const {
    return !pair.is_polar() || contactsim::takes_part(pair, item, contact_mesh_, mesh_);
  }
  std::uint64_t n_searches() const { return n_searches_; }
  /// The memory of trees, margins and places of the last search [bytes].
  std::size_t bytes() const {
    return faces_phase_.bytes() + nodes_phase_.bytes() + edges_phase_.bytes() + bytes_of(face_margin_) +
           bytes_of(node_margin_) + bytes_of(searched_at_) + turned_away_.bytes();
  }
  const BroadPhaseCounts& face_counts() const { return faces_phase_.counts(); }
  const BroadPhaseCounts& node_counts() const { return nodes_phase_.counts(); }
  const BroadPhaseCounts& edge_counts() const { return edges_phase_.counts(); }

 private:
  void set_margins();
  void set_surface_margins();
  /// How far a node, or some node of each surface, has moved since the last search, over its margin [1]
  double used_margin(const ContactKinematics& kinematics, SurfaceNodeIndex row) const;
  IndexedVector<SurfaceIndex, double> used_margins(const ContactKinematics& kinematics) const;
  /// Whether the margins that two surfaces have used up leave room between all their faces: what one has used
  /// beyond its own, at its widest, the other has left at its narrowest.
  bool has_room(SurfaceIndex first, double first_used, SurfaceIndex second, double second_used) const;
  Box face_box(const ContactKinematics& kinematics, FaceIndex face, double dt, double deep) const;
  Box node_box(const ContactKinematics& kinematics, SurfaceNodeIndex row, double dt, double deep) const;
  bool faces_may_meet(const ContactKinematics& kinematics, FaceIndex first, FaceIndex second);
  /// Whether only faces that face each other have to do with each other in a pair: nothing holds any others
  /// together, now or later.
  bool has_to_face(const PairRule& rule) const;
  bool node_may_meet(SurfaceNodeIndex row, FaceIndex face) const;
  Box edge_box(const ContactKinematics& kinematics, EdgeIndex edge, double dt, double deep) const;
  /// Whether a sharp edge is none in a pair: both its faces stand for one round surface.
  bool is_smoothed(const ContactEdge& edge, PairIndex pair) const;
  bool edges_may_meet(EdgeIndex first, EdgeIndex second) const;
  /// The rigid body that has all of these contact nodes, if one has.
  OptionalIndex<std::uint32_t> rigid_body_of(std::span<const ContactNodeIndex> nodes) const;
  bool are_of_one_rigid_body(std::span<const ContactNodeIndex> a, std::span<const ContactNodeIndex> b) const {
    const OptionalIndex<std::uint32_t> body = rigid_body_of(a);
    return body && body == rigid_body_of(b);
  }
  /// Whether faces, or edges, without a common node are of elements that have one: they look away from each
  /// other, as the opposite skins of a plate one element thick, and would meet through their own material.
  /// Lofts are looked at by what the mesh joins.
  ///   first_node, second_node  any contact node of each
  bool are_skins_of_one(ElementSide first, ContactNodeIndex first_node, ElementSide second,
                        ContactNodeIndex second_node) const;
  bool has_element_of(ContactNodeIndex node, const ContactFace& face) const;
  /// Of pairs that slide infinitesimally keeps the partners of the first search; what deaths have exposed
  /// slides as it will.
  ///   first        of the first search; taken over from the lists there
  ///   is_new       1 of rows that deaths have exposed, or empty
  ///   surface_of   surface of a row
  template <class Row, class SurfaceOf>
  void keep_first_partners(const IndexedVector<Row, std::uint8_t>& is_new, const SurfaceOf& surface_of,
                           PairLists<Row, FaceIndex>& first, PairLists<Row, FaceIndex>& lists) const;
  template <class AnIndex>
  static void release(AnIndex entity, std::size_t n, IndexedVector<AnIndex, std::uint8_t>& is_new) {
    is_new.resize(n, 0);
    is_new[entity] = 1;
  }
  [[noreturn]] void stop_at(const ContactKinematics& kinematics, const Motion& motion,
                            ContactNodeIndex node) const;

  const ContactMesh& contact_mesh_;
  const Mesh& mesh_;
  const PairRules& rules_;
  AdjacentFaces adjacent_;
  std::span<const OptionalIndex<std::uint32_t>> body_of_;  // [n_nodes], or empty
  bool is_once_;
  double length_scaling_;
  bool has_face_pairs_ = false, has_node_pairs_ = false, has_small_sliding_ = false;
  bool has_eroded_nodes_ = false;
  bool has_start_reach_ = false, reaches_for_start_ = true;
  IndexedVector<PairIndex, std::uint8_t> has_to_face_;                    // [n_pairs] see has_to_face()
  IndexedVector<SurfaceIndex, double> activation_distance_;               // of the models [length]
  IndexedVector<PairIndex, double> least_reach_;                          // or empty [length]
  IndexedVector<FaceIndex, float> face_margin_;                           // [length]
  IndexedVector<ContactNodeIndex, float> node_margin_;                    // [n_contact_nodes] [length]
  IndexedVector<SurfaceIndex, double> widest_margin_, narrowest_margin_;  // [length]
  Eigen::Vector3d searched_from_ = Eigen::Vector3d::Zero();               // a place near the nodes [length]
  IndexedVector<ContactNodeIndex, Eigen::Vector3f>
      searched_at_;  // [n_contact_nodes] where the last search was, from there [length]
  BroadPhase faces_phase_, nodes_phase_, edges_phase_;
  FacesTurnedAway turned_away_;
  // Of the first search, if pairs keep their partners.
  FacePairLists first_face_partners_;
  NodeFaceLists first_node_faces_;
  // 1 of what deaths have exposed since: it has no first partners. Empty before.
  IndexedVector<FaceIndex, std::uint8_t> is_new_face_;
  IndexedVector<SurfaceNodeIndex, std::uint8_t> is_new_row_;
  std::uint64_t n_searches_ = 0;
};

}  // namespace contactsim
