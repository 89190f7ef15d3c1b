// SPDX-License-Identifier: BSD-3-Clause
// What is reported of procedures that follow each other before any of them runs, by the program.
#include "app/run/procedure_checks.hpp"

#include "support/catch.hpp"
#include "support/exodus_file.hpp"
#include "support/mesh_builder.hpp"
#include "support/program_run.hpp"

using Catch::Matchers::Contains;
using contactsim::test::MeshBuilder;
using contactsim::test::ProgramDirectory;

namespace {

/// What a procedure has of its own.
struct Lines {
  std::string kind, name, start, end;
  std::string transfer = {}, region = {};
};

const std::string take_all = "begin procedural transfer t\ninclude all blocks\nend\n";

std::string procedure(const Lines& of) {
  return "begin " + of.kind + " procedure " + of.name + "\n" + of.transfer +
         "begin time control\nbegin time stepping block t\nstart time = " + of.start +
         "\nbegin parameters for " + of.kind + " region " + of.name + "\n" +
         (of.kind == "adagio" ? "number of time steps = 1\n" : "") +
         "end\nend\ntermination time = " + of.end + "\nend\nbegin " + of.kind + " region " + of.name +
         "\nuse finite element model f\n" +
         "begin fixed displacement\nblock = low high\ncomponents = x y z\nend\n" + of.region + "end\nend\n";
}

/// A directory with two boxes and decks of several procedures on them.
struct TwoBoxes : ProgramDirectory {
  TwoBoxes() {
    MeshBuilder b;
    b.add_hexes({.id = 1, .name = "low"});
    b.add_hexes({.id = 2, .name = "high", .origin = {0, 0, 1.5}, .share_nodes = false});
    contactsim::test::write_exodus(path("a.g"), b.build());
  }
  contactsim::test::ProgramOutput check(const std::vector<Lines>& procedures,
                                        const std::string& sierra = "") const {
    std::string deck = "begin sierra\n" + sierra +
                       "begin material m\ndensity = 8000\nbegin parameters for model elastic\n"
                       "youngs modulus = 2e11\npoissons ratio = 0.3\nend\nend\n"
                       "begin finite element model f\ndatabase name = a.g\n"
                       "begin parameters for block low high\nmaterial = m\nmodel = elastic\nend\nend\n"
                       "begin finite element model g\ndatabase name = a.g\nomit block high\n"
                       "begin parameters for block low\nmaterial = m\nmodel = elastic\nend\nend\n";
    for (const Lines& of : procedures) deck += procedure(of);
    write("a.i", deck + "end\n");
    return run({"a.i", "--check"});
  }
  /// What is found wrong.
  std::string error(const std::vector<Lines>& procedures, const std::string& sierra = "") const {
    const auto [code, out, err] = check(procedures, sierra);
    CHECK(code == 2);
    return err;
  }
};

const Lines load{"adagio", "load", "0", "1"};
const std::string contact =
    "begin contact definition c\nskin all blocks = on\nbegin interaction defaults\ngeneral contact = "
    "on\nend\nend\n";

std::string heartbeat(const std::string& name, const std::string& more = "") {
  return "begin heartbeat output\nstream name = " + name + "\n" + more + "global kinetic_energy as k\nend\n";
}

}  // namespace

TEST_CASE("a transfer needs a procedure before it", "[app][procedures]") {
  CHECK_THAT(
      TwoBoxes().error({{"presto", "hit", "0", "1e-3", take_all}}),
      Contains(":2") && Contains("there is no procedure before 'hit' whose state could be taken over"));
}

TEST_CASE("blocks that a transfer names are looked up", "[app][procedures]") {
  CHECK_THAT(TwoBoxes().error(
                 {load, {"presto", "hit", "1", "1.001", "begin procedural transfer\nblock = hihg\nend\n"}}),
             Contains("'hihg'") && Contains("did you mean 'high'?"));
}

TEST_CASE("a state is taken over on the same mesh", "[app][procedures]") {
  std::string other = procedure({"presto", "hit", "1", "1.001", take_all});
  const TwoBoxes boxes;
  boxes.check({load, {"presto", "hit", "1", "1.001", take_all}});
  std::string deck = boxes.read("a.i");
  deck.replace(deck.rfind("model f\nbegin fixed displacement\nblock = low high"), 48,
               "model g\nbegin fixed displacement\nblock = low     ");
  boxes.write("a.i", deck);
  const auto [code, out, err] = boxes.run({"a.i", "--check"});
  CHECK(code == 2);
  CHECK_THAT(err, Contains("the procedure before works on another mesh"));
}

