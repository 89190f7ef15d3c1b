// SPDX-License-Identifier: BSD-3-Clause
#include "app/reports/statics_report.hpp"

#include "support/catch.hpp"

using namespace contactsim;

namespace {

State load_state() {
  State state;
  state.step = 7;
  state.time = 0.25;
  state.dt = 0.125;
  state.energies.internal = 1.5;
  state.energies.external = -2.5;
  return state;
}

LoadStepReport converged() {
  LoadStepReport report;
  report.search = {CgReport::End::converged, 11, 30, 0, false, 2.0, 400.0};
  report.n_evaluations = 34;
  report.n_cutbacks = 1;
  report.n_updates = 3;
  return report;
}

const std::string plain =
    "        7  2.500000e-01   1.2500e-01   1.50000e+00  -2.50000e+00         11         34   5.0000e-03     "
    "   1";

}  // namespace

TEST_CASE("a line of a load step stands under its heading", "[app][statics]") {
  CHECK(format_load_step(load_state(), converged(), false) == plain + "\n");
  CHECK(format_load_step(load_state(), converged(), true) == plain + "        3\n");
  for (const bool has_contact : {false, true}) {
    const std::string heading = load_step_heading(has_contact);
    CHECK(heading.front() == '\n');
    CHECK(heading.size() == format_load_step(load_state(), converged(), has_contact).size() + 1);
  }
}

TEST_CASE("forces left over are a share of their reference, if there is one", "[app][statics]") {
  LoadStepReport report = converged();
  report.search.reference = 0.0;
  CHECK(format_load_step(load_state(), report, false).find("   2.0000e+00 ") != std::string::npos);
}

TEST_CASE("what was put up with in a load step is said behind its numbers", "[app][statics]") {
  LoadStepReport report = converged();
  const auto remark = [&] { return format_load_step(load_state(), report, false).substr(plain.size()); };
  report.search.end = CgReport::End::acceptable;
  CHECK(remark() == "  acceptable, not below the target\n");
  report = converged();
  report.contact.change = 0.5;
  report.contact.reference = 10.0;
  CHECK(remark() == "\n");  // multipliers have no part
  report.contact_target = 0.05;
  CHECK(remark() == "\n");  // just at the target
  report.contact_target = 0.01;
  CHECK(remark() == "  multipliers change contact forces by 0.05, not below the target 0.01\n");
  report = converged();
  report.stabilizing_force = 0.0;
  CHECK(remark() == "\n");
  report.stabilizing_force = 0.125;
  CHECK(remark() == "  stabilization bears 0.12\n");
  report = converged();
  report.n_again = 2;
  report.has_left_newton = true;
  report.n_negative = 2;
  CHECK(remark() ==
        "  anew after deaths: 2  by nodal blocks, the full tangent led nowhere  not stable along 2 "
        "directions\n");
  report = converged();
  report.n_negative = 1;
  CHECK(remark() == "  not stable along 1 direction\n");
}
