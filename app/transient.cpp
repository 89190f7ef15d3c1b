// SPDX-License-Identifier: BSD-3-Clause
#include "app/transient.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "app/block_energy_watch.hpp"
#include "app/energy_watch.hpp"
#include "app/progress.hpp"
#include "app/refusals.hpp"
#include "app/run_contact.hpp"
#include "app/run_death.hpp"
#include "app/run_outputs.hpp"
#include "app/run_report.hpp"
#include "app/run_restart.hpp"
#include "app/run_setup.hpp"
#include "app/stop_signal.hpp"
#include "app/timed_force.hpp"
#include "contact/interface_laws/refuse_laws.hpp"
#include "core/definition/simulation.hpp"
#include "core/dynamics/internal_force.hpp"
#include "io/outputs.hpp"

namespace contactsim {

namespace {

/// What a run has besides its region.
struct RunParts {
  ForceTerm& external;
  RunContact* contact;  ///< null without contact
  RunDeath* death;      ///< null when nothing can die
  Outputs& outputs;
  RunRestart& restart;
};

/// A region on its way from start to end.
class Run {
 public:
  Run(const RunInput& input, const Setup& setup, RunParts parts, Log& log, Diagnostics& warnings)
      : model_(setup.model),
        control_(setup.control),
        state_(make_state(input.mesh.coordinates(), model_.blocks, control_.start_time())),
        outputs_(parts.outputs),
        restart_(parts.restart),
        internal_(model_, state_),
        timed_internal_(internal_),
        timed_external_(parts.external),
        contact_(parts.contact),
        death_(parts.death),
        log_(log),
        warnings_(warnings) {
    set_initial_state(setup.initial, model_.blocks, state_);
    if (death_ != nullptr) death_->begin(state_);
    if (contact_ == nullptr) return;
    is_for_overlap_only_ = input.region.contact->overlap_removal.is_all_there_is;
    timed_contact_.emplace(contact_->force());
    state_.forces.contact = Eigen::Matrix3Xd::Zero(3, model_.mesh->n_nodes());
  }

  ExitCode run() {
    ExitCode code = ExitCode::done;
    try {
      if (restart_.earlier() != nullptr) {
        resume(*restart_.earlier());
      } else {
        begin();
      }
      while (!is_over()) step();
      finish();
    } catch (const SolveError& error) {
      progress_.wipe();
      log_.write_error(fmt::format("error: step {}, {}", state_.step, error.what()));
      write_output(true);
      code = ExitCode::solve;
    }
    if (stopped_by_) code = ExitCode::stopped;
    const double whole = clock_seconds() - begun_;
    if (death_ != nullptr) log_.write(death_->report(state_));
    if (contact_ != nullptr) {
      if (state_.energies.largest > energy_of_round_off(model_, state_.dt))
        contact_->warn_of_energy(state_.energies, warnings_);
      contact_->warn_of_lost(warnings_);
      contact_->warn_of_penetration(warnings_);
      log_.write(format_energy_balance(state_.energies, contact_->force().stored_at_start(),
                                       contact_->given_out_by_overlaps()));
      log_.write(contact_->report());
      contact_->write_debug_files();
    }
    log_.write(restart_.report());
    write_wall_times(whole);
    return code;
  }

 private:
  ForceTerms terms() {
    return {timed_internal_, timed_external_, timed_contact_ ? &*timed_contact_ : nullptr};
  }
  Checkpoint checkpoint() {
    const bool shifts = restart_.shifts();
    return {model_, state_,   contact_,
            death_, outputs_, shifts ? std::optional(control_.start_time()) : std::nullopt};
  }
  bool is_over() const { return end_ || stopped_by_ || control_.is_over(state_.time, state_.dt); }

  void begin() {
    const StepReport at_start = start(model_, terms(), control_, state_);
    const std::string report = contact_ != nullptr ? contact_->start_report(warnings_) : "";
    log_.write(format_model(model_, at_start) + report + format_paths(outputs_.paths()) + step_heading());
    warn_of_user_step(at_start);
    block_watch_.begin(state_);
    end_step();
    restart_.begin(state_);
  }

