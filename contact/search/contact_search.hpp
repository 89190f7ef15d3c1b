// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "contact/interface_laws/pair_rules.hpp"
#include "contact/mesh/contact_kinematics.hpp"
#include "contact/mesh/contact_remap.hpp"
#include "contact/search/broad_phase.hpp"
#include "contact/search/candidate_filter.hpp"
#include "contact/search/faces_turned_away.hpp"
#include "contact/search/first_partners.hpp"
#include "contact/search/search_margins.hpp"
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
  ///   ranks    which search together
  ContactSearch(const ContactMesh& contact_mesh, const Mesh& mesh, const PairRules& rules,
                const SearchOptions& search, const DashOptions& dash,
                std::span<const OptionalIndex<std::uint32_t>> body_of = {}, Ranks& ranks = one_rank());

  /// Goes over to other faces and nodes, which stand where `faces` of the constructor stood already. A search
  /// has to follow.
  void remap(const ContactRemap& remap);

  /// Takes notice of other reaches of the pairs. A search has to follow.
  void renew_reaches() { set_activation_distances(); }
  /// Has searches reach at least as far as these gaps [n_pairs] [length]. A search has to follow.
  void reach_at_least(IndexedVector<PairIndex, double> gaps) {
    least_reach_ = std::move(gaps);
    set_activation_distances();
  }
  /// Searches reach as far as what is held at the start may be apart, the first ones do; or only as far as
  /// what may touch before the next search. A search has to follow.
  void reach_for_start(bool does);
  /// Whether that makes a difference.
  bool has_start_reach() const { return has_start_reach_; }

  /// Whether anything has moved far enough since the last search, or none was made.
  bool is_due(const ContactKinematics& kinematics);

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
  bool has_first_partners(PairIndex pair) const {
    return first_partners_.has_any(pair, contact_mesh_, rules_);
  }
  /// Keeps these of the first search alone.
  void keep_face_partners(FacePairLists lists) { first_partners_.keep(std::move(lists)); }
  /// Has faces, or surface nodes, that kept their partners meet whatever they may, as what is new does.
  void release_face(FaceIndex face) { first_partners_.release(face, contact_mesh_); }
  void release_row(SurfaceNodeIndex row) { first_partners_.release(row, contact_mesh_); }

  void archive(StateArchive& saved);

  /// How far beyond touch what a contact node may meet is looked for [length].
  double margin_of(ContactNodeIndex node) const { return margins_.of(node); }
  /// Whether a face or a surface node takes part in a pair by its side of a shell.
  template <class Item>
  bool takes_part(const SurfacePair& pair, const Item& item) const {
    return filter_.takes_part(pair, item);
  }
  std::uint64_t n_searches() const { return n_searches_; }
  /// The memory of trees, margins, filter and places of the last search [bytes].
  std::size_t bytes() const {
    return faces_phase_.bytes() + nodes_phase_.bytes() + edges_phase_.bytes() + margins_.bytes() +
           turned_away_.bytes() + filter_.bytes();
  }
  const BroadPhaseCounts& face_counts() const { return faces_phase_.counts(); }
  const BroadPhaseCounts& node_counts() const { return nodes_phase_.counts(); }
  const BroadPhaseCounts& edge_counts() const { return edges_phase_.counts(); }

 private:
  void set_activation_distances();
  Box face_box(const ContactKinematics& kinematics, FaceIndex face, double dt, double deep) const;
  Box node_box(const ContactKinematics& kinematics, SurfaceNodeIndex row, double dt, double deep) const;
  Box edge_box(const ContactKinematics& kinematics, EdgeIndex edge, double dt, double deep) const;
  /// Of pairs that slide infinitesimally keeps the candidates of the first search.
  template <class Lists>
  void keep_first_partners(Lists& lists) {
    if (!has_small_sliding_) return;
    if (n_searches_ == 0) {
      first_partners_.keep(lists);
    } else {
      first_partners_.restrict(contact_mesh_, rules_, lists);
    }
  }
  [[noreturn]] void stop_at(const ContactKinematics& kinematics, const Motion& motion,
                            ContactNodeIndex node) const;

  const ContactMesh& contact_mesh_;
  const Mesh& mesh_;
  const PairRules& rules_;
  bool is_once_;
  Ranks* ranks_;
  double length_scaling_;
  bool has_face_pairs_ = false, has_node_pairs_ = false, has_small_sliding_ = false;
  bool has_eroded_nodes_ = false;
  bool has_start_reach_ = false, reaches_for_start_ = true;
  IndexedVector<SurfaceIndex, double> activation_distance_;  // of the models [length]
  IndexedVector<PairIndex, double> least_reach_;             // or empty [length]
  CandidateFilter filter_;
  SearchMargins margins_;
  BroadPhase faces_phase_, nodes_phase_, edges_phase_;
  FacesTurnedAway turned_away_;
  FirstPartners first_partners_;  // if pairs keep them
  std::uint64_t n_searches_ = 0;
  double quiet_until_ = 0.0;  // no search is due up to that path() of the contact nodes [length]
};

}  // namespace contactsim
