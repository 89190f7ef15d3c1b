// SPDX-License-Identifier: BSD-3-Clause
#include "contact/contact_faces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/loft_faces.hpp"
#include "contact/sort_once.hpp"
#include "core/mesh/element_checks.hpp"
#include "core/mesh/face_geometry.hpp"
#include "core/skin.hpp"

namespace contactsim {

namespace {

std::vector<std::uint32_t> collect_nodes(const ContactModel& contact, const Mesh& mesh,
                                         std::span<const FreeNode> free_nodes) {
  std::vector<std::uint8_t> is_used(mesh.n_nodes(), 0);
  for (const FreeNode& free : free_nodes) is_used[free.node.value] = 1;
  for (const ContactSurface& surface : contact.surfaces.surfaces) {
    for (const ElementSide face : surface.faces) {
      for (const NodeIndex node : mesh.side_nodes(face)) is_used[node.value] = 1;
    }
    for (const NodeIndex node : surface.nodes) is_used[node.value] = 1;
  }
  for (const LoftRod& rod : contact.loft.rods) {
    for (const NodeIndex node : mesh.element_nodes(rod.element).first(2)) is_used[node.value] = 1;
  }
  for (const LoftSphere& sphere : contact.loft.spheres) is_used[sphere.centre.value] = 1;
  std::vector<std::uint32_t> nodes;
  nodes.reserve(static_cast<std::size_t>(std::count(is_used.begin(), is_used.end(), 1)));
  for (std::uint32_t node = 0; node < mesh.n_nodes(); ++node) {
    if (is_used[node] != 0) nodes.push_back(node);
  }
  return nodes;
}

PairLists list_faces_of_nodes(std::span<const ContactFace> faces, std::size_t n_nodes) {
  return list_by_row(n_nodes, [&](const auto& take) {
    for (std::uint32_t f = 0; f < faces.size(); ++f) {
      const std::size_t n = faces[f].is_triangle() ? 3 : 4;
      for (std::size_t k = 0; k < n; ++k) take(faces[f].corners[k], f);
    }
  });
}

/// Nodes of the mesh that are in contact, by their positions there: the whole mesh may have many more.
class SharesByNode {
 public:
  explicit SharesByNode(const ContactFaces& faces) : faces_(faces), nodes_(faces.n_mesh_points()) {}
  SurfaceNode& operator[](NodeIndex node) { return nodes_[faces_.find_node(node)]; }

