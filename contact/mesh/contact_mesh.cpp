// SPDX-License-Identifier: BSD-3-Clause
#include "contact/mesh/contact_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/mesh/contact_model.hpp"
#include "contact/mesh/loft_faces.hpp"
#include "contact/mesh/surface_nodes.hpp"
#include "core/base/threads.hpp"
#include "core/dynamics/model.hpp"
#include "core/elements/element_table.hpp"
#include "core/mesh/element_checks.hpp"
#include "core/mesh/face_geometry.hpp"

namespace contactsim {

namespace {

IndexedVector<ContactNodeIndex, NodeIndex> collect_nodes(const ContactModel& contact, const Mesh& mesh,
                                                         std::span<const ErodedNode> eroded_nodes) {
  std::vector<std::uint8_t> is_used(mesh.n_nodes(), 0);
  for (const ErodedNode& free : eroded_nodes) is_used[free.node.value] = 1;
  for (const ContactSurface& surface : contact.surfaces.surfaces) {
    for (const ElementSide face : surface.faces) {
      for (const auto& facet : mesh.side_facets(face)) {
        for (const NodeIndex node : facet) is_used[node.value] = 1;
      }
    }
    for (const NodeIndex node : surface.nodes) is_used[node.value] = 1;
  }
  for (const LoftCapsule& rod : contact.loft.capsules) {
    for (const NodeIndex node : mesh.element_nodes(rod.element).first(2)) is_used[node.value] = 1;
  }
  for (const LoftSphere& sphere : contact.loft.spheres) is_used[sphere.centre.value] = 1;
  IndexedVector<ContactNodeIndex, NodeIndex> nodes;
  nodes.reserve(static_cast<std::size_t>(std::count(is_used.begin(), is_used.end(), 1)));
  for (std::uint32_t node = 0; node < mesh.n_nodes(); ++node) {
    if (is_used[node] != 0) nodes.push_back({node});
  }
  return nodes;
}

PairLists<ContactNodeIndex, FaceIndex> list_faces_of_nodes(const IndexedVector<FaceIndex, ContactFace>& faces,
                                                           std::size_t n_nodes) {
  return list_by_row<ContactNodeIndex, FaceIndex>(n_nodes, [&](const auto& take) {
    for (const FaceIndex f : indices(faces)) {
      const std::size_t n = faces[f].is_triangle() ? 3 : 4;
      for (std::size_t k = 0; k < n; ++k) take(faces[f].corners[k], f);
    }
  });
}

/// Where the facets of each face of a surface begin, and their number at the end.
std::vector<std::size_t> first_facets(const ContactSurface& surface, const Mesh& mesh) {
  std::vector<std::size_t> first(1, 0);
  first.reserve(surface.faces.size() + 1);
  for (const ElementSide side : surface.faces) first.push_back(first.back() + mesh.side_facets(side).n);
  return first;
}

/// Numbers the facets of a surface's faces, with the thickness behind them.
void add_faces(const ContactSurface& surface, SurfaceIndex position, const ContactNumbers& numbers,
               ContactMesh& made) {
  const std::vector<std::size_t> places = first_facets(surface, numbers.mesh());
  made.faces.resize(made.faces.size() + places.back());
  const auto faces = std::span(made.faces).last(places.back());
  const auto n = static_cast<std::int64_t>(surface.faces.size());
#pragma omp parallel for schedule(static) num_threads(threads_for(surface.faces.size()))
  for (std::int64_t i = 0; i < n; ++i) {
    const ElementSide side = surface.faces[static_cast<std::size_t>(i)];
    const double thickness = thickness_behind(numbers.mesh(), side);
    std::size_t place = places[static_cast<std::size_t>(i)];
    for (const auto& facet : numbers.mesh().side_facets(side)) {
      ContactFace& face = faces[place++];
      for (std::size_t k = 0; k < 4; ++k) face.corners[k] = numbers[facet[k]];
      face.surface = position;
      face.side = side;
      face.penalty_properties.thickness = thickness;
    }
  }
}

/// What blocks are made of.
class Materials {
 public:
  explicit Materials(const Model& model) : model_(model), of_block_(model.mesh->blocks().size(), nullptr) {
    for (const ModelBlock& block : model.blocks) of_block_[block.mesh_block] = &block;
  }

  void add(ElementSide side, PenaltyProperties& penalty_properties) const {
    const ModelBlock& block = block_of(side);
    const ElementProperties& properties = block.properties;
    const bool is_shell = !block.thickness.empty();
    const double thickness = is_shell ? thickness_of(block, side.element()) : penalty_properties.thickness;
    penalty_properties.stiffness = penalty_over_element * properties.law.moduli().bulk / thickness;
    // Half of a solid moves with its face, all of a shell.
    penalty_properties.mass_per_area = (is_shell ? 1.0 : 0.5) * properties.density * thickness;
  }

  /// Whether an element is of a material: point masses, springs and dampers are not.
  bool has_material(ElementSide side) const {
    const ModelBlock& block = block_of(side);
    return block.element->step_rule == StepRule::material && block.properties.density > 0.0;
  }

