// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "core/elements/solid_block.hpp"
#include "core/force_term.hpp"
#include "core/mesh/topology.hpp"

namespace contactsim {

/// The sums and extremes of a chunk in a step.
struct ChunkStep {
  double stable_step;            ///< the least [time]
  std::size_t critical_element;  ///< position in the block of the first that has it
  double least_volume;           ///< [length^3]; NaN when one is
  double hourglass_work;         ///< [energy]
  double viscous_work;           ///< [energy]
};

/// Row of the element table: a solid element by shape and section formulation.
struct SolidElement {
  Shape shape;
  std::string_view formulation;  ///< as SOLID SECTION names it
  std::size_t n_nodes;
  std::size_t n_points;  ///< integration points with a stress and a material state
  std::size_t n_own;     ///< further Lanes that a batch remembers

  /// Sets the volumes of the elements of a chunk.
  ///   coordinates  [3 x n_nodes] [length]
  ///   volumes      [n_batches of the block] [length^3]
  void (*volumes)(const SolidBlock& block, const BatchChunk& chunk, const Eigen::Matrix3Xd& coordinates,
                  std::span<Lanes> volumes);

  /// Brings the elements of a chunk to the end of a step, forces on their nodes and all.
  ChunkStep (*advance)(const SolidBlock& block, const BatchChunk& chunk, const Motion& motion,
                       SolidBlockState& state);
};

/// All rows; the first of a shape is its default.
std::span<const SolidElement* const> solid_elements();

/// The row of a shape and formulation (compared without case), null when there is none.
const SolidElement* find_solid_element(Shape shape, std::string_view formulation);

/// The formulations of a shape, for messages: "mean_quadrature, selective_deviatoric"; "" when it has none.
std::string list_formulations(Shape shape);

}  // namespace contactsim
