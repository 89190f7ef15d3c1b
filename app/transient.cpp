// SPDX-License-Identifier: BSD-3-Clause
#include "app/transient.hpp"

#include <fmt/format.h>

#include "app/progress.hpp"
#include "app/refusals.hpp"
#include "app/run_report.hpp"
#include "app/timed_force.hpp"
#include "core/conditions/kinematics.hpp"
#include "core/internal_force.hpp"
#include "core/mesh/element_checks.hpp"

namespace contactsim {

namespace {

/// An energy that appears or vanishes is worth a warning when it is this share of the largest.
constexpr double worrying_error = 0.01;

class ExternalForce final : public ForceTerm {
 public:
  ForceReport set_forces(const Motion&, Eigen::Matrix3Xd& forces) override {
    forces.setZero();
    return {};
  }
};

/// A region on its way from start to end.
class Run {
 public:
  Run(const RunInput& input, Model model, ExternalForce external, const TimeStepControl& control, Log& log,
      Diagnostics& warnings)
      : input_(input),
        model_(std::move(model)),
        external_(std::move(external)),
        control_(control),
        state_(make_state(input.mesh.coordinates(), model_.blocks, control.start_time())),
        log_(log),
        warnings_(warnings) {}

  ExitCode go() {
    const double begun = clock_seconds();
    const StepReport at_start = start(model_, terms(), control_, state_);
    log_.write(format_model(model_, at_start));
    log_.write(step_heading());
    tell(false);
    try {
      while (!control_.is_over(state_.time, state_.dt)) step();
    } catch (const SolveError& error) {
      log_.write(format_step(state_));
      finish(begun);
      log_.write_error(fmt::format("error: step {}, {}", state_.step, error.what()));
      return ExitCode::solve;
    }
    finish(begun);
    return ExitCode::done;
  }

 private:
  ForceTerms terms() { return {timed_internal_, timed_external_}; }

  void step() {
    advance(model_, terms(), control_, state_);
    const bool is_last = control_.is_over(state_.time, state_.dt);
    tell(is_last);
    warn_of_energy();
    progress_.show(state_.time);
  }

  /// A line of the log when it is due.
  void tell(bool is_last) {
    const auto& parameters = control_.periods()[control_.period_at(state_.time)].parameters;
    if (!is_last && state_.step % parameters.step_interval != 0) return;
    progress_.wipe();
    log_.write(format_step(state_));
  }

  void warn_of_energy() {
    const Energies& e = state_.energies;
    if (has_warned_ || std::abs(e.error) <= worrying_error * e.largest) return;
    has_warned_ = true;
    warnings_.add_warning("energy-error", {},
                          fmt::format("at step {}, time {:.6g}, energy of {:.3g} has appeared from nowhere "
                                      "({:.2g} % of the largest)",
                                      state_.step, state_.time, e.error, 100.0 * e.error / e.largest),
                          "a smaller time step scale factor tells whether the step is too large");
  }

  void finish(double begun) {
    const double whole = clock_seconds() - begun;
    const double known = timed_internal_.seconds() + timed_external_.seconds();
    const std::vector<PartTime> parts{{"elements", timed_internal_.seconds()},
                                      {"loads", timed_external_.seconds()},
                                      {"nodes and the rest", whole - known}};
    log_.write(format_wall_times(parts, whole, state_.step, n_elements()));
  }

  std::size_t n_elements() const {
    std::size_t n = 0;
    for (const SolidBlock& block : model_.blocks) n += block.n_elements;
    return n;
  }

  const RunInput& input_;
  const Model model_;
  ExternalForce external_;
  const TimeStepControl& control_;
  State state_;
  Log& log_;
  Diagnostics& warnings_;
  InternalForce internal_{model_, state_};
  TimedForce timed_internal_{internal_}, timed_external_{external_};
  Progress progress_{control_.start_time(), control_.termination_time()};
  bool has_warned_ = false;
};

}  // namespace

ExitCode run_transient(const RunInput& input, Log& log, Diagnostics& warnings) {
  const auto stop_on_errors = [&] {
    if (warnings.has_errors()) throw DeckError(warnings);
  };
  refuse_what_is_missing(input.procedure, input.region, warnings);
  stop_on_errors();
  Model model = make_model(input.definition, input.region, input.mesh, warnings);
  const ConditionScope scope{input.definition, input.region, input.procedure.time_control->blocks, input.mesh,
                             warnings};
  model.kinematics = make_kinematics(scope);
  stop_on_errors();
  ExternalForce external;
  const TimeStepControl control = make_time_step_control(input.procedure, input.region);
  return Run(input, std::move(model), std::move(external), control, log, warnings).go();
}

}  // namespace contactsim
