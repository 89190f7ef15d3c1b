// SPDX-License-Identifier: BSD-3-Clause
#include "parser/explain.hpp"

#include <sstream>
#include <vector>

#include "parser/command_tree.hpp"
#include "support/catch.hpp"

using namespace contactsim;

namespace {

std::string explained(const std::vector<std::string>& words) { return explain(words).text; }

bool holds_line(const std::string& text, const std::string& line) {
  return ("\n" + text).find("\n" + line + "\n") != std::string::npos;
}

std::size_t widest_line(const std::string& text) {
  std::istringstream lines(text);
  std::size_t widest = 0;
  for (std::string line; std::getline(lines, line);) widest = std::max(widest, line.size());
  return widest;
}

}  // namespace

TEST_CASE("without words the tree of blocks is shown", "[parser][explain]") {
  const std::string tree = explained({});
  CHECK(holds_line(tree, "BEGIN SIERRA [<title>]                                  A whole run"));
  CHECK(
      holds_line(tree,
                 "  BEGIN FUNCTION <name>                                 A function of time, of place or of "
                 "variables"));
  CHECK(holds_line(
      tree, "    BEGIN VALUES                                        The points of a function, one a line"));
  CHECK(tree.find("BEGIN SPRING SUPPORT SECTION <name>") != std::string::npos);
  CHECK(widest_line(tree) <= 100);
}

TEST_CASE("a command is explained with its place, syntax, default and support", "[parser][explain]") {
  CHECK(
      explained({"Time", "step", "INCREASE", "factor"}) ==
      "TIME STEP INCREASE FACTOR = <real > 0>\n"
      "  Largest growth from one step to the next [1]\n"
      "  dimension  1\n"
      "  default    1.1\n"
      "  support    supported\n"
      "  in         sierra > presto procedure > time control > time stepping block > parameters for presto\n"
      "             region\n");
}

TEST_CASE("underscores and BEGIN do not matter to a question", "[parser][explain]") {
  CHECK(explained({"time_step_increase_factor"}) == explained({"time", "step", "increase", "factor"}));
  CHECK(explained({"begin", "time", "control"}) == explained({"time control"}));
  CHECK(explained({"parameters for model elastic plastic"}).find("YIELD STRESS") != std::string::npos);
}

TEST_CASE("what a command names, needs and stands for is reported", "[parser][explain]") {
  CHECK(holds_line(explained({"start", "time"}), "  default    required"));
  CHECK(holds_line(explained({"failure", "function"}), "  names      a function"));
  CHECK(holds_line(explained({"include", "nodes", "in"}), "  names      a node set of the mesh"));
  CHECK(holds_line(explained({"angular", "velocity"}),
                   "  choice     one of MAGNITUDE, ANGULAR VELOCITY or FUNCTION"));
  CHECK(holds_line(explained({"inactive", "periods"}),
                   "  choice     at most one of ACTIVE PERIODS or INACTIVE PERIODS"));
}

TEST_CASE("a block is explained with what it holds", "[parser][explain]") {
  CHECK(
      explained({"begin", "time", "control"}) ==
      "BEGIN TIME CONTROL [<name>]\n"
      "  When the procedure begins and ends, and its time steps\n"
      "  support    supported\n"
      "  in         sierra > presto procedure\n"
      "  holds\n"
      "    BEGIN TIME STEPPING BLOCK <name>                    A period: from its start time to that of the\n"
      "                                                        next such block\n"
      "    TERMINATION TIME = <real>                           When the procedure ends [time]\n");
}

TEST_CASE("rows that say the same in several blocks are one entry", "[parser][explain]") {
  const std::string text = explained({"thickness scale factor"});
  CHECK(text ==
        "THICKNESS SCALE FACTOR = <real > 0>\n"
        "  Factor of the thickness [1]\n"
        "  dimension  1\n"
        "  default    1\n"
        "  support    supported\n"
        "  in         sierra > shell section\n"
        "  in         sierra > membrane section\n");
}

TEST_CASE("another spelling finds its row", "[parser][explain]") {
  const std::string text = explained({"solid", "mechanics", "use", "model"});
  CHECK(holds_line(text, "MODEL = <model>"));
  CHECK(holds_line(text, "  also       solid mechanics use model"));
}

TEST_CASE("ignored and refused commands are called that", "[parser][explain]") {
  CHECK(holds_line(explained({"mpc"}), "  support    refused: it would change the answer"));
  CHECK(holds_line(explained({"decomposition method"}), "  support    ignored: read, without effect"));
}

TEST_CASE("a question that nothing answers gets the nearest phrases", "[parser][explain]") {
  const std::string text = explained({"frictoin"});
  CHECK(text.find("No block or command is called 'frictoin'. The nearest are\n") == 0);
  CHECK(holds_line(text, "  friction coefficient"));
  CHECK(explained({"termination tiem"}).find("  termination time\n") != std::string::npos);
}

TEST_CASE("every row can be asked for and fits the page", "[parser][explain]") {
  for (const TreeRow& entry : command_tree()) {
    if (entry.row->phrase.empty()) continue;
    INFO(entry.row->phrase);
    const std::string text = explained({entry.row->phrase});
    CHECK(text.find(entry.row->help.substr(1, 20)) != std::string::npos);
    CHECK(widest_line(text) <= 100);
  }
}
