// SPDX-License-Identifier: BSD-3-Clause
#include "contact/contact_faces.hpp"

#include <algorithm>
#include <cmath>

#include "contact/sort_once.hpp"
#include "core/mesh/face_geometry.hpp"
#include "core/skin.hpp"

namespace contactsim {

namespace {

/// Position of a mesh node among the contact nodes.
std::uint32_t position_of(const std::vector<std::uint32_t>& mesh_nodes, NodeIndex node) {
  const auto found = std::lower_bound(mesh_nodes.begin(), mesh_nodes.end(), node.value);
  return static_cast<std::uint32_t>(found - mesh_nodes.begin());
}

std::vector<std::uint32_t> collect_nodes(const ContactSurfaces& surfaces, const Mesh& mesh) {
  std::vector<std::uint8_t> is_used(mesh.n_nodes(), 0);
  for (const ContactSurface& surface : surfaces.surfaces) {
    for (const ElementSide face : surface.faces) {
      for (const NodeIndex node : mesh.side_nodes(face)) is_used[node.value] = 1;
    }
    for (const NodeIndex node : surface.nodes) is_used[node.value] = 1;
  }
  std::vector<std::uint32_t> nodes;
  for (std::uint32_t node = 0; node < mesh.n_nodes(); ++node) {
    if (is_used[node] != 0) nodes.push_back(node);
  }
  return nodes;
}

/// Volumes and moduli of the elements behind faces.
class Backings {
 public:
  explicit Backings(const Model& model) : model_(model) {}

  Backing of(ElementSide side) const {
    const SolidBlock& block = block_of(side.element());
    const std::size_t element = side.element().value - block.first_element.value;
    const double volume = block.mass[element / n_lanes](static_cast<Eigen::Index>(element % n_lanes)) /
                          block.properties.density;
    const double area = area_vector(*model_.mesh, side).norm();
    Backing backing;
    backing.thickness = volume / area;
    backing.stiffness = moduli_of(block.properties.law).bulk / backing.thickness;
    backing.mass_per_area = 0.5 * block.properties.density * backing.thickness;
    return backing;
  }

 private:
  const SolidBlock& block_of(ElementIndex element) const {
    const std::uint32_t mesh_block = model_.mesh->block_of(element);
    const auto holds = [&](const SolidBlock& block) { return block.mesh_block == mesh_block; };
    return *std::find_if(model_.blocks.begin(), model_.blocks.end(), holds);
  }

