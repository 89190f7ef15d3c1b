// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "core/elements/element_table.hpp"

namespace contactsim::test {

/// A regular shell of edges near 1 in the plane z = 0 [3 x nodes of the shape].
Eigen::Matrix3Xd regular_shell(Shape shape);

/// Three layers of Gauss.
ShellSettings gauss_layers(std::int64_t n_layers = 3);

/// One shell, or another element whose nodes may turn, that a test moves as it likes.
struct LoneShell {
  ModelBlock block;
  ModelBlockState state;
  Eigen::Matrix3Xd coordinates;  ///< now [3 x n_nodes]

  LoneShell(const ElementFormulation& row, const MaterialLaw& law, const Eigen::Matrix3Xd& at_rest,
            double thickness, const ShellSettings& settings = gauss_layers());

  /// Any block of one element.
  LoneShell(ModelBlock its_block, const Eigen::Matrix3Xd& at_rest);

  /// Moves the nodes along straight lines in one step, and turns them.
  ///   turns  [3 x n_nodes] angular velocity times dt [1]
  ChunkStep move_to(const Eigen::Matrix3Xd& there, const Eigen::Matrix3Xd& turns, double dt = 1.0);
  /// Asks for the forces where it stands.
  ChunkStep stay();

  /// On the nodes, of the last move [3 x n_nodes] [force], [force length]; no moments: zeros.
  Eigen::Matrix3Xd forces() const;
  Eigen::Matrix3Xd moments() const;
  /// Along the axes of the shell [force/length^2].
  Eigen::Matrix3d stress(std::size_t layer) const;
  /// Work of the stress so far [energy].
  double stress_work() const { return state.at(block.layout, 0, block.layout.energy()); }
};

/// How nodes turn that rotation_of(angle) takes along a chord: twice the tangent of half the angle [3 x n]
/// [1].
Eigen::Matrix3Xd turns_of(double angle, Eigen::Index n);

/// Turns of nodes at random, of up to a size [3 x n] [1].
Eigen::Matrix3Xd random_turns(Eigen::Index n, double size, unsigned seed);

/// The moment about the origin of all forces and moments of the last move [force length].
Eigen::Vector3d total_moment(const LoneShell& shell);

/// Checks that the forces and moments of the last move are minus the derivatives of the work, of stress and
/// of hourglass forces, by displacements and turns of the nodes.
///   margin  [force]
void check_derivatives_of_work(const LoneShell& shell, double margin);

/// Derivatives of the restoring forces and moments by displacements and turns of the nodes, by differences:
/// nodes in turn, each three displacements and three turns.
Eigen::MatrixXd stiffness_of(const LoneShell& shell);

/// 2 / the highest frequency of a shell that gives its nodes equal masses and inertias [time].
double stable_limit(const LoneShell& shell);

}  // namespace contactsim::test
