// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/death_commands.hpp"

#include "parser/commands/entity_set_commands.hpp"
#include "parser/commands/row_lists.hpp"
#include "parser/commands/variable_readers.hpp"

namespace contactsim {

namespace {

/// [KILL WHEN <n> INTEGRATION POINTS REMAIN]
std::optional<std::int64_t> read_remaining_points(Arguments& arguments) {
  if (!arguments.accept("kill")) return std::nullopt;
  arguments.expect("when");
  const std::int64_t n = arguments.non_negative_integer();
  arguments.expect("integration");
  if (!arguments.accept("point")) arguments.expect("points");
  if (!arguments.accept("remains")) arguments.expect("remain");
  return n;
}

DeathCriterion read_element_criterion(Arguments& arguments) {
  ElementCriterion criterion{read_variable_test(arguments), std::nullopt};
  criterion.remaining_points = read_remaining_points(arguments);
  return criterion;
}

void read_criterion(Arguments& arguments, ElementDeath& death) {
  using R = NodalCriterion::Reduction;
  static const Choices forms({"avg nodal value of", "average nodal value of", "max nodal value of",
                              "maximum nodal value of", "min nodal value of", "minimum nodal value of",
                              "element value of", "global value of", "always true"});
  static constexpr R reductions[] = {R::average, R::average, R::maximum, R::maximum, R::minimum, R::minimum};
  const std::size_t form = arguments.choice(forms);
  if (form < std::size(reductions)) {
    death.criteria.emplace_back(NodalCriterion{reductions[form], read_variable_test(arguments)});
  } else if (form == 6) {
    death.criteria.push_back(read_element_criterion(arguments));
  } else if (form == 7) {
    death.criteria.emplace_back(GlobalCriterion{read_variable_test(arguments)});
  } else {
    death.criteria.emplace_back(AlwaysCriterion{});
  }
}

void read_material_criterion(Arguments& arguments, ElementDeath& death) {
  const bool is_on = arguments.on_off();
  const auto remaining = read_remaining_points(arguments);
  if (is_on) death.criteria.emplace_back(MaterialCriterion{remaining});
}

void read_method(Arguments& arguments, ElementDeath&) {
  static const Choices methods({"deactivate element", "deactivate nodal mpcs", "disconnect element"});
  if (arguments.at_end()) arguments.fail_here("expected DEACTIVATE ELEMENT after 'death method'");
  const Word& value = arguments.peek();
  if (arguments.choice(methods) != 0) {
    arguments.refuse(value, "only DEATH METHOD = DEACTIVATE ELEMENT is supported");
  }
}

std::vector<Row<ElementDeath>> criterion_rows() {
  using D = ElementDeath;
  return {
      row<D>("criterion",
             "IS {{AVG|MAX|MIN} NODAL|ELEMENT|GLOBAL} VALUE OF <variable> {<|<=|=|>=|>} <real> "
             "[KILL WHEN <n> INTEGRATION POINTS REMAIN], or IS ALWAYS TRUE",
             read_criterion,
             "Kills an element when it holds, in the variable's dimension; any criterion of several", "none"),
      row<D>("material criterion", "= {ON|OFF} [KILL WHEN <n> INTEGRATION POINTS REMAIN]",
             read_material_criterion, "Kills an element when its material model has failed", "OFF"),
      row("death on inversion", read::on_off, &D::on_inversion, "Kills inverted elements"),
      row("death on ill defined contact", read::on_off, &D::on_ill_defined_contact,
          "Kills elements whose contact faces have lost their shape"),
  };
}

std::vector<Row<ElementDeath>> timing_rows() {
  using D = ElementDeath;
  return {
      row("check step interval", read::positive_integer, &D::check_step_interval,
          "Steps [1] between two checks"),
      row("check time interval", read::positive, &D::check_time_interval,
          "Least time between two checks [time]"),
      row("death start time", read::real, &D::start_time, "No element dies before it [time]"),
      row("death steps", read::positive_integer, &D::death_steps,
          "Steps [1] over which the stress of a dying element fades"),
      row("aggressive contact cleanup", read::on_off, &D::cleans_contact_aggressively,
          "Kills solids too that have lost their last face neighbour by a death"),
      row("nodal erosion", read::on_off, &D::erodes_nodes,
          "Nodes whose elements are all dead leave contact, as if these had never been there; OFF keeps them "
          "as free masses that meet faces; contactsim's own line"),
      row("new edges on death", read::on_off, &D::makes_new_edges,
          "Edges that deaths expose become edges of contact as others; contactsim's own line"),
      row<D>("death method", "= {DEACTIVATE ELEMENT|DEACTIVATE NODAL MPCS|DISCONNECT ELEMENT}", read_method,
             "What happens to a dead element; the last two are refused", "DEACTIVATE ELEMENT"),
  };
}

std::vector<Row<ElementDeath>> other_rows() {
  using D = ElementDeath;
  static const auto log = choice_of<DeathLog>({"minimal", "some", "full"});
  return {
      row("summary output step interval", read::positive_integer, &D::summary_step_interval,
          "Steps [1] between two reports of deaths in the log; absent: one whenever something dies"),
      row("summary output time interval", read::positive, &D::summary_time_interval,
          "Time between two reports of deaths in the log [time]"),
      row("logfile output", log, &D::log,
          "What the log tells of deaths: how many, also the surfaces that changed, also the whole table"),
      ignored<D>("skip criteria evaluation at start of load step", "= {ON|OFF}", "Of implicit runs only"),
      ignored<D>("force valid acme connectivity", "", "Of ACME; surfaces follow element death by themselves"),
      refused_block<D>("death proximity", "Elements near a dead one are not killed"),
  };
}

void check(const ElementDeath& death, DeckNames& names) {
  if (!death.criteria.empty() || death.on_inversion || death.on_ill_defined_contact) return;
  names.add_problem_of_block("has no criterion", "give it a CRITERION line");
}

}  // namespace

const Table<ElementDeath>& element_death_table() {
  using D = ElementDeath;
  static const Choice must_pick_elements{"picks no elements", ""};
  static const Table<D> table(joined<D>({
                                  lift_all(entity_set_rows(must_pick_elements), &D::set),
                                  {row("include blocks with material", read::names_of(NameKind::material),
                                       &D::materials, "Adds the blocks of these materials")
                                       .one_of(must_pick_elements)},
                                  criterion_rows(),
                                  timing_rows(),
                                  other_rows(),
                              }),
                              check);
  return table;
}

}  // namespace contactsim
