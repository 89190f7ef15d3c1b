// SPDX-License-Identifier: BSD-3-Clause
#include "support/lone_element.hpp"
#include "core/materials/elastic.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <cmath>
#include <random>

namespace contactsim::test {

namespace {

/// Where component ij of the stress at a point stands in the element's state.
std::size_t stress_place(const StateLayout& layout, std::size_t point, Eigen::Index i, Eigen::Index j) {
  return point * layout.point_size + symmetric_place[i][j];
}

}  // namespace

Mesh one_element_mesh(Shape shape, const Eigen::Matrix3Xd& coordinates,
                      const std::vector<std::uint32_t>& nodes) {
  MeshParts parts;
  parts.path = "one element";
  parts.coordinates = coordinates;
  ElementBlock block;
  block.id = 1;
  block.shape = shape;
  block.nodes_per_element = topology(shape).n_nodes;
  block.n_elements = 1;
  for (std::uint32_t node = 0; node < topology(shape).n_nodes; ++node)
    block.nodes.push_back({nodes.empty() ? node : nodes[node]});
  parts.blocks.push_back(std::move(block));
  return Mesh(std::move(parts));
}

Eigen::Matrix3Xd regular_element(Shape shape) {
  Eigen::Matrix3Xd x(3, topology(shape).n_nodes);
  const double height = std::sqrt(0.75);
  switch (shape) {
    case Shape::tet4:
      x << 0, 1, 0.5, 0.5, 0, 0, height, height / 3.0, 0, 0, 0, std::sqrt(2.0 / 3.0);
      break;
    case Shape::tet10:  // edges near 2: their halves are what is regular
      x.leftCols(4) = 2.0 * regular_element(Shape::tet4);
      for (const auto& [middle, a, b] :
           {std::array{4, 0, 1}, {5, 1, 2}, {6, 2, 0}, {7, 0, 3}, {8, 1, 3}, {9, 2, 3}})
        x.col(middle) = 0.5 * (x.col(a) + x.col(b));
      break;
    case Shape::wedge6:
      x << 0, 1, 0.5, 0, 1, 0.5, 0, 0, height, 0, 0, height, 0, 0, 0, 1, 1, 1;
      break;
    case Shape::pyramid5:
      x << 0, 1, 1, 0, 0.5, 0, 0, 1, 1, 0.5, 0, 0, 0, 0, std::sqrt(0.5);
      break;
    default:
      x << 0, 1, 1, 0, 0, 1, 1, 0, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 0, 0, 1, 1, 1, 1;
  }
  return x;
}

Eigen::Matrix3Xd distorted(const Eigen::Matrix3Xd& coordinates, double size, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> shift(-size, size);
  Eigen::Matrix3Xd moved = coordinates;
  for (double& number : moved.reshaped()) number += shift(random);
  return moved;
}

Eigen::Matrix3Xd flat_and_warped(Shape shape, unsigned seed) {
  const bool has_parts = shape == Shape::tet10;  // whose twelve tetrahedra turn inside out sooner
  const Eigen::Matrix3Xd thick = distorted(regular_element(shape), has_parts ? 0.12 : 0.2, seed);
  const Eigen::Matrix3d slant{{1.0, 0.2, 0.0}, {0.0, 1.0, 0.0}, {1.5, -0.7, 0.03}};
  Eigen::Matrix3Xd moved = slant * thick;
  moved.row(2) += (has_parts ? 0.02 : 0.1) * thick.row(0).cwiseProduct(thick.row(1));
  return moved;
}

Eigen::Matrix3d rotation_of(double angle) {
  return Eigen::AngleAxisd(angle, Eigen::Vector3d(1.0, -2.0, 0.5).normalized()).toRotationMatrix();
}

ElementProperties undamped(const MaterialLaw& law) { return {law, 7800.0, 0.05, 0.0, 0.0, 0.0}; }

ElementProperties undamped_elastic() { return undamped(ElasticLaw{{160e9, 80e9}}); }

std::string name_of(const ElementFormulation& row) {
  return std::string(topology(row.shape).name) + " " + std::string(row.formulation);
}

LoneElement::LoneElement(const ElementFormulation& row, const ElementProperties& properties,
                         const Eigen::Matrix3Xd& at_rest, std::vector<std::uint32_t> nodes)
    : block(make_solid_block(one_element_mesh(row.shape, at_rest, nodes), 0, row, properties)),
      state(make_state(block)),
      coordinates(at_rest) {}

ChunkStep LoneElement::move_to(const Eigen::Matrix3Xd& there, double dt) {
  const Eigen::Matrix3Xd velocity =
      dt > 0.0 ? Eigen::Matrix3Xd((there - coordinates) / dt) : Eigen::Matrix3Xd::Zero(3, there.cols());
  coordinates = there;
  return block.element->advance(block, block.chunks[0], {0.0, dt, coordinates, velocity}, state);
}

double LoneElement::volume() const {
  Lanes volume;
  block.element->volumes(block, block.chunks[0], coordinates, {&volume, 1});
  return volume(0);
}

Eigen::Matrix3Xd LoneElement::forces() const {
  Eigen::Matrix3Xd all = Eigen::Matrix3Xd::Zero(3, coordinates.cols());
  block.sums.add(state.forces, all);
  return all;
}

Eigen::Matrix3d LoneElement::stress(std::size_t point) const {
  Eigen::Matrix3d tensor;
  for (Eigen::Index i = 0; i < 3; ++i) {
    for (Eigen::Index j = 0; j < 3; ++j)
      tensor(i, j) = state.at(block.layout, 0, stress_place(block.layout, point, i, j));
  }
  return tensor;
}

void LoneElement::set_stress(const Eigen::Matrix3d& stress) {
  for (std::size_t point = 0; point < block.layout.n_points; ++point) {
    for (Eigen::Index i = 0; i < 3; ++i) {
      for (Eigen::Index j = i; j < 3; ++j)
        state.values[stress_place(block.layout, point, i, j)].setConstant(stress(i, j));
    }
  }
}

Eigen::MatrixXd stiffness_of(const LoneElement& element) {
  constexpr double h = 1e-7;  // of edges near 1: round-off and curvature are then alike
  const Eigen::Index n = element.coordinates.size();
  Eigen::MatrixXd stiffness(n, n);
  for (Eigen::Index column = 0; column < n; ++column) {
    Eigen::Matrix3Xd at[2] = {element.coordinates, element.coordinates};
    at[0](column) -= h;
    at[1](column) += h;
    Eigen::Matrix3Xd force[2];
    for (const int side : {0, 1}) {
      LoneElement moved = element;
      moved.move_to(at[side]);
      force[side] = moved.forces();
    }
    stiffness.col(column) = (force[0] - force[1]).reshaped() / (2.0 * h);
  }
  return stiffness;
}

double stable_limit(const LoneElement& element) {
  const std::size_t n_corners = element.block.element->n_nodes;
  Eigen::VectorXd mass = Eigen::VectorXd::Zero(element.coordinates.size());
  for (std::size_t corner = 0; corner < n_corners; ++corner) {
    const Eigen::Index node = element.block.chunk_nodes[element.block.nodes[corner * n_lanes]];
    mass.segment<3>(3 * node).array() += element.mass() * element.block.element->mass_share(corner);
  }
  const Eigen::MatrixXd stiffness = stiffness_of(element);
  const Eigen::VectorXd scale = mass.cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd scaled =
      scale.asDiagonal() * (0.5 * (stiffness + stiffness.transpose())) * scale.asDiagonal();
  return 2.0 / std::sqrt(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(scaled, Eigen::EigenvaluesOnly)
                             .eigenvalues()
                             .maxCoeff());
}

}  // namespace contactsim::test
