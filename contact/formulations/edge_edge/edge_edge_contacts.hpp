// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "contact/formulations/close_candidates.hpp"
#include "contact/formulations/contact_formulation.hpp"
#include "contact/formulations/edge_edge/edge_bounds.hpp"
#include "contact/formulations/edge_edge/edge_slips.hpp"
#include "contact/geometry/edge_edge.hpp"
#include "contact/mesh/pair_lists.hpp"

namespace contactsim {

/// The pairs of edges that may touch, and the slip that friction holds at each. Both edges have equal weight.
/// Edges push each other apart, with friction. What ties or pulls acts on faces and their nodes: between
/// edges only where these are of faces.
/// A PointFormulation.
class EdgeEdgeContacts {
 public:
  explicit EdgeEdgeContacts(const FormulationSetup& setup);

  void find_candidates(ContactSearch& search, const ContactKinematics& kinematics, const Motion& motion);
  /// Goes over to candidates.
  ///   candidates  rows of edges with others of greater number
  void take_candidates(EdgePairLists candidates) {
    candidates_ = std::move(candidates);
    close_.forget();
  }
  std::size_t n_rows() const { return candidates_.n_rows(); }
  std::size_t n_candidates() const { return candidates_.partners.size(); }
  std::size_t n_close() const { return close_.size(); }
  void forget_close() { close_.forget(); }
  /// Edges need no bounds of faces.
  void watch(IndexedVector<FaceIndex, std::uint8_t>& /*is_watched*/) const {}

  void begin_step();
  void undo_begin_step() { swap_steps(); }
  void begin_detection(const ContactStepContext& context);
  void detect(const ContactStepContext& context, CandidateRows rows, std::vector<ContactPoint>& points) const;
  void update(const ContactStepContext& context, CandidateRows rows, std::span<const ContactPoint> points);
  /// None: an edge that has passed another is behind its faces, which know it.
  void find_lost(const PairRules& /*rules*/, std::vector<LostContact>& /*lost*/) const {}
  /// Marks the edges of HYBRID pairs that are close to each other.
  void mark_close(const ContactStepContext& context, double size_share, PairRules& rules) const;
  /// Appends the gaps before the first step of edges of pairs that have to know them.
  void add_start_gaps(const ContactStepContext& context, FoundStartGaps& gaps) const;

  void remap(const ContactRemap& remap);
  void archive(StateArchive& saved);

 private:
  void swap_steps();
  struct Pair {
    const ContactEdge &first, &second;
    const PairRule& rule;
    bool touched;         ///< one of the edges, something, in the last step
    double depth_before;  ///< and how deep it was [length]
    double offset = 0.0;  ///< taken off the gap [length]
  };

  void detect_one(const ContactStepContext& context, EdgeIndex first, EdgeIndex second,
                  std::vector<ContactPoint>& points) const;
  /// Whether ties hold faces or nodes of two sharp edges together.
  bool are_held(const ContactStepContext& context, PairIndex pair, EdgeIndex first, EdgeIndex second) const;
  /// Whether a point of an edge is its own: at a node that several have, only the edge that is nearest there
  /// has it, the first of them if they are alike.
  ///   way  to the other edge [length]
  bool owns(const ContactStepContext& context, EdgeIndex edge, double share, const EdgePairPoint& pair_point,
            const Eigen::Vector3d& way) const;
  /// The contact point of two edges; without stiffness when the edges are not near.
  static ContactPoint make_contact_point(const ContactStepContext& context, const Pair& pair,
                                         const EdgePairPoint& pair_point);

  const ContactMesh& contact_mesh_;
  EdgePairLists candidates_;
  CloseCandidates<EdgeIndex, EdgeIndex> close_;
  std::vector<EdgeIndex> all_edges_, close_edges_;        // of the mesh, of close candidates
  EdgeBounds bounds_;                                     // of the step
  PairLists<ContactNodeIndex, EdgeIndex> edges_of_node_;  // [n_contact_nodes] round ones, by first_alike
  EdgeSlips slips_before_, slips_now_;                    // in the last step and in this one
  // Penetration, 0 where nothing touches, in the last step and in this one [length]
  IndexedVector<EdgeIndex, float> depth_before_, depth_now_;
};

}  // namespace contactsim
