// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/death_commands.hpp"

#include "support/bound_region.hpp"
#include "support/catch.hpp"

using namespace contactsim;

namespace {

ElementDeath death_of(const std::string& lines) {
  const BoundRegion bound = bound_region("begin element death d\n" + lines + "end\n");
  CHECK(bound.messages == "");
  return bound.region.element_deaths.at(0);
}

std::string death_messages(const std::string& lines) {
  return bound_region("begin element death d\n" + lines + "end\n").messages;
}

}  // namespace

TEST_CASE("element death has defaults", "[parser][death]") {
  const ElementDeath death = death_of("block = b\n");
  CHECK(death.name.text == "d");
  CHECK(death.criteria.empty());
  CHECK(death.check_step_interval == 1);
  CHECK_FALSE(death.check_time_interval);
  CHECK_FALSE(death.start_time);
  CHECK_FALSE(death.on_inversion);
  CHECK_FALSE(death.on_ill_defined_contact);
  CHECK(death.death_steps == 1);
  CHECK_FALSE(death.cleans_contact_aggressively);
}

TEST_CASE("every form of criterion is bound, in order", "[parser][death]") {
  const ElementDeath death = death_of(
      "criterion is avg nodal value of coordinates(x) >= 3\ncriterion is max nodal value of velocity(z) > "
      "1e3\n"
      "criterion is min nodal value of temperature < -5\n"
      "criterion is element value of eqps > 0.2 kill when 3 integration points remain\n"
      "criterion = element value of von_mises > 2.0e6\ncriterion is global value of time > 1\n"
      "criterion is always true\nmaterial criterion = on kill when 1 integration points remain\n");
  REQUIRE(death.criteria.size() == 8);
  const auto average = std::get<NodalCriterion>(death.criteria[0]);
  CHECK(average.reduction == NodalCriterion::Reduction::average);
  CHECK(average.test.variable.name.text == "coordinates");
  CHECK(average.test.variable.component == "x");
  CHECK(std::get<NodalCriterion>(death.criteria[1]).reduction == NodalCriterion::Reduction::maximum);
  CHECK(std::get<NodalCriterion>(death.criteria[2]).reduction == NodalCriterion::Reduction::minimum);
  CHECK(std::get<NodalCriterion>(death.criteria[2]).test.value == -5.0);
  CHECK(std::get<ElementCriterion>(death.criteria[3]).remaining_points == 3);
  CHECK_FALSE(std::get<ElementCriterion>(death.criteria[4]).remaining_points);
  CHECK(std::get<GlobalCriterion>(death.criteria[5]).test.variable.name.text == "time");
  CHECK(std::holds_alternative<AlwaysCriterion>(death.criteria[6]));
  CHECK(std::get<MaterialCriterion>(death.criteria[7]).remaining_points == 1);
}

TEST_CASE("a material criterion that is off is none", "[parser][death]") {
  CHECK(death_of("material criterion = off\n").criteria.empty());
}

TEST_CASE("element death takes all of its lines", "[parser][death]") {
  const ElementDeath death = death_of(
      "include all blocks\nremove block = b\ninclude blocks with material = steel foam\ncheck step interval "
      "= 10\n"
      "check time interval = 1e-5\ndeath start time = 1e-3\ndeath on inversion = on\n"
      "death on ill defined contact = on\ndeath steps = 5\naggressive contact cleanup = on\n"
      "death method = deactivate element\n");
  CHECK(death.set.includes_all_blocks);
  CHECK(joined_names(death.set.removed_blocks) == "b");
  CHECK(joined_names(death.materials) == "steel foam");
  CHECK(death.check_step_interval == 10);
  CHECK(death.check_time_interval == 1e-5);
  CHECK(death.start_time == 1e-3);
  CHECK(death.on_inversion);
  CHECK(death.on_ill_defined_contact);
  CHECK(death.death_steps == 5);
  CHECK(death.cleans_contact_aggressively);
}

TEST_CASE("other ways to die are refused", "[parser][death]") {
  CHECK(death_messages("death method = disconnect element\nbegin death proximity\nblock = b\nend\n") ==
        "a.i:2:16: error: only DEATH METHOD = DEACTIVATE ELEMENT is supported\n"
        "a.i:3:7: error: block 'death proximity' is not supported and would change the answer; "
        "elements near a dead one are not killed\n");
}

TEST_CASE("element death takes lines on reports, nodes and edges", "[parser][death]") {
  const ElementDeath plain = death_of("block = b\n");
  CHECK(plain.log == DeathLog::some);
  CHECK(plain.erodes_nodes);
  CHECK(plain.makes_new_edges);
  CHECK_FALSE(plain.summary_step_interval);
  const ElementDeath death = death_of(
      "summary output step interval = 5\nsummary output time interval = 0.5\nlogfile output = full\n"
      "nodal erosion = off\nnew edges on death = off\n");
  CHECK(death.summary_step_interval == 5);
  CHECK(death.summary_time_interval == 0.5);
  CHECK(death.log == DeathLog::full);
  CHECK_FALSE(death.erodes_nodes);
  CHECK_FALSE(death.makes_new_edges);
}

TEST_CASE("lines on implicit runs and ACME are ignored", "[parser][death]") {
  CHECK(death_messages(
            "skip criteria evaluation at start of load step = on\nforce valid acme connectivity\n") ==
        "a.i:2:1: warning: 'skip criteria evaluation at start of load step' has no effect here; "
        "of implicit runs only [deck-ignored]\n"
        "a.i:3:1: warning: 'force valid acme connectivity' has no effect here; of ACME; surfaces "
        "follow element death by themselves [deck-ignored]\n");
}

TEST_CASE("an unknown criterion lists the known ones", "[parser][death]") {
  CHECK(death_messages("criterion is element valu of x > 1\n") ==
        "a.i:2:14: error: expected one of avg nodal value of, average nodal value of, max nodal "
        "value of, maximum nodal value of, min nodal value of, minimum nodal value of, element "
        "value of, global value of, always true for 'criterion', found 'element'\n");
}
