// SPDX-License-Identifier: BSD-3-Clause
#include "app/reports/statics_report.hpp"

#include <fmt/format.h>

namespace contactsim {

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
  if (report.n_negative > 0) remark += fmt::format("  not stable along {} directions", report.n_negative);
  return fmt::format("{:>9} {:>13.6e} {:>12.4e} {:>13.5e} {:>13.5e} {:>10} {:>10} {:>12.4e} {:>8}{}\n",
                     state.step, state.time, state.dt, state.energies.internal, state.energies.external,
                     search.n_iterations, report.n_evaluations, left, report.n_cutbacks, remark);
}

}  // namespace contactsim
