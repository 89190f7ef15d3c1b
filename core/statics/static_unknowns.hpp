// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "core/dynamics/model.hpp"

namespace contactsim {

/// How the unknowns of load steps stand in vectors: displacements of all nodes, those of rigid bodies behind
/// those of the mesh, then rotations likewise where nodes turn; residuals and increments alike.
class StaticUnknowns {
 public:
  ///   n_nodes  those of rigid bodies included
  ///   turns    whether nodes turn
  StaticUnknowns(const Model& model, std::uint32_t n_nodes, bool turns);

  Eigen::Index size() const { return weights_.size(); }
  /// 3 a node: where rotations begin.
  Eigen::Index n() const { return n_; }
  /// The same of the nodes of the mesh.
  Eigen::Index n_mesh() const { return n_mesh_; }
  bool turn() const { return size() > n_; }

  /// Vectors of the nodes of the mesh in a vector of unknowns, 0 of all others.
  ///   of_places, of_turns  [3 x n_nodes of the mesh], or empty: 0
  Eigen::VectorXd vector_of(const Eigen::Matrix3Xd& of_places, const Eigen::Matrix3Xd& of_turns) const;
  /// The displacements of the nodes of the mesh in a vector of unknowns, which must outlive them
  /// [3 x n_nodes of the mesh].
  auto places_in(const Eigen::VectorXd& vector) const {
    return vector.head(n_mesh_).reshaped(3, n_mesh_ / 3);
  }
  /// The same of rotations. Precondition: nodes turn.
  auto turns_in(const Eigen::VectorXd& vector) const {
    return vector.segment(n_, n_mesh_).reshaped(3, n_mesh_ / 3);
  }
  /// What squares of residuals count by: 1, and 1/length^2 of moments.
  const Eigen::VectorXd& weights() const { return weights_; }
  double norm(const Eigen::VectorXd& residual) const;
  /// What makes forces of the residuals of a node's unknowns: 1, and 1/length of rotations [3 or 6].
  Eigen::VectorXd scales_of(std::uint32_t node) const;
  /// The node with the largest force in a residual.
  NodeIndex largest_at(const Eigen::VectorXd& residual) const;
  /// The largest displacement of a node in an increment [length].
  double longest_in(const Eigen::VectorXd& increment) const;

 private:
  Eigen::Index n_mesh_, n_;
  Eigen::VectorXd weights_;
};

}  // namespace contactsim
