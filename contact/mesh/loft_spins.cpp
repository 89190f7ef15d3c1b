// SPDX-License-Identifier: BSD-3-Clause
#include "contact/mesh/loft_spins.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "core/base/threads.hpp"

namespace contactsim {

namespace {

/// Sum |r|^2 I - r r^T of one neighbour.
Eigen::Matrix3d inertia_of(const Eigen::Vector3d& arm) {
  return arm.squaredNorm() * Eigen::Matrix3d::Identity() - arm * arm.transpose();
}

/// The inverse; 0 where all neighbours lie on a line with the node.
Eigen::Matrix3d inverse_or_zero(const Eigen::Matrix3d& inertia) {
  constexpr double flat = 1e-9;
  const double size = inertia.trace();
  Eigen::Matrix3d inverse;
  bool exists = false;
  inertia.computeInverseWithCheck(inverse, exists, flat * size * size * size);
  return exists ? inverse : Eigen::Matrix3d::Zero();
}

/// The Frobenius norm of r x K.
double size_of_cross(const Eigen::Vector3d& arm, const Eigen::Matrix3d& flexible) {
  double sum = 0.0;
  for (int i = 0; i < 3; ++i) sum += arm.cross(Eigen::Vector3d(flexible.col(i))).squaredNorm();
  return std::sqrt(sum);
}

}  // namespace

LoftSpins::LoftSpins(const LoftPoints& loft, std::size_t n_mesh_nodes, const RigidNodes& rigid) : first_{0} {
  std::vector<std::pair<NodeIndex, NodeIndex>> around;
  for (const auto& shell : loft.shell_nodes()) {
    for (const NodeIndex node : shell) {
      for (const NodeIndex other : shell) {
        if (node != other && rigid.is_free(node) && rigid.is_free(other)) around.push_back({node, other});
      }
    }
  }
  std::ranges::sort(around);
  around.erase(std::ranges::unique(around).begin(), around.end());
  if (!around.empty()) index_.resize(n_mesh_nodes);
  for (auto first = around.begin(); first != around.end();) {
    const auto last =
        std::find_if(first, around.end(), [&](const auto& one) { return one.first != first->first; });
    if (last - first > 1) {
      index_[first->first] = static_cast<std::uint32_t>(nodes_.size());
      nodes_.push_back(first->first);
      for (auto one = first; one != last; ++one) neighbours_.push_back(one->second);
      first_.push_back(static_cast<std::uint32_t>(neighbours_.size()));
    }
    first = last;
  }
  free_.assign(nodes_.size(), Eigen::Matrix3d::Identity());
  flexible_.assign(nodes_.size(), Eigen::Matrix3d::Zero());
  own_bounds_.assign(nodes_.size(), 0.0);
  bounds_.assign(neighbours_.size(), 0.0);
  arms_.assign(neighbours_.size(), Eigen::Vector3d::Zero());
}

void LoftSpins::hold(const ModelFreeDirections& free) {
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const Eigen::Matrix3d* own = free.of_turns(nodes_[i]);
    free_[i] = own != nullptr ? *own : Eigen::Matrix3d::Identity();
  }
}

void LoftSpins::update(const Eigen::Matrix3Xd& coordinates) {
#pragma omp parallel for schedule(static) num_threads(threads_for(nodes_.size()))
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
    for (std::size_t k = first_[i]; k < first_[i + 1]; ++k) {
      arms_[k] = coordinates.col(neighbours_[k].value) - coordinates.col(nodes_[i].value);
      inertia += inertia_of(arms_[k]);
    }
    flexible_[i] = inverse_or_zero(inertia);
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (std::size_t k = first_[i]; k < first_[i + 1]; ++k) {
      bounds_[k] = size_of_cross(arms_[k], flexible_[i]);
      sum += arms_[k];
    }
    own_bounds_[i] = size_of_cross(sum, flexible_[i]);
  }
}

Eigen::Vector3d LoftSpins::mid_spin(std::size_t i, const Eigen::Matrix3Xd& coordinates,
                                    const Eigen::Matrix3Xd& velocity, double dt,
                                    const Eigen::Vector3d& own) const {
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const NodeIndex other : neighbours(i)) {
    const Eigen::Vector3d moves = velocity.col(other.value) - velocity.col(nodes_[i].value);
    const Eigen::Vector3d arm =
        coordinates.col(other.value) - coordinates.col(nodes_[i].value) - 0.5 * dt * moves;
    inertia += inertia_of(arm);
    sum += arm.cross(moves);
  }
  return own + free_[i] * (inverse_or_zero(inertia) * sum - own);
}

}  // namespace contactsim
