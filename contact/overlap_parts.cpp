// SPDX-License-Identifier: BSD-3-Clause
#include "contact/overlap_parts.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "contact/broad_phase.hpp"
#include "contact/contact_faces.hpp"
#include "contact/contact_scene.hpp"
#include "core/mesh/face_geometry.hpp"

namespace contactsim {

namespace {

/// Half the thickness of the solid behind a face; 0 for other elements.
double half_thickness(const Mesh& mesh, ElementSide side) {
  const bool is_solid = topology(mesh.blocks()[mesh.block_of(side.element())].shape).family == Family::solid;
  return is_solid ? 0.5 * thickness_behind(mesh, side) : 0.0;
}

OverlapFace make_face(const Mesh& mesh, ElementSide side, std::uint32_t surface) {
  OverlapFace face;
  const auto corners = mesh.side_nodes(side);
  for (std::size_t i = 0; i < 4; ++i) face.nodes[i] = corners[i].value;
  face.surface = surface;
  face.side = side;
  const double area = area_vector(mesh, side).norm();
  face.size = std::sqrt(area);
  face.reach = area > 0.0 ? half_thickness(mesh, side) : 0.0;
  return face;
}

/// The nodes of a surface's faces, with what the faces give them; or those of a surface of nodes.
std::map<std::uint32_t, OverlapNode> nodes_of(const ContactSurface& surface, const Mesh& mesh,
                                              std::span<const OverlapFace> faces) {
  std::map<std::uint32_t, OverlapNode> nodes;
  for (const NodeIndex node : surface.nodes) nodes[node.value] = {};
  for (const OverlapFace& face : faces) {
    const Eigen::Vector3d area = area_vector(mesh, face.side);
    const std::size_t n_corners = face.is_triangle() ? 3 : 4;
    for (std::size_t i = 0; i < n_corners; ++i) {
      const auto [found, is_new] = nodes.try_emplace(face.nodes[i]);
      OverlapNode& node = found->second;
      node.normal += area;
      node.size = std::max(node.size, face.size);
      node.reach = is_new ? face.reach : std::min(node.reach, face.reach);
    }
  }
  return nodes;
}

void add_surface(const ContactModel& model, const Mesh& mesh, std::uint32_t index, OverlapParts& parts) {
  const ContactSurface& surface = model.surfaces.surfaces[index];
  const std::size_t first_face = parts.faces.size();
  for (const ElementSide side : surface.faces) parts.faces.push_back(make_face(mesh, side, index));
  for (auto& [node, made] : nodes_of(surface, mesh, std::span(parts.faces).subspan(first_face))) {
    made.node = node;
    made.surface = index;
    parts.nodes.push_back(made);
  }
}

Box box_of(const OverlapFace& face, const Eigen::Matrix3Xd& coordinates, double deepest) {
  // Both sides move, each by no more than the deepest overlap.
  const double margin = 2.0 * std::max(face.reach, deepest);
  Box box;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto at = [&](std::size_t i) { return coordinates(static_cast<int>(k), face.nodes[i]); };
    box.lo[k] = std::min({at(0), at(1), at(2), at(3)}) - margin;
    box.hi[k] = std::max({at(0), at(1), at(2), at(3)}) + margin;
  }
  return box;
}

bool is_corner_of_element(const Mesh& mesh, std::uint32_t node, const OverlapFace& face) {
  const auto nodes = mesh.element_nodes(face.side.element());
  return std::find(nodes.begin(), nodes.end(), NodeIndex{node}) != nodes.end();
}

PairLists find_near(const OverlapParts& parts, const ContactModel& model, const Mesh& mesh,
                    const PairRules& rules) {
  double deepest = 0.0;
  for (const SurfacePair& pair : model.pairs)
    deepest = std::max(deepest, pair.overlap_normal_tolerance.value_or(0.0));
  std::vector<Box> node_boxes, face_boxes;
  for (const OverlapNode& node : parts.nodes) {
    const Eigen::Vector3d x = mesh.coordinates().col(node.node);
    node_boxes.push_back({{x[0], x[1], x[2]}, {x[0], x[1], x[2]}});
  }
  for (const OverlapFace& face : parts.faces) face_boxes.push_back(box_of(face, mesh.coordinates(), deepest));
  BroadPhase nodes, faces;
  PairLists lists;
  const bool is_sound = !nodes.update(node_boxes) && !faces.update(face_boxes);
  if (!is_sound) return lists;
  nodes.find_pairs(
      faces,
      [&](std::uint32_t row, std::uint32_t partner) {
        const OverlapNode& node = parts.nodes[row];
        const OverlapFace& face = parts.faces[partner];
        return rules.find(node.surface, face.surface) != PairRules::none &&
               !is_corner_of_element(mesh, node.node, face);
      },
      lists);
  return lists;
}

void add_planes(const ContactModel& model, OverlapParts& parts) {
  const auto add = [&](std::uint32_t with_planes, std::uint32_t with_nodes, OverlapSites& sites) {
    for (const std::uint32_t plane : model.surfaces.surfaces[with_planes].analytic_planes) {
      for (std::uint32_t i = 0; i < parts.nodes.size(); ++i) {
        if (parts.nodes[i].surface == with_nodes) sites.planes.push_back({i, plane});
      }
    }
  };
  for (std::uint32_t p = 0; p < model.pairs.size(); ++p) {
    const SurfacePair& pair = model.pairs[p];
    add(pair.first, pair.second, parts.sites[p]);
    if (pair.first != pair.second) add(pair.second, pair.first, parts.sites[p]);
  }
}

}  // namespace

OverlapParts make_overlap_parts(const ContactModel& model, const Mesh& mesh) {
  OverlapParts parts;
  parts.sites.resize(model.pairs.size());
  std::vector<std::uint8_t> is_paired(model.surfaces.surfaces.size(), 0);
  for (const SurfacePair& pair : model.pairs) is_paired[pair.first] = is_paired[pair.second] = 1;
  for (std::uint32_t i = 0; i < is_paired.size(); ++i) {
    if (is_paired[i] != 0) add_surface(model, mesh, i, parts);
  }
  add_planes(model, parts);
  if (parts.faces.empty() || parts.nodes.empty()) return parts;
  const PairRules rules(model.pairs, std::vector<ActiveTimes>(model.pairs.size()),
                        model.surfaces.surfaces.size());
  const PairLists near = find_near(parts, model, mesh, rules);
  for (std::uint32_t i = 0; i < near.n_rows(); ++i) {
    for (const std::uint32_t face : near.of(i)) {
      const std::uint32_t pair = rules.find(parts.nodes[i].surface, parts.faces[face].surface);
      parts.sites[pair].faces.push_back({i, face});
    }
  }
  return parts;
}

}  // namespace contactsim
