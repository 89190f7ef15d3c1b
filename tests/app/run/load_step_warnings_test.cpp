// SPDX-License-Identifier: BSD-3-Clause
#include "app/run/load_step_warnings.hpp"

#include "support/catch.hpp"
#include "support/deck_dump.hpp"

using namespace contactsim;
using Catch::Matchers::Contains;

namespace {

/// Load steps of some reports, one after the other.
struct WarnedSteps {
  Diagnostics found;
  LoadStepWarnings warnings{found};
  State state;

  void take(const LoadStepReport& report) {
    ++state.step;
    state.time = 0.5 * static_cast<double>(state.step);
    warnings.step(state, report);
  }
  std::string end() {
    warnings.end(state);
    return messages(found);
  }
};

/// A step that ended with this share of forces left over, its target being 0.001.
LoadStepReport searched(double share, CgReport::End end) {
  LoadStepReport report;
  report.search.end = end;
  report.search.residual = 200.0 * share;
  report.search.reference = 200.0;
  report.search_target = 1e-3;
  return report;
}

LoadStepReport acceptable(double share) { return searched(share, CgReport::End::acceptable); }

}  // namespace

TEST_CASE("load steps that ended as they should are nothing to tell", "[app][statics]") {
  WarnedSteps steps;
  CHECK(steps.end() == "");
  steps.take(searched(5e-4, CgReport::End::converged));
  CHECK(steps.end() == "");
}

TEST_CASE("forces left over above the target are reported once, with the first step and the worst",
          "[app][statics]") {
  WarnedSteps one;
  one.take(searched(5e-4, CgReport::End::converged));
  one.take(acceptable(0.002));
  CHECK_THAT(one.end(),
             Contains("warning: 1 load step ended above the target, the first at step 2, time 1: forces "
                      "left over are 0.002 of their reference at step 2, where the target is 0.001; ") &&
                 Contains("[equilibrium-acceptable]"));
  WarnedSteps three;
  for (const double share : {0.002, 0.02, 0.01}) three.take(acceptable(share));
  CHECK_THAT(three.end(),
             Contains("3 load steps ended above the target, the first at step 1, time 0.5: forces left "
                      "over are 0.02 of their reference at step 2, where"));
}

TEST_CASE("multipliers that would still change are reported with change and target", "[app][statics]") {
  WarnedSteps steps;
  LoadStepReport report = searched(1e-4, CgReport::End::converged);
  report.contact.change = 3.0;
  report.contact.reference = 100.0;
  steps.take(report);  // multipliers have no part
  CHECK(steps.end() == "");
  report.contact_target = 0.03;
  steps.take(report);  // just at the target
  CHECK(steps.end() == "");
  report.contact_target = 0.01;
  steps.take(report);
  CHECK_THAT(steps.end(),
             Contains("1 load step ended above the target, the first at step 3, time 1.5: multipliers "
                      "would still change contact forces by 0.03 of their size at step 3, where the "
                      "target is 0.01; ") &&
                 Contains("[multipliers-unfinished]"));
}

TEST_CASE("deaths that nothing has balanced are counted from the first", "[app][statics][death]") {
  WarnedSteps steps;
  steps.state.step = 4;
  steps.warnings.note_deaths_left(steps.state);
  CHECK_THAT(steps.end(), Contains("in 1 load step, the first of them 4, elements still died") &&
                              Contains("[deaths-left]"));
  WarnedSteps two;
  two.state.step = 4;
  two.warnings.note_deaths_left(two.state);
  two.state.step = 9;
  two.warnings.note_deaths_left(two.state);
  CHECK_THAT(two.end(), Contains("in 2 load steps, the first of them 4, "));
}

TEST_CASE("stabilization that still bears as a block ends is reported, within a block it is not",
          "[app][statics]") {
  WarnedSteps steps;
  LoadStepReport report = searched(1e-4, CgReport::End::converged);
  report.stabilizing_force = 0.25;
  steps.take(report);
  CHECK(steps.end() == "");
  report.ends_block = true;
  steps.take(report);
  CHECK_THAT(steps.end(),
             Contains("still bears 0.25 of the forces as the time stepping block ends at time 1, the "
                      "largest of 1 such end: ") &&
                 Contains("[stabilization-remains]"));
  WarnedSteps below;
  report.stabilizing_force = 1e-3;  // not above the target of the search
  below.take(report);
  CHECK(below.end() == "");
}

TEST_CASE("energy of stabilization is reported from a twentieth of the internal energy on",
          "[app][statics]") {
  WarnedSteps steps;
  steps.state.energies.internal = -100.0;
  steps.state.energies.stabilization = 5.0;
  CHECK(steps.end() == "");
  steps.state.energies.stabilization = 6.0;
  CHECK_THAT(steps.end(),
             Contains("contact stabilization has taken up 6 of energy, 0.06 of the internal energy -100: ") &&
                 Contains("[stabilization-energy]"));
}
