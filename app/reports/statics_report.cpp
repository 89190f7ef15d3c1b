// SPDX-License-Identifier: BSD-3-Clause
#include "app/reports/statics_report.hpp"

#include <fmt/format.h>

#include "core/base/pluralize.hpp"
#include "core/statics/sparse_factor.hpp"

namespace contactsim {

namespace {

const char* describe(LinearSolver solver) {
  if (solver == LinearSolver::multigrid) return "AMG, multigrid";
  if (solver == LinearSolver::distributed)
    return "DISTRIBUTED, a factor of MUMPS that ranks share:\n  results agree to the target of forces from "
           "run to run, not "
           "to the byte";
  return has_mumps() ? "DIRECT, a factor of MUMPS" : "DIRECT, a factor of Eigen, slower than MUMPS'";
}

}  // namespace

std::string format_load_step_search(const LoadSteps& load_steps) {
  const auto& choice = load_steps.linear_solver();
  if (!choice) return "  equilibrium by conjugate gradients with nodal blocks\n";
  std::string text =
      fmt::format("  equilibrium by Newton's steps, equations by {}", describe(choice->solver));
  if (!choice->is_asked_for) text += ", not as the deck asks";
  if (!choice->reason.empty()) text += ": " + choice->reason;
  return text + "\n";
}

std::string format_factor(const LoadSteps& load_steps) {
  const auto& choice = load_steps.linear_solver();
  const auto memory = load_steps.factor_memory();
  if (!choice || choice->solver != LinearSolver::distributed || !memory) return "";
  return fmt::format("\nFactor: {} MB on the rank with most of it, {} MB on all\n", memory->largest,
                     memory->all);
}

std::string load_step_heading(bool has_contact) {
  return fmt::format("\n{:>9} {:>13} {:>12} {:>13} {:>13} {:>10} {:>10} {:>12} {:>8}{}\n", "step", "time",
                     "time step", "internal", "external", "iterations", "residuals", "left over", "cutbacks",
                     has_contact ? "  updates" : "");
}

std::string format_load_step(const State& state, const LoadStepReport& report, bool has_contact) {
  const CgReport& search = report.search;
  const double left = search.reference > 0.0 ? search.residual / search.reference : search.residual;
  std::string remark = has_contact ? fmt::format(" {:>8}", report.n_updates) : "";
  remark += search.end == CgReport::End::acceptable ? "  acceptable, not below the target" : "";
  if (report.is_contact_short())
    remark += fmt::format("  multipliers change contact forces by {:.2g}, not below the target {:.2g}",
                          report.contact.change / report.contact.reference, *report.contact_target);
  if (report.stabilizing_force.value_or(0.0) > 0.0)
    remark += fmt::format("  stabilization bears {:.2g}", *report.stabilizing_force);
  if (report.n_again > 0) remark += fmt::format("  anew after deaths: {}", report.n_again);
  if (report.has_left_newton) remark += "  by nodal blocks, the full tangent led nowhere";
  if (report.n_negative > 0)
    remark += "  not stable along " + pluralize(static_cast<std::size_t>(report.n_negative), "direction");
  return fmt::format("{:>9} {:>13.6e} {:>12.4e} {:>13.5e} {:>13.5e} {:>10} {:>10} {:>12.4e} {:>8}{}\n",
                     state.step, state.time, state.dt, state.energies.internal, state.energies.external,
                     search.n_iterations, report.n_evaluations, left, report.n_cutbacks, remark);
}

}  // namespace contactsim
