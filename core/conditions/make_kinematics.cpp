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
  void add_driven(DrivenNodes driven, const EntitySet& set, const DirectionChoice& choice,
                  const ActivePeriods& periods);
  bool check(const PrescribedCondition& prescribed, const ConditionLabel& label);

  const ConditionScope& scope_;
  std::vector<DrivenNodes> driven_;
};

void KinematicsMaker::add_driven(DrivenNodes driven, const EntitySet& set, const DirectionChoice& choice,
                                 const ActivePeriods& periods) {
  driven.nodes = find_nodes(set, driven.label, scope_);
  driven.times = make_active_times(periods, scope_.blocks);
  const auto direction = find_direction(choice, scope_);
  if (!direction || driven.nodes.empty()) return;
  driven.direction = *direction;
  driven_.push_back(std::move(driven));
}

void KinematicsMaker::add(const FixedCondition& fixed) {
  if (fixed.is_rotation) {
    scope_.diagnostics.add_warning("condition-ignored", fixed.name.location,
                                   "the fixed rotation has no effect: the nodes of solids have no rotations");
    return;
  }
  DrivenNodes driven;
  driven.label = {"the fixed displacement", fixed.name.location};
  add_driven(std::move(driven), fixed.set, fixed.direction, fixed.periods);
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
  if (!value) return;
  driven.value = std::move(*value);
  add_driven(std::move(driven), prescribed.set, prescribed.direction, prescribed.periods);
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