  /// A node of a point mass alone stands for a rigid cube as wide as the thinnest element that it may meet;
  /// what it may bear limits its stiffness.
  static void add_rigid_cube(double mass, double width, SurfaceNode& node) {
    constexpr double rigid = 1e200;  // its product with any stiffness is finite
    node.area = width * width;
    node.penalty_properties = {width, rigid, mass / node.area};
  }

  /// A node without faces stands for a cube of its mass.
  void add_cube(double mass, SurfaceNode& node) const {
    const double width = std::cbrt(mass / block_of(node.side).properties.density);
    node.area = width * width;
    node.penalty_properties.thickness = width;
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
  const double area = face_area(mesh, side);
  if (shape.family == Family::shell) return std::sqrt(area);
  return solid_volume(mesh.coordinates(), mesh.element_nodes(side.element()), shape) / area;
}

ContactNodeIndex ContactMesh::find_node(NodeIndex node) const {
  const auto begin = mesh_nodes.begin(), end = begin + static_cast<std::ptrdiff_t>(n_mesh_points());
  return index_of(mesh_nodes, std::lower_bound(begin, end, node));
}

std::optional<SurfaceNodeIndex> ContactMesh::find_row(ContactNodeIndex node, SurfaceIndex surface) const {
  const auto begin = surface_nodes.begin() + first_node[surface.value].value;
  const auto end = surface_nodes.begin() + first_node[surface.value + 1].value;
  const auto found = std::ranges::lower_bound(begin, end, node, {}, &SurfaceNode::node);
  if (found == end || found->node != node) return std::nullopt;
  return index_of(surface_nodes, found);
}

std::size_t ContactMesh::bytes() const {
  return bytes_of(mesh_nodes) + bytes_of(first_alike) + bytes_of(faces) + bytes_of(surface_nodes) +
         bytes_of(edges) + bytes_of(first_face) + bytes_of(first_node) + bytes_of(mass) +
         faces_of_node.bytes();
}

bool ContactMesh::share_node(const ContactFace& a, const ContactFace& b) const {
  return std::ranges::any_of(a.corners, [&](ContactNodeIndex own) {
    return std::ranges::any_of(
        b.corners, [&](ContactNodeIndex other) { return first_alike[own] == first_alike[other]; });
  });
}

ContactMesh make_contact_mesh(const ContactModel& contact, const Mesh& mesh,
                              std::span<const ErodedNode> eroded_nodes) {
  const auto& surfaces = contact.surfaces.surfaces;
  ContactMesh made;
  made.mesh_nodes = collect_nodes(contact, mesh, eroded_nodes);
  add_loft_points(contact, mesh, made);
  made.first_face.emplace_back();
  made.first_node.emplace_back();
  const ContactNumbers numbers(mesh, made);
  SurfaceNodes nodes(numbers);
  const std::vector<double> radii = least_radii(contact, mesh);
  for (const SurfaceIndex s : indices(surfaces)) {
    add_faces(surfaces[s], s, numbers, made);
    nodes.add(surfaces[s], s, made);
    if (!eroded_nodes.empty()) nodes.add_free(eroded_nodes, s, surfaces[s].kind == SurfaceKind::node, made);
    add_lofts(contact, mesh, s, radii, made);
    made.first_face.push_back(made.faces.next());
    made.first_node.push_back(made.surface_nodes.next());
  }
  made.faces.shrink_to_fit();
  made.surface_nodes.shrink_to_fit();
  made.faces_of_node = list_faces_of_nodes(made.faces, made.n_nodes());
  return made;
}

void add_penalty_properties(const Model& model, ContactMesh& contact_mesh) {
  contact_mesh.mass.clear();
  contact_mesh.mass.reserve(contact_mesh.n_nodes());
  for (const ContactNodeIndex i : contact_mesh.nodes()) {
    const auto node = static_cast<Eigen::Index>(contact_mesh.mesh_nodes[i].value);
    double mass = model.mass(node);
    const bool turns = model.inertia.cols() > 0 && model.inertia(node) > minimum_nodal_mass;
    if (!contact_mesh.is_mesh_point(i) && turns) {
      const double arm = contact_mesh.loft.distance(i.value - contact_mesh.n_mesh_points());
      mass = 1.0 / (1.0 / mass + arm * arm / model.inertia(node));
    }
    contact_mesh.mass.push_back(mass);
  }
  const Materials materials(model);
  for (ContactFace& face : contact_mesh.faces) materials.add(face.side, face.penalty_properties);
  double thinnest = std::numeric_limits<double>::infinity();
  for (const ContactFace& face : contact_mesh.faces)
    thinnest = std::min(thinnest, face.penalty_properties.thickness);
  for (SurfaceNode& node : contact_mesh.surface_nodes) {
    const bool has_faces = !std::isnan(node.penalty_properties.thickness);
    if (!has_faces && !materials.has_material(node.side)) {
      Materials::add_rigid_cube(contact_mesh.mass[node.node], std::isinf(thinnest) ? 1.0 : thinnest, node);
      continue;
    }
    if (!has_faces) materials.add_cube(contact_mesh.mass[node.node], node);
    materials.add(node.side, node.penalty_properties);
  }
  for (ContactEdge& edge : contact_mesh.edges) materials.add(edge.side, edge.penalty_properties);
}

}  // namespace contactsim
