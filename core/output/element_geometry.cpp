// SPDX-License-Identifier: BSD-3-Clause
#include "core/output/element_geometry.hpp"

#include <Eigen/Geometry>
#include <array>

namespace contactsim {

namespace {

// Adds the gradient of a part of the volume under three corners: factor times det(a, b, c) / 6.
void add_triangle(const std::array<int, 3>& corners, double factor, const ElementVectors& x,
                  ElementVectors& gradient) {
  for (std::size_t i = 0; i < 3; ++i) {
    const Eigen::Vector3d b = x.col(corners[(i + 1) % 3]), c = x.col(corners[(i + 2) % 3]);
    gradient.col(corners[i]) += factor / 6.0 * b.cross(c);
  }
}

void add_facet(const FacetCorners& corners, const ElementVectors& x, ElementVectors& gradient) {
  const int a = corners[0], b = corners[1], c = corners[2], d = corners[3];
  if (c == d) {
    add_triangle({a, b, c}, 1.0, x, gradient);
    return;
  }
  add_triangle({a, b, c}, 0.5, x, gradient);
  add_triangle({a, c, d}, 0.5, x, gradient);
  add_triangle({a, b, d}, 0.5, x, gradient);
  add_triangle({b, c, d}, 0.5, x, gradient);
}

// How a shell's place in its middle changes with its natural coordinates.
struct SurfaceTangents {
  SurfaceTangents(const Topology& topology, const ElementVectors& x) {
    if (topology.n_corners == 4) {
      slopes_r = {-0.25, 0.25, 0.25, -0.25};
      slopes_s = {-0.25, -0.25, 0.25, 0.25};
      natural_area = 4.0;
    }
    for (int a = 0; a < topology.n_corners; ++a) {
      along_r += slopes_r[static_cast<std::size_t>(a)] * (x.col(a) - x.col(0));
      along_s += slopes_s[static_cast<std::size_t>(a)] * (x.col(a) - x.col(0));
    }
  }

  std::array<double, 4> slopes_r{-1.0, 1.0, 0.0, 0.0}, slopes_s{-1.0, 0.0, 1.0, 0.0};  // of shape functions
  double natural_area = 0.5;
  Eigen::Vector3d along_r = Eigen::Vector3d::Zero(), along_s = Eigen::Vector3d::Zero();
};

}  // namespace

ElementVectors gather(std::span<const NodeIndex> nodes, const Eigen::Matrix3Xd& values) {
  ElementVectors gathered(3, static_cast<Eigen::Index>(nodes.size()));
  for (std::size_t i = 0; i < nodes.size(); ++i)
    gathered.col(static_cast<Eigen::Index>(i)) = values.col(nodes[i].value);
  return gathered;
}

ElementVectors volume_gradient(const Topology& topology, const ElementVectors& x) {
  // Seen from a node of its own an element far from the origin loses no digits.
  const ElementVectors near = x.colwise() - x.col(0).eval();
  ElementVectors gradient = ElementVectors::Zero(3, x.cols());
  for (std::size_t side = 0; side < topology.sides.size(); ++side) {
    for (const FacetCorners& corners : topology.facets(side)) add_facet(corners, near, gradient);
  }
  return gradient;
}

ElementVectors surface_gradient(const Topology& topology, const ElementVectors& x) {
  const SurfaceTangents tangents(topology, x);
  const Eigen::Vector3d normal = tangents.along_r.cross(tangents.along_s);
  const Eigen::Vector3d dual_r = tangents.along_s.cross(normal) / normal.squaredNorm();
  const Eigen::Vector3d dual_s = normal.cross(tangents.along_r) / normal.squaredNorm();
  ElementVectors gradient = ElementVectors::Zero(3, x.cols());
  for (int a = 0; a < topology.n_corners; ++a)
    gradient.col(a) = tangents.slopes_r[static_cast<std::size_t>(a)] * dual_r +
                      tangents.slopes_s[static_cast<std::size_t>(a)] * dual_s;
  return gradient;
}

double surface_area(const Topology& topology, const ElementVectors& x) {
  const SurfaceTangents tangents(topology, x);
  return tangents.natural_area * tangents.along_r.cross(tangents.along_s).norm();
}

Eigen::Vector3d surface_normal(const Topology& topology, const ElementVectors& x) {
  const SurfaceTangents tangents(topology, x);
  return tangents.along_r.cross(tangents.along_s).stableNormalized();
}

double solid_volume(const ElementVectors& x, const ElementVectors& gradient) {
  return (x.colwise() - x.col(0).eval()).cwiseProduct(gradient).sum() / 3.0;
}

}  // namespace contactsim
