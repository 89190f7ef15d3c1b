// SPDX-License-Identifier: BSD-3-Clause
#include "app/reports/run_log.hpp"

#include <fmt/format.h>

#include "app/reports/contact_report.hpp"
#include "app/reports/death_report.hpp"
#include "app/reports/pair_report.hpp"
#include "app/reports/run_report.hpp"
#include "app/reports/statics_report.hpp"

namespace contactsim {

namespace {

/// What ramped overlaps put into contact without springs, which gives it out at once [energy].
double ramped_without_springs(const ContactForce& force) {
  double sum = 0.0;
  const auto histories = force.histories();
  for (const PairIndex i : indices(histories))
    sum += force.rules()[i].is_balanced ? histories[i].ramped : 0.0;
  return sum;
}

}  // namespace

void RunLog::look(RunEvent event, const Simulation& run) {
  if (event != RunEvent::step && progress_) progress_->wipe();
  switch (event) {
    case RunEvent::restart_sought:
      return log_.write(format_restart_source(run.restart()));
    case RunEvent::begun:
      return write_start(run, false);
    case RunEvent::resumed:
      return write_start(run, true);
    case RunEvent::elements_died:
      return write_deaths(run);
    case RunEvent::step:
      return write_step(run, false);
    case RunEvent::failed:
      return log_.write_error(fmt::format("error: step {}, {}", run.state().step, *run.failure()));
    case RunEvent::ended:
      return write_end(run);
  }
}

void RunLog::write_start(const Simulation& run, bool is_resumed) {
  if (!is_resumed) log_.write(format_model(run.model(), run.start_report()));
  if (!is_resumed && run.contact_force() != nullptr)
    log_.write(format_contact_start(*run.contact_force(), *run.contact_model(), run.untied(), run.mesh()));
  if (const auto traffic = run.rank_traffic())
    log_.write(format_ranks(*traffic, run.load_steps() != nullptr));
  if (run.load_steps() != nullptr) log_.write(format_load_step_search(*run.load_steps()));
  log_.write(format_paths(run.output_paths()) + (run.load_steps() != nullptr
                                                     ? load_step_heading(run.contact_force() != nullptr)
                                                     : step_heading()));
  if (!log_.is_quiet()) progress_.emplace(run.control().start_time(), run.control().termination_time());
}

void RunLog::write_deaths(const Simulation& run) {
  const RunDeath& deaths = *run.deaths();
  log_.write(format_deaths(deaths.tally(), run.state(), deaths.detail(), run.contact_model(), run.mesh()));
}

void RunLog::write_step(const Simulation& run, bool is_last) {
  const State& state = run.state();
  const TimeStepControl& control = run.control();
  const std::int64_t interval = control.periods()[control.period_at(state.time)].parameters.step_interval;
  if ((is_last || state.step % interval == 0) && last_line_ != state.step) {
    if (progress_) progress_->wipe();
    log_.write(run.load_steps() != nullptr
                   ? format_load_step(state, run.load_steps()->report(), run.contact_force() != nullptr)
                   : format_step(state));
    last_line_ = state.step;
  }
  if (!is_last && progress_ && state.step > 0) progress_->show(state.time);
}

void RunLog::write_end(const Simulation& run) {
  write_step(run, true);
  if (!run.failure() && run.end()) log_.write(fmt::format("The run ends here: {}\n", run.end()->reason));
  if (!run.failure() && run.stopped_by())
    log_.write_error(fmt::format("stopped by {} after step {}", *run.stopped_by(), run.state().step));
  if (run.deaths() != nullptr) {
    if (run.deaths()->tally().n_died > 0) write_deaths(run);
    log_.write(format_death_total(run.deaths()->tally(), run.deaths()->n_may_die()));
  }
  if (const ContactForce* force = run.contact_force()) {
    log_.write(format_energy_balance(run.state().energies, force->stored_at_start(),
                                     run.given_out_by_overlaps(), ramped_without_springs(*force)) +
               format_pair_histories(*run.contact_model(), force->histories()) +
               format_contact(*force, run.load_steps() != nullptr));
  }
  if (run.load_steps() != nullptr) log_.write(format_factor(*run.load_steps()));
  log_.write(format_stored_states(run.restart()));
  std::size_t n_elements = 0;
  for (const ModelBlock& block : run.model().blocks) n_elements += block.n_elements;
  log_.write(format_wall_times(run.part_times(), run.seconds(), run.state().step, n_elements));
}

}  // namespace contactsim