 private:
  const ContactFaces& faces_;
  std::vector<SurfaceNode> nodes_;
};

/// Adds to the nodes of faces that are wanted their shares of area and of thickness times area behind it.
template <class IsWanted>
void add_shares(std::span<const ElementSide> sides, const Mesh& mesh, const IsWanted& is_wanted,
                SharesByNode& by_node) {
  for (const ElementSide side : sides) {
    const auto corners = mesh.side_nodes(side);
    const std::size_t n = corners[2] == corners[3] ? 3 : 4;
    const double share = area_vector(mesh, side).norm() / static_cast<double>(n);
    const double thickness = thickness_behind(mesh, side);
    for (std::size_t k = 0; k < n; ++k) {
      if (!is_wanted(corners[k])) continue;
      SurfaceNode& node = by_node[corners[k]];
      node.area += share;
      node.backing.thickness += share * thickness;
      node.side = side;
    }
  }
}

/// Adds an element to the nodes of a set that have no outside face: those of lines, particles and inside of
/// solids. What they stand for is left to add_backing().
///   is_in  [n_nodes] 1 of such nodes
void add_elements(const Mesh& mesh, std::span<const std::uint8_t> is_in, SharesByNode& by_node) {
  for (std::uint32_t i = mesh.n_elements(); i-- > 0;) {
    for (const NodeIndex node : mesh.element_nodes({i})) {
      if (is_in[node.value] == 0) continue;
      by_node[node].side = ElementSide({i}, 1);
      by_node[node].backing.thickness = std::numeric_limits<double>::quiet_NaN();
    }
  }
}

/// The same of the nodes of a set: by the faces of the mesh's outside whose corners are all in the set; a
/// node that has no such face by all outside faces that it has.
void add_shares_of_set(std::span<const NodeIndex> nodes, const Mesh& mesh, SharesByNode& by_node) {
  const Skin skin = make_skin(mesh, std::vector<std::uint8_t>(mesh.n_elements(), 1));
  std::vector<std::uint8_t> is_in(mesh.n_nodes(), 0);
  for (const NodeIndex node : nodes) is_in[node.value] = 1;
  std::vector<ElementSide> inside;
  for (const ElementSide side : skin.exterior) {
    const auto corners = mesh.side_nodes(side);
    if (std::all_of(corners.begin(), corners.end(), [&](NodeIndex node) { return is_in[node.value] != 0; }))
      inside.push_back(side);
  }
  add_shares(
      inside, mesh, [](NodeIndex) { return true; }, by_node);
  for (const NodeIndex node : nodes) is_in[node.value] = by_node[node].area > 0.0 ? 0 : 1;
  add_shares(
      skin.exterior, mesh, [&](NodeIndex node) { return is_in[node.value] != 0; }, by_node);
  for (const NodeIndex node : nodes) is_in[node.value] = by_node[node].area > 0.0 ? 0 : 1;
  add_elements(mesh, is_in, by_node);
}

std::vector<NodeIndex> corner_nodes(std::span<const ElementSide> sides, const Mesh& mesh) {
  std::vector<NodeIndex> nodes;
  for (const ElementSide side : sides) {
    for (const NodeIndex node : mesh.side_nodes(side)) nodes.push_back(node);
  }
  sort_once(nodes);
  return nodes;
}

void add_faces(const ContactSurface& surface, std::uint32_t position, const Mesh& mesh, ContactFaces& made) {
  for (const ElementSide side : surface.faces) {
    ContactFace face;
    const auto corners = mesh.side_nodes(side);
    for (std::size_t k = 0; k < 4; ++k) face.corners[k] = made.find_node(corners[k]);
    face.surface = position;
    face.side = side;
    face.backing.thickness = thickness_behind(mesh, side);
    made.faces.push_back(face);
  }
}

/// The nodes of a surface, those of its faces or its own.
///   by_node  scratch
void add_nodes(const ContactSurface& surface, std::uint32_t position, const Mesh& mesh, SharesByNode& by_node,
               ContactFaces& made) {
  const bool is_of_nodes = surface.kind == SurfaceKind::node;
  const std::vector<NodeIndex> nodes = is_of_nodes ? surface.nodes : corner_nodes(surface.faces, mesh);
  for (const NodeIndex node : nodes) by_node[node] = {};
  if (is_of_nodes) {
    add_shares_of_set(nodes, mesh, by_node);
  } else {
    add_shares(
        surface.faces, mesh, [](NodeIndex) { return true; }, by_node);
  }
  for (const NodeIndex node : nodes) {
    SurfaceNode own = by_node[node];
    if (own.area > 0.0) {
      own.backing.thickness /= own.area;
    } else if (!std::isnan(own.backing.thickness)) {
      continue;  // of no element
    }
    own.node = made.find_node(node);
    own.surface = position;
    made.surface_nodes.push_back(own);
  }
}

/// Free nodes of a surface, among its nodes.
///   is_of_nodes  whether it is a surface of nodes, which stand for their masses
void add_free_nodes(std::span<const FreeNode> free_nodes, std::uint32_t position, bool is_of_nodes,
                    const Mesh& mesh, ContactFaces& made) {
  const auto first = static_cast<std::ptrdiff_t>(made.first_node.back());
  for (const FreeNode& free : free_nodes) {
    if (free.surface != position) continue;
    SurfaceNode own;
    own.node = made.find_node(free.node);
    own.surface = position;
    own.side = free.side;
    own.is_free = true;
    if (is_of_nodes) {
      own.backing.thickness = std::numeric_limits<double>::quiet_NaN();
    } else {
      const auto corners = mesh.side_nodes(free.side);
      own.area = area_vector(mesh, free.side).norm() / (corners[2] == corners[3] ? 3.0 : 4.0);
      own.backing.thickness = thickness_behind(mesh, free.side);
    }
    made.surface_nodes.push_back(own);
  }
  std::ranges::sort(made.surface_nodes.begin() + first, made.surface_nodes.end(), {}, &SurfaceNode::node);
}

/// What blocks are made of.
class Materials {
 public:
  explicit Materials(const Model& model) : model_(model), of_block_(model.mesh->blocks().size(), nullptr) {
    for (const ModelBlock& block : model.blocks) of_block_[block.mesh_block] = &block;
  }

