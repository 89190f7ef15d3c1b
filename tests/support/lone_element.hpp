// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "core/elements/element_table.hpp"

namespace contactsim::test {

/// A regular element of edges near 1 [3 x nodes of the shape].
Eigen::Matrix3Xd regular_element(Shape shape);

/// Every coordinate moved at random by up to a size.
Eigen::Matrix3Xd distorted(const Eigen::Matrix3Xd& coordinates, double size, unsigned seed);

/// A distorted element, sheared and a thirtieth as thick as it is wide, its upper and lower faces warped
/// alike by more than the thickness.
Eigen::Matrix3Xd flat_and_warped(Shape shape, unsigned seed);

/// Rotation about an axis that is no coordinate axis.
Eigen::Matrix3d rotation_of(double angle);

/// Steel-like moduli (bulk 160e9, shear 80e9) without bulk viscosity and hourglass viscosity.
ElementProperties undamped(const MaterialLaw& law);
ElementProperties undamped_elastic();

/// "HEX8 mean_quadrature".
std::string name_of(const ElementFormulation& row);

/// A mesh of one element over these coordinates.
///   nodes  of the element by columns of the coordinates, when they are not 0, 1, 2...
Mesh one_element_mesh(Shape shape, const Eigen::Matrix3Xd& coordinates,
                      const std::vector<std::uint32_t>& nodes = {});

/// One solid element that a test moves as it likes.
struct LoneElement {
  ModelBlock block;
  ModelBlockState state;
  Eigen::Matrix3Xd coordinates;  ///< now [3 x n_nodes]

  ///   nodes  of the element by columns of at_rest, when they are not 0, 1, 2...
  LoneElement(const ElementFormulation& row, const ElementProperties& properties,
              const Eigen::Matrix3Xd& at_rest, std::vector<std::uint32_t> nodes = {});

  /// Moves the nodes along straight lines in one step; dt 0 asks for the forces where it stands.
  ChunkStep move_to(const Eigen::Matrix3Xd& there, double dt = 1.0);
  /// Asks for the forces where it stands.
  ChunkStep stay() { return move_to(coordinates, 0.0); }

  /// On the nodes, of the last move [3 x n_nodes] [force].
  Eigen::Matrix3Xd forces() const;
  Eigen::Matrix3d stress(std::size_t point = 0) const;
  void set_stress(const Eigen::Matrix3d& stress);  ///< at every point
  double mass() const { return block.mass[0](0); }
  double volume() const;
  /// Work of the stress so far [energy].
  double stress_work() const { return state.at(block.layout, 0, block.layout.energy()); }
};

/// Derivatives of the restoring forces by the coordinates of the nodes, by differences [force/length].
Eigen::MatrixXd stiffness_of(const LoneElement& element);

/// 2 / the highest frequency of an element with its lumped masses [time].
double stable_limit(const LoneElement& element);

}  // namespace contactsim::test
