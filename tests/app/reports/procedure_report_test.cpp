// SPDX-License-Identifier: BSD-3-Clause
#include "app/reports/procedure_report.hpp"

#include "core/definition/procedure.hpp"
#include "support/catch.hpp"

using namespace contactsim;

namespace {

Procedure procedure_named(const std::string& name) {
  Procedure procedure;
  procedure.name.text = name;
  return procedure;
}

Region region_named(const std::string& name) {
  Region region;
  region.name.text = name;
  return region;
}

std::vector<DeckName> block_names(const std::vector<std::string>& texts) {
  std::vector<DeckName> names;
  for (const std::string& text : texts) names.push_back({text, {}});
  return names;
}

}  // namespace

TEST_CASE("the heading of a procedure has name, kind, region and times", "[app][procedures]") {
  Procedure procedure = procedure_named("press");
  CHECK(format_procedure(procedure, region_named("r"), nullptr) == "\nProcedure press: explicit, region r\n");
  procedure.time_control.emplace().termination_time = 2.5e-3;
  CHECK(format_procedure(procedure, region_named("r"), nullptr) == "\nProcedure press: explicit, region r\n");
  procedure.time_control->time_stepping_blocks.resize(2);
  procedure.time_control->time_stepping_blocks[0].start_time = -1.0;
  procedure.time_control->time_stepping_blocks[1].start_time = 1e-3;
  procedure.implicit_by = ImplicitCause{"adagio region 'r'", {}};
  CHECK(format_procedure(procedure, region_named("r"), nullptr) ==
        "\nProcedure press: quasi-static, region r, time -1 to 0.0025\n");
}

TEST_CASE("a later procedure says whose state it takes over, of which blocks", "[app][procedures]") {
  const Procedure before = procedure_named("press");
  Procedure procedure = procedure_named("release");
  CHECK(format_procedure(procedure, region_named("s"), &before) ==
        "\nProcedure release: explicit, region s\n  starts from the mesh\n");
  procedure.transfers.resize(3);
  procedure.transfers[0].set.includes_all_blocks = true;
  procedure.transfers[1].set.blocks = block_names({"a", "b"});
  procedure.transfers[2].set.includes_all_blocks = true;
  procedure.transfers[2].set.removed_blocks = block_names({"c", "d"});
  CHECK(format_procedure(procedure, region_named("s"), &before) ==
        "\nProcedure release: explicit, region s\n"
        "  takes over the state of all blocks from press\n"
        "  takes over the state of the blocks a, b from press\n"
        "  takes over the state of all blocks but c, d from press\n");
}
