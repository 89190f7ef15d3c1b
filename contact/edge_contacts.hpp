// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <span>
#include <vector>

#include "contact/contact_scene.hpp"
#include "contact/edge_edge.hpp"
#include "contact/pair_lists.hpp"

namespace contactsim {

/// The pairs of edges that may touch, and the slip that friction holds at each. Both edges have equal weight.
/// Ties and laws that pull do not act between edges.
class EdgeContacts {
 public:
  /// The faces must outlive this.
  explicit EdgeContacts(const ContactFaces& faces);

  /// Room for the next candidates: rows of edges with others of greater number. take_candidates() follows.
  PairLists& next_candidates() { return next_; }
  /// Goes over to the next candidates, with what is remembered of pairs that are in both.
  void take_candidates();

  const PairLists& candidates() const { return candidates_; }
  std::size_t n_rows() const { return candidates_.n_rows(); }

  /// Appends the places of contact of rows [begin, end). Rows may be shared among threads.
  void find(const ContactScene& scene, std::size_t begin, std::size_t end,
            std::vector<ContactRecord>& records);

  void archive(StateArchive& saved);

 private:
  /// What is known of a pair from the last step.
  struct Memory {
    /// Slip that is held at its one or two places [length].
    std::array<Eigen::Vector3d, 2> elastic{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
    bool touched = false;
  };
  struct Pair {
    const ContactEdge &first, &second;
    const PairRule& rule;
    const Memory& memory;
  };

  void find_one(const ContactScene& scene, std::uint32_t first, std::size_t candidate,
                std::vector<ContactRecord>& records);
  /// Whether a place of an edge is its own: at a node that several have, only the edge that is nearest there
  /// has it, the first of them if they are alike.
  ///   way  to the other edge [length]
  bool owns(const ContactScene& scene, std::uint32_t edge, double share, const EdgePlace& place,
            const Eigen::Vector3d& way) const;
  /// The record of a place; without stiffness when the edges are not near.
  static ContactRecord make_record(const ContactScene& scene, const Pair& pair, const EdgePlace& place);

  const ContactFaces& faces_;
  PairLists candidates_, next_;
  PairLists edges_of_node_;     // [n_contact_nodes] round ones, by first_alike
  std::vector<Memory> memory_;  // [n_candidates]
};

}  // namespace contactsim
