// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/condition_load_commands.hpp"

#include "parser/commands/block_rows.hpp"
#include "parser/commands/condition_line_commands.hpp"
#include "parser/commands/entity_set_commands.hpp"

namespace contactsim {

namespace {

template <bool is_moment>
const Table<NodalLoad>& nodal_load_table() {
  using L = NodalLoad;
  static const Table<L> table(joined<L>({
      lift_all(entity_set_rows(must_pick_parts), &L::set),
      lift_all(direction_rows(), &L::direction),
      scaled_function_rows("", &L::function,
                           is_moment ? "of time [time]: the moment on each node [force*length]"
                                     : "of time [time]: the force on each node [force]",
                           one_value),
      lift_all(mesh_variable_rows(), &L::variable),
      lift_all(period_rows(), &L::periods),
      user_subroutine_rows<L>(),
  }));
  return table;
}

template <bool is_moment>
Row<Region> nodal_load_block(std::string phrase, std::string help) {
  return block<Region, NodalLoad>(
      std::move(phrase), Naming::optional, nodal_load_table<is_moment>,
      [](Region& region, NodalLoad load) {
        load.is_moment = is_moment;
        region.nodal_loads.push_back(std::move(load));
      },
      std::move(help));
}

const Table<Pressure>& pressure_table() {
  using P = Pressure;
  static const auto masking = choice_of<P::Masking>({"off", "on", "contact"});
  static const Table<P> table(joined<P>({
      lift_all(entity_set_rows(must_pick_parts), &P::set),
      scaled_function_rows("", &P::function, "of time [time]: the pressure into the face [force/length^2]",
                           one_value),
      lift_all(mesh_variable_rows(), &P::variable),
      {
          row("velocity damping coefficient", read::real, &P::velocity_damping_coefficient,
              "Pressure per velocity out of the face [force*time/length^3]"),
          row("masking method", masking, &P::masking, "Which faces are left out"),
          row("external force contribution output name", read::text, &P::force_output_name,
              "Nodal variable that takes the forces of this block"),
      },
      lift_all(period_rows(), &P::periods),
      user_subroutine_rows<P>(),
  }));
  return table;
}

const Table<Traction>& traction_table() {
  using T = Traction;
  static const Table<T> table(joined<T>({
      lift_all(entity_set_rows(must_pick_parts), &T::set),
      lift_all(direction_rows(), &T::direction),
      first_required(scaled_function_rows("", &T::function, "of time [time]: the traction [force/length^2]")),
      lift_all(period_rows(), &T::periods),
      user_subroutine_rows<T>(),
  }));
  return table;
}

const Table<Gravity>& gravity_table() {
  using G = Gravity;
  static const Table<G> table(joined<G>({
      lift_all(entity_set_rows(), &G::set),
      lift_all(direction_rows(), &G::direction),
      lift_all<G, ScaledFunction>(
          {
              row("function", read::name_of(NameKind::function), &ScaledFunction::function,
                  "Function of time [time]: a factor of gravity [1]", "SIERRA_CONSTANT_FUNCTION_ONE"),
              row("scale factor", read::real, &ScaledFunction::scale_factor, "Multiplies the function [1]"),
          },
          &G::function),
      {row("gravitational constant", read::real, &G::gravitational_constant, "Acceleration [length/time^2]")},
      lift_all(period_rows(), &G::periods),
      user_subroutine_rows<G>(),
  }));
  return table;
}

const Table<ViscousDamping>& viscous_damping_table() {
  using V = ViscousDamping;
  static const Table<V> table(joined<V>({
      lift_all(entity_set_rows(must_pick_parts), &V::set),
      {
          row("mass damping coefficient", read::non_negative, &V::mass_damping_coefficient,
              "Speed that is lost in a unit of time, over the speed [1/time]")
              .required(),
          refused<V>(
              "stiffness damping coefficient", "= <real>",
              "LINEAR BULK VISCOSITY of a block damps waves of pressure; give MASS DAMPING COEFFICIENT"),
      },
      lift_all(period_rows(), &V::periods),
  }));
  return table;
}

}  // namespace

std::vector<Row<Region>> load_rows() {
  using R = Region;
  return {
      nodal_load_block<false>("prescribed force", "Forces on nodes"),
      nodal_load_block<true>("prescribed moment", "Moments on nodes"),
      block<R, Pressure>("pressure", Naming::optional, pressure_table, &R::pressures,
                         "Pressure on faces, positive into them"),
      block<R, Traction>("traction", Naming::optional, traction_table, &R::tractions,
                         "Force per area on faces along a direction"),
      block<R, ViscousDamping>(
          "viscous damping", Naming::optional, viscous_damping_table, &R::viscous_dampings,
          "Slows nodes in proportion to their mass; what is lost counts as external work"),
      block<R, Gravity>("gravity", Naming::optional, gravity_table, &R::gravities,
                        "Acceleration of a body; several blocks add"),
  };
}

}  // namespace contactsim
