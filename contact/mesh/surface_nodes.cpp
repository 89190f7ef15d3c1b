// SPDX-License-Identifier: BSD-3-Clause
#include "contact/mesh/surface_nodes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/mesh/face_geometry.hpp"
#include "core/mesh/skin.hpp"

namespace contactsim {

namespace {

using FacetNodes = std::array<NodeIndex, 4>;

std::size_t n_corners(const FacetNodes& corners) { return corners[2] == corners[3] ? 3 : 4; }

/// Of the area of a facet [length^2].
double corner_share(const Mesh& mesh, const FacetNodes& corners) {
  return area_vector(mesh.coordinates(), corners).norm() / static_cast<double>(n_corners(corners));
}

/// Adds a facet's share to one of its corners.
void add_share(double area, double thickness, ElementSide side, SurfaceNode& node) {
  node.area += area;
  node.penalty_properties.thickness += area * thickness;
  node.side = side;
}

/// The share of an eroded node in the face that it stands for: of its facets there, together [length^2].
double share_of(const Mesh& mesh, const ErodedNode& free) {
  double share = 0.0;
  for (const FacetNodes& corners : mesh.side_facets(free.side)) {
    if (std::ranges::find(corners, free.node) != corners.end()) share += corner_share(mesh, corners);
  }
  return share;
}

}  // namespace

ContactNumbers::ContactNumbers(const Mesh& mesh, const ContactMesh& made)
    : mesh_(mesh), n_nodes_(made.n_mesh_points()), numbers_(mesh.n_nodes()) {
  for (std::uint32_t i = 0; i < n_nodes_; ++i) numbers_[made.mesh_nodes[{i}].value] = {i};
}

/// Adds to the nodes of sides that are wanted their shares of area and of thickness times area.
template <class IsWanted>
void SurfaceNodes::add_shares(std::span<const ElementSide> sides, const IsWanted& is_wanted) {
  const Mesh& mesh = numbers_.mesh();
  for (const ElementSide side : sides) {
    const double thickness = thickness_behind(mesh, side);
    for (const auto& corners : mesh.side_facets(side)) {
      const double share = corner_share(mesh, corners);
      for (std::size_t k = 0; k < n_corners(corners); ++k) {
        if (is_wanted(corners[k])) add_share(share, thickness, side, of_node_[numbers_[corners[k]]]);
      }
    }
  }
}

/// Sets what the corners of faces stand for. Returns them, ascending.
std::vector<ContactNodeIndex> SurfaceNodes::take_faces(
    std::span<const ContactFace> faces, IndexedSpan<ContactNodeIndex, const NodeIndex> mesh_nodes) {
  for (const ContactFace& face : faces) {
    for (const ContactNodeIndex corner : face.corners) of_node_[corner] = {};
  }
  std::vector<ContactNodeIndex> nodes;
  for (const ContactFace& face : faces) {
    FacetNodes corners;
    for (std::size_t k = 0; k < 4; ++k) corners[k] = mesh_nodes[face.corners[k]];
    const double share = corner_share(numbers_.mesh(), corners);
    for (std::size_t k = 0; k < n_corners(corners); ++k) {
      SurfaceNode& node = of_node_[face.corners[k]];
      if (node.area == 0.0) nodes.push_back(face.corners[k]);
      node.node = face.corners[k];
      add_share(share, face.penalty_properties.thickness, face.side, node);
    }
  }
  std::ranges::sort(nodes);
  nodes.erase(std::unique(nodes.begin(), nodes.end()),
              nodes.end());  // those of faces without area came again
  return nodes;
}

/// Adds an element to the nodes of a set that have no outside face: those of lines, particles and inside of
/// solids. What they stand for is left to add_penalty_properties().
///   is_in  [n_nodes] 1 of such nodes
void SurfaceNodes::add_elements(std::span<const std::uint8_t> is_in) {
  const Mesh& mesh = numbers_.mesh();
  for (std::uint32_t i = mesh.n_elements(); i-- > 0;) {
    for (const NodeIndex node : mesh.element_nodes({i})) {
      if (is_in[node.value] == 0) continue;
      SurfaceNode& own = of_node_[numbers_[node]];
      own.side = ElementSide({i}, 1);
      own.penalty_properties.thickness = std::numeric_limits<double>::quiet_NaN();
    }
  }
}

/// The same of the nodes of a set: by the faces of the mesh's outside whose corners are all in the set; a
/// node that has no such face by all outside faces that it has.
std::vector<ContactNodeIndex> SurfaceNodes::take_set(std::span<const NodeIndex> nodes) {
  const Mesh& mesh = numbers_.mesh();
  const Skin skin = make_skin(mesh, std::vector<std::uint8_t>(mesh.n_elements(), 1));
  std::vector<std::uint8_t> is_in(mesh.n_nodes(), 0);
  for (const NodeIndex node : nodes) {
    of_node_[numbers_[node]] = {};
    is_in[node.value] = 1;
  }
  const auto is_wanted = [&](NodeIndex node) { return is_in[node.value] != 0; };
  std::vector<ElementSide> inside;
  std::ranges::copy_if(skin.exterior, std::back_inserter(inside), [&](ElementSide side) {
    return std::ranges::all_of(mesh.side_facets(side), [&](const FacetNodes& corners) {
      return std::ranges::all_of(corners, is_wanted);
    });
  });
  add_shares(inside, is_wanted);
  const auto drop_found = [&] {
    for (const NodeIndex node : nodes) is_in[node.value] = of_node_[numbers_[node]].area > 0.0 ? 0 : 1;
  };
  drop_found();
  add_shares(skin.exterior, is_wanted);
  drop_found();
  add_elements(is_in);
  std::vector<ContactNodeIndex> taken;
  for (const NodeIndex node : nodes) taken.push_back(numbers_[node]);
  return taken;
}

void SurfaceNodes::add(const ContactSurface& surface, SurfaceIndex position, ContactMesh& made) {
  const auto nodes =
      surface.kind == SurfaceKind::node
          ? take_set(surface.nodes)
          : take_faces(std::span<const ContactFace>(made.faces).subspan(made.first_face.back().value),
                       made.mesh_nodes);
  for (const ContactNodeIndex node : nodes) {
    SurfaceNode own = of_node_[node];
    if (own.area > 0.0) {
      own.penalty_properties.thickness /= own.area;
    } else if (!std::isnan(own.penalty_properties.thickness)) {
      continue;  // of no element
    }
    own.node = node;
    own.surface = position;
    made.surface_nodes.push_back(own);
  }
}

void SurfaceNodes::add_free(std::span<const ErodedNode> eroded_nodes, SurfaceIndex position, bool is_of_nodes,
                            ContactMesh& made) const {
  const Mesh& mesh = numbers_.mesh();
  const auto first = static_cast<std::ptrdiff_t>(made.first_node.back().value);
  for (const ErodedNode& free : eroded_nodes) {
    if (free.surface != position) continue;
    SurfaceNode own;
    own.node = numbers_[free.node];
    own.surface = position;
    own.side = free.side;
    own.is_free = true;
    if (is_of_nodes) {
      own.penalty_properties.thickness = std::numeric_limits<double>::quiet_NaN();
    } else {
      own.area = share_of(mesh, free);
      own.penalty_properties.thickness = thickness_behind(mesh, free.side);
    }
    made.surface_nodes.push_back(own);
  }
  std::ranges::sort(made.surface_nodes.begin() + first, made.surface_nodes.end(), {}, &SurfaceNode::node);
}

}  // namespace contactsim