  void resume(const SavedState& earlier) {
    StateArchive saved(earlier);
    archive(checkpoint(), saved);
    restart_.forget_earlier();
    block_watch_.begin(state_);
    outputs_.resume(state_);
    restart_.begin(state_);
    log_.write(format_paths(outputs_.paths()) + step_heading());
  }

  void step() {
    advance(model_, terms(), control_, state_);
    warn_of_energy();
    if (contact_ != nullptr) contact_->stop_at_runaway(state_);
    end_step();
    store(false);
    progress_.show(state_.time);
  }

  /// Whoever looks at a state, once each.
  void end_step() {
    check_termination();
    if (death_ != nullptr) death_->step(state_);
    stopped_by_ = signals_.find_stop();
    write_output(false);
  }

  void finish() {
    warn_of_negative_energy();
    // A run that resumes from here must not know that this one ended: the state comes first.
    store(true);
    write_output(true);
    if (end_) log_.write(fmt::format("The run ends here: {}\n", *end_));
    if (stopped_by_) log_.write_error(fmt::format("stopped by {} after step {}", *stopped_by_, state_.step));
  }

  void store(bool is_last) {
    const double begun = clock_seconds();
    if (restart_.store(checkpoint(), is_last, stopped_by_.has_value() || signals_.take_restart_wish()))
      outputs_.write_at_restart(state_);
    restart_seconds_ += clock_seconds() - begun;
  }

  void check_termination() {
    const double begun = clock_seconds();
    end_ = outputs_.check_termination(state_);
    if (is_for_overlap_only_) end_ = "OVERLAP REMOVAL ONLY";
    output_seconds_ += clock_seconds() - begun;
  }

  /// Files and a line of the log, when they are due.
  void write_output(bool is_last) {
    const double begun = clock_seconds();
    outputs_.write(state_, is_last);
    const auto& parameters = control_.periods()[control_.period_at(state_.time)].parameters;
    if ((is_last || state_.step % parameters.step_interval == 0) && last_line_ != state_.step) {
      progress_.wipe();
      log_.write(format_step(state_));
      last_line_ = state_.step;
    }
    output_seconds_ += clock_seconds() - begun;
  }

  void warn_of_user_step(const StepReport& at_start) {
    // The step of rigid bodies alone is a proposal; contact makes its stiffness after it.
    const bool is_bound = at_start.critical_element || contact_ != nullptr;
    if (!is_bound || state_.next_dt <= at_start.stable_step) return;
    warnings_.add_warning("user-time-step", {},
                          fmt::format("the user time step {:.4g} is larger than the stable one, {:.4g}",
                                      state_.next_dt, at_start.stable_step));
  }

  void warn_of_energy() {
    if (state_.step % BlockEnergyWatch::interval == 0) warn_of_negative_energy();
    const Energies& e = state_.energies;
    if (has_warned_ || !watch_.is_off(state_)) return;
    has_warned_ = true;
    warnings_.add_warning("energy-error", {},
                          fmt::format("at step {}, time {:.6g}, the energy balance is off by {:.3g} "
                                      "({:.2g} % of the largest term)",
                                      state_.step, state_.time, e.error, 100.0 * e.error / e.largest),
                          "a smaller TIME STEP SCALE FACTOR tells whether the steps are too large");
  }

  void warn_of_negative_energy() {
    for (const NegativeEnergy& found : block_watch_.look(state_)) {
      const std::string block =
          fmt::format("{} (block {})", model_.mesh->name({EntityKind::block, found.mesh_block}),
                      model_.mesh->blocks()[found.mesh_block].id);
      warnings_.add_warning(
          "negative-internal-energy", {},
          fmt::format("at step {}, time {:.6g}, {} of {} {} given out {:.3g} more energy than {} taken up "
                      "({:.2g} % of the largest term)",
                      state_.step, state_.time,
                      found.is_of_hourglasses ? "the hourglass resistance" : "the stresses", block,
                      found.is_of_hourglasses ? "has" : "have", -found.energy,
                      found.is_of_hourglasses ? "it has" : "they have",
                      -100.0 * found.energy / state_.energies.largest),
          "the energy balance does not show it; a smaller TIME STEP SCALE FACTOR or finer elements help");
    }
  }

