// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "contact/mesh/contact_kinematics.hpp"
#include "contact/search/box_tree.hpp"
#include "core/base/optional_index.hpp"

namespace contactsim {

/// A solid, or the room between the top and the bottom of a lofted shell.
struct BodyVolume {
  Eigen::Matrix<double, 3, 8> corners;  ///< [length]; a wedge of a triangle has six
  Shape shape;
  std::uint32_t body;  ///< its first node
  ElementIndex element;
};

/// What nodes may lie in: the volumes of thick bodies, which are those with contact faces of solids or of
/// lofted shells. Bodies are what solids and shells join.
class BodyVolumes {
 public:
  /// All must outlive this.
  ///   alive  [n_elements] 0 of elements that hold nothing; empty: all do
  BodyVolumes(const Mesh& mesh, const ContactMesh& contact_mesh, std::span<const std::uint8_t> alive = {});

  /// [n_nodes] the first node of each node's body.
  const std::vector<std::uint32_t>& bodies() const { return bodies_; }
  /// The first nodes of thick bodies, ascending.
  const std::vector<std::uint32_t>& thick_bodies() const { return thick_bodies_; }
  /// The position in thick_bodies() of the body of a node, if it is one.
  OptionalIndex<std::uint32_t> number_of_body(std::uint32_t node) const { return find_number(bodies_[node]); }

  /// The boxes around thick bodies [n_thick_bodies].
  ///   coordinates  [3 x n_nodes] of the mesh [length]
  ///   kinematics   the contact nodes there, as for near()
  std::vector<Box> boxes(const Eigen::Matrix3Xd& coordinates, const ContactKinematics& kinematics) const;
  /// The volumes that meet the boxes of what may lie in them.
  ///   boxes  of each thick body [n_thick_bodies]
  std::vector<BodyVolume> near(const Eigen::Matrix3Xd& coordinates, const ContactKinematics& kinematics,
                               std::span<const Box> boxes) const;

 private:
  /// Of a lofted shell, first the corners of the top, then below each of them that of the bottom.
  struct Loft {
    std::array<ContactNodeIndex, 8> corners;
    ElementIndex element;
  };
  class NumberOfLast;
  void find_thick_bodies();
  OptionalIndex<std::uint32_t> find_number(std::uint32_t body) const;
  void find_lofts();

  const Mesh& mesh_;
  const ContactMesh& contact_mesh_;
  std::span<const std::uint8_t> alive_;
  std::vector<std::uint32_t> bodies_, thick_bodies_;
  std::vector<Loft> lofts_;
};

}  // namespace contactsim