  const Model& model_;
};

PairLists list_faces_of_nodes(std::span<const ContactFace> faces, std::size_t n_nodes) {
  PairLists lists;
  lists.begin.assign(n_nodes + 1, 0);
  const auto n_corners = [](const ContactFace& face) { return face.is_triangle() ? 3u : 4u; };
  for (const ContactFace& face : faces) {
    for (unsigned k = 0; k < n_corners(face); ++k) ++lists.begin[face.corners[k] + 1];
  }
  for (std::size_t i = 0; i < n_nodes; ++i) lists.begin[i + 1] += lists.begin[i];
  lists.partners.resize(lists.begin.back());
  std::vector<std::uint32_t> next(lists.begin.begin(), lists.begin.end() - 1);
  for (std::uint32_t f = 0; f < faces.size(); ++f) {
    for (unsigned k = 0; k < n_corners(faces[f]); ++k) lists.partners[next[faces[f].corners[k]]++] = f;
  }
  return lists;
}

/// Gives every node of the faces its share of their areas and the mean of what stands behind them.
void add_nodes_of_faces(std::span<const ElementSide> sides, const Backings& backings, const Mesh& mesh,
                        std::vector<SurfaceNode>& by_node) {
  for (const ElementSide side : sides) {
    const auto corners = mesh.side_nodes(side);
    const std::size_t n = corners[2] == corners[3] ? 3 : 4;
    const double share = area_vector(mesh, side).norm() / static_cast<double>(n);
    const Backing backing = backings.of(side);
    for (std::size_t k = 0; k < n; ++k) {
      SurfaceNode& node = by_node[corners[k].value];
      node.area += share;
      node.backing.thickness += share * backing.thickness;
      node.backing.stiffness += share * backing.stiffness;
      node.backing.mass_per_area += share * backing.mass_per_area;
    }
  }
}

SurfaceNode mean_of(SurfaceNode sums) {
  sums.backing.thickness /= sums.area;
  sums.backing.stiffness /= sums.area;
  sums.backing.mass_per_area /= sums.area;
  return sums;
}

/// Faces of the mesh's outside whose corners are all in the set; when there are none, all that touch it.
std::vector<ElementSide> faces_at(std::span<const NodeIndex> nodes, const Mesh& mesh) {
  const Skin skin = make_skin(mesh, std::vector<std::uint8_t>(mesh.n_elements(), 1));
  std::vector<std::uint8_t> is_in(mesh.n_nodes(), 0);
  for (const NodeIndex node : nodes) is_in[node.value] = 1;
  std::vector<ElementSide> inside, touching;
  for (const ElementSide side : skin.exterior) {
    const auto corners = mesh.side_nodes(side);
    const auto n_in =
        std::count_if(corners.begin(), corners.end(), [&](NodeIndex node) { return is_in[node.value] != 0; });
    if (n_in == 4) inside.push_back(side);
    if (n_in > 0) touching.push_back(side);
  }
  return inside.empty() ? touching : inside;
}

std::vector<NodeIndex> corner_nodes(std::span<const ElementSide> sides, const Mesh& mesh) {
  std::vector<NodeIndex> nodes;
  for (const ElementSide side : sides) {
    for (const NodeIndex node : mesh.side_nodes(side)) nodes.push_back(node);
  }
  sort_once(nodes);
  return nodes;
}

}  // namespace

bool ContactFace::shares_node(const ContactFace& other) const {
  for (const std::uint32_t node : corners) {
    if (node == other.corners[0] || node == other.corners[1] || node == other.corners[2] ||
        node == other.corners[3])
      return true;
  }
  return false;
}

ContactFaces make_contact_faces(const ContactSurfaces& surfaces, const Model& model) {
  const Mesh& mesh = *model.mesh;
  const Backings backings(model);
  ContactFaces made;
  made.mesh_nodes = collect_nodes(surfaces, mesh);
  made.first_face.push_back(0);
  made.first_node.push_back(0);
  std::vector<SurfaceNode> by_node(mesh.n_nodes());
  for (std::uint32_t s = 0; s < surfaces.surfaces.size(); ++s) {
    const ContactSurface& surface = surfaces.surfaces[s];
    for (const ElementSide side : surface.faces) {
      ContactFace face;
      const auto corners = mesh.side_nodes(side);
      for (std::size_t k = 0; k < 4; ++k) face.corners[k] = position_of(made.mesh_nodes, corners[k]);
      face.surface = s;
      face.side = side;
      face.backing = backings.of(side);
      made.faces.push_back(face);
    }
    const bool is_of_nodes = surface.kind == SurfaceKind::node;
    const std::vector<ElementSide> sides = is_of_nodes ? faces_at(surface.nodes, mesh) : surface.faces;
    const std::vector<NodeIndex> nodes = is_of_nodes ? surface.nodes : corner_nodes(sides, mesh);
    for (const NodeIndex node : corner_nodes(sides, mesh)) by_node[node.value] = {};
    add_nodes_of_faces(sides, backings, mesh, by_node);
    for (const NodeIndex node : nodes) {
      SurfaceNode& sums = by_node[node.value];
      if (!(sums.area > 0.0)) continue;
      SurfaceNode mean = mean_of(sums);
      mean.node = position_of(made.mesh_nodes, node);
      mean.surface = s;
      made.surface_nodes.push_back(mean);
    }
    made.first_face.push_back(static_cast<std::uint32_t>(made.faces.size()));
    made.first_node.push_back(static_cast<std::uint32_t>(made.surface_nodes.size()));
  }
  for (const std::uint32_t node : made.mesh_nodes)
    made.mass.push_back(model.mass(0, static_cast<Eigen::Index>(node)));
  made.faces_of_node = list_faces_of_nodes(made.faces, made.n_nodes());
  return made;
}

}  // namespace contactsim
