// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/output_restart_commands.hpp"

#include "support/bound_region.hpp"
#include "support/catch.hpp"

using namespace contactsim;

namespace {

RestartData restart_of(const std::string& lines) {
  const BoundRegion bound = bound_region("begin restart data\n" + lines + "end\n");
  CHECK(bound.messages == "");
  return bound.region.restart_data.at(0);
}

}  // namespace

TEST_CASE("restart data has defaults", "[parser][output]") {
  const RestartData restart = restart_of("");
  CHECK_FALSE(restart.database);
  CHECK_FALSE(restart.restart_time);
  CHECK_FALSE(restart.is_automatic);
  CHECK_FALSE(restart.is_optional);
  CHECK_FALSE(restart.cycle_count);
  CHECK(restart.overwrites);
}

TEST_CASE("restart data takes all of its lines", "[parser][output]") {
  const RestartData restart = restart_of(
      "database name = %B.rst\ninput database name = in\noutput database name = out\noverwrite = off\n"
      "restart time = 1e-3\nrestart = automatic\noverlay count = 2\ncycle count = 3\nfile cycle count = "
      "4\noptional\n"
      "shift to start time\nat time 0 interval = 0.1\n");
  CHECK(restart.database->text == "%B.rst");
  CHECK(restart.input_database->text == "in");
  CHECK(restart.output_database->text == "out");
  CHECK_FALSE(restart.overwrites);
  CHECK(restart.restart_time == 1e-3);
  CHECK(restart.is_automatic);
  CHECK(restart.overlay_count == 2);
  CHECK(restart.cycle_count == 3);
  CHECK(restart.file_cycle_count == 4);
  CHECK(restart.is_optional);
  CHECK(restart.shifts_to_start_time);
  CHECK(restart.schedule.time_phases.size() == 1);
  CHECK(restart_of("restart = auto\n").is_automatic);
}

TEST_CASE("wall times have units", "[parser][output]") {
  const auto phases =
      restart_of("at wall time 12h increment = 700m\nat wall time 90 interval 1.5d\n").wall_time_phases;
  REQUIRE(phases.size() == 2);
  CHECK(phases[0].start == 43200.0);
  CHECK(phases[0].increment == 42000.0);
  CHECK(phases[1].start == 90.0);
  CHECK(phases[1].increment == 129600.0);
  CHECK(restart_of("at wall time 0s increment = 30S\n").wall_time_phases.at(0).increment == 30.0);
  CHECK(bound_region(
            "begin restart data\nat wall time 12w increment = 1h\nat wall time 0 increment = 0s\nend\n")
            .messages ==
        "a.i:2:14: error: expected a time such as 30s, 700m, 12h or 1d for 'at wall time', found '12w'\n"
        "a.i:3:1: error: the increment of 'at wall time' must be greater than 0\n");
}
