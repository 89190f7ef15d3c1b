// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <span>
#include <vector>

#include "contact/formulations/contact_step_context.hpp"
#include "contact/geometry/edge_edge.hpp"
#include "contact/mesh/pair_lists.hpp"

namespace contactsim {

/// The pairs of edges that may touch, and the slip that friction holds at each. Both edges have equal weight.
/// Edges push each other apart, with friction. What ties or pulls acts on faces and their nodes: between
/// edges only where these are of faces.
class EdgeContacts {
 public:
  /// The faces must outlive this.
  explicit EdgeContacts(const ContactMesh& contact_mesh);

  /// Room for the next candidates: rows of edges with others of greater number. take_candidates() follows.
  PairLists& next_candidates() { return next_; }
  /// Goes over to the next candidates, with what is remembered of pairs that are in both.
  void take_candidates();

  /// Goes over to other edges, which stand where those of the constructor stood already.
  void remap(const ContactRemap& remap);

  /// Marks the edges of HYBRID pairs that are close to each other.
  ///   size_share  the automatic CAPTURE TOLERANCE over the shorter edge [1]
  void mark_close(const ContactStepContext& context, double size_share, PairRules& rules) const;

  const PairLists& candidates() const { return candidates_; }
  std::size_t n_rows() const { return candidates_.n_rows(); }

  /// Begins a step: which edges touch is gathered anew.
  void begin_step();
  /// Adds a contact point to what is known of its edges.
  void note(const ContactPoint& point);

  /// Appends the contact points of rows [begin, end). Rows may be shared among threads.
  void find(const ContactStepContext& context, std::size_t begin, std::size_t end,
            std::vector<ContactPoint>& points);

  /// How deep each edge was in the last step [n_edges], 0 where it did not touch.
  std::span<const float> depths() const { return depth_now_; }

  void archive(StateArchive& saved);

 private:
  /// Slip that is held at the one or two contact points of a pair [length].
  using ElasticSlips = std::array<Eigen::Vector3d, 2>;
  struct Pair {
    const ContactEdge &first, &second;
    const PairRule& rule;
    bool touched;         ///< one of the edges, something, in the last step
    double depth_before;  ///< and how deep it was [length]
  };

  void find_one(const ContactStepContext& context, std::uint32_t first, std::size_t candidate,
                std::vector<ContactPoint>& points);
  /// Whether ties hold faces or nodes of two sharp edges together.
  bool are_held(const ContactStepContext& context, std::uint32_t pair, std::uint32_t first,
                std::uint32_t second) const;
  /// Whether a point of an edge is its own: at a node that several have, only the edge that is nearest there
  /// has it, the first of them if they are alike.
  ///   way  to the other edge [length]
  bool owns(const ContactStepContext& context, std::uint32_t edge, double share,
            const EdgePairPoint& pair_point, const Eigen::Vector3d& way) const;
  /// The contact point of two edges; without stiffness when the edges are not near.
  static ContactPoint make_contact_point(const ContactStepContext& context, const Pair& pair,
                                         const EdgePairPoint& pair_point);

  const ContactMesh& contact_mesh_;
  PairLists candidates_, next_;
  PairLists edges_of_node_;                  // [n_contact_nodes] round ones, by first_alike
  std::vector<ElasticSlips> elastic_slips_;  // [n_candidates]
  // [n_edges] penetration, 0 where nothing touches, in the last step and in this one [length]
  std::vector<float> depth_before_, depth_now_;
};

}  // namespace contactsim
