// SPDX-License-Identifier: BSD-3-Clause
#include <utility>
#include <vector>

#include "core/conditions/entity_nodes.hpp"
#include "core/conditions/kinematic_conflicts.hpp"
#include "core/conditions/kinematics.hpp"
#include "core/conditions/oblique_holds.hpp"
#include "core/conditions/stored_values.hpp"

namespace contactsim {

namespace {

const char* words_of(PrescribedQuantity quantity) {
  static constexpr const char* words[] = {"the prescribed displacement", "the prescribed velocity",
                                          "the prescribed acceleration", "the prescribed rotation",
                                          "the prescribed rotational velocity"};
  return words[static_cast<std::size_t>(quantity)];
}

Drive drive_of(PrescribedQuantity quantity) {
  if (quantity == PrescribedQuantity::displacement) return Drive::displacement;
  return quantity == PrescribedQuantity::velocity ? Drive::velocity : Drive::acceleration;
}

/// Compiles conditions, each on its own.
class KinematicsMaker {
 public:
  explicit KinematicsMaker(const ConditionScope& scope) : scope_(scope) {}

  void add(const FixedCondition& fixed);
  void add(const PrescribedCondition& prescribed);
  std::vector<DrivenNodes> take() { return std::move(driven_); }

 private:
  bool find_names(const EntitySet& set, const DirectionChoice& choice, DrivenNodes& driven) const;
  bool check(const PrescribedCondition& prescribed, const ConditionLabel& label) const;

  const ConditionScope& scope_;
  std::vector<DrivenNodes> driven_;
};

/// Returns whether there is something to drive.
bool KinematicsMaker::find_names(const EntitySet& set, const DirectionChoice& choice,
                                 DrivenNodes& driven) const {
  driven.nodes = find_nodes(set, driven.label, scope_);
  const auto direction = find_direction(choice, scope_);
  if (direction) driven.direction = *direction;
  return direction && !driven.nodes.empty();
}

void KinematicsMaker::add(const FixedCondition& fixed) {
  if (fixed.is_rotation) {
    scope_.diagnostics.add_warning("condition-ignored", fixed.name.location,
                                   "the fixed rotation has no effect: the nodes of solids have no rotations");
    return;
  }
  DrivenNodes driven;
  driven.label = {"the fixed displacement", fixed.name.location};
  driven.times = make_active_times(fixed.periods, scope_.blocks);
  if (find_names(fixed.set, fixed.direction, driven)) driven_.push_back(std::move(driven));
}

/// Solids know no rotations.
bool KinematicsMaker::check(const PrescribedCondition& prescribed, const ConditionLabel& label) const {
  const bool turns = prescribed.quantity == PrescribedQuantity::rotation ||
                     prescribed.quantity == PrescribedQuantity::rotational_velocity;
  if (!turns) return true;
  scope_.diagnostics.add_error(
      label.location, label.what + " cannot act: the nodes of solids have no rotations",
      "PRESCRIBED DISPLACEMENT or VELOCITY with CYLINDRICAL AXIS turns nodes about an axis");
  return false;
}

void KinematicsMaker::add(const PrescribedCondition& prescribed) {
  DrivenNodes driven;
  driven.label = {words_of(prescribed.quantity), prescribed.name.location};
  if (!check(prescribed, driven.label)) return;
  driven.drive = drive_of(prescribed.quantity);
  driven.times = make_active_times(prescribed.periods, scope_.blocks);
  const bool has_nodes = find_names(prescribed.set, prescribed.direction, driven);
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

}  // namespace

Kinematics make_kinematics(const ConditionScope& scope) {
  KinematicsMaker maker(scope);
  for (const FixedCondition& fixed : scope.region.fixed_conditions) maker.add(fixed);
  for (const PrescribedCondition& prescribed : scope.region.prescribed_conditions) maker.add(prescribed);
  std::vector<DrivenNodes> driven = maker.take();
  check_conflicts(driven, scope.mesh, scope.diagnostics);
  return Kinematics(scope.mesh, separate_oblique_holds(std::move(driven)));
}

}  // namespace contactsim
