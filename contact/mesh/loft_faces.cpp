// SPDX-License-Identifier: BSD-3-Clause
#include "contact/mesh/loft_faces.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <numbers>

#include "contact/mesh/contact_model.hpp"

namespace contactsim {

namespace {

/// The facets of a surface's bricks, and their corners as nodes.
void add_bricks(const ContactModel& contact, SurfaceIndex position, ContactMesh& made) {
  const LoftGeometry& loft = contact.loft;
  const auto first = static_cast<std::uint32_t>(made.n_mesh_points());
  std::map<ContactNodeIndex, SurfaceNode> nodes;
  for (std::size_t i = 0; i < loft.facets.size(); ++i) {
    const LoftFacet& facet = loft.facets[i];
    if (facet.part == LoftPart::prism || contact.surface_of_facet[i] != position) continue;
    ContactFace face;
    for (std::size_t k = 0; k < 4; ++k) face.corners[k] = {first + *made.loft.of_vertex(facet.vertices[k])};
    face.surface = position;
    face.side = ElementSide(facet.element, facet.side);
    face.penalty_properties.thickness = made.loft.thickness(face.corners[0].value - first);
    const std::size_t n = face.is_triangle() ? 3 : 4;
    for (std::size_t k = 0; k < n; ++k) {
      SurfaceNode& node = nodes[face.corners[k]];
      node.area += facet_area(loft, facet) / static_cast<double>(n);
      node.node = face.corners[k];
      node.surface = position;
      node.side = face.side;
      node.penalty_properties.thickness = made.loft.thickness(face.corners[k].value - first);
    }
    made.faces.push_back(face);
  }
  for (const auto& [point, node] : nodes) made.surface_nodes.push_back(node);
}

/// The capsules of a surface, and spheres around their ends: a node has the smallest radius of its rods.
///   radii  [n_nodes] of the mesh's nodes
void add_capsules(const ContactModel& contact, const Mesh& mesh, SurfaceIndex position,
                  std::span<const double> radii, ContactMesh& made) {
  std::map<ContactNodeIndex, SurfaceNode> nodes;
  for (std::size_t i = 0; i < contact.loft.capsules.size(); ++i) {
    if (contact.surface_of_capsule[i] != position) continue;
    const LoftCapsule& rod = contact.loft.capsules[i];
    const auto ends = mesh.element_nodes(rod.element).first(2);
    const auto& x = mesh.coordinates();
    const double length = (x.col(ends[1].value) - x.col(ends[0].value)).norm();
    ContactEdge edge;
    edge.surface = position;
    edge.side = ElementSide(rod.element, 1);
    edge.radius = rod.radius;
    edge.width = 2.0 * rod.radius;
    edge.penalty_properties.thickness = 0.5 * std::numbers::pi * rod.radius;  // section over width
    for (std::size_t k = 0; k < 2; ++k) {
      edge.nodes[k] = made.find_node(ends[k]);
      edge.less[k] = rod.radius - radii[ends[k].value];
      SurfaceNode& node = nodes[edge.nodes[k]];
      node.radius = static_cast<float>(radii[ends[k].value]);
      node.area += rod.radius * length;
      node.node = edge.nodes[k];
      node.surface = position;
      node.side = edge.side;
      node.penalty_properties.thickness = edge.penalty_properties.thickness;
    }
    made.edges.push_back(edge);
  }
  for (const auto& [point, node] : nodes) made.surface_nodes.push_back(node);
}

/// The particles of a surface.
void add_spheres(const ContactModel& contact, SurfaceIndex position, ContactMesh& made) {
  for (std::size_t i = 0; i < contact.loft.spheres.size(); ++i) {
    if (contact.surface_of_sphere[i] != position) continue;
    const LoftSphere& sphere = contact.loft.spheres[i];
    SurfaceNode node;
    node.node = made.find_node(sphere.centre);
    node.surface = position;
    node.side = ElementSide(sphere.element, 1);
    node.radius = static_cast<float>(sphere.radius);
    node.area = std::numbers::pi * sphere.radius * sphere.radius;
    node.penalty_properties.thickness = 4.0 / 3.0 * sphere.radius;  // volume over cross-section
    made.surface_nodes.push_back(node);
    made.edges.push_back({{node.node, node.node},
                          position,
                          node.side,
                          sphere.radius,
                          2.0 * sphere.radius,
                          node.penalty_properties});
  }
}

}  // namespace

void add_loft_points(const ContactModel& contact, const Mesh& mesh, ContactMesh& made) {
  const auto n_mesh_points = static_cast<std::uint32_t>(made.n_nodes());
  made.first_alike.resize(n_mesh_points);
  std::ranges::copy(made.nodes(), made.first_alike.begin());
  made.loft = LoftPoints(contact.loft, mesh);
  std::map<NodeIndex, ContactNodeIndex> first_on_node;
  for (std::uint32_t i = 0; i < made.loft.size(); ++i) {
    const NodeIndex node = made.loft.node(i);
    const auto own = made.mesh_nodes.begin() + n_mesh_points;
    const auto found = std::lower_bound(made.mesh_nodes.begin(), own, node);
    const bool is_mesh_point = found != own && *found == node;
    const auto alike = first_on_node.try_emplace(
        node, is_mesh_point ? index_of(made.mesh_nodes, found) : ContactNodeIndex{n_mesh_points + i});
    made.first_alike.push_back(alike.first->second);
    made.mesh_nodes.push_back(node);
  }
}

std::vector<double> least_radii(const ContactModel& contact, const Mesh& mesh) {
  if (contact.loft.capsules.empty()) return {};
  std::vector<double> radii(static_cast<std::size_t>(mesh.coordinates().cols()),
                            std::numeric_limits<double>::infinity());
  for (const LoftCapsule& rod : contact.loft.capsules) {
    for (const NodeIndex end : mesh.element_nodes(rod.element).first(2))
      radii[end.value] = std::min(radii[end.value], rod.radius);
  }
  return radii;
}

void add_lofts(const ContactModel& contact, const Mesh& mesh, SurfaceIndex surface,
               std::span<const double> radii, ContactMesh& made) {
  add_bricks(contact, surface, made);
  add_capsules(contact, mesh, surface, radii, made);
  add_spheres(contact, surface, made);
}

}  // namespace contactsim
