// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/condition_commands.hpp"

#include "parser/commands/block_rows.hpp"
#include "parser/commands/condition_line_commands.hpp"
#include "parser/commands/entity_set_commands.hpp"

namespace contactsim {

namespace {

const Table<FixedCondition>& fixed_table() {
  using F = FixedCondition;
  static const Table<F> table(joined<F>({
      lift_all(entity_set_rows(must_pick_parts), &F::set),
      lift_all(direction_rows(), &F::direction),
      lift_all(period_rows(), &F::periods),
      user_subroutine_rows<F>(),
  }));
  return table;
}

/// What a quantity is called, and its dimension.
struct QuantityWords {
  const char* phrase;
  const char* value;
};

constexpr QuantityWords words_of(PrescribedQuantity quantity) {
  switch (quantity) {
    case PrescribedQuantity::displacement:
      return {"prescribed displacement", "of time [time]: the displacement [length]"};
    case PrescribedQuantity::velocity:
      return {"prescribed velocity", "of time [time]: the velocity [length/time]"};
    case PrescribedQuantity::acceleration:
      return {"prescribed acceleration", "of time [time]: the acceleration [length/time^2]"};
    case PrescribedQuantity::rotation:
      return {"prescribed rotation", "of time [time]: the angle in radians [1]"};
    case PrescribedQuantity::rotational_velocity:
      return {"prescribed rotational velocity", "of time [time]: the angular velocity [1/time]"};
  }
  return {"", ""};
}

template <PrescribedQuantity quantity>
const Table<PrescribedCondition>& prescribed_table() {
  using P = PrescribedCondition;
  static const Table<P> table(joined<P>({
      lift_all(entity_set_rows(must_pick_parts), &P::set),
      lift_all(direction_or_axis_rows(), &P::direction),
      scaled_function_rows("", &P::function, words_of(quantity).value, one_value),
      lift_all(mesh_variable_rows(), &P::variable),
      lift_all(period_rows(), &P::periods),
      user_subroutine_rows<P>(),
  }));
  return table;
}

template <PrescribedQuantity quantity>
Row<Region> prescribed_block(std::string help) {
  return block<Region, PrescribedCondition>(
      words_of(quantity).phrase, Naming::optional, prescribed_table<quantity>,
      [](Region& region, PrescribedCondition condition) {
        condition.quantity = quantity;
        region.prescribed_conditions.push_back(std::move(condition));
      },
      std::move(help));
}

Row<Region> fixed_block(std::string_view phrase, bool is_rotation, std::string_view help) {
  return block<Region, FixedCondition>(
      phrase, Naming::optional, fixed_table,
      [is_rotation](Region& region, FixedCondition condition) {
        condition.is_rotation = is_rotation;
        region.fixed_conditions.push_back(std::move(condition));
      },
      help);
}

}  // namespace

std::vector<Row<Region>> kinematic_condition_rows() {
  using Q = PrescribedQuantity;
  return {
      fixed_block("fixed displacement", false, "Holds nodes where they are when it begins to act"),
      fixed_block("fixed rotation", true, "Holds the rotations of nodes"),
      prescribed_block<Q::displacement>("Moves nodes by a function of time, from their mesh position"),
      prescribed_block<Q::velocity>("Moves nodes at a velocity"),
      prescribed_block<Q::acceleration>("Moves nodes at an acceleration"),
      prescribed_block<Q::rotation>("Turns nodes or rigid bodies by an angle"),
      prescribed_block<Q::rotational_velocity>("Turns nodes or rigid bodies at an angular velocity"),
  };
}

std::vector<Row<Region>> other_condition_rows() {
  using R = Region;
  const std::string temperature = "Temperatures act through thermal strains only, which are not supported";
  return {
      ignored_block<R>("initial temperature", temperature),
      ignored_block<R>("prescribed temperature", temperature),
      refused_block<R>("centripetal force", "An angular velocity about an axis may say the same"),
      refused_block<R>("fluid pressure", "PRESSURE with a function may say the same"),
      refused_block<R>("pore pressure", "Pores are not modelled"),
      refused_block<R>("cavity expansion", "PRESSURE with a function may say the same"),
      refused_block<R>("blast pressure", "PRESSURE with a function may say the same"),
      refused_block<R>("silent boundary", "Boundaries reflect waves"),
      refused_block<R>("periodic", "Periodic conditions are not modelled"),
  };
}

}  // namespace contactsim
