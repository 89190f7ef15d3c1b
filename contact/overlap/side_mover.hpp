// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <span>
#include <vector>

#include "contact/overlap/overlap_detection.hpp"

namespace contactsim {

/// Moves the nodes of sides of contact, and knows by how much for which pair.
class SideMover {
 public:
  /// All must outlive this.
  ///   is_held  [n_nodes] as remove_overlap() has it
  SideMover(const ContactModel& model, const ContactMesh& contact_mesh, std::span<const std::uint8_t> is_held,
            ShiftedPoints& points)
      : model_(model),
        contact_mesh_(contact_mesh),
        is_held_(is_held),
        points_(points),
        moved_(model.pairs.size()) {}

  /// Moves what moves out of an overlap by a way along its normal. Returns whether anything did.
  bool resolve(PairIndex pair, const Overlap& overlap, double way);
  /// The same by a share of the depth, less what the sides have gone since the points were renewed.
  bool resolve_rest(PairIndex pair, const Overlap& overlap, double share);
  /// Moves a node of the mesh.
  void move(PairIndex pair, NodeIndex node, const Eigen::Vector3d& way);
  /// Half the way when the nodes of the other side, which move by themselves, can move [1].
  double share_of_first(PairIndex pair, const Overlap& overlap) const;

  /// How far nodes have gone for a pair, by node of the mesh [length].
  const std::map<std::uint32_t, Eigen::Vector3d>& moved(PairIndex pair) const { return moved_[pair]; }
  /// The pair that has moved the nodes of an element farthest.
  PairIndex culprit_of(std::span<const NodeIndex> element_nodes) const;

 private:
  /// Moves a side by moving its free nodes, those more that have more of it.
  void move(PairIndex pair, const ContactPointSide& side, const Eigen::Vector3d& way);
  /// The sum of the squares of the free nodes' weights [1].
  double mobility(const ContactPointSide& side) const;
  bool can_move(const ContactPointSide& side) const;
  bool is_held(ContactNodeIndex point) const;

  const ContactModel& model_;
  const ContactMesh& contact_mesh_;
  std::span<const std::uint8_t> is_held_;
  ShiftedPoints& points_;
  IndexedVector<PairIndex, std::map<std::uint32_t, Eigen::Vector3d>> moved_;
};

}  // namespace contactsim
