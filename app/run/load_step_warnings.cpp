// SPDX-License-Identifier: BSD-3-Clause
#include "app/run/load_step_warnings.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/base/pluralize.hpp"

namespace contactsim {

void LoadStepWarnings::Steps::add(const State& state, double share_now, double target_now) {
  if (n == 0) {
    first = state.step;
    first_time = state.time;
  }
  ++n;
  if (share_now <= share) return;
  share = share_now;
  target = target_now;
  worst = state.step;
  worst_time = state.time;
}

std::string LoadStepWarnings::Steps::format(const char* what, const char* reference) const {
  return fmt::format(
      "{} above the target, the first at step {}, time {:.6g}: {} {:.3g} of {} at step {}, "
      "where the target is {:.3g}",
      n == 1 ? "1 load step ended" : fmt::format("{} load steps ended", n), first, first_time, what, share,
      reference, worst, target);
}

void LoadStepWarnings::begin(const LoadSteps& load_steps, const SolverSettings& settings, bool has_deaths) {
  if (settings.control_failure && !has_deaths)
    warnings_.add_warning("control-failure", settings.control_failure->name.location,
                          "CONTROL FAILURE has no effect: the region has no ELEMENT DEATH");
  const auto& choice = load_steps.linear_solver();
  if (!choice || choice->is_asked_for) return;
  warnings_.add_warning(
      "linear-solver", settings.cg.full_tangent->name.location,
      fmt::format(
          "LINEAR SOLVER = {} is DIRECT here: {}",
          settings.cg.full_tangent->linear_solver == LinearSolver::distributed ? "DISTRIBUTED" : "AMG",
          choice->reason));
}

void LoadStepWarnings::note_deaths_left(const State& state) {
  if (n_with_deaths_++ == 0) first_with_deaths_ = state.step;
}

void LoadStepWarnings::step(const State& state, const LoadStepReport& report) {
  if (report.search.end == CgReport::End::acceptable)
    searches_.add(state, report.search.residual / report.search.reference, report.search_target);
  if (report.ends_block && report.stabilizing_force.value_or(0.0) > report.search_target)
    stabilized_.add(state, *report.stabilizing_force, report.search_target);
  if (report.is_contact_short())
    updates_.add(state, report.contact.change / report.contact.reference, *report.contact_target);
}

void LoadStepWarnings::warn_of_stabilization(const Energies& energies) const {
  constexpr double worrying = 0.05;
  if (stabilized_.n > 0)
    warnings_.add_warning(
        "stabilization-remains", {},
        fmt::format("contact stabilization still bears {:.3g} of the forces as the time stepping block ends "
                    "at time {:.6g}, the largest of {}: the equilibrium is not that of the loads alone",
                    stabilized_.share, stabilized_.worst_time,
                    pluralize(static_cast<std::size_t>(stabilized_.n), "such end")),
        "STABILIZATION REMAINING FRACTION = 0 lets go of it");
  if (energies.stabilization > worrying * std::abs(energies.internal))
    warnings_.add_warning(
        "stabilization-energy", {},
        fmt::format(
            "contact stabilization has taken up {:.3g} of energy, {:.3g} of the internal energy {:.3g}: "
            "the way to the equilibrium may have been another one without it",
            energies.stabilization, energies.stabilization / std::abs(energies.internal), energies.internal),
        "loads that grow from 0 move what does not touch yet with little energy; a smaller CONTACT "
        "STABILIZATION takes up less along surfaces that slide");
}

void LoadStepWarnings::end(const State& state) const {
  warn_of_stabilization(state.energies);
  if (searches_.n > 0)
    warnings_.add_warning("equilibrium-acceptable", {},
                          searches_.format("forces left over are", "their reference"),
                          "ACCEPTABLE RELATIVE RESIDUAL of BEGIN CG says what is put up with, MAXIMUM "
                          "ITERATIONS how long the search goes on");
  if (n_with_deaths_ > 0)
    warnings_.add_warning(
        "deaths-left", {},
        fmt::format("in {}, the first of them {}, elements still died in the last iteration of "
                    "CONTROL FAILURE: the step after finds the equilibrium without them",
                    pluralize(static_cast<std::size_t>(n_with_deaths_), "load step"), first_with_deaths_),
        "MAXIMUM ITERATIONS of BEGIN CONTROL FAILURE says how many there are");
  if (updates_.n > 0)
    warnings_.add_warning("multipliers-unfinished", {},
                          updates_.format("multipliers would still change contact forces by", "their size"),
                          "ACCEPTABLE RELATIVE RESIDUAL of BEGIN CONTROL CONTACT says what is put up with, "
                          "MAXIMUM ITERATIONS how many updates there are");
}

}  // namespace contactsim
