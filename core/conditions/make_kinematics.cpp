// SPDX-License-Identifier: BSD-3-Clause
#include <utility>
#include <vector>

#include "core/conditions/entity_nodes.hpp"
#include "core/conditions/kinematic_conflicts.hpp"
#include "core/conditions/kinematics.hpp"
#include "core/conditions/oblique_holds.hpp"
#include "core/conditions/stored_values.hpp"
#include "core/least_mass.hpp"

namespace contactsim {

namespace {

const char* words_of(PrescribedQuantity quantity) {
  static constexpr const char* words[] = {"the prescribed displacement", "the prescribed velocity",
                                          "the prescribed acceleration", "the prescribed rotation",
                                          "the prescribed rotational velocity"};
  return words[static_cast<std::size_t>(quantity)];
}

Drive drive_of(PrescribedQuantity quantity) {
  switch (quantity) {
    case PrescribedQuantity::displacement:
    case PrescribedQuantity::rotation:
      return Drive::displacement;
    case PrescribedQuantity::velocity:
    case PrescribedQuantity::rotational_velocity:
      return Drive::velocity;
    case PrescribedQuantity::acceleration:
      break;
  }
  return Drive::acceleration;
}

bool is_of_rotations(const PrescribedCondition& prescribed) {
  return prescribed.quantity == PrescribedQuantity::rotation ||
         prescribed.quantity == PrescribedQuantity::rotational_velocity;
}

/// Compiles conditions, each on its own.
class KinematicsMaker {
 public:
  ///   inertia  of the nodes that turn, when conditions on rotations are compiled; null: on positions
  KinematicsMaker(const ConditionScope& scope, const Eigen::Matrix3Xd* inertia)
      : scope_(scope), inertia_(inertia) {}

  void add(const FixedCondition& fixed);
  void add(const PrescribedCondition& prescribed);
  std::vector<DrivenNodes> take() { return std::move(driven_); }

 private:
  bool find_names(const EntitySet& set, const DirectionChoice& choice, DrivenNodes& driven) const;
  bool keep_turning(std::vector<NodeIndex>& nodes) const;

  const ConditionScope& scope_;
  const Eigen::Matrix3Xd* inertia_;
  std::vector<DrivenNodes> driven_;
};

/// Returns whether there is something to drive.
bool KinematicsMaker::find_names(const EntitySet& set, const DirectionChoice& choice,
                                 DrivenNodes& driven) const {
  driven.nodes = find_nodes(set, driven.label, scope_);
  const auto direction = find_direction(choice, scope_);
  if (direction) driven.direction = *direction;
  if (const auto* axis = std::get_if<Axis>(&driven.direction); axis != nullptr && inertia_ != nullptr)
    driven.direction = Eigen::Vector3d(axis->direction);
  return direction && !driven.nodes.empty();
}

/// Returns whether some are left, or there were none before.
bool KinematicsMaker::keep_turning(std::vector<NodeIndex>& nodes) const {
  if (inertia_ == nullptr || nodes.empty()) return true;
  std::erase_if(nodes, [&](NodeIndex node) {
    return inertia_->cols() == 0 || (*inertia_)(0, node.value) <= least_mass;
  });
  return !nodes.empty();
}

void KinematicsMaker::add(const FixedCondition& fixed) {
  DrivenNodes driven;
  driven.label = {fixed.is_rotation ? "the fixed rotation" : "the fixed displacement", fixed.name.location};
  driven.times = make_active_times(fixed.periods, scope_.blocks);
  const bool has_nodes = find_names(fixed.set, fixed.direction, driven);
  if (!keep_turning(driven.nodes)) {
    scope_.diagnostics.add_warning("condition-ignored", fixed.name.location,
                                   "the fixed rotation has no effect: the nodes of solids have no rotations");
    return;
  }
  if (has_nodes) driven_.push_back(std::move(driven));
}

void KinematicsMaker::add(const PrescribedCondition& prescribed) {
  DrivenNodes driven;
  driven.label = {words_of(prescribed.quantity), prescribed.name.location};
  driven.drive = drive_of(prescribed.quantity);
  driven.times = make_active_times(prescribed.periods, scope_.blocks);
  const bool has_nodes = find_names(prescribed.set, prescribed.direction, driven);
  if (!keep_turning(driven.nodes)) {
    return scope_.diagnostics.add_error(
        driven.label.location, driven.label.what + " cannot act: the nodes of solids have no rotations",
        "PRESCRIBED DISPLACEMENT or VELOCITY with CYLINDRICAL AXIS turns nodes about an axis");
  }
  const ValueTarget target{prescribed.direction.components, driven.nodes, driven.label};
  const auto values = find_condition_values(prescribed.function, prescribed.variable, target, scope_);
  if (!values || !has_nodes) return;
  if (values->size() == 1) {
    driven.value = values->front();
    driven_.push_back(std::move(driven));
    return;
  }
  std::size_t next = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    if (!prescribed.direction.components[c]) continue;
    DrivenNodes& part = driven_.emplace_back(driven);
    part.direction = Components{{c == 0, c == 1, c == 2}};
    part.value = (*values)[next++];
  }
}

Kinematics compile(const ConditionScope& scope, const Eigen::Matrix3Xd* inertia) {
  KinematicsMaker maker(scope, inertia);
  const bool wants_rotations = inertia != nullptr;
  for (const FixedCondition& fixed : scope.region.fixed_conditions) {
    if (fixed.is_rotation == wants_rotations) maker.add(fixed);
  }
  for (const PrescribedCondition& prescribed : scope.region.prescribed_conditions) {
    if (is_of_rotations(prescribed) == wants_rotations) maker.add(prescribed);
  }
  std::vector<DrivenNodes> driven = maker.take();
  check_conflicts(driven, scope.mesh, scope.diagnostics);
  return Kinematics(scope.mesh, separate_oblique_holds(std::move(driven)));
}

}  // namespace

Kinematics make_kinematics(const ConditionScope& scope) { return compile(scope, nullptr); }

Kinematics make_rotation_kinematics(const ConditionScope& scope, const Eigen::Matrix3Xd& inertia) {
  return compile(scope, &inertia);
}

}  // namespace contactsim
