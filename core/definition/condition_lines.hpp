// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <limits>
#include <optional>
#include <vector>

#include "core/base/names.hpp"

namespace contactsim {

/// Which way a condition acts: one of components, a direction, an axis; or none of them. Along components or
/// a direction motion at right angles stays free. About an axis values are angles [1] where they would be
/// lengths; nodes move on arcs, their distance from the axis is kept, motion along the axis stays free.
struct DirectionChoice {
  std::array<bool, 3> components{};   ///< COMPONENTS = X Y Z: the global axes, each with the same value
  std::optional<DeckName> direction;  ///< DIRECTION: defined by DEFINE DIRECTION
  std::optional<DeckName> cylindrical_axis;  ///< CYLINDRICAL AXIS: about an axis of DEFINE AXIS

  bool has_components() const { return components[0] || components[1] || components[2]; }
};

/// A function of the deck times a factor: value(x) = scale_factor * function(x).
struct ScaledFunction {
  std::optional<DeckName> function;  ///< absent: not given; what that means is up to the command
  double scale_factor = 1.0;         ///< [1]
  bool operator==(const ScaledFunction&) const = default;
};

/// The time stepping blocks in which a command acts: active ones less inactive ones. Both lists empty:
/// always.
struct ActivePeriods {
  std::vector<DeckName> active;    ///< acts in these only
  std::vector<DeckName> inactive;  ///< acts in all but these
};

/// Values of a condition that are read from the mesh file. Source: Sierra/SM 5.22, READ VARIABLE.
struct MeshVariable {
  enum class Object { node, face };
  enum class Time {
    run_time,
    given,
    first,
    last
  };  ///< which stored time; run_time: interpolated as the run goes

  std::optional<DeckName> variable;  ///< absent: nothing is read
  Time time = Time::run_time;
  double given_time = std::numeric_limits<double>::quiet_NaN();  ///< of Time::given [time]
  std::optional<Object> object;                                  ///< absent: the default of the command
};

}  // namespace contactsim
