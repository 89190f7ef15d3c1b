// SPDX-License-Identifier: BSD-3-Clause
#include "core/statics/static_unknowns.hpp"

#include <cmath>

namespace contactsim {

namespace {

/// Turns moments into forces at the radius of gyration that a node's inertia has.
Eigen::VectorXd residual_weights(const Model& model, Eigen::Index n, Eigen::Index size) {
  Eigen::VectorXd weights = Eigen::VectorXd::Ones(size);
  for (Eigen::Index i = n; i < size; ++i) {
    const Eigen::Index node = (i - n) / 3;
    if (node >= model.inertia.cols()) break;  // those of rigid bodies have displacements alone
    const double mass = model.mass(node), inertia = model.inertia(node);
    weights(i) = inertia > minimum_nodal_mass ? mass / inertia : 0.0;
  }
  return weights;
}

}  // namespace

StaticUnknowns::StaticUnknowns(const Model& model, std::uint32_t n_nodes, bool turns)
    : n_mesh_(3 * Eigen::Index{model.mesh->n_nodes()}),
      n_(3 * Eigen::Index{n_nodes}),
      weights_(residual_weights(model, n_, turns ? 2 * n_ : n_)) {}

Eigen::VectorXd StaticUnknowns::vector_of(const Eigen::Matrix3Xd& of_places,
                                          const Eigen::Matrix3Xd& of_turns) const {
  Eigen::VectorXd vector = Eigen::VectorXd::Zero(size());
  if (of_places.size() > 0) vector.head(n_mesh_) = of_places.reshaped();
  if (turn() && of_turns.size() > 0) vector.segment(n_, n_mesh_) = of_turns.reshaped();
  return vector;
}

double StaticUnknowns::norm(const Eigen::VectorXd& residual) const {
  return std::sqrt(residual.cwiseAbs2().dot(weights_));
}

Eigen::VectorXd StaticUnknowns::scales_of(std::uint32_t node) const {
  const Eigen::Index per_node = 3 * size() / n_;
  Eigen::VectorXd scales = Eigen::VectorXd::Ones(per_node);
  if (per_node > 3) scales.tail<3>() = weights_.segment<3>(n_ + 3 * Eigen::Index{node}).cwiseSqrt();
  return scales;
}

NodeIndex StaticUnknowns::largest_at(const Eigen::VectorXd& residual) const {
  Eigen::Index node = 0;
  residual.head(n_).reshaped(3, n_ / 3).colwise().squaredNorm().maxCoeff(&node);
  return {static_cast<std::uint32_t>(node)};
}

double StaticUnknowns::longest_in(const Eigen::VectorXd& increment) const {
  return std::sqrt(increment.head(n_).reshaped(3, n_ / 3).colwise().squaredNorm().maxCoeff());
}

}  // namespace contactsim
