// SPDX-License-Identifier: BSD-3-Clause
#include "contact/overlap_parts.hpp"

#include <algorithm>
#include <cmath>

#include "contact/contact_search.hpp"
#include "contact/joined_faces.hpp"
#include "contact/sharp_edges.hpp"

namespace contactsim {

namespace {

bool is_solid(const Mesh& mesh, ElementSide side) {
  return topology(mesh.blocks()[mesh.block_of(side.element())].shape).family == Family::solid;
}

std::vector<OverlapFace> measure_faces(const MovingSurface& start, const Mesh& mesh) {
  std::vector<OverlapFace> measured;
  for (const ContactFace& face : start.faces().faces) {
    const double area = start.area(face).norm();
    const bool has_thickness = start.faces().is_lofted(face) || is_solid(mesh, face.side);
    measured.push_back({std::sqrt(area), has_thickness && area > 0.0 ? 0.5 * face.backing.thickness : 0.0});
  }
  return measured;
}

std::vector<OverlapNode> measure_nodes(const MovingSurface& start, std::span<const OverlapFace> of_face) {
  const ContactFaces& faces = start.faces();
  std::vector<OverlapNode> measured;
  for (const SurfaceNode& node : faces.surface_nodes) {
    OverlapNode& made = measured.emplace_back();
    made.reach = node.radius;
    if (node.radius > 0.0f) continue;
    bool is_first = true;
    for (const std::uint32_t face : faces.faces_of_node.of(node.node)) {
      if (faces.faces[face].surface != node.surface) continue;
      made.normal += start.area(faces.faces[face]);
      made.size = std::max(made.size, of_face[face].size);
      made.reach = is_first ? of_face[face].reach : std::min(made.reach, of_face[face].reach);
      is_first = false;
    }
  }
  return measured;
}

/// A box around points, wider by a margin.
template <class Points>
Box box_around(const Points& points, double margin) {
  const Eigen::Vector3d lo = points.rowwise().minCoeff(), hi = points.rowwise().maxCoeff();
  Box box;
  for (std::size_t k = 0; k < 3; ++k) {
    box.lo[k] = lo[static_cast<Eigen::Index>(k)] - margin;
    box.hi[k] = hi[static_cast<Eigen::Index>(k)] + margin;
  }
  return box;
}

/// Finds what is near to what.
class NearParts {
 public:
  NearParts(const ContactModel& model, const ContactDefinition& definition, const Mesh& mesh,
            OverlapParts& parts)
      : model_(model),
        definition_(definition),
        mesh_(mesh),
        parts_(parts),
        start_(surface_of_mesh(parts.faces, mesh)),
        rules_(model.pairs, std::vector<ActiveTimes>(model.pairs.size()), model.surfaces.surfaces.size()),
        joined_(parts.faces, mesh) {}

  void add_planes();
  void add_faces();
  void add_edges();

 private:
  std::vector<Box> boxes_of_nodes() const;
  std::vector<Box> boxes_of_faces() const;
  bool may_meet(std::uint32_t row, std::uint32_t face) const;

