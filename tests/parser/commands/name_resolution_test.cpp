// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/name_resolution.hpp"

#include "support/catch.hpp"
#include "support/parsed_deck.hpp"

using namespace contactsim;

namespace {

/// The lines at Sierra scope, with a procedure behind them whose region holds more lines and uses the model
/// fem.
ParsedDeck with_region(const std::string& sierra_lines, const std::string& region_lines) {
  return parsed_sierra(sierra_lines +
                       "begin finite element model fem\nend\n"
                       "begin presto procedure p\nbegin presto region r\nuse finite element model fem\n" +
                       region_lines + "end\nend\n");
}

}  // namespace

TEST_CASE("names may be used before they are defined, in any case", "[parser][names]") {
  CHECK(parsed_sierra(
            "begin presto procedure p\n"
            "begin presto region r\n"
            "  use finite element model FEM\n"
            "  begin prescribed velocity\n"
            "    block = block_1\n"
            "    direction = DOWN\n"
            "    function = Ramp\n"
            "  end\n"
            "end\n"
            "begin time control\n"
            "  begin time stepping block t\n"
            "    start time = 0\n"
            "    begin parameters for presto region R\n    end\n"
            "  end\n"
            "  termination time = 1\n"
            "end\n"
            "end\n"
            "begin finite element model fem\n"
            "  begin parameters for block block_1\n"
            "    section = SHELLS\n"
            "    material = STEEL\n"
            "    model = Elastic\n"
            "  end\n"
            "end\n"
            "begin shell section shells\n  thickness = 1\n  rigid body = RB\nend\n"
            "begin rigid body rb\n  direction = Down\n  cylindrical axis = A\nend\n"
            "begin material steel\n"
            "  density = 1\n"
            "  begin parameters for model ELASTIC\n    youngs modulus = 1\n    poissons ratio = 0\n  end\n"
            "end\n"
            "define axis a with point P direction DOWN\n"
            "define direction down with vector 0 0 -1\n"
            "define point p with coordinates 0 0 0\n"
            "begin function ramp\n  type = piecewise linear\n  begin values\n    0 0\n    1 1\n  end\nend\n")
            .messages == "");
}

TEST_CASE("each kind of name that is missing is reported where it is used", "[parser][names]") {
  CHECK(with_region("begin rigid body rb\nend\n",
                    "begin prescribed velocity\nblock = b\ndirection = dwn\nfunction = rmap\nend\n"
                    "begin prescribed rotation\nrigid body = rc\ncylindrical axis = a\nfunction = f\nend\n")
            .messages ==
        "a.i:11:13: error: unknown direction 'dwn'; the deck has no direction: DEFINE DIRECTION <name> WITH "
        "VECTOR <x> <y> <z>\n"
        "a.i:12:12: error: unknown function 'rmap'; the deck has no function\n"
        "a.i:15:14: error: unknown rigid body 'rc'; did you mean 'rb'?\n"
        "a.i:16:20: error: unknown axis 'a'; the deck has no axis\n"
        "a.i:17:12: error: unknown function 'f'; the deck has no function\n");
}

TEST_CASE("the function that is always one needs no definition", "[parser][names]") {
  CHECK(with_region("define direction down with vector 0 0 -1\n",
                    "begin prescribed velocity\nblock = b\ndirection = down\nfunction = "
                    "SIERRA_CONSTANT_FUNCTION_ONE\nend\n")
            .messages == "");
}

TEST_CASE("points and directions of an axis must be there when the axis is used", "[parser][names]") {
  const std::string axes = "define axis a with point p direction d\ndefine axis b with point q point s\n";
  CHECK(with_region(axes, "").messages == "");
  CHECK(with_region(axes + "begin function f\ntype = constant\nbegin values\n1\nend\nend\n",
                    "begin prescribed rotation\nblock = x\ncylindrical axis = a\nfunction = f\nend\n"
                    "begin prescribed rotation\nblock = y\ncylindrical axis = b\nfunction = f\nend\n")
            .messages ==
        "a.i:2:26: error: unknown point 'p'; the deck has no point\n"
        "a.i:2:38: error: unknown direction 'd'; the deck has no direction: DEFINE DIRECTION <name> WITH "
        "VECTOR <x> <y> <z>\n"
        "a.i:3:26: error: unknown point 'q'; the deck has no point\n"
        "a.i:3:34: error: unknown point 's'; the deck has no point\n");
}

TEST_CASE("a second definition of a name is an error of its kind alone", "[parser][names]") {
  CHECK(parsed_sierra("begin rigid body x\nend\n"
                      "begin solid section x\nend\n"
                      "begin shell section X\nend\n"
                      "define point x with coordinates 0 0 0\n"
                      "define point x with coordinates 0 0 1\n"
                      "begin presto procedure p\nend\n"
                      "begin presto procedure p\nend\n")
            .messages ==
        "a.i:6:21: error: the section 'X' is defined a second time; the first stands at a.i:4:21\n"
        "a.i:9:14: error: the point 'x' is defined a second time; the first stands at a.i:8:14\n"
        "a.i:12:24: error: the procedure 'p' is defined a second time; the first stands at a.i:10:24\n");
}

TEST_CASE("what only unused definitions name is not looked up", "[parser][names]") {
  CHECK(with_region(
            "begin solid section s\nrigid body = nobody\nend\n"
            "begin finite element model other\nbegin parameters for block b\nmaterial = nothing\nend\nend\n",
            "")
            .messages == "");
}

TEST_CASE("in a deck of contact alone names may be defined elsewhere", "[parser][names]") {
  CHECK(parsed("begin finite element model m\nbegin parameters for block b\nmaterial = steel\nsection = "
               "s\nend\nend\n"
               "begin shell section s\nrigid body = rb\nthickness = 1\nend\n"
               "skin all blocks = on\n")
            .messages == "");
}

TEST_CASE("periods are those of the procedure", "[parser][names]") {
  const std::string control =
      "begin time control\nbegin time stepping block t1\nstart time = 0\nend\ntermination time = 1\nend\n";
  const std::string condition =
      "begin fixed displacement\nblock = b\ncomponents = x\nactive periods = t1 t2\nend\n";
  CHECK(parsed_sierra("begin finite element model m\nend\nbegin presto procedure p\n" + control +
                      "begin presto region r\nuse finite element model m\n" + condition + "end\nend\n")
            .messages == "a.i:16:21: error: unknown time stepping block 't2'; did you mean 't1'?\n");
}
