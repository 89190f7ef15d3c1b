// SPDX-License-Identifier: BSD-3-Clause
#include <utility>

#include "core/conditions/entity_nodes.hpp"
#include "core/conditions/kinematic_conflicts.hpp"
#include "core/conditions/kinematics.hpp"
#include "core/conditions/oblique_holds.hpp"

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
  bool check(const PrescribedCondition& prescribed, const ConditionLabel& label);

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

bool KinematicsMaker::check(const PrescribedCondition& prescribed, const ConditionLabel& label) {
  const bool turns = prescribed.quantity == PrescribedQuantity::rotation ||
                     prescribed.quantity == PrescribedQuantity::rotational_velocity;
  if (turns) {
    scope_.diagnostics.add_error(
        label.location, label.what + " cannot act: the nodes of solids have no rotations",
        "PRESCRIBED DISPLACEMENT or VELOCITY with CYLINDRICAL AXIS turns nodes about an axis");
    return false;
  }
  if (!prescribed.variable.variable) return true;
  const DeckName& variable = *prescribed.variable.variable;
  scope_.diagnostics.add_error(variable.location, label.what + " cannot read its values from the mesh yet",
                               "give it a FUNCTION", static_cast<int>(variable.text.size()));
  return false;
}

void KinematicsMaker::add(const PrescribedCondition& prescribed) {
  DrivenNodes driven;
  driven.label = {words_of(prescribed.quantity), prescribed.name.location};
  if (!check(prescribed, driven.label)) return;
  driven.drive = drive_of(prescribed.quantity);
  auto value = make_condition_function(prescribed.function, driven.label, scope_);
  driven.times = make_active_times(prescribed.periods, scope_.blocks);
  const bool has_nodes = find_names(prescribed.set, prescribed.direction, driven);
  if (!value || !has_nodes) return;
  driven.value = std::move(*value);
  driven_.push_back(std::move(driven));
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
