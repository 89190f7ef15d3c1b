// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "core/dynamics/internal_force.hpp"
#include "core/elements/elements.hpp"
#include "core/materials/elastic.hpp"
#include "core/statics/static_problem.hpp"
#include "support/mesh_builder.hpp"

namespace contactsim::test {

class NoLoad final : public ForceTerm {
 public:
  ForceReport set_forces(const Motion& motion, Eigen::Matrix3Xd& forces) override {
    forces = Eigen::Matrix3Xd::Zero(3, motion.coordinates.cols());
    return {};
  }
};

/// n x n x n cells of an elastic cube of edge 2, some nodes held.
struct StaticCube {
  Mesh mesh;
  Model model;
  State state;
  NoLoad nothing;
  std::optional<InternalForce> internal;
  std::optional<StaticProblem> problem;

  explicit StaticCube(std::vector<NodeIndex> held = {}, int n = 2)
      : mesh(MeshBuilder().add_hexes({.cells = {n, n, n}, .size = {2, 2, 2}}).build()) {
    model.mesh = &mesh;
    ElementProperties properties{ElasticLaw{{160e9, 80e9}}, 7800.0};
    properties.linear_bulk_viscosity = properties.quadratic_bulk_viscosity = 0.0;
    model.blocks.push_back(make_solid_block(mesh, 0, hex8_selective_deviatoric, properties));
    model.mass = lumped_mass(mesh, model.blocks);
    if (!held.empty()) {
      PrescribedMotion fixed;
      fixed.direction = Components{{true, true, true}};
      fixed.nodes = std::move(held);
      model.kinematic_constraints = KinematicConstraints(mesh, {fixed});
    }
    state = make_state(mesh.coordinates(), model.blocks, 0.0);
    internal.emplace(model, state);
    problem.emplace(model, ForceTerms{*internal, nothing}, nullptr, ResidualReference::internal, state);
    problem->begin_step(1.0);
  }

  Eigen::VectorXd pulled(double size) const {
    Eigen::VectorXd increment(problem->size());
    for (Eigen::Index i = 0; i < increment.size(); i += 3)
      increment.segment<3>(i) =
          size * mesh.coordinates().col(i / 3).cwiseProduct(Eigen::Vector3d(1.0, -0.3, 0.2));
    return increment;
  }
};

}  // namespace contactsim::test
