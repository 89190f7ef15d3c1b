// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact/geometry/face_map.hpp"
#include "contact/mesh/contact_mesh.hpp"

namespace contactsim {

/// Which lofts overlap others only because the mesh joins them: at folds, corners and T-junctions skins lie
/// in each other from the start, farther than the elements that share a node when shells are thicker, or
/// beams wider, than long. They never touch there.
class AdjacentFaces {
 public:
  /// The faces must outlive this.
  AdjacentFaces(const ContactMesh& contact_mesh, const Mesh& mesh) : contact_mesh_(contact_mesh) {
    renew(mesh);
  }
  /// Takes over that the faces have changed.
  void renew(const Mesh& mesh);

  /// Whether one of two faces is of a loft, their shells or solids lay within the thickness of their lofts of
  /// each other at the start, and faces join them that lie no farther away.
  bool are_adjacent(FaceIndex first, FaceIndex second) const;
  /// The same of a surface node and a face, and of two edges.
  bool are_adjacent(const SurfaceNode& node, FaceIndex face) const;
  bool are_adjacent(const ContactEdge& first, const ContactEdge& second) const;

 private:
  /// Contact nodes, first_alike, with the distance that their lofts stand off.
  struct Piece {
    std::array<ContactNodeIndex, 4> nodes{};
    double offset = 0.0;  ///< [length]
  };
  Piece piece_of(const ContactFace& face) const;
  Piece piece_of(const SurfaceNode& node) const;
  Piece piece_of(const ContactEdge& edge) const;
  /// Position among the faces, then the edges.
  using PieceIndex = Index<Piece>;
  IndexRange<PieceIndex> pieces() const {
    return {{}, {static_cast<std::uint32_t>(contact_mesh_.faces.size() + contact_mesh_.edges.size())}};
  }
  Piece piece(PieceIndex index) const;
  double offset_of(ContactNodeIndex node) const;
  /// Finds which nodes pieces join to one body, and how large these are.
  void find_bodies();
  void bound_bodies();
  /// Whether all nodes of the body of a node are within a distance of it.
  bool has_body_within(ContactNodeIndex node, double distance) const;
  bool are_adjacent(const Piece& a, const Piece& b) const;
  FaceCorners corners(const Piece& piece) const;

  const ContactMesh& contact_mesh_;
  Eigen::Matrix3Xd x_;  // 3 x n_contact_nodes at the start, of lofts the nodes that they hang on [length]
  IndexedVector<ContactNodeIndex, ContactNodeIndex>
      body_;  // [n_contact_nodes] by first_alike: the first node of its body
  /// [n_contact_nodes] of a first node of a body: a sphere around the body [length]
  IndexedVector<ContactNodeIndex, Eigen::Vector4d> spheres_;
  PairLists<ContactNodeIndex, PieceIndex>
      pieces_of_node_;  // [n_contact_nodes] by first_alike; empty without lofts
};

}  // namespace contactsim
