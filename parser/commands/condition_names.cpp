// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/condition_names.hpp"

#include <fmt/format.h>

namespace contactsim {

namespace {

/// Checks the lines of one condition block.
class ConditionChecks {
 public:
  /// what  the block as messages call it: "the pressure"
  ConditionChecks(const DeckName& name, std::string what, const NameUses& uses)
      : name_(name), what_(std::move(what)), uses_(uses) {}

  void set(const EntitySet& set) const {
    uses_.use(set);
    if (set.names_something()) return;
    fail("picks no part of the mesh", "give it a NODE SET, SURFACE, BLOCK, ASSEMBLY or RIGID BODY line");
  }

  void direction(const DirectionChoice& choice) const {
    uses_.use(choice);
    const int n =
        (choice.has_components() ? 1 : 0) + (choice.direction ? 1 : 0) + (choice.cylindrical_axis ? 1 : 0);
    if (n == 0) fail("has no direction", "give it a COMPONENT or a DIRECTION line");
    if (n > 1)
      fail("has more than one kind of direction", "keep one of COMPONENT, DIRECTION and CYLINDRICAL AXIS");
  }

  void value(const ScaledFunction& function, const MeshVariable& variable) const {
    uses_.use(function);
    if (!function.function && !variable.variable)
      fail("has no value", "give it a FUNCTION or a READ VARIABLE line");
    if (function.function && variable.variable) {
      fail("has two values", "keep one of FUNCTION and READ VARIABLE");
    }
  }

  void fail(const char* text, std::string hint) const {
    uses_.add_error(name_, fmt::format("{} {}", what_, text), std::move(hint));
  }

 private:
  const DeckName& name_;
  std::string what_;
  const NameUses& uses_;
};

const char* words_of(PrescribedQuantity quantity) {
  static constexpr const char* words[] = {"the prescribed displacement", "the prescribed velocity",
                                          "the prescribed acceleration", "the prescribed rotation",
                                          "the prescribed rotational velocity"};
  return words[static_cast<std::size_t>(quantity)];
}

void check(const FixedCondition& fixed, const NameUses& uses) {
  const ConditionChecks checks(fixed.name,
                               fixed.is_rotation ? "the fixed rotation" : "the fixed displacement", uses);
  checks.set(fixed.set);
  checks.direction(fixed.direction);
  uses.use(fixed.periods);
}

void check(const PrescribedCondition& prescribed, const NameUses& uses) {
  const ConditionChecks checks(prescribed.name, words_of(prescribed.quantity), uses);
  checks.set(prescribed.set);
  checks.direction(prescribed.direction);
  checks.value(prescribed.function, prescribed.variable);
  uses.use(prescribed.periods);
}

void check(const NodalLoad& load, const NameUses& uses) {
  const ConditionChecks checks(load.name, load.is_moment ? "the prescribed moment" : "the prescribed force",
                               uses);
  checks.set(load.set);
  checks.direction(load.direction);
  checks.value(load.function, load.variable);
  uses.use(load.periods);
}

void check(const Pressure& pressure, const NameUses& uses) {
  const ConditionChecks checks(pressure.name, "the pressure", uses);
  checks.set(pressure.set);
  checks.value(pressure.function, pressure.variable);
  uses.use(pressure.periods);
}

void check(const Traction& traction, const NameUses& uses) {
  const ConditionChecks checks(traction.name, "the traction", uses);
  checks.set(traction.set);
  checks.direction(traction.direction);
  uses.use(traction.function);
  if (!traction.function.function) checks.fail("has no value", "give it a FUNCTION line");
  uses.use(traction.periods);
}

/// Without mesh parts it acts on everything, without a function it is constant.
void check(const Gravity& gravity, const NameUses& uses) {
  const ConditionChecks checks(gravity.name, "the gravity", uses);
  uses.use(gravity.set);
  checks.direction(gravity.direction);
  uses.use(gravity.function);
  uses.use(gravity.periods);
}

void check(const InitialVelocity& velocity, const NameUses& uses) {
  const ConditionChecks checks(velocity.name, "the initial velocity", uses);
  checks.set(velocity.set);
  checks.direction(velocity.direction);
  uses.use(velocity.function);
  const bool has_function = velocity.function.function.has_value();
  const int n = (velocity.magnitude ? 1 : 0) + (velocity.angular_velocity ? 1 : 0) + (has_function ? 1 : 0);
  if (n == 0) checks.fail("has no value", "give it a MAGNITUDE, an ANGULAR VELOCITY or a FUNCTION line");
  if (n > 1) checks.fail("has more than one value", "keep one of MAGNITUDE, ANGULAR VELOCITY and FUNCTION");
  if (n == 1 && velocity.angular_velocity.has_value() != velocity.direction.cylindrical_axis.has_value()) {
    checks.fail("needs both or none of CYLINDRICAL AXIS and ANGULAR VELOCITY", "");
  }
}

void check(const InitialCondition& condition, const NameUses& uses) {
  const ConditionChecks checks(condition.name, "the initial condition", uses);
  const bool is_global = condition.type == VariableType::global;
  is_global ? uses.use(condition.set) : checks.set(condition.set);
  if (!condition.variable) checks.fail("has no variable", "give it an INITIALIZE VARIABLE NAME line");
  if (!condition.type) checks.fail("does not say where its variable lives", "give it a VARIABLE TYPE line");
  if (condition.magnitude.empty() == !condition.mesh_variable.variable.has_value()) {
    checks.fail("needs one of MAGNITUDE and READ VARIABLE", "");
  }
}

template <class Condition>
void check_all(const std::vector<Condition>& conditions, const NameUses& uses) {
  for (const Condition& condition : conditions) check(condition, uses);
}

}  // namespace

void resolve_condition_names(const Region& region, const NameUses& uses) {
  check_all(region.fixed_conditions, uses);
  check_all(region.prescribed_conditions, uses);
  check_all(region.nodal_loads, uses);
  check_all(region.pressures, uses);
  check_all(region.tractions, uses);
  check_all(region.gravities, uses);
  check_all(region.initial_velocities, uses);
  check_all(region.initial_conditions, uses);
}

}  // namespace contactsim
