// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "core/elements/element_vectors.hpp"
#include "core/elements/force_term.hpp"
#include "core/elements/model_block.hpp"
#include "core/mesh/topology.hpp"

namespace contactsim {

/// The sums and extremes of a chunk in a step.
struct ChunkStep {
  double stable_step;            ///< the least [time]
  std::size_t critical_element;  ///< position in the block of the first that has it
  double min_volume;             ///< [length^3]; NaN when one is
  double hourglass_work;         ///< [energy]
  double viscous_work;           ///< [energy]
};

/// How the stable step of elements goes together with that of others. Elements of a material bring the mass
/// that they move, so that the least of their steps is that of all; the others move the mass of others.
enum class StepRule : std::uint8_t { material, stiffness, damping, none };

/// Row of the element table: what a formulation makes of elements of a shape.
struct ElementFormulation {
  Shape shape;
  std::string_view formulation;  ///< as their section names it
  std::size_t n_nodes;
  std::size_t n_points;  ///< integration points with a stress and a material state
  std::size_t n_own;     ///< further Lanes that a batch remembers

  /// Sets the volumes of the elements of a chunk.
  ///   coordinates  [3 x n_nodes] [length]
  ///   volumes      [n_batches of the block] [length^3]
  void (*volumes)(const ModelBlock& block, const BatchChunk& chunk, const Eigen::Matrix3Xd& coordinates,
                  std::span<Lanes> volumes);

  /// Brings the elements of a chunk to the end of a step, forces on their nodes and all.
  ChunkStep (*advance)(const ModelBlock& block, const BatchChunk& chunk, const Motion& motion,
                       ModelBlockState& state);
  bool has_rotations = false;  ///< whether its nodes turn: Motion has angular velocities, it sets moments

  /// The axes, as rows, along which an element keeps its stress; null: the global axes.
  ///   coordinates  [3 x n_nodes] of the element now [length]
  Eigen::Matrix3d (*frame)(const ElementVectors& coordinates) = nullptr;

  StepRule step_rule = StepRule::material;

  /// [n_nodes] of the element's mass that each of its nodes has, together 1; empty: equal ones [1].
  std::span<const double> mass_shares = {};

  double mass_share(std::size_t node) const {
    return mass_shares.empty() ? 1.0 / static_cast<double>(n_nodes) : mass_shares[node];
  }
  bool has_material() const { return step_rule == StepRule::material; }
};

/// The rows of solids; the first of a shape is its default.
std::span<const ElementFormulation* const> solid_elements();

/// The rows of shells, in the same order.
std::span<const ElementFormulation* const> shell_elements();

/// The rows of membranes, one of each shape of shells.
std::span<const ElementFormulation* const> membrane_elements();

/// The rows of lines and particles: beam, truss, particle, spring, damper, point mass without and with
/// inertia.
std::span<const ElementFormulation* const> line_elements();

/// The row of lines or particles of a shape and formulation, null when there is none.
const ElementFormulation* find_line_element(Shape shape, std::string_view formulation);

/// The row of a shape and formulation (compared without case), null when there is none.
const ElementFormulation* find_solid_element(Shape shape, std::string_view formulation);

/// The first row of a shape of solids: what a block without a word on it gets; null when there is none.
const ElementFormulation* default_solid_element(Shape shape);

/// The same of shells. The formulations of four-node shells mean the one of triangles there is, so that a
/// section may be for both.
const ElementFormulation* find_shell_element(Shape shape, std::string_view formulation);

/// The row of membranes of a shape, null when there is none.
const ElementFormulation* find_membrane_element(Shape shape);

/// The formulations of a shape, for messages: "mean_quadrature, selective_deviatoric"; "" when it has none.
std::string list_formulations(Shape shape);

}  // namespace contactsim