TEST_CASE("procedures at odds in time or without a transfer are warned of", "[app][procedures]") {
  const TwoBoxes boxes;
  const auto late = boxes.check({load, {"presto", "hit", "2", "2.001", take_all}});
  CHECK(late.exit_code == 0);
  CHECK_THAT(late.err,
             Contains("warning: the procedure 'hit' starts at time 2 with the state that 'load' comes to "
                      "at 1; functions of time jump from one to the other [procedure-times]"));
  const auto anew = boxes.check({load, {"presto", "hit", "1", "1.001"}});
  CHECK(anew.exit_code == 0);
  CHECK_THAT(anew.err, Contains("[procedure-from-mesh]"));
  CHECK(boxes.check({load, {"presto", "hit", "1", "1.001", take_all}}).err == "");
}

TEST_CASE("procedures write files of their own, or append to one", "[app][procedures]") {
  const TwoBoxes boxes;
  Lines first = load, second{"presto", "hit", "1", "1.001", take_all};
  first.region = second.region = heartbeat("a.csv");
  CHECK_THAT(boxes.error({first, second}),
             Contains("the procedure 'hit' would overwrite a.csv, which a procedure before it writes"));
  second.region = heartbeat("a.csv", "append = on\n");
  CHECK(boxes.check({first, second}).exit_code == 0);
  first.region = second.region = "begin results output\nat time 0 increment = 1\nnodal displacement\nend\n";
  CHECK_THAT(boxes.error({first, second}), Contains("the procedure 'hit' would overwrite a.e"));
  first.region = second.region = heartbeat("log");
  CHECK(boxes.check({first, second}).exit_code == 0);
  first.region = second.region = "begin restart data\nat step 0 increment = 1\nend\n";
  CHECK_THAT(boxes.error({first, second}), Contains("would overwrite a.rsout"));
}

TEST_CASE("what a transfer does not take over is refused", "[app][procedures]") {
  const TwoBoxes boxes;
  const Lines hit{"presto", "hit", "0", "1", "", contact}, go{"presto", "go", "1", "1.001", take_all};
  const std::string over = "contact of the procedure before is over: this one has none";
  CHECK_THAT(boxes.check({hit, go}).err, Contains(over));
  Lines pressed = load;
  pressed.region = contact;
  CHECK_THAT(boxes.check({pressed, go}).err, Contains(over));
  Lines meeting = go;
  meeting.region = contact;
  CHECK(boxes.check({load, meeting}).exit_code == 0);
  meeting.region = contact;
  meeting.region.insert(meeting.region.find("general"), "friction model = tied\n");
  CHECK_THAT(boxes.error({load, meeting}), Contains("contact that holds what is near at the start is not"));
  meeting.region = contact;
  meeting.region.insert(meeting.region.find("begin inter"), "remove initial overlap\n");
  CHECK_THAT(boxes.error({load, meeting}), Contains("overlap removal is not supported together with"));
  const std::string kick = "begin initial velocity\nblock = low\ncomponent = x\nmagnitude = 1\nend\n";
  const Lines fly{"presto", "fly", "0", "1"};
  Lines kicked = go;
  kicked.region = kick;
  CHECK_THAT(boxes.error({fly, kicked}), Contains("an initial velocity is not supported together with"));
  CHECK(boxes.check({load, kicked}).exit_code == 0);
  kicked.region =
      "begin initial condition\nblock = low\nvariable type = node\ninitialize variable name = "
      "displacement\nmagnitude = 1 0 0\nend\n";
  CHECK_THAT(boxes.error({load, kicked}), Contains("an initial condition of anything but velocity"));
  Lines dying{
      "presto", "dying",
      "0",      "1",
      "",       "begin element death\nblock = low\ncriterion is element value of von_mises > 1e9\nend\n"};
  CHECK_THAT(boxes.error({dying, go}), Contains("ELEMENT DEATH in the procedure before alone"));
  Lines going = go;
  going.region = dying.region;
  CHECK(boxes.check({dying, going}).exit_code == 0);
}
