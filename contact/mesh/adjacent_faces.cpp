// SPDX-License-Identifier: BSD-3-Clause
#include "contact/mesh/adjacent_faces.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "contact/geometry/node_face.hpp"

namespace contactsim {

namespace {

/// Distance of a point from a face; beyond its edges that from its nearest corner at most [length].
double distance_of_point(const Eigen::Vector3d& point, const FaceCorners& face) {
  double least = (face.colwise() - point).colwise().norm().minCoeff();
  const auto closest = project_onto_face(face, face.col(2) == face.col(3), point);
  return closest ? std::min(least, std::hypot(closest->gap, closest->beyond)) : least;
}

double distance(const FaceCorners& a, const FaceCorners& b) {
  double least = std::numeric_limits<double>::infinity();
  for (Eigen::Index k = 0; k < 4; ++k)
    least = std::min({least, distance_of_point(a.col(k), b), distance_of_point(b.col(k), a)});
  return least;
}

bool are_within(double reach, const FaceCorners& a, const FaceCorners& b) {
  for (Eigen::Index k = 0; k < 4; ++k) {
    if ((b.colwise() - a.col(k)).colwise().norm().minCoeff() <= reach) return true;
  }
  return distance(a, b) <= reach;
}

double radius(const FaceCorners& face) { return (face.colwise() - face.col(0)).colwise().norm().maxCoeff(); }

}  // namespace

void AdjacentFaces::renew(const Mesh& mesh) {
  const ContactMesh& contact_mesh = contact_mesh_;
  pieces_of_node_ = {};
  if (contact_mesh.loft.size() == 0 && contact_mesh.edges.empty()) return;
  pieces_of_node_ = list_by_row<ContactNodeIndex, PieceIndex>(contact_mesh.n_nodes(), [&](const auto& take) {
    for (const PieceIndex i : pieces()) {
      for (const ContactNodeIndex node : piece(i).nodes) take(node, i);
    }
  });
  find_bodies();
  x_.resize(3, static_cast<Eigen::Index>(contact_mesh.n_nodes()));
  for (const ContactNodeIndex i : contact_mesh.nodes())
    x_.col(i.value) = mesh.coordinates().col(contact_mesh.mesh_nodes[i].value);
  bound_bodies();
}

/// About the middle of the box around each body.
void AdjacentFaces::bound_bodies() {
  IndexedVector<ContactNodeIndex, Eigen::AlignedBox3d> boxes(body_.size());
  for (const ContactNodeIndex i : indices(body_)) boxes[body_[i]].extend(x_.col(i.value));
  spheres_.assign(body_.size(), Eigen::Vector4d::Zero());
  for (const ContactNodeIndex i : indices(body_)) {
    Eigen::Vector4d& sphere = spheres_[body_[i]];
    sphere.head<3>() = boxes[body_[i]].center();
    sphere[3] = std::max(sphere[3], (x_.col(i.value) - sphere.head<3>()).norm());
  }
}

bool AdjacentFaces::has_body_within(ContactNodeIndex node, double distance) const {
  const Eigen::Vector4d& sphere = spheres_[body_[node]];
  constexpr double rounding = 1e-9;
  return (1.0 + rounding) * ((sphere.head<3>() - x_.col(node.value)).norm() + sphere[3]) <= distance;
}

void AdjacentFaces::find_bodies() {
  body_.resize(contact_mesh_.n_nodes());
  std::ranges::copy(indices(body_), body_.begin());
  const auto first_of = [this](ContactNodeIndex node) {
    while (body_[node] != node) node = body_[node] = body_[body_[node]];
    return node;
  };
  for (const PieceIndex i : pieces()) {
    const auto nodes = piece(i).nodes;
    for (const ContactNodeIndex node : nodes) {
      const auto [low, high] = std::minmax({first_of(nodes[0]), first_of(node)});
      body_[high] = low;
    }
  }
  for (const ContactNodeIndex i : indices(body_)) body_[i] = first_of(i);
}

AdjacentFaces::Piece AdjacentFaces::piece(PieceIndex index) const {
  const std::uint32_t n_faces = contact_mesh_.faces.next().value;
  return index.value < n_faces ? piece_of(contact_mesh_.faces[{index.value}])
                               : piece_of(contact_mesh_.edges[{index.value - n_faces}]);
}

AdjacentFaces::Piece AdjacentFaces::piece_of(const ContactEdge& edge) const {
  const ContactNodeIndex a = contact_mesh_.first_alike[edge.nodes[0]],
                         b = contact_mesh_.first_alike[edge.nodes[1]];
  const double offset = std::max({edge.radius, offset_of(edge.nodes[0]), offset_of(edge.nodes[1])});
  return {{a, b, b, b}, offset};
}

double AdjacentFaces::offset_of(ContactNodeIndex node) const {
  const std::size_t first = contact_mesh_.n_mesh_points();
  return node.value < first ? 0.0 : contact_mesh_.loft.distance(node.value - first);
}

AdjacentFaces::Piece AdjacentFaces::piece_of(const ContactFace& face) const {
  Piece piece;
  for (std::size_t k = 0; k < 4; ++k) {
    piece.nodes[k] = contact_mesh_.first_alike[face.corners[k]];
    piece.offset = std::max(piece.offset, offset_of(face.corners[k]));
  }
  return piece;
}

AdjacentFaces::Piece AdjacentFaces::piece_of(const SurfaceNode& node) const {
  Piece piece;
  piece.nodes.fill(contact_mesh_.first_alike[node.node]);
  piece.offset = std::max<double>(offset_of(node.node), node.radius);
  return piece;
}

FaceCorners AdjacentFaces::corners(const Piece& piece) const {
  FaceCorners corners;
  for (Eigen::Index k = 0; k < 4; ++k)
    corners.col(k) = x_.col(piece.nodes[static_cast<std::size_t>(k)].value);
  return corners;
}

bool AdjacentFaces::are_adjacent(FaceIndex first, FaceIndex second) const {
  if (pieces_of_node_.n_rows() == 0) return false;
  return are_adjacent(piece_of(contact_mesh_.faces[first]), piece_of(contact_mesh_.faces[second]));
}

bool AdjacentFaces::are_adjacent(const SurfaceNode& node, FaceIndex face) const {
  if (pieces_of_node_.n_rows() == 0) return false;
  return are_adjacent(piece_of(node), piece_of(contact_mesh_.faces[face]));
}

bool AdjacentFaces::are_adjacent(const ContactEdge& first, const ContactEdge& second) const {
  return are_adjacent(piece_of(first), piece_of(second));
}

bool AdjacentFaces::are_adjacent(const Piece& a, const Piece& b) const {
  const double offset = a.offset + b.offset;
  if (offset == 0.0 || body_[a.nodes[0]] != body_[b.nodes[0]]) return false;
  const FaceCorners at_a = corners(a), at_b = corners(b);
  if (!are_within(offset, at_a, at_b)) return false;
  const double farthest = radius(at_a) + offset + radius(at_b);
  if (has_body_within(a.nodes[0], farthest)) return true;
  // Nodes that pieces join to the first, those near the second first, and in which search a node was met
  // last.
  using Step = std::pair<double, ContactNodeIndex>;
  thread_local std::vector<Step> steps;
  thread_local IndexedVector<ContactNodeIndex, std::uint64_t> met;
  thread_local std::uint64_t search = 0;
  ++search;
  steps.clear();
  met.resize(std::max(met.size(), body_.size()), 0);
  const auto meet = [&](ContactNodeIndex node) {
    if (std::exchange(met[node], search) == search) return;
    steps.emplace_back((x_.col(node.value) - at_b.col(0)).squaredNorm(), node);
    std::ranges::push_heap(steps, std::greater<>());
  };
  std::ranges::for_each(a.nodes, meet);
  while (!steps.empty()) {
    std::ranges::pop_heap(steps, std::greater<>());
    const ContactNodeIndex nearest = steps.back().second;
    steps.pop_back();
    for (const PieceIndex neighbour : pieces_of_node_.of(nearest)) {
      for (const ContactNodeIndex node : piece(neighbour).nodes) {
        if (std::ranges::find(b.nodes, node) != b.nodes.end()) return true;
        if ((x_.col(node.value) - at_a.col(0)).norm() <= farthest) meet(node);
      }
    }
  }
  return false;
}

}  // namespace contactsim
