// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/output/element_geometry.hpp"
#include "core/output/output_table.hpp"

namespace contactsim {

/// One element at the time of output, and what its variables are made of.
struct ElementView {
  const OutputContext& context;
  const EntityRange& range;
  std::size_t i;  ///< element range.first + i of the block

  const ModelBlock& block() const { return context.model.blocks[range.block]; }
  const ElementBlock& mesh_block() const { return context.model.mesh->blocks()[block().mesh_block]; }
  const Topology& shape() const { return topology(mesh_block().shape); }
  std::size_t element() const { return range.first + i; }

  /// The columns of the element's nodes of an array over the mesh.
  ElementVectors gathered(const Eigen::Matrix3Xd& values) const;
  ElementVectors coordinates() const { return gathered(context.state.coordinates); }

  /// One of numbers that are kept by batches [n_batches].
  double lane_value(const std::vector<Lanes>& numbers) const {
    return numbers[element() / n_lanes](static_cast<Eigen::Index>(element() % n_lanes));
  }
  double mass() const { return lane_value(block().mass); }  ///< [mass]
  double thickness_growth() const;                          ///< of shells, over that of the start [1]
  double thickness() const {
    return (1.0 + thickness_growth()) * lane_value(block().thickness);
  }                              ///< [length]
  double volume() const;         ///< now; lines and particles keep theirs [length^3]
  double strain_energy() const;  ///< work of the stress so far [energy]
  /// 1 alive, 0 dead, in between while it dies [1]
  double life() const { return context.state.blocks[range.block].life_of(element()); }
  Eigen::Matrix3d stress() const { return stress_of(context, range, i); }

  /// The motion from the mesh to now: its mean gradient by the mesh's coordinates. Of shells that of the
  /// surface and the stretch of the thickness; of lines the stretch along them; particles do not deform, and
  /// cohesive elements have their separation.
  Eigen::Matrix3d deformation_gradient() const;
  Eigen::Matrix3d log_strain() const;  ///< of the deformation gradient [1]

  /// Symmetric part of the mean velocity gradient, in the same way [1/time].
  Eigen::Matrix3d rate_of_deformation() const;

  /// The axes, as rows, along which the element keeps its stress.
  Eigen::Matrix3d frame() const;
};

}  // namespace contactsim