  void add(ElementSide side, Backing& backing) const {
    const ModelBlock& block = block_of(side);
    const ElementProperties& properties = block.properties;
    const bool is_shell = !block.thickness.empty();
    const double thickness = is_shell ? thickness_of(block, side.element()) : backing.thickness;
    backing.stiffness = penalty_over_element * moduli_of(properties.law).bulk / thickness;
    // Half of a solid moves with its face, all of a shell.
    backing.mass_per_area = (is_shell ? 1.0 : 0.5) * properties.density * thickness;
  }

  /// A node without faces stands for a cube of its mass.
  void add_cube(double mass, SurfaceNode& node) const {
    const double width = std::cbrt(mass / block_of(node.side).properties.density);
    node.area = width * width;
    node.backing.thickness = width;
  }

 private:
  const ModelBlock& block_of(ElementSide side) const {
    return *of_block_[model_.mesh->block_of(side.element())];
  }
  static double thickness_of(const ModelBlock& block, ElementIndex element) {
    const std::size_t i = element.value - block.first_element.value;
    return block.thickness[i / n_lanes](static_cast<Eigen::Index>(i % n_lanes));
  }

  const Model& model_;
  std::vector<const ModelBlock*> of_block_;
};

}  // namespace

double thickness_behind(const Mesh& mesh, ElementSide side) {
  const Topology& shape = topology(mesh.blocks()[mesh.block_of(side.element())].shape);
  const double area = area_vector(mesh, side).norm();
  if (shape.family == Family::shell) return std::sqrt(area);
  return solid_volume(mesh.coordinates(), mesh.element_nodes(side.element()), shape) / area;
}

std::uint32_t ContactFaces::find_node(NodeIndex node) const {
  const auto begin = mesh_nodes.begin(), end = begin + static_cast<std::ptrdiff_t>(n_mesh_points());
  return static_cast<std::uint32_t>(std::lower_bound(begin, end, node.value) - begin);
}

bool ContactFaces::share_node(const ContactFace& a, const ContactFace& b) const {
  return std::ranges::any_of(a.corners, [&](std::uint32_t own) {
    return std::ranges::any_of(b.corners,
                               [&](std::uint32_t other) { return first_alike[own] == first_alike[other]; });
  });
}

ContactFaces make_contact_faces(const ContactModel& contact, const Mesh& mesh,
                                std::span<const FreeNode> free_nodes) {
  const auto& surfaces = contact.surfaces.surfaces;
  ContactFaces made;
  made.mesh_nodes = collect_nodes(contact, mesh, free_nodes);
  add_loft_points(contact, mesh, made);
  made.first_face.push_back(0);
  made.first_node.push_back(0);
  SharesByNode by_node(made);
  for (std::uint32_t s = 0; s < surfaces.size(); ++s) {
    add_faces(surfaces[s], s, mesh, made);
    add_nodes(surfaces[s], s, mesh, by_node, made);
    const bool is_of_nodes = surfaces[s].kind == SurfaceKind::node;
    if (!free_nodes.empty()) add_free_nodes(free_nodes, s, is_of_nodes, mesh, made);
    add_lofts(contact, mesh, s, made);
    made.first_face.push_back(static_cast<std::uint32_t>(made.faces.size()));
    made.first_node.push_back(static_cast<std::uint32_t>(made.surface_nodes.size()));
  }
  made.faces.shrink_to_fit();
  made.surface_nodes.shrink_to_fit();
  made.faces_of_node = list_faces_of_nodes(made.faces, made.n_nodes());
  return made;
}

void add_backing(const Model& model, ContactFaces& faces) {
  faces.mass.clear();
  faces.mass.reserve(faces.n_nodes());
  for (std::size_t i = 0; i < faces.n_nodes(); ++i) {
    const auto node = static_cast<Eigen::Index>(faces.mesh_nodes[i]);
    double mass = model.mass(0, node);
    const bool turns = model.inertia.cols() > 0 && model.inertia(0, node) > least_mass;
    if (i >= faces.n_mesh_points() && turns) {
      const double arm = faces.loft.distance(i - faces.n_mesh_points());
      mass = 1.0 / (1.0 / mass + arm * arm / model.inertia(0, node));
    }
    faces.mass.push_back(mass);
  }
  const Materials materials(model);
  for (ContactFace& face : faces.faces) materials.add(face.side, face.backing);
  for (SurfaceNode& node : faces.surface_nodes) {
    if (std::isnan(node.backing.thickness)) materials.add_cube(faces.mass[node.node], node);
    materials.add(node.side, node.backing);
  }
  for (ContactEdge& edge : faces.edges) materials.add(edge.side, edge.backing);
}

}  // namespace contactsim
