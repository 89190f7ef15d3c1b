// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/run/checkpoint.hpp"
#include "app/run/energy_warnings.hpp"
#include "app/run/load_step_warnings.hpp"
#include "app/run/run_contact.hpp"
#include "app/run/run_death.hpp"
#include "app/run/run_restart.hpp"
#include "app/run/run_setup.hpp"
#include "app/run/simulation.hpp"
#include "app/run/timed_force.hpp"
#include "core/conditions/condition_scope.hpp"
#include "core/dynamics/internal_force.hpp"
#include "core/dynamics/rank_share.hpp"
#include "core/dynamics/subcycler.hpp"
#include "core/output/output_plan.hpp"
#include "core/statics/load_steps.hpp"
#include "core/statics/shared_elements.hpp"

namespace contactsim {

/// What a simulation is made of, in the order in which the later is made from the earlier.
struct Simulation::Parts {
  Parts(const RunInput& run_input, RunSettings run_settings, Diagnostics& run_diagnostics);

  ForceTerms terms() {
    return {timed_internal, timed_external, timed_contact ? &*timed_contact : nullptr,
            subcycler ? &*subcycler : nullptr, setup.load_schedule ? share.get() : nullptr};
  }
  Checkpoint checkpoint();
  /// Gives files their names, and has steps end where they want them to. Throws FileError when one would
  /// replace what must be kept.
  void prepare_files();
  /// Throws FileError when a file of the run would replace what must be kept, or cannot be written.
  void check_files() const;
  /// The state that the procedure before has come to becomes that of the start, as far as it is taken over.
  void take_over();
  void warn_of_new_contact();
  /// Whether contact taken over still finds its forces: PreloadForces.
  bool is_settling() const;
  void warn_of_preload();
  void refuse_held_anew();
  /// Finds the forces of the start, and what they warn of.
  void start_anew();
  /// Moves the state by a step, explicit or to the next equilibrium. Returns false when the search for that
  /// was given up, as stop_when() wants it. Throws SolveError.
  bool advance();
  /// Has elements die that should at the end of a step, and load steps follow.
  void let_die();
  /// Has the state hold what other ranks know of it, for who reads more than a step leaves on each.
  void complete_state();
  /// Has it hold where all nodes are.
  void complete_coordinates();
  /// Why the run ends with its state, if it does.
  std::optional<EarlyEnd> find_end();
  std::vector<PartTime> times() const;

  RunInput input;
  std::vector<StartOverlap> overlaps;  // of contact with what was taken over
  bool takes_over_contact = false;     // from load steps
  const RunSettings settings;
  Diagnostics& diagnostics;
  Setup setup;
  const ConditionScope scope;
  const std::unique_ptr<RunContact> contact;  // null without contact
  OutputPlan outputs;
  const std::unique_ptr<RunDeath> death;  // null when nothing can die
  RunRestart restart;
  const std::vector<RunMark> marks;  // of runs that store states
  State state;
  const std::unique_ptr<RankShare> share;  // on several ranks, else null
  std::int64_t complete_step = -1;         // of explicit procedures, whose state is complete
  InternalForce internal;
  const std::unique_ptr<SharedElements> shared_internal;  // of load steps on several ranks, else null
  std::optional<Subcycler> subcycler;
  TimedForce timed_internal, timed_external;
  std::optional<TimedForce> timed_contact;
  std::optional<LoadSteps> load_steps;  // of implicit procedures
  EnergyWarnings energy_warnings;
  LoadStepWarnings load_step_warnings;
  std::vector<Observer> observers;
  StepReport at_start;
  std::optional<EarlyEnd> end;                            // why the run ends before its termination time
  std::optional<std::string> stopped_by;                  // a signal, say
  std::function<std::optional<std::string>()> find_stop;  // null: nobody asks for one within a step
  std::optional<std::string> failure;
  double begun = 0.0;  // of the clock [s]
  double whole_seconds = 0.0, output_seconds = 0.0, restart_seconds = 0.0;
};

}  // namespace contactsim
