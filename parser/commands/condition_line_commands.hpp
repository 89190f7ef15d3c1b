// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "core/definition/condition_lines.hpp"
#include "parser/commands/row_lists.hpp"

namespace contactsim {

/// A condition whose value is that of one of several lines.
inline const Choice one_value{"has no value", "has more than one value"};

/// COMPONENT and DIRECTION, of which one must be given.
std::vector<Row<DirectionChoice>> direction_rows();

/// The same and CYLINDRICAL AXIS.
std::vector<Row<DirectionChoice>> direction_or_axis_rows();

/// ACTIVE PERIODS or INACTIVE PERIODS.
std::vector<Row<ActivePeriods>> period_rows();

/// READ VARIABLE and the lines that go with it; the value is that of one_value.
std::vector<Row<MeshVariable>> mesh_variable_rows();

/// FUNCTION and SCALE FACTOR, or <prefix> FUNCTION and <prefix> SCALE FACTOR.
///   prefix   "", or keyword words such as "normal displacement"
///   meaning  what the function maps to what, with dimensions: "of time [time]: the pressure
///   [force/length^2]"
///   choice   that the function is part of
std::vector<Row<ScaledFunction>> scaled_function_rows(const std::string& prefix, const std::string& meaning,
                                                      const Choice& choice = {});

/// The same, of a member of T.
template <class T>
std::vector<Row<T>> scaled_function_rows(const std::string& prefix, ScaledFunction T::*part,
                                         const std::string& meaning, const Choice& choice = {}) {
  return lift_all(scaled_function_rows(prefix, meaning, choice), part);
}

/// The lines that hand a condition to a user subroutine, all refused.
template <class T>
std::vector<Row<T>> user_subroutine_rows() {
  const std::string why = "User subroutines cannot be run; an analytic FUNCTION may say the same";
  return {
      refused<T>("node set subroutine", "= <name>", why).or_spelled("nodeset subroutine"),
      refused<T>("surface subroutine", "= <name>", why),
      refused<T>("element block subroutine", "= <name>", why),
      ignored<T>("subroutine debugging", "{ON|OFF}", why),
      refused<T>("subroutine real parameter", ": <name> = <value>", why),
      refused<T>("subroutine integer parameter", ": <name> = <value>", why),
      refused<T>("subroutine string parameter", ": <name> = <value>", why),
  };
}

}  // namespace contactsim
