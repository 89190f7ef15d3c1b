// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bench_meshes.hpp"
#include "core/dynamics/integrator.hpp"
#include "core/dynamics/internal_force.hpp"
#include "core/materials/material_law.hpp"

/// Meshes of elements that move to and fro, for benchmarks of the elements' forces and of whole steps.
namespace contactsim::bench {

inline constexpr ElasticModuli steel{160e9, 80e9};
MaterialLaw elastic_law();
MaterialLaw elastic_plastic_law();
MaterialLaw ep_power_hard_law();
MaterialLaw johnson_cook_law();

/// One block of elements that a scene moves to and fro, asking for its forces in every step.
class MovedElements {
 public:
  MovedElements(const MovedElements&) = delete;
  MovedElements& operator=(const MovedElements&) = delete;

  const Mesh& mesh() const { return mesh_; }
  /// Of the last step [time].
  double stable_step() const { return stable_step_; }

  static constexpr double dt = 2e-5;

 protected:
  explicit MovedElements(Mesh mesh) : mesh_(std::move(mesh)) { model_.mesh = &mesh_; }
  /// Begins with a block of the mesh where the mesh has it; velocities are still to be set.
  void begin(ModelBlock block);
  /// Bytes of forces, and of arrays of nodes that are moved besides.
  ///   n_arrays  read or written
  double n_bytes_with(double n_arrays) const;

  Mesh mesh_;
  Model model_;
  State state_;
  std::optional<InternalForce> internal_;
  Eigen::Matrix3Xd x_, v_, forces_;
  double stable_step_ = 0.0;
};

/// Forces of one block of solid elements in a shear wave to and fro, of strains near 1 %, which takes the
/// plastic laws over their yield stress in every step, even when they have hardened for a while.
class SolidScene : public MovedElements {
 public:
  SolidScene(Mesh mesh, const char* formulation, const MaterialLaw& law);

  void step();
  double n_bytes() const { return n_bytes_with(4.0); }  // positions and velocities are read and written
};

/// The same of a sheet of n x n shells, which is also bent.
class ShellScene : public MovedElements {
 public:
  ShellScene(std::uint32_t n, const MaterialLaw& law, std::int64_t n_layers);

  void step();
  double n_bytes() const { return n_bytes_with(6.0); }

 private:
  Eigen::Matrix3Xd w_, moments_;
};

/// Forces of nothing.
class NoLoads final : public ForceTerm {
 public:
  ForceReport set_forces(const Motion&, Eigen::Matrix3Xd&) override { return {}; }
};

/// One period that never ends, with the stable step.
TimeStepControl endless();

/// Whole steps of a free cube of n x n x n elastic hexahedra in a shear wave.
class WholeStepScene {
 public:
  explicit WholeStepScene(std::uint32_t n);
  WholeStepScene(const WholeStepScene&) = delete;
  WholeStepScene& operator=(const WholeStepScene&) = delete;

  void step();
  const Mesh& mesh() const { return mesh_; }
  double n_bytes() const;

 private:
  Mesh mesh_;
  Model model_;
  State state_;
  std::optional<InternalForce> internal_;
  NoLoads none_;
  TimeStepControl control_ = endless();
};

}  // namespace contactsim::bench
