// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "core/conditions/free_directions.hpp"

namespace contactsim {

class KinematicConstraints;
struct Model;

/// The directions in which the conditions of a model that act at a time leave its nodes and rigid bodies
/// free.
class ModelFreeDirections {
 public:
  /// Takes over the conditions that act in the step that begins now. Returns whether they are others than in
  /// the last call.
  bool update(const Model& model, double time);

  /// Projection on the free directions of a node of the mesh or of a rigid body, by its position: on all of
  /// them while none of its conditions acts. Null of what no condition is of.
  const Eigen::Matrix3d* of_node(NodeIndex node) const { return nodes_.find(node.value); }
  const Eigen::Matrix3d* of_turns(NodeIndex node) const { return turns_.find(node.value); }
  const Eigen::Matrix3d* of_body(std::uint32_t body) const { return bodies_.find(body); }
  const Eigen::Matrix3d* of_body_turns(std::uint32_t body) const { return body_turns_.find(body); }

 private:
  /// As one set of conditions leaves them.
  struct Directions {
    std::vector<std::uint8_t> active;  // [n_conditions]
    std::vector<FreeDirections> held;  // ascending

    bool update(const KinematicConstraints& kinematic_constraints, double time);
    const Eigen::Matrix3d* find(std::uint32_t node) const;
  };

  Directions nodes_, turns_, bodies_, body_turns_;
};

}  // namespace contactsim
