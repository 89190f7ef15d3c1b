// SPDX-License-Identifier: BSD-3-Clause
#include "contact/output/surface_drawing.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <utility>

#include "contact/mesh/contact_kinematics.hpp"
#include "contact/mesh/feature_edges.hpp"
#include "core/base/names.hpp"
#include "core/base/optional_index.hpp"

namespace contactsim {

namespace {

/// The side of an analytic plane's square in units of the mesh's largest length. Source: Sierra/SM 5.22,
/// analytic objects.
constexpr double plane_size = 3.0;

/// Collects the points and facets of all surfaces.
class SurfaceDrawing {
 public:
  SurfaceDrawing(const ContactModel& model, const Mesh& mesh, const ContactMesh& contact_mesh)
      : model_(model), mesh_(mesh), contact_mesh_(contact_mesh) {
    for (const ContactSurface& surface : model.surfaces.surfaces)
      drawing_.blocks.push_back({surface.name, {}, {}});
    point_of_node_.resize(mesh.n_nodes());
  }

  FacetMesh draw() {
    for (const SurfaceIndex surface : indices(model_.surfaces.surfaces)) draw_mesh_parts(surface);
    draw_lofts();
    draw_edges();
    drawing_.coordinates.resize(3, static_cast<Eigen::Index>(points_.size()));
    for (std::size_t i = 0; i < points_.size(); ++i) {
      drawing_.coordinates.col(static_cast<Eigen::Index>(i)) = points_[i];
    }
    return std::move(drawing_);
  }

 private:
  using Facet = std::array<std::uint32_t, 4>;

  std::uint32_t add_point(const Eigen::Vector3d& position) {
    points_.push_back(position);
    return static_cast<std::uint32_t>(points_.size() - 1);
  }

  std::uint32_t point_of(NodeIndex node) {
    OptionalIndex<std::uint32_t>& point = point_of_node_[node.value];
    if (!point) point = add_point(mesh_.coordinates().col(node.value));
    return *point;
  }

  void draw_mesh_parts(SurfaceIndex index) {
    const ContactSurface& surface = model_.surfaces.surfaces[index];
    FacetBlock& block = drawing_.blocks[index.value];
    for (const ElementSide face : surface.faces) {
      for (const auto& nodes : mesh_.side_facets(face)) {
        Facet facet{};
        std::transform(nodes.begin(), nodes.end(), facet.begin(),
                       [&](NodeIndex node) { return point_of(node); });
        block.facets.push_back(facet);
      }
    }
    for (const NodeIndex node : surface.nodes) block.points.push_back(point_of(node));
    for (const std::uint32_t plane : surface.analytic_planes) draw_plane(model_.planes[plane], block);
  }

  void draw_lofts() {
    const auto first = static_cast<std::uint32_t>(points_.size());
    drawn_loft_points_.resize(contact_mesh_.loft.size());
    for (std::uint32_t i = 0; i < model_.loft.vertices.cols(); ++i) {
      const std::uint32_t drawn = add_point(model_.loft.vertices.col(i));
      if (const OptionalIndex<std::uint32_t> loft_point = contact_mesh_.loft.of_vertex(i))
        drawn_loft_points_[*loft_point] = drawn;
    }
    for (std::size_t i = 0; i < model_.loft.facets.size(); ++i) {
      Facet facet = model_.loft.facets[i].vertices;
      for (std::uint32_t& vertex : facet) vertex += first;
      drawing_.blocks[model_.surface_of_facet[i].value].facets.push_back(facet);
    }
    for (std::size_t i = 0; i < model_.loft.spheres.size(); ++i) {
      draw_sphere(model_.loft.spheres[i], drawing_.blocks[model_.surface_of_sphere[i].value]);
    }
  }

