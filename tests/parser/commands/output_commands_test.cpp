// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/output_commands.hpp"

#include "support/bound_region.hpp"
#include "support/catch.hpp"

using namespace contactsim;

TEST_CASE("results output has defaults", "[parser][output]") {
  const BoundRegion bound = bound_region("begin results output\nend\n");
  CHECK(bound.messages == "");
  const ResultsOutput& results = bound.region.results_outputs.at(0);
  CHECK_FALSE(results.database.name);
  CHECK(results.database.overwrites);
  CHECK(results.database.component_separator == "_");
  CHECK(results.mesh == ResultsOutput::OutputMesh::unrefined);
  CHECK(results.variables.empty());
  CHECK(results.schedule.time_phases.empty());
}

TEST_CASE("results output takes all of its lines", "[parser][output]") {
  const BoundRegion bound = bound_region(
      "begin results output out\n database name = Dir/%B.e\n database type = exodusII\n overwrite = false\n"
      " title - a drop at 5 m/s\n component separator character = none\n include = block_1\n exclude = "
      "block_2\n"
      " output mesh = exposed surface\n at time 0 increment = 1e-5\n nodal variables = displacement as "
      "d\nend\n");
  CHECK(bound.messages == "");
  const ResultsOutput& results = bound.region.results_outputs.at(0);
  CHECK(results.name.text == "out");
  CHECK(results.database.name->text == "Dir/%B.e");
  CHECK_FALSE(results.database.overwrites);
  CHECK(results.database.title == "- a drop at 5 m/s");
  CHECK(results.database.component_separator == "");
  CHECK(joined_names(results.included) == "block_1");
  CHECK(joined_names(results.excluded) == "block_2");
  CHECK(results.mesh == ResultsOutput::OutputMesh::exposed_surface);
  CHECK(results.schedule.time_phases.size() == 1);
  CHECK(results.variables.size() == 1);
}

TEST_CASE("a component separator is one character", "[parser][output]") {
  CHECK(bound_region("begin results output\ncomponent separator character = .\nend\n")
            .region.results_outputs.at(0)
            .database.component_separator == ".");
  CHECK(bound_region("begin results output\ncomponent separator character = ab\nend\n").messages ==
        "a.i:2:33: error: expected one character or NONE for 'component separator character', found 'ab'\n");
}

TEST_CASE("what has no place in our files is ignored, catalyst with all inside it", "[parser][output]") {
  CHECK(
      bound_region(
          "begin results output\n database type = catalyst\n property compose = on\n timeseries name = t\n"
          " begin catalyst\n  begin camera c\n   look at 1 2 3\n  end\n  begin imageset\n  end\n end\nend\n")
          .messages ==
      "a.i:2:18: warning: 'catalyst' files are not written, Exodus is [deck-ignored]\n"
      "a.i:3:2: warning: 'property' has no effect here; the file's layout is contactsim's own "
      "[deck-ignored]\n"
      "a.i:4:2: warning: 'timeseries name' has no effect here; lists of files are not written "
      "[deck-ignored]\n"
      "a.i:5:8: warning: block 'catalyst' has no effect here; pictures are not made during the run "
      "[deck-ignored]\n");
}

TEST_CASE("several outputs of one kind keep their order", "[parser][output]") {
  const BoundRegion bound = bound_region(
      "begin results output a\nend\nbegin history output h\n database name = h.h\n global time\nend\n"
      "begin results output b\nend\n");
  CHECK(bound.messages == "");
  REQUIRE(bound.region.results_outputs.size() == 2);
  CHECK(bound.region.results_outputs[1].name.text == "b");
  CHECK(bound.region.history_outputs.at(0).database.name->text == "h.h");
}

TEST_CASE("heartbeat output has defaults", "[parser][output]") {
  const BoundRegion bound = bound_region("begin heartbeat output\nend\n");
  const HeartbeatOutput& heartbeat = bound.region.heartbeat_outputs.at(0);
  CHECK_FALSE(heartbeat.stream);
  CHECK(heartbeat.format == HeartbeatOutput::Format::csv);
  CHECK_FALSE(heartbeat.appends);
  CHECK_FALSE(heartbeat.precision);
  CHECK_FALSE(heartbeat.has_labels);
  CHECK_FALSE(heartbeat.timestamp_format);
  CHECK_FALSE(heartbeat.monitored);
}

TEST_CASE("heartbeat output takes all of its lines", "[parser][output]") {
  const BoundRegion bound = bound_region(
      "begin heartbeat output h\n stream name = h.csv\n format = spyhis\n append = on\n precision = 8\n "
      "labels = off\n"
      " legend = on\n timestamp format ''\n monitor = results\n at step 0 increment = 1\n global timestep as "
      "dt\nend\n");
  CHECK(bound.messages == "");
  const HeartbeatOutput& heartbeat = bound.region.heartbeat_outputs.at(0);
  CHECK(heartbeat.name.text == "h");
  CHECK(heartbeat.stream->text == "h.csv");
  CHECK(heartbeat.format == HeartbeatOutput::Format::spyhis);
  CHECK(heartbeat.appends);
  CHECK(heartbeat.precision == 8);
  CHECK(heartbeat.has_labels == false);
  CHECK(heartbeat.has_legend == true);
  CHECK(heartbeat.timestamp_format == "");
  CHECK(heartbeat.monitored == HeartbeatOutput::Monitored::results);
  CHECK(heartbeat.schedule.step_phases.size() == 1);
  CHECK(heartbeat.variables.size() == 1);
}

TEST_CASE("the misspelling HEARTBEAT OUPUT is taken with a warning", "[parser][output]") {
  const BoundRegion bound =
      bound_region("begin heartbeat ouput h\n stream name = f\nend heartbeat ouput h\n");
  CHECK(bound.messages == "a.i:1:7: warning: HEARTBEAT OUPUT is taken as HEARTBEAT OUTPUT [deck-misspelt]\n");
  CHECK(bound.region.heartbeat_outputs.at(0).name.text == "h");
  CHECK(bound.region.heartbeat_outputs.at(0).stream->text == "f");
  CHECK(bound_region("begin heartbeat ouput\nend heartbeat output\n").messages ==
        "a.i:1:7: warning: HEARTBEAT OUPUT is taken as HEARTBEAT OUTPUT [deck-misspelt]\n");
  CHECK(bound_region("begin heartbeat_ouput\nend\n").messages ==
        "a.i:1:7: warning: HEARTBEAT OUPUT is taken as HEARTBEAT OUTPUT [deck-misspelt]\n");
}
