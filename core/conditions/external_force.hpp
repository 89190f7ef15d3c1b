// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "core/base/node_ranges.hpp"
#include "core/conditions/active_times.hpp"
#include "core/conditions/condition_function.hpp"
#include "core/conditions/condition_scope.hpp"
#include "core/elements/force_term.hpp"
#include "core/elements/node_sums.hpp"

namespace contactsim {

/// GRAVITY, PRESCRIBED FORCE and PRESCRIBED MOMENT: a vector on every node, times its mass or not.
struct NodeLoad {
  std::vector<NodeIndex> nodes;                         ///< ascending, each once
  std::vector<double> masses;                           ///< [n] of the nodes, empty: 1 of each [mass]
  Eigen::Vector3d direction = Eigen::Vector3d::Zero();  ///< unit, or the sum of some units [1]
  ConditionFunction value{0.0};  ///< [force], [force length], or of masses [length/time^2]
  ActiveTimes times;
};

/// PRESSURE and TRACTION: a load per area of the deformed faces.
struct FaceLoad {
  std::vector<std::array<NodeIndex, 4>> faces;  ///< facets by corners, outward; a triangle repeats its last
  std::vector<ElementSide> sides;               ///< [n_faces] the sides that they are of
  NodeSums sums;                                ///< of the corners of the faces
  std::optional<Eigen::Vector3d> direction;     ///< of a traction; absent: a pressure, against the normal
  ConditionFunction value{0.0};                 ///< [force/length^2]
  double damping = 0.0;  ///< pressure per velocity out of the face [force*time/length^3]
  ActiveTimes times;
};

/// VISCOUS DAMPING: nodes that lose speed v' = -c v by themselves, whatever the size of the steps: the force
/// is -m (1 - exp(-c dt)) / dt v, with the velocity half a step before.
struct NodeDamping {
  std::vector<NodeIndex> nodes;  ///< ascending, each once
  double coefficient = 0.0;      ///< c, >= 0 [1/time]
  ActiveTimes times;
};

/// The loads of a region. A load acts at the times of its active periods.
class ExternalForce final : public ForceTerm {
 public:
  ///   mesh     must outlive this
  ///   mass     [n_nodes] of the nodes that damping slows [mass]
  ///   inertia  [n_nodes] of those that turn, or none [mass length^2]
  explicit ExternalForce(const Mesh& mesh, Eigen::RowVectorXd mass = {}, Eigen::RowVectorXd inertia = {})
      : mesh_(&mesh), mass_(std::move(mass)), inertia_(std::move(inertia)), followed_(mesh.n_nodes()) {}
  void add(NodeLoad load) { node_loads_.push_back(std::move(load)); }
  void add_moment(NodeLoad moment) { node_moments_.push_back(std::move(moment)); }
  void add(FaceLoad load);
  void add(NodeDamping damping) { dampings_.push_back(std::move(damping)); }
  /// Whether there are no loads at all.
  bool is_empty() const {
    return node_loads_.empty() && node_moments_.empty() && face_loads_.empty() && dampings_.empty();
  }
  /// Adds the nodes to a list whose loads depend on where they are: of faces, and of functions in space.
  void add_nodes_where_place_counts(std::vector<NodeIndex>& nodes) const;
  /// From now on loads that are alike everywhere need act on these nodes only.
  void follow(const NodeRanges& nodes) { followed_ = nodes; }
  /// Takes the faces of dead elements out of all loads.
  ///   alive  [n_elements] 0 of dead elements
  void take_off(std::span<const std::uint8_t> alive);

  /// Sums loads in the order in which they were added: the same bits for any number of threads. Allocates
  /// nothing. Throws SolveError when a load has no finite value.
  /// The report sets no limit to the step. Without loads, forces of no columns stay so. VELOCITY DAMPING
  /// COEFFICIENT acts on velocities half a step old: density times wave speed, which lets waves out, is about
  /// the most that stays stable.
  ForceReport set_forces(const Motion& motion, Eigen::Matrix3Xd& forces) override;
  /// As set_forces, of the prescribed moments.
  void set_moments(const Motion& motion, Eigen::Matrix3Xd& moments) override;

 private:
  [[noreturn]] void fail_at(const ConditionFunction& value, double time, NodeIndex node) const;
  void add_load(const NodeLoad& load, const Motion& motion, Eigen::Matrix3Xd& forces) const;
  void add_load(const FaceLoad& load, const Motion& motion, Eigen::Matrix3Xd& forces);

  void add_damping(const Motion& motion, const Eigen::Matrix3Xd& velocity, const Eigen::RowVectorXd& mass,
                   Eigen::Matrix3Xd& forces) const;

  const Mesh* mesh_;
  Eigen::RowVectorXd mass_, inertia_;  ///< that dampings act on
  std::vector<NodeLoad> node_loads_, node_moments_;
  std::vector<FaceLoad> face_loads_;
  std::vector<NodeDamping> dampings_;
  NodeRanges followed_;
  std::vector<NodeVector> corner_forces_;  ///< [4 x n_faces] of the load that is being added [force]
};

/// Compiles the loads of a region. Errors: unknown names, moments on nodes without rotations, masked
/// pressures, pressures of faces that are read from the mesh. Throws FileError.
///   mass     [n_nodes] lumped [mass]
///   inertia  as Model::inertia
ExternalForce make_external_force(const ConditionScope& scope, const Eigen::RowVectorXd& mass,
                                  const Eigen::RowVectorXd& inertia = {});

}  // namespace contactsim