  void draw_plane(const AnalyticPlane& plane, FacetBlock& block) {
    const auto& x = mesh_.coordinates();
    if (x.cols() == 0) return;
    const Eigen::Vector3d extent = x.rowwise().maxCoeff() - x.rowwise().minCoeff();
    const double half = 0.5 * plane_size * plane.scale_factor * extent.maxCoeff();
    const Eigen::Vector3d u = plane.normal.unitOrthogonal();
    const Eigen::Vector3d v = plane.normal.normalized().cross(u);
    const auto corner = [&](double a, double b) { return add_point(plane.origin + half * (a * u + b * v)); };
    const std::uint32_t c0 = corner(-1, -1), c1 = corner(1, -1), c2 = corner(1, 1), c3 = corner(-1, 1);
    block.facets.push_back({c0, c1, c2, c3});
  }

  /// The six sides of a cube, each cut in four, blown up to the sphere.
  void draw_sphere(const LoftSphere& sphere, FacetBlock& block) {
    for (int axis = 0; axis < 3; ++axis) {
      for (const double sign : {-1.0, 1.0}) draw_sphere_side(sphere, axis, sign, block);
    }
  }

  void draw_sphere_side(const LoftSphere& sphere, int axis, double sign, FacetBlock& block) {
    const Eigen::Vector3d centre = mesh_.coordinates().col(sphere.centre.value);
    std::array<std::uint32_t, 9> grid{};
    for (int i = 0; i < 9; ++i) {
      Eigen::Vector3d direction;
      direction[axis] = sign;
      const int row = i / 3 - 1;
      direction[(axis + 1) % 3] = sign * row;  // the sign keeps the corners' order outward
      direction[(axis + 2) % 3] = i % 3 - 1;
      grid[static_cast<std::size_t>(i)] = add_point(centre + sphere.radius * direction.normalized());
    }
    for (const std::size_t i : {0u, 1u, 3u, 4u})
      block.facets.push_back({grid[i], grid[i + 3], grid[i + 4], grid[i + 1]});
  }

  void draw_edges() {
    const auto n_mesh_points = static_cast<std::uint32_t>(contact_mesh_.n_mesh_points());
    const auto point_of_contact_node = [&](ContactNodeIndex node) {
      return node.value < n_mesh_points ? point_of({contact_mesh_.mesh_nodes[node]})
                                        : drawn_loft_points_[node.value - n_mesh_points];
    };
    for (const SurfaceIndex i : indices(model_.surfaces.surfaces)) {
      FacetBlock block{find_free_name(model_.surfaces.surfaces[i].name + "_edges"), {}, {}, {}};
      for (const ContactEdge& edge : contact_mesh_.edges) {
        if (edge.surface != i || edge.is_particle() || (edge.is_sharp() && !edge.is_feature)) continue;
        block.edges.push_back({point_of_contact_node(edge.nodes[0]), point_of_contact_node(edge.nodes[1])});
      }
      if (!block.edges.empty()) drawing_.blocks.push_back(std::move(block));
    }
  }

  std::string find_free_name(const std::string& wanted) const {
    const auto is_taken = [&](const std::string& name) {
      return std::ranges::any_of(drawing_.blocks,
                                 [&](const FacetBlock& block) { return fold(block.name) == fold(name); });
    };
    std::string name = wanted;
    for (int i = 2; is_taken(name); ++i) name = fmt::format("{}_{}", wanted, i);
    return name;
  }

  const ContactModel& model_;
  const Mesh& mesh_;
  const ContactMesh& contact_mesh_;
  FacetMesh drawing_;
  std::vector<Eigen::Vector3d> points_;
  std::vector<OptionalIndex<std::uint32_t>> point_of_node_;  ///< [n_nodes]
  std::vector<std::uint32_t> drawn_loft_points_;             ///< [n_loft_points] of the contact mesh
};

}  // namespace

FacetMesh draw_surfaces(const ContactModel& model, const Mesh& mesh, const ContactMesh& contact_mesh) {
  return SurfaceDrawing(model, mesh, contact_mesh).draw();
}

FacetMesh draw_surfaces(const ContactModel& model, const Mesh& mesh,
                        const std::vector<SurfaceOptions>& options) {
  ContactMesh contact_mesh = make_contact_mesh(model, mesh);
  choose_feature_edges(options, model.surfaces.surfaces, kinematics_of_mesh(contact_mesh, mesh),
                       contact_mesh);
  return draw_surfaces(model, mesh, contact_mesh);
}

}  // namespace contactsim
