// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "contact/mesh/contact_mesh.hpp"
#include "contact/surfaces/contact_surface.hpp"

namespace contactsim {

/// The contact nodes of a mesh's nodes. The mesh must outlive it.
class ContactNumbers {
 public:
  ///   made  has its nodes
  ContactNumbers(const Mesh& mesh, const ContactMesh& made);

  const Mesh& mesh() const { return mesh_; }
  std::size_t n_nodes() const { return n_nodes_; }
  /// Precondition: the node is in contact.
  ContactNodeIndex operator[](NodeIndex node) const { return numbers_[node.value]; }

 private:
  const Mesh& mesh_;
  std::size_t n_nodes_;
  std::vector<ContactNodeIndex> numbers_;  ///< [n_nodes of the mesh]
};

/// Makes the nodes of contact surfaces, with what each stands for of area and of thickness behind it.
class SurfaceNodes {
 public:
  /// The numbers must outlive this.
  explicit SurfaceNodes(const ContactNumbers& numbers) : numbers_(numbers), of_node_(numbers.n_nodes()) {}

  /// Adds the nodes of a surface, those of its faces or its own.
  ///   made  has the faces of the surface as its last, first_face not yet their end
  void add(const ContactSurface& surface, SurfaceIndex position, ContactMesh& made);

  /// Adds free nodes of a surface, among its nodes.
  ///   is_of_nodes  whether it is a surface of nodes, which stand for their masses
  void add_free(std::span<const ErodedNode> eroded_nodes, SurfaceIndex position, bool is_of_nodes,
                ContactMesh& made) const;

 private:
  template <class IsWanted>
  void add_shares(std::span<const ElementSide> sides, const IsWanted& is_wanted);
  std::vector<ContactNodeIndex> take_faces(std::span<const ContactFace> faces,
                                           IndexedSpan<ContactNodeIndex, const NodeIndex> mesh_nodes);
  std::vector<ContactNodeIndex> take_set(std::span<const NodeIndex> nodes);
  void add_elements(std::span<const std::uint8_t> is_in);

  const ContactNumbers& numbers_;
  IndexedVector<ContactNodeIndex, SurfaceNode> of_node_;  ///< scratch [n_contact_nodes]
};

}  // namespace contactsim
