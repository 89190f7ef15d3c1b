// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "core/base/names.hpp"

namespace contactsim {

/// What a line with DURING says of one time stepping block: it sets a field of a copy of the settings.
template <class Settings>
struct DuringPeriod {
  DeckName period;
  std::function<void(Settings&)> set;
};

/// The settings of a time stepping block: those of all with what is said of this one.
template <class Settings>
Settings settings_during(const Settings& settings, const DeckName& period) {
  Settings of_period = settings;
  for (const DuringPeriod<Settings>& during : settings.during) {
    if (during.period == period) during.set(of_period);
  }
  return of_period;
}

/// What residuals are compared with. Source: Sierra/SM 5.22, BEGIN CG, REFERENCE.
enum class ResidualReference : std::uint8_t {
  external,   ///< loads and reactions together
  internal,   ///< forces of the elements
  belytschko  ///< the largest of loads, forces of the elements and reactions
};

/// How equations of the whole stiffness are solved.
enum class LinearSolver : std::uint8_t {
  automatic,   ///< by multigrid for large solids, else by a factor
  multigrid,   ///< conjugate gradients with smoothed aggregation
  direct,      ///< a sparse factor
  distributed  ///< the same divided among ranks, whose last bits differ from run to run
};

/// BEGIN FULL TANGENT PRECONDITIONER: the inverse of the whole stiffness, made anew where it has become a bad
/// one.
struct FullTangentSettings {
  DeckName name;
  LinearSolver linear_solver = LinearSolver::automatic;
  double tangent_diagonal_scale = 0.0;  ///< of the diagonal that is added to it, >= 0 [1]
};

/// BEGIN CG. Source: Sierra/SM 5.20 and 5.22, BEGIN CG.
struct CgSettings {
  DeckName name;
  double target_relative_residual = 1e-4;              ///< > 0 [1]
  std::optional<double> target_residual;               ///< > 0 [force]
  std::optional<double> acceptable_relative_residual;  ///< absent: ten times the target [1]
  std::optional<double> acceptable_residual;           ///< > 0 [force]
  std::int64_t min_iterations = 0;
  std::int64_t max_iterations = 0;      ///< 0: 100 with a full tangent, else the nodes or 1000 if more
  double line_search_tolerance = 1e-2;  ///< of the slope along a direction, > 0 [1]
  ResidualReference reference = ResidualReference::external;
  std::optional<FullTangentSettings> full_tangent;
  std::vector<DuringPeriod<CgSettings>> during;  ///< in deck order

  double acceptable_relative() const {
    return acceptable_relative_residual.value_or(10.0 * target_relative_residual);
  }
};

/// BEGIN CONTROL CONTACT: how often multipliers of contact are updated in a load step. Source:
/// Sierra/SM 5.22, 4.4.2.
struct ControlContact {
  DeckName name;
  double target_relative_residual = 1e-3;              ///< > 0 [1]
  std::optional<double> acceptable_relative_residual;  ///< absent: ten times the target [1]
  std::int64_t min_iterations = 0;
  std::int64_t max_iterations = 100;                 ///< 0: the penalty alone
  std::vector<DuringPeriod<ControlContact>> during;  ///< in deck order

  double acceptable_relative() const {
    return acceptable_relative_residual.value_or(10.0 * target_relative_residual);
  }
};

/// BEGIN CONTROL FAILURE: a step in which elements die is made anew without them, until no others die.
/// Source: Sierra/SM 5.26, 4.7.
struct ControlFailure {
  DeckName name;
  std::int64_t max_iterations = 100;                 ///< searches after deaths, in a step
  std::vector<DuringPeriod<ControlFailure>> during;  ///< in deck order
};

/// BEGIN LOADSTEP PREDICTOR: where the search of a step begins.
struct LoadstepPredictor {
  enum class Type : std::uint8_t { secant, scale_factor };
  DeckName name;
  Type type = Type::secant;
  double scale_factor = 1.0;                 ///< of the increment of the last step [1]
  std::optional<double> first_scale_factor;  ///< of the first step of a period [1]
};

/// BEGIN SOLVER.
struct SolverSettings {
  DeckName name;
  CgSettings cg;
  LoadstepPredictor predictor;
  ControlContact control_contact;
  std::optional<ControlFailure> control_failure;  ///< absent: the next step finds the equilibrium
};

/// BEGIN ADAPTIVE TIME STEPPING.
struct AdaptiveTimeStepping {
  DeckName name;
  double cutback_factor = 0.5;             ///< after a step without equilibrium, in (0, 1) [1]
  double growth_factor = 1.5;              ///< after an easy step, >= 1 [1]
  std::int64_t max_failure_cutbacks = 10;  ///< in a row, >= 0
  std::int64_t target_iterations = 0;      ///< a step of fewer is easy; 0: every step is
  std::int64_t iteration_window = 0;       ///< around the target, where the step stays
  std::optional<double> max_multiplier;    ///< largest step over the given one, > 0; absent: no bound [1]
  double min_multiplier = 1e-6;            ///< smallest step over the given one, > 0 [1]
  std::vector<DuringPeriod<AdaptiveTimeStepping>> during;  ///< in deck order
};

}  // namespace contactsim
