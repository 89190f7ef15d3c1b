// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/condition_initial_commands.hpp"

#include "parser/commands/block_rows.hpp"
#include "parser/commands/condition_line_commands.hpp"
#include "parser/commands/entity_set_commands.hpp"

namespace contactsim {

namespace {

void check(const InitialVelocity& velocity, DeckNames& names) {
  const bool has_axis = velocity.direction.cylindrical_axis.has_value();
  const bool has_other_value = velocity.magnitude || velocity.function.function;
  const bool turns = velocity.angular_velocity.has_value();
  if ((has_axis && has_other_value && !turns) || (turns && !has_axis && !has_other_value))
    names.add_problem_of_block("needs both or none of CYLINDRICAL AXIS and ANGULAR VELOCITY");
}

void check(const InitialCondition& condition, DeckNames& names) {
  if (condition.type == VariableType::global || condition.set.names_something()) return;
  names.add_problem_of_block(must_pick_parts.lack,
                             "give it a NODE SET, SURFACE, BLOCK, ASSEMBLY or RIGID BODY line");
}

const Table<InitialVelocity>& initial_velocity_table() {
  using V = InitialVelocity;
  static const Table<V> table(
      joined<V>({
          lift_all(entity_set_rows(must_pick_parts), &V::set),
          lift_all(direction_or_axis_rows(), &V::direction),
          {
              row("magnitude", read::real, &V::magnitude,
                  "Velocity along the components or the direction [length/time]")
                  .one_of(one_value),
              row("angular velocity", read::real, &V::angular_velocity,
                  "Angular velocity about the cylindrical axis [1/time]")
                  .one_of(one_value),
          },
          scaled_function_rows("", &V::function, "in place of MAGNITUDE: the velocity [length/time]",
                               one_value),
          user_subroutine_rows<V>(),
      }),
      check);
  return table;
}

const Table<InitialCondition>& initial_condition_table() {
  using C = InitialCondition;
  static const auto type = choice_of<VariableType>({"node", "edge", "face", "element", "global"});
  static const Table<C> table(
      joined<C>({
          lift_all(entity_set_rows(), &C::set),
          {
              row("initialize variable name", read::name, &C::variable, "Variable that gets the values")
                  .required(),
              row("variable type", type, &C::type, "Where the variable lives").required(),
              row("magnitude", read::reals, &C::magnitude,
                  "One value per component, in the variable's dimension")
                  .one_of(one_value),
          },
          lift_all(mesh_variable_rows(), &C::mesh_variable),
          {
              row("scale factor", read::real, &C::scale_factor, "Multiplies what is read [1]"),
              refused<C>("distance type", "= <words>", "Values that vary in space: read them from the mesh"),
          },
          user_subroutine_rows<C>(),
      }),
      check);
  return table;
}

}  // namespace

std::vector<Row<Region>> initial_condition_rows() {
  using R = Region;
  return {
      block<R, InitialVelocity>("initial velocity", Naming::optional, initial_velocity_table,
                                &R::initial_velocities,
                                "Velocity at the start; of several blocks on a node the last one counts"),
      block<R, InitialCondition>("initial condition", Naming::optional, initial_condition_table,
                                 &R::initial_conditions, "A variable's values at the start"),
  };
}

}  // namespace contactsim
