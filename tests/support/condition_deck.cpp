// SPDX-License-Identifier: BSD-3-Clause
#include "support/condition_deck.hpp"

#include <stdexcept>

#include "parser/commands/region_commands.hpp"
#include "parser/commands/sierra_commands.hpp"
#include "parser/text/syntax.hpp"

namespace contactsim::test {

namespace {

constexpr const char* definition_lines =
    "begin function one\n type = constant\n begin values\n 1\n end\nend\n"
    "begin function ramp\n type = analytic\n evaluate expression = \"x\"\nend\n"
    "begin function bad\n type = analytic\n evaluate expression = \"1/(x-1)\"\nend\n"
    "begin function at_x\n type = analytic\n expression variable: p = nodal coordinates(x)\n"
    " evaluate expression = \"2*p\"\nend\n"
    "begin function bad_at_x\n type = analytic\n expression variable: p = nodal_vector coordinates\n"
    " evaluate expression = \"1/(p_x-1)\"\nend\n"
    "begin function of_stress\n type = analytic\n expression variable: s = element stress(xx)\n"
    " evaluate expression = \"s\"\nend\n"
    "define point origin with coordinates 0 0 0\n"
    "define point right with coordinates 1 0 0\n"
    "define direction up with vector 0 0 2\n"
    "define direction slanted with vector 3 4 0\n"
    "define direction across with vector -4 3 0\n"
    "define axis spin with point origin direction up\n"
    "define axis rightward with point origin point right\n"
    "define axis none with point right point right\n"
    "begin finite element model m\n alias block_1 as body\nend\n";

template <class T>
T bind_lines(const Table<T>& table, const std::string& file, const std::string& lines) {
  Diagnostics diagnostics;
  const Block block = parse_syntax(make_source(file, lines), diagnostics);
  Binding binding{diagnostics};
  T target;
  table.bind(block, target, binding);
  if (!diagnostics.empty()) throw std::logic_error("the test's deck is wrong:\n" + messages(diagnostics));
  return target;
}

TimeSteppingBlock period(const std::string& name, double start) {
  TimeSteppingBlock block;
  block.name.text = name;
  block.start_time = start;
  return block;
}

}  // namespace

ConditionDeck::ConditionDeck(const Mesh& mesh, const std::string& region_lines, double start,
                             const StoredVariables* stored)
    : mesh_(mesh), stored_(stored) {
  static const Table<SimulationDefinition> definitions(definition_rows());
  definition_ = bind_lines(definitions, "d.i", definition_lines);
  Procedure& procedure = definition_.procedures.emplace_back();
  procedure.regions.push_back(bind_lines(region_table(), "c.i", region_lines));
  procedure.time_control.emplace().time_stepping_blocks = {period("p1", start), period("p2", 1.0),
                                                           period("p3", 2.0)};
}

}  // namespace contactsim::test
