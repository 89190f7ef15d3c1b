// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/run/run_estimate.hpp"
#include "app/run/run_input.hpp"
#include "core/base/diagnostics.hpp"
#include "core/base/errors.hpp"
#include "core/dynamics/integrator.hpp"
#include "core/dynamics/model.hpp"
#include "core/dynamics/rank_traffic.hpp"
#include "core/dynamics/state.hpp"
#include "core/dynamics/time_step.hpp"
#include "core/output/termination.hpp"

namespace contactsim {

class ContactForce;
class LoadSteps;
class RunDeath;
class RunRestart;
class Simulation;
struct Interpenetration;
struct UntiedPart;

/// What observers are notified of.
enum class RunEvent : std::uint8_t {
  restart_sought,  ///< restart() knows whether there is a state to go on from
  begun,           ///< the forces of the start are known
  resumed,         ///< the state of an earlier run is restored
  elements_died,   ///< deaths(): a report is due
  step,            ///< the state of the start, and that of every step: what is due of it is written
  failed,          ///< the motion cannot go on: failure()
  ended            ///< the last state is written
};

/// Looks at a run; it may read all of it and change nothing.
using Observer = std::function<void(RunEvent, const Simulation&)>;

/// A part of a run and how long it took.
struct PartTime {
  std::string name;
  double seconds = 0.0;  ///< of the clock
};

/// A region on its way from its start time to its termination time, by explicit dynamics with contact. It
/// writes the files that the region asks for, prints nothing and ends no process:
///
///     Simulation simulation(input, settings, diagnostics);
///     simulation.observe(observer);
///     simulation.begin();
///     while (!simulation.is_over()) simulation.step();
///     simulation.finish();
class Simulation {
 public:
  /// Prepares the run: elements, conditions, contact, outputs. All must outlive it.
  ///   diagnostics  gains what is found on the way, until the end of the run
  /// Throws DeckError when there are errors among it, also earlier ones; FileError; SolveError.
  Simulation(const RunInput& input, RunSettings settings, Diagnostics& diagnostics);
  ~Simulation();
  Simulation(const Simulation&) = delete;
  Simulation& operator=(const Simulation&) = delete;

  /// Notifies an observer of all that comes, after those that are there.
  void observe(Observer observer);

  /// What the run would come to, found by its start and by steps of at most a second; it says what a run's
  /// start would warn of and writes no file. Not to be begun afterwards. Throws FileError for a file that the
  /// run could not write, SolveError.
  RunEstimate estimate();

  /// Takes over what RunInput::earlier says and completes the state of the start, or restores that of an
  /// earlier run where the definition says so, and writes what is due. Throws FileError, SolveError.
  void begin();
  /// Whether the termination time has come, a SOLUTION TERMINATION holds, or stop() was called.
  bool is_over() const;
  /// Moves the run by a step and writes what is due. Throws SolveError when the motion cannot go on,
  /// FileError.
  void step();
  /// Writes the last state, also after a SolveError, and what the run came to. Throws FileError.
  void finish();

  /// Ends the run with the step that it has come to, with a stored state if it stores any.
  ///   reason  "SIGTERM"
  void stop(std::string reason);
  /// Has a load step that is sought be given up, and the run be ended so with the step before it, once there
  /// is a reason.
  ///   find_stop  asked within the step
  void stop_when(std::function<std::optional<std::string>()> find_stop);
  /// Stores a state to resume from now, if the region has RESTART DATA. Throws FileError.
  void store_restart();

  const Procedure& procedure() const;
  const Mesh& mesh() const;
  const Model& model() const;
  const State& state() const;
  const TimeStepControl& control() const;
  std::optional<RankTraffic> rank_traffic() const;  ///< on several ranks
  const ContactForce* contact_force() const;        ///< null without contact
  ContactForce* contact_force();
  const LoadSteps* load_steps() const;        ///< null in explicit procedures
  const ContactModel* contact_model() const;  ///< of the living elements; null without contact
  IndexedSpan<PairIndex, const UntiedPart> untied()
      const;                       ///< of each pair at the start; empty without contact
  const RunDeath* deaths() const;  ///< null when nothing can die
  const RunRestart& restart() const;
  /// To be called before begin(): it begins at its start though the deck asks to resume.
  void begin_at_start();
  std::vector<std::string> output_paths() const;

  const StepReport& start_report() const;             ///< of begin(), unless it resumed
  const std::optional<std::string>& failure() const;  ///< what the SolveError said
  const std::optional<EarlyEnd>& end() const;         ///< why the run ends before its termination time
  const std::optional<std::string>& stopped_by() const;
  /// What contact without springs gave out to come out of overlaps of the mesh [energy].
  double given_out_by_overlaps() const;
  /// Where bodies have come to lie in each other; empty without contact.
  IndexedSpan<PairIndex, const Interpenetration> interpenetrations() const;
  /// Of the clock; the whole is known at RunEvent::ended.
  std::vector<PartTime> part_times() const;
  double seconds() const;

 private:
  struct Parts;

  void notify(RunEvent event);
  template <class Work>
  void try_to(const Work& work);
  void begin_anew();
  void resume();
  void end_step();
  void write(bool is_last);
  void store(bool is_last, bool is_wanted);

  std::unique_ptr<Parts> parts_;
};

}  // namespace contactsim