  void write_wall_times(double whole) {
    const double contact = timed_contact_ ? timed_contact_->seconds() : 0.0;
    const double death = death_ != nullptr ? death_->seconds() : 0.0;
    const double known = timed_internal_.seconds() + timed_external_.seconds() + contact + output_seconds_ +
                         restart_seconds_ + death;
    std::vector<PartTime> parts{{"elements", timed_internal_.seconds()},
                                {"loads", timed_external_.seconds()},
                                {"nodes", whole - known},
                                {"log and files", output_seconds_}};
    if (restart_.stores()) parts.push_back({"restart files", restart_seconds_});
    if (death_ != nullptr) parts.push_back({"element death", death});
    if (contact_ != nullptr) parts.insert(parts.begin() + 1, {"contact", contact});
    std::size_t n_elements = 0;
    for (const ModelBlock& block : model_.blocks) n_elements += block.n_elements;
    log_.write(format_wall_times(parts, whole, state_.step, n_elements));
  }

  const Model& model_;
  const TimeStepControl& control_;
  State state_;
  Outputs& outputs_;
  RunRestart& restart_;
  StopSignals signals_;
  InternalForce internal_;
  TimedForce timed_internal_, timed_external_;
  RunContact* contact_;  // null without contact
  RunDeath* death_;      // null when nothing can die
  std::optional<TimedForce> timed_contact_;
  Log& log_;
  Diagnostics& warnings_;
  Progress progress_{control_.start_time(), control_.termination_time()};
  double begun_ = clock_seconds();
  double output_seconds_ = 0.0, restart_seconds_ = 0.0;
  std::optional<std::int64_t> last_line_;  // of the log, its step
  bool is_for_overlap_only_ = false;       // the deck wants no steps
  EnergyWatch watch_{model_};
  BlockEnergyWatch block_watch_{model_};
  bool has_warned_ = false;
  std::optional<std::string> end_;         // why the run ends before its termination time
  std::optional<std::string> stopped_by_;  // a signal
};

void stop_on_errors(const Diagnostics& diagnostics) {
  if (diagnostics.has_errors()) throw DeckError(diagnostics);
}

}  // namespace

ExitCode run_transient(const RunInput& input, Log& log, Diagnostics& warnings) {
  refuse_what_is_missing(input.procedure, input.region, warnings);
  if (input.contact != nullptr) {
    const LawScope laws{input.region.contact->friction_models, input.definition.functions,
                        input.procedure.time_control->time_stepping_blocks};
    refuse_laws(input.contact->pairs, input.contact->surfaces.surfaces, laws, warnings);
  }
  stop_on_errors(warnings);
  Setup setup = set_up(input, warnings);
  stop_on_errors(warnings);
  const ConditionScope scope{input.definition, input.region,
                             input.procedure.time_control->time_stepping_blocks, input.mesh, warnings};
  std::optional<RunContact> contact;
  if (input.contact != nullptr) contact.emplace(input, setup.model);
  RunContact* const run_contact = contact ? &*contact : nullptr;
  Outputs outputs(scope, setup.model, output_settings(input, run_contact, log));
  std::optional<RunDeath> death;
  if (!input.region.element_deaths.empty())
    death.emplace(scope, setup.death_sets, outputs.variables(), DeathParts{setup.external, run_contact, log});
  RunRestart restart(input, warnings);
  stop_on_errors(warnings);
  restart.find_state(outputs.paths(), log, warnings);
  outputs.add_suffix(restart.suffix());
  if (run_contact != nullptr) run_contact->add_suffix(restart.suffix());
  std::vector<std::string> paths = outputs.paths();
  if (run_contact != nullptr) std::ranges::copy(run_contact->paths(), std::back_inserter(paths));
  check_output_paths(input, paths);
  for (StepTarget& target : outputs.step_targets()) setup.control.add_target(std::move(target));
  if (auto target = restart.step_target()) setup.control.add_target(std::move(*target));
  return Run(input, setup, {setup.external, run_contact, death ? &*death : nullptr, outputs, restart}, log,
             warnings)
      .run();
}

}  // namespace contactsim