  const ContactModel& model_;
  const ContactDefinition& definition_;
  const Mesh& mesh_;
  OverlapParts& parts_;
  MovingSurface start_;
  PairRules rules_;
  JoinedFaces joined_;
};

void NearParts::add_planes() {
  const ContactFaces& faces = parts_.faces;
  const auto add = [&](std::uint32_t with_planes, std::uint32_t with_nodes, PairSites& sites) {
    for (const std::uint32_t plane : model_.surfaces.surfaces[with_planes].analytic_planes) {
      for (std::uint32_t i = faces.first_node[with_nodes]; i < faces.first_node[with_nodes + 1]; ++i) {
        const bool is_lofted = parts_.is_lofted(faces.surface_nodes[i]);
        (is_lofted ? sites.lofted : sites.meshed).planes.push_back({i, plane});
      }
    }
  };
  for (std::uint32_t p = 0; p < model_.pairs.size(); ++p) {
    const SurfacePair& pair = model_.pairs[p];
    add(pair.first, pair.second, parts_.sites[p]);
    if (pair.first != pair.second) add(pair.second, pair.first, parts_.sites[p]);
  }
}

std::vector<Box> NearParts::boxes_of_nodes() const {
  std::vector<Box> boxes;
  // A ball may be pushed on by as much as it is thick.
  for (const SurfaceNode& node : parts_.faces.surface_nodes)
    boxes.push_back(box_around(start_.x(node.node), 2.0 * static_cast<double>(node.radius)));
  return boxes;
}

std::vector<Box> NearParts::boxes_of_faces() const {
  double deepest = 0.0;
  for (const SurfacePair& pair : model_.pairs)
    deepest = std::max(deepest, pair.overlap_normal_tolerance.value_or(0.0));
  std::vector<Box> boxes;
  for (std::uint32_t i = 0; i < parts_.faces.faces.size(); ++i) {
    // Both sides move, each by no more than the deepest overlap.
    const double margin = 2.0 * std::max(parts_.of_face[i].reach, deepest);
    const auto& corners = parts_.faces.faces[i].corners;
    FaceCorners x;
    for (std::size_t k = 0; k < 4; ++k) x.col(static_cast<Eigen::Index>(k)) = start_.x(corners[k]);
    boxes.push_back(box_around(x, margin));
  }
  return boxes;
}

bool NearParts::may_meet(std::uint32_t row, std::uint32_t index) const {
  const ContactFaces& faces = parts_.faces;
  const SurfaceNode& node = faces.surface_nodes[row];
  const ContactFace& face = faces.faces[index];
  if (rules_.find(node.surface, face.surface) == PairRules::none) return false;
  const auto own = mesh_.element_nodes(face.side.element());
  if (std::ranges::find(own, NodeIndex{faces.mesh_nodes[node.node]}) != own.end()) return false;
  return !joined_.are_joined(node, index);
}

void NearParts::add_faces() {
  const ContactFaces& faces = parts_.faces;
  if (faces.faces.empty() || faces.surface_nodes.empty()) return;
  BroadPhase node_boxes, face_boxes;
  if (node_boxes.update(boxes_of_nodes()) || face_boxes.update(boxes_of_faces())) return;
  PairLists near;
  node_boxes.find_pairs(
      face_boxes, [this](std::uint32_t row, std::uint32_t face) { return may_meet(row, face); }, near);
  for (std::uint32_t i = 0; i < near.n_rows(); ++i) {
    const SurfaceNode& node = faces.surface_nodes[i];
    for (const std::uint32_t face : near.of(i)) {
      PairSites& sites = parts_.sites[rules_.find(node.surface, faces.faces[face].surface)];
      const bool is_lofted = parts_.is_lofted(node) || faces.is_lofted(faces.faces[face]);
      (is_lofted ? sites.lofted : sites.meshed).faces.push_back({i, face});
    }
  }
}

void NearParts::add_edges() {
  const ContactFaces& faces = parts_.faces;
  if (faces.edges.empty()) return;
  PairLists near;
  const Motion rest{0.0, 0.0, mesh_.coordinates(), mesh_.coordinates()};
  ContactSearch(faces, mesh_, rules_, definition_.search, definition_.dash).find_edges(start_, rest, near);
  for (std::uint32_t i = 0; i < near.n_rows(); ++i) {
    for (const std::uint32_t other : near.of(i)) {
      const ContactEdge &first = faces.edges[i], &second = faces.edges[other];
      if (first.is_sharp() && second.is_sharp()) continue;
      parts_.sites[rules_.find(first.surface, second.surface)].edges.push_back({i, other});
    }
  }
}

}  // namespace

OverlapParts make_overlap_parts(const ContactModel& model, const ContactDefinition& definition,
                                const Mesh& mesh) {
  OverlapParts parts;
  parts.faces = make_contact_faces(model, mesh);
  choose_edges(definition.surface_options, model.surfaces.surfaces, mesh, parts.faces);
  const MovingSurface start = surface_of_mesh(parts.faces, mesh);
  parts.of_face = measure_faces(start, mesh);
  parts.of_node = measure_nodes(start, parts.of_face);
  parts.sites.resize(model.pairs.size());
  NearParts near(model, definition, mesh, parts);
  near.add_planes();
  near.add_faces();
  near.add_edges();
  return parts;
}

}  // namespace contactsim
