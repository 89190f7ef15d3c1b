// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/friction_commands.hpp"

#include "support/bound_region.hpp"
#include "support/catch.hpp"

using namespace contactsim;

namespace {

/// What is said about friction models when an interaction uses one of them. The first line of `models` is
/// line 6.
std::string use_of(const std::string& model, const std::string& models) {
  return contact_name_messages(
      "contact surface s contains b\nbegin interaction\nsurfaces = s s\nfriction model = " + model + "\n" +
      "end\n" + models);
}

}  // namespace

TEST_CASE("frictionless and tied need no definition but may have one", "[parser][friction]") {
  CHECK(use_of("FRICTIONLESS", "") == "");
  CHECK(use_of("Tied", "") == "");
  CHECK(use_of("tied", "begin tied model tied\nend\n") == "");
  CHECK(use_of("frictionless", "begin frictionless model frictionless\nend\n") == "");
}

TEST_CASE("a friction model may be used before it is defined, in any case", "[parser][friction]") {
  CHECK(use_of("RUB", "begin constant friction model rub\nend\n") == "");
}

TEST_CASE("an unknown friction model is an error at the reference", "[parser][friction]") {
  CHECK(use_of("rob", "begin constant friction model rub\nend\n") ==
        "a.i:5:18: error: unknown friction model 'rob'; did you mean 'rub'?\n");
  CHECK(use_of("rob", "") ==
        "a.i:5:18: error: unknown friction model 'rob'; the deck has no friction model: BEGIN CONSTANT "
        "FRICTION MODEL <name>, say\n");
}

TEST_CASE("a material named as friction model is distinguished", "[parser][friction]") {
  CHECK(use_of("steel", "") ==
        "a.i:5:18: error: 'steel' is a material, not a friction model; cohesive materials as "
        "friction models are not supported\n");
  CHECK(use_of("steel", "begin tied model steel\nend\n") == "");
}

TEST_CASE("equal models of one name are a warning, unequal ones an error", "[parser][friction]") {
  const std::string first = "begin constant friction model rub\nfriction coefficient = 0.3\nend\n";
  CHECK(use_of("rub", first + "begin constant friction model RUB\nfriction coefficient = 0.30\nend\n") ==
        "a.i:10:31: warning: the friction model 'RUB' is defined twice, with equal content; the "
        "first stands at a.i:7:31 [deck-duplicate]\n");
  CHECK(
      use_of("rub", first + "begin constant friction model rub\nfriction coefficient = 0.4\nend\n") ==
      "a.i:10:31: error: the friction model 'rub' is defined a second time; the first stands at a.i:7:31\n");
  CHECK(
      use_of("rub", first + "begin tied model rub\nend\n") ==
      "a.i:10:18: error: the friction model 'rub' is defined a second time; the first stands at a.i:7:31\n");
}

TEST_CASE("equality looks at the names in a model, without case", "[parser][friction]") {
  const std::string first = "begin adhesion model a\nadhesion function = f\nend\n";
  CHECK(use_of("a", first + "begin adhesion model a\nadhesion function = F\nend\n").find("warning") !=
        std::string::npos);
  CHECK(use_of("a", first + "begin adhesion model a\nadhesion function = g\nend\n").find("error") !=
        std::string::npos);
}

TEST_CASE("what a used model needs is reported when it is missing", "[parser][friction]") {
  CHECK(use_of("m", "begin spring weld model m\nend\n") ==
        "a.i:7:25: error: the friction model 'm' has no NORMAL DISPLACEMENT FUNCTION; add NORMAL "
        "DISPLACEMENT FUNCTION = <function>\n"
        "a.i:7:25: error: the friction model 'm' has no TANGENTIAL DISPLACEMENT FUNCTION; add TANGENTIAL "
        "DISPLACEMENT FUNCTION = <function>\n");
  CHECK(use_of("m", "begin area weld model m\nnormal capacity = 1\nend\n") ==
        "a.i:7:23: error: the friction model 'm' has no TANGENTIAL CAPACITY; add TANGENTIAL CAPACITY = <real "
        "> 0>\n");
  CHECK(use_of("m", "begin adhesion model m\nend\n") ==
        "a.i:7:22: error: the friction model 'm' has no ADHESION FUNCTION; add ADHESION FUNCTION = "
        "<function>\n");
  CHECK(use_of("m",
               "begin cohesive zone model m\ntraction displacement function = f\ncritical normal gap = "
               "1\nend\n") ==
        "a.i:7:27: error: the friction model 'm' has no CRITICAL TANGENTIAL GAP; add CRITICAL TANGENTIAL GAP "
        "= <real > 0>\n");
  CHECK(use_of("m", "begin junction model m\nnormal traction function = f\nend\n") ==
        "a.i:7:22: error: the friction model 'm' has no TANGENTIAL TRACTION FUNCTION; add TANGENTIAL "
        "TRACTION FUNCTION = <function>\n");
  CHECK(use_of("m",
               "begin threaded model m\nnormal traction function = f\ntangential traction function = g\n"
               "normal capacity = 1\nend\n") ==
        "a.i:7:22: error: the friction model 'm' has no TANGENTIAL CAPACITY; add TANGENTIAL CAPACITY = <real "
        "> 0>\n");
  CHECK(use_of("m", "begin pv_dependent model m\nend\n") == "");  // two coefficients need no more
  CHECK(use_of("m", "begin time variant model m\nend\n") ==
        "a.i:7:26: error: the friction model 'm' has no MODEL; add MODEL = <model> DURING PERIODS <period> "
        "...\n");
}

TEST_CASE("a model that nothing uses is not looked into", "[parser][friction]") {
  CHECK(use_of("tied",
               "begin adhesion model m\nadhesion function = nowhere\nend\nbegin area weld model w\nend\n") ==
        "");
}

TEST_CASE("models are used through others, and their names are looked up", "[parser][friction]") {
  CHECK(use_of("h",
               "begin hybrid model h\ninitially close = v\ninitially far = tied\nend\n"
               "begin time variant model v\nmodel = w during periods p1 p9\nend\n"
               "begin surface weld model w\nnormal capacity = 1\ntangential capacity = 1\nfailed model = "
               "x\nend\n") ==
        "a.i:12:29: error: unknown time stepping block 'p9'; did you mean 'p1'?\n"
        "a.i:17:16: error: unknown friction model 'x'; did you mean 'h'?\n");
  CHECK(use_of("a", "begin adhesion model a\nadhesion function = ff\nend\n") ==
        "a.i:8:21: error: unknown function 'ff'; did you mean 'f'?\n");
}

TEST_CASE("a model that selects itself is an error, a weld that fails into itself is not",
          "[parser][friction]") {
  CHECK(use_of("h",
               "begin hybrid model h\ninitially close = v\nend\n"
               "begin time variant model v\nmodel = h during periods p1\nend\n") ==
        "a.i:7:20: error: the friction model 'h' selects itself\n"
        "a.i:10:26: error: the friction model 'v' selects itself\n");
  CHECK(use_of("w",
               "begin surface weld model w\nnormal capacity = 1\ntangential capacity = 1\nfailed model = "
               "w\nend\n") == "");
}
