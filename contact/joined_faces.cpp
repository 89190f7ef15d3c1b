// SPDX-License-Identifier: BSD-3-Clause
#include "contact/joined_faces.hpp"

#include <algorithm>
#include <cmath>

#include "contact/node_face.hpp"

namespace contactsim {

namespace {

/// Distance of a point from a face; beyond its edges that from its nearest corner at most [length].
double distance_of_point(const Eigen::Vector3d& point, const FaceCorners& face) {
  double least = (face.colwise() - point).colwise().norm().minCoeff();
  const auto foot = project_onto_face(face, face.col(2) == face.col(3), point);
  return foot ? std::min(least, std::hypot(foot->gap, foot->beyond)) : least;
}

double distance(const FaceCorners& a, const FaceCorners& b) {
  double least = std::numeric_limits<double>::infinity();
  for (Eigen::Index k = 0; k < 4; ++k)
    least = std::min({least, distance_of_point(a.col(k), b), distance_of_point(b.col(k), a)});
  return least;
}

double radius(const FaceCorners& face) { return (face.colwise() - face.col(0)).colwise().norm().maxCoeff(); }

PairLists list_by_first_alike(const ContactFaces& faces) {
  PairLists lists;
  lists.begin.assign(faces.n_nodes() + 1, 0);
  for (const ContactFace& face : faces.faces) {
    for (const std::uint32_t corner : face.corners) ++lists.begin[faces.first_alike[corner] + 1];
  }
  for (std::size_t i = 0; i < faces.n_nodes(); ++i) lists.begin[i + 1] += lists.begin[i];
  lists.partners.resize(lists.begin.back());
  std::vector<std::uint32_t> next(lists.begin.begin(), lists.begin.end() - 1);
  for (std::uint32_t f = 0; f < faces.faces.size(); ++f) {
    for (const std::uint32_t corner : faces.faces[f].corners)
      lists.partners[next[faces.first_alike[corner]]++] = f;
  }
  return lists;
}

}  // namespace

void JoinedFaces::renew(const Mesh& mesh) {
  if (faces_.loft.size() == 0) return;
  faces_of_node_ = list_by_first_alike(faces_);
  x_.resize(3, static_cast<Eigen::Index>(faces_.n_nodes()));
  for (Eigen::Index i = 0; i < x_.cols(); ++i)
    x_.col(i) = mesh.coordinates().col(faces_.mesh_nodes[static_cast<std::size_t>(i)]);
}

double JoinedFaces::reach_of(std::uint32_t node) const {
  const std::size_t first = faces_.n_mesh_points();
  return node < first ? 0.0 : faces_.loft.distance(node - first);
}

JoinedFaces::Piece JoinedFaces::piece_of(const ContactFace& face) const {
  Piece piece;
  for (std::size_t k = 0; k < 4; ++k) {
    piece.nodes[k] = faces_.first_alike[face.corners[k]];
    piece.reach = std::max(piece.reach, reach_of(face.corners[k]));
  }
  return piece;
}

JoinedFaces::Piece JoinedFaces::piece_of(const SurfaceNode& node) const {
  Piece piece;
  piece.nodes.fill(faces_.first_alike[node.node]);
  piece.reach = reach_of(node.node);
  return piece;
}

FaceCorners JoinedFaces::corners(const Piece& piece) const {
  FaceCorners corners;
  for (Eigen::Index k = 0; k < 4; ++k) corners.col(k) = x_.col(piece.nodes[static_cast<std::size_t>(k)]);
  return corners;
}

bool JoinedFaces::are_joined(std::uint32_t first, std::uint32_t second) const {
  if (faces_.loft.size() == 0) return false;
  return are_joined(piece_of(faces_.faces[first]), piece_of(faces_.faces[second]));
}

bool JoinedFaces::are_joined(const SurfaceNode& node, std::uint32_t face) const {
  if (faces_.loft.size() == 0) return false;
  return are_joined(piece_of(node), piece_of(faces_.faces[face]));
}

bool JoinedFaces::are_joined(const Piece& a, const Piece& b) const {
  const double reach = a.reach + b.reach;
  const FaceCorners at_a = corners(a), at_b = corners(b);
  if (reach == 0.0 || distance(at_a, at_b) > reach) return false;
  const double farthest = radius(at_a) + reach + radius(at_b);
  std::vector<std::uint32_t> seen(a.nodes.begin(), a.nodes.end());
  for (std::size_t i = 0; i < seen.size(); ++i) {
    for (const std::uint32_t face : faces_of_node_.of(seen[i])) {
      for (const std::uint32_t corner : faces_.faces[face].corners) {
        const std::uint32_t node = faces_.first_alike[corner];
        if (std::ranges::find(b.nodes, node) != b.nodes.end()) return true;
        const bool is_near = (x_.col(node) - at_a.col(0)).norm() <= farthest;
        if (is_near && std::ranges::find(seen, node) == seen.end()) seen.push_back(node);
      }
    }
  }
  return false;
}

}  // namespace contactsim
