// SPDX-License-Identifier: BSD-3-Clause
#include "core/dynamics/discrete_steps.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/elements/element_table.hpp"

namespace contactsim {

namespace {

/// How easily the ends of springs move.
class Ends {
 public:
  explicit Ends(const Model& model)
      : model_(model), is_prescribed_(model.mesh->n_nodes(), 0), sums_(n_movers(model), 0.0) {
    for (const NodeIndex node : model.kinematic_constraints.never_free()) is_prescribed_[node.value] = 1;
    for (const RigidBody& body : model.rigid.bodies) {
      per_inertia_.push_back(
          Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(body.flexible, Eigen::EigenvaluesOnly)
              .eigenvalues()[2]);
    }
  }

  /// Counts a spring at both of its ends.
  void add(std::span<const NodeIndex> nodes, double stiffness) {
    for (const NodeIndex node : nodes) sums_[mover_of(node)] += stiffness * std::sqrt(mobility(node));
  }
  /// The sum of a spring's row.
  double row(std::span<const NodeIndex> nodes) const {
    double sum = 0.0;
    for (const NodeIndex node : nodes) sum += std::sqrt(mobility(node)) * sums_[mover_of(node)];
    return sum;
  }

 private:
  static std::size_t n_movers(const Model& model) {
    return model.mesh->n_nodes() + model.rigid.bodies.size();
  }

  OptionalIndex<std::uint32_t> body_of(NodeIndex node) const {
    const auto& bodies = model_.rigid.nodes.body_of;
    return bodies.empty() ? OptionalIndex<std::uint32_t>() : bodies[node.value];
  }
  std::size_t mover_of(NodeIndex node) const {
    const OptionalIndex<std::uint32_t> body = body_of(node);
    return body ? model_.mesh->n_nodes() + *body : node.value;
  }
  /// Acceleration by a force, at most [1/mass].
  double mobility(NodeIndex node) const {
    const OptionalIndex<std::uint32_t> index = body_of(node);
    if (!index) {
      const double mass = model_.mass(node.value);
      return mass > minimum_nodal_mass && is_prescribed_[node.value] == 0 ? 1.0 / mass : 0.0;
    }
    const RigidBody& body = model_.rigid.bodies[*index];
    const double arm = (model_.mesh->coordinates().col(node.value) - body.centre).norm();
    return 1.0 / body.mass + arm * arm * per_inertia_[*index];
  }

  const Model& model_;
  std::vector<std::uint8_t> is_prescribed_;  ///< [n_nodes]
  std::vector<double> per_inertia_;          ///< [n_bodies] the largest [1/(mass length^2)]
  std::vector<double> sums_;                 ///< [n_nodes + n_bodies]
};

double& lane(std::vector<Lanes>& values, std::uint32_t element, std::size_t n_each = 1, std::size_t k = 0) {
  return values[element / n_lanes * n_each + k](static_cast<Eigen::Index>(element % n_lanes));
}

/// The greatest stiffness that a cohesive element may have over its area [force/length^3].
double greatest_stiffness(const TractionLaw& law) {
  return std::max(std::max(1.0, law.penetration_factor) * law.normal_stiffness(), law.tangential_stiffness());
}

/// Calls act(two nodes, what is between them, its stable step) for all pairs of a cohesive element.
template <class Act>
void for_each_pair(ModelBlock& block, std::uint32_t element, std::span<const NodeIndex> nodes,
                   const Act& act) {
  const std::size_t n = nodes.size() / 2;
  const double stiffness = greatest_stiffness(block.cohesive.law);
  for (std::size_t pair = 0; pair < n; ++pair) {
    const std::array ends{nodes[pair], nodes[pair + n]};
    act(std::span<const NodeIndex>(ends), stiffness * lane(block.cohesive.area, element, n, pair),
        lane(block.cohesive.stable_step, element));
  }
}

/// The same for all elements of a rule.
template <class Act>
void for_each(Model& model, StepRule rule, const Act& act) {
  for (ModelBlock& block : model.blocks) {
    if (block.element->step_rule != rule || block.is_rigid) continue;
    const ElementBlock& source = model.mesh->blocks()[block.mesh_block];
    for (std::uint32_t i = 0; i < source.n_elements; ++i) {
      if (block.cohesive.area.empty()) {
        act(source.element_nodes(i), lane(block.discrete.stiffness, i), lane(block.discrete.stable_step, i));
      } else {
        for_each_pair(block, i, source.element_nodes(i), act);
      }
    }
  }
}

}  // namespace

void set_discrete_steps(Model& model) {
  for (const StepRule rule : {StepRule::stiffness, StepRule::damping}) {
    Ends ends(model);
    for_each(model, rule, [&](std::span<const NodeIndex> nodes, double stiffness, double&) {
      ends.add(nodes, stiffness);
    });
    for_each(model, rule, [&](std::span<const NodeIndex> nodes, double, double& stable_step) {
      const double bound = ends.row(nodes);
      if (bound > 0.0)
        stable_step = std::min(stable_step, 2.0 / (rule == StepRule::damping ? bound : std::sqrt(bound)));
    });
  }
}

double combined_step(double material, double stiffness, double damping) {
  if (std::isinf(stiffness) && std::isinf(damping)) return material;
  const double squares = 1.0 / (material * material) + 1.0 / (stiffness * stiffness), linear = 1.0 / damping;
  // The root of squares dt^2 + linear dt = 1, in a form without cancellation.
  return 2.0 / (linear + std::sqrt(linear * linear + 4.0 * squares));
}

}  // namespace contactsim
