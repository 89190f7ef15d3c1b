// SPDX-License-Identifier: BSD-3-Clause
// Rows of the whole that output_table_test.cpp has no values of.
#include "support/row_values.hpp"

using namespace contactsim;
using namespace contactsim::test;

TEST_CASE("each part of the contact energy has a row of its own", "[core][output]") {
  SampleRun run;
  run.state.energies.contact = 10.0;
  run.state.energies.friction = 2.0;
  run.state.energies.contact_damping = 3.0;
  run.state.energies.impact = 4.0;
  check_close(global(run, "contact_energy"), {10});
  check_close(global(run, "friction_energy"), {2});
  check_close(global(run, "contact_damping_energy"), {3});
  check_close(global(run, "contact_impact_energy"), {4});
}
