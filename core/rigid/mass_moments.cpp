// SPDX-License-Identifier: BSD-3-Clause
#include "core/rigid/mass_moments.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "core/elements/element_vectors.hpp"

namespace contactsim {

namespace {

using Corners = Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::ColMajor, 3, 4>;

/// A simplex of uniform mass: moments of a tetrahedron (four corners) or triangle (three).
/// Source: Lasserre and Avrachenkov, Am. Math. Monthly 108 (2001) 151-154, for degree two.
void add_simplex(double mass, const Corners& corners, MassMoments& moments) {
  const auto n = static_cast<double>(corners.cols());
  const Eigen::Vector3d sum = corners.rowwise().sum();
  moments.mass += mass;
  moments.first += mass / n * sum;
  moments.second += mass / (n * (n + 1.0)) * (corners * corners.transpose() + sum * sum.transpose());
}

/// Calls add(a, b, c, share) for the triangles of a facet; one of four corners has both ways to split it.
template <class Add>
void for_each_triangle(const FacetCorners& c, const Add& add) {
  if (c[2] == c[3]) return add(c[0], c[1], c[2], 1.0);
  add(c[0], c[1], c[2], 0.5);
  add(c[0], c[2], c[3], 0.5);
  add(c[0], c[1], c[3], 0.5);
  add(c[1], c[2], c[3], 0.5);
}

MassMoments solid_moments(const Topology& shape, const ElementVectors& x, double density) {
  const Eigen::Vector3d middle = x.leftCols(shape.n_corners).rowwise().mean();
  MassMoments moments;
  const auto add = [&](int a, int b, int c, double share) {
    Corners tetrahedron(3, 4);
    tetrahedron << middle, x.col(a), x.col(b), x.col(c);
    const Eigen::Matrix3d edges = tetrahedron.rightCols<3>().colwise() - middle;
    add_simplex(share * density * edges.determinant() / 6.0, tetrahedron, moments);
  };
  for (std::size_t side = 0; side < shape.sides.size(); ++side) {
    for (const FacetCorners& corners : shape.facets(side)) for_each_triangle(corners, add);
  }
  return moments;
}

MassMoments shell_moments(const Topology& shape, const ElementVectors& x, double mass, double thickness) {
  const FacetCorners face{0, 1, 2, static_cast<std::uint8_t>(shape.n_corners == 3 ? 2 : 3)};
  MassMoments moments;
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  for_each_triangle(face, [&](int a, int b, int c, double share) {
    Corners triangle(3, 3);
    triangle << x.col(a), x.col(b), x.col(c);
    const Eigen::Vector3d area =
        0.5 * Eigen::Vector3d(x.col(b) - x.col(a)).cross(Eigen::Vector3d(x.col(c) - x.col(a)));
    add_simplex(share * area.norm(), triangle, moments);
    normal += area;
  });
  const double per_area = mass / moments.mass;  // mass was area so far
  normal.normalize();
  const Eigen::Matrix3d across = mass * thickness * thickness / 12.0 * normal * normal.transpose();
  return {mass, per_area * moments.first, per_area * moments.second + across};
}

double at(const std::vector<Lanes>& values, std::size_t element) {
  return values[element / n_lanes](static_cast<Eigen::Index>(element % n_lanes));
}

MassMoments element_moments(const ModelBlock& block, const Topology& shape, std::size_t element,
                            const ElementVectors& x) {
  if (shape.family == Family::solid) return solid_moments(shape, x, block.properties.density);
  const double mass = at(block.mass, element);
  if (shape.family == Family::shell) return shell_moments(shape, x, mass, at(block.thickness, element));
  MassMoments moments;
  for (Eigen::Index node = 0; node < x.cols(); ++node)
    moments.add(mass / static_cast<double>(x.cols()), x.col(node));
  const Eigen::Matrix3d& inertia = block.discrete.inertia;
  moments.second += 0.5 * inertia.trace() * Eigen::Matrix3d::Identity() - inertia;
  return moments;
}

}  // namespace

void MassMoments::add(double point_mass, const Eigen::Vector3d& place) {
  mass += point_mass;
  first += point_mass * place;
  second += point_mass * place * place.transpose();
}

Eigen::Matrix3d inertia_of(const Eigen::Matrix3d& second_moment) {
  return second_moment.trace() * Eigen::Matrix3d::Identity() - second_moment;
}

MassMoments mass_moments(const ModelBlock& block, const Mesh& mesh, const Eigen::Vector3d& origin) {
  const ElementBlock& source = mesh.blocks()[block.mesh_block];
  const Topology& shape = topology(source.shape);
  MassMoments sum;
  for (std::uint32_t element = 0; element < source.n_elements; ++element) {
    const auto nodes = source.element_nodes(element);
    ElementVectors x(3, static_cast<Eigen::Index>(nodes.size()));
    for (std::size_t i = 0; i < nodes.size(); ++i)
      x.col(static_cast<Eigen::Index>(i)) = mesh.coordinates().col(nodes[i].value) - origin;
    const MassMoments one = element_moments(block, shape, element, x);
    sum.mass += one.mass;
    sum.first += one.first;
    sum.second += one.second;
  }
  return sum;
}

}  // namespace contactsim
