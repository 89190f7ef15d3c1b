// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

#include "contact/mesh/contact_model.hpp"
#include "contact/overlap/deep_overlaps.hpp"

namespace contactsim {

/// How overlap removal learns that a node stays where it is, or that its body does not go as a whole.
inline constexpr std::uint8_t held_fully = 1, held_in_part = 2;

/// A body on its way out of another one.
struct BodyMove {
  PairIndex pair;                                 ///< of surfaces that overlap
  std::uint32_t body = 0;                         ///< its first node
  Eigen::Vector3d way = Eigen::Vector3d::Zero();  ///< [length]
  double depth = 0.0;                             ///< of the deepest node [length]
};

/// Parts bodies that lie deeper in each other than half an element: to push their surfaces out would crush
/// the elements behind them, so bodies go as wholes, half the way each, or all of it where one has a node
/// that is held.
class BodyParting {
 public:
  /// All must outlive this.
  BodyParting(const ContactModel& model, const Mesh& mesh, const OverlapParts& parts);

  /// The moves of a pass, no more than one of each body. Overlap that is deeper than the pair's overlap
  /// normal tolerance stays.
  ///   coordinates  [3 x n_nodes] of the mesh [length]
  ///   surface      the contact nodes there
  ///   is_held      [n_nodes] 0, held_fully or held_in_part; or empty
  std::vector<BodyMove> find_moves(const Eigen::Matrix3Xd& coordinates, const ContactKinematics& kinematics,
                                   std::span<const std::uint8_t> is_held) const;

  /// Nodes that lie deeper in another body than half an element.
  std::vector<DeepOverlap> find_deep(const Eigen::Matrix3Xd& coordinates,
                                     const ContactKinematics& kinematics) const;

  std::span<const NodeIndex> nodes_of(std::uint32_t body) const {
    return std::span(nodes_).subspan(begin_[body], begin_[body + 1] - begin_[body]);
  }

 private:
  std::uint32_t body_of(ContactNodeIndex point) const {
    return deep_.bodies()[parts_.contact_mesh.mesh_nodes[point].value];
  }

  const ContactModel& model_;
  const OverlapParts& parts_;
  DeepOverlaps deep_;
  std::vector<std::uint32_t> begin_;  // [n_nodes + 1] by the first node of a body
  std::vector<NodeIndex> nodes_;      // by body
};

}  // namespace contactsim
