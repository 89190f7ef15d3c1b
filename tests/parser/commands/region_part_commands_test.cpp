// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/region_part_commands.hpp"

#include "support/bound_region.hpp"
#include "support/catch.hpp"

using namespace contactsim;

namespace {

Region region_of(const std::string& lines) {
  BoundRegion bound = bound_region(lines);
  CHECK(bound.messages == "");
  return std::move(bound.region);
}

}  // namespace

TEST_CASE("solution termination is bound", "[parser][region]") {
  const Region region = region_of(
      "begin solution termination\n terminate global kinetic_energy < 1e-3\n terminate nodal max "
      "displacement(z) >= 2\n"
      " terminate element eqps > 0.5\n skip times = 0 to 1e-4\n terminate type = procedure\nend\n");
  const SolutionTermination& termination = region.terminations.at(0);
  REQUIRE(termination.criteria.size() == 3);
  CHECK(termination.criteria[0].location == VariableLocation::global);
  CHECK(termination.criteria[0].test.variable.name.text == "kinetic_energy");
  CHECK(termination.criteria[0].test.comparison == Comparison::less);
  CHECK(termination.criteria[1].location == VariableLocation::nodal);
  CHECK(termination.criteria[1].reduction == NodalCriterion::Reduction::maximum);
  CHECK(termination.criteria[1].test.variable.component == "z");
  CHECK(termination.criteria[2].location == VariableLocation::element);
  CHECK_FALSE(termination.criteria[2].reduction);
  REQUIRE(termination.skipped_times.size() == 1);
  CHECK(termination.skipped_times[0].to == 1e-4);
  CHECK(termination.scope == SolutionTermination::Scope::procedure);
  CHECK(bound_region("begin solution termination\n skip times = 2 to 1\nend\n").messages ==
        "a.i:2:2: error: the second of the skipped times lies before the first\n");
}

TEST_CASE("mass properties are bound", "[parser][region]") {
  const Region region =
      region_of("begin mass properties\n block = b1 b2\n assembly = a\n structure name = lid\nend\n");
  CHECK(joined_names(region.mass_properties.at(0).set.blocks) == "b1 b2");
  CHECK(region.mass_properties.at(0).structure_name == "lid");
}

TEST_CASE("a spot weld is bound", "[parser][region]") {
  const SpotWeld weld =
      region_of(
          "begin spot weld w\n node set = n\n surface = s\n normal displacement function = f\n"
          " normal displacement scale factor = 2\n tangential displacement function = g\n"
          " tangential displacement scale factor = 3\n failure envelope exponent = 1\n"
          " failure decay cycles = 10\n failure function = h\n ignore initial offsets = on\nend\n")
          .spot_welds.at(0);
  CHECK(weld.name.text == "w");
  CHECK(joined_names(weld.node_sets) == "n");
  CHECK(joined_names(weld.side_sets) == "s");
  CHECK(weld.normal.function->text == "f");
  CHECK(weld.normal.scale_factor == 2.0);
  CHECK(weld.tangential.function->text == "g");
  CHECK(weld.tangential.scale_factor == 3.0);
  CHECK(weld.envelope_exponent == 1.0);
  CHECK(weld.decay_cycles == 10);
  CHECK(weld.failure_function->text == "h");
  CHECK(weld.ignores_initial_offsets);
}

TEST_CASE("mass scaling is bound", "[parser][region]") {
  const MassScaling scaling = region_of(
                                  "begin mass scaling\n include all blocks\n target time step = 1e-6\n"
                                  " allowable mass increase ratio = 1.1\nend\n")
                                  .mass_scalings.at(0);
  CHECK(scaling.set.includes_all_blocks);
  CHECK(scaling.target_time_step == 1e-6);
  CHECK(scaling.allowable_mass_increase == 1.1);
}

TEST_CASE("blocks to subcycle are bound, by name or all", "[parser][region]") {
  const auto blocks =
      region_of("subcycle blocks = tip 'small part'\nsubcycle blocks = rim\n").subcycle_blocks;
  REQUIRE(blocks.size() == 3);
  CHECK(blocks[1].text == "small part");
  CHECK(blocks[2].text == "rim");
  CHECK(region_of("subcycle blocks = ALL\n").subcycle_blocks.at(0).text == "ALL");
  CHECK(region_of("").subcycle_blocks.empty());
}

TEST_CASE("other estimates of the time step are ignored with all their lines", "[parser][region]") {
  CHECK(
      bound_region("begin node based time step parameters\n increment interval = 5\n step interval = 1\nend\n"
                   "begin lanczos parameters l\n anything goes\nend\nbegin power method parameters\nend\n")
          .messages ==
      "a.i:1:7: warning: block 'node based time step parameters' has no effect here; the "
      "element-based estimate of the time step is used, which is safe [deck-ignored]\n"
      "a.i:5:7: warning: block 'lanczos parameters' has no effect here; the element-based "
      "estimate of the time step is used, which is safe [deck-ignored]\n"
      "a.i:8:7: warning: block 'power method parameters' has no effect here; the element-based "
      "estimate of the time step is used, which is safe [deck-ignored]\n");
}

TEST_CASE("joints between nodes are refused", "[parser][region]") {
  const std::string block =
      GENERATE("line weld", "mpc", "tied joint", "submodel", "torsional spring mechanism");
  const std::string found = bound_region("begin " + block + " x\n y = z\nend\n").messages;
  CHECK(found.find("a.i:1:7: error: block '" + block + "' is not supported and would change the answer") ==
        0);
}
