// SPDX-License-Identifier: BSD-3-Clause
// Rigid bodies and analytic planes in quasi-static procedures by the program.
#include <cmath>

#include "support/catch.hpp"
#include "support/exodus_file.hpp"
#include "support/mesh_builder.hpp"
#include "support/program_run.hpp"

using Catch::Matchers::Contains;
using contactsim::test::MeshBuilder;
using contactsim::test::ProgramDirectory;

namespace {

/// A directory with a rigid block on a larger elastic one.
struct Punch : ProgramDirectory {
  Punch() {
    contactsim::test::write_exodus(
        path("a.g"), MeshBuilder()
                         .add_hexes({1, "low", {3, 3, 2}, {0, 0, 0}, {3, 3, 1}})
                         .add_hexes({2, "up", {2, 2, 2}, {0.7, 0.8, 1.0}, {1.5, 1.5, 1}, false})
                         .add_node_set(1, "bottom", [](const Eigen::Vector3d& x) { return x.z() == 0.0; })
                         .build());
  }
  /// Writes the deck a.i.
  ///   sierra  further lines at the top
  void write_deck(const std::string& region, const std::string& sierra = "") const {
    write("a.i",
          "begin sierra\n" + sierra +
              "begin material m\ndensity = 8000\nbegin parameters for model elastic\n"
              "youngs modulus = 1e6\npoissons ratio = 0.3\nend\nend\n"
              "begin function ramp\ntype = piecewise linear\nbegin values\n0 0\n1 1\nend\nend\n"
              "begin rigid body punch\nend\nbegin solid section rigid\nrigid body = punch\nend\n"
              "begin finite element model f\nbegin parameters for block low\nmaterial = m\nmodel = elastic\n"
              "end\nbegin parameters for block up\nmaterial = m\nmodel = elastic\nsection = rigid\nend\nend\n"
              "begin adagio procedure p\nbegin time control\nbegin time stepping block t\nstart time = 0\n"
              "begin parameters for adagio region r\ntime increment = 0.25\nend\nend\n"
              "termination time = 1\nend\n"
              "begin adagio region r\nuse finite element model f\n"
              "begin fixed displacement\nnode set = bottom\ncomponents = x y z\nend\n"
              "begin heartbeat output\nstream name = a.csv\nprecision = 17\nat step 0 increment = 1\n"
              "global reactz_punch as force\nglobal displz_punch as way\nglobal rreacty_punch as moment\n"
              "end\n" +
              region + "end\nend\nend\n");
  }
  /// The last number of a column after the time.
  double last(int column) const {
    const std::string text = read("a.csv");
    std::string line = text.substr(text.rfind('\n', text.size() - 2) + 1);
    for (int i = 0; i < column; ++i) line = line.substr(line.find(',') + 1);
    return std::stod(line);
  }
};

const std::string rough_contact =
    "begin contact definition c\nskin all blocks = on\nbegin constant friction model rough\n"
    "friction coefficient = 0.3\nend\nbegin interaction defaults\ngeneral contact = on\n"
    "friction model = rough\nend\nend\n";
const std::string tied_contact =
    "begin contact definition c\nskin all blocks = on\nbegin tied model glue\nend\n"
    "begin interaction defaults\ngeneral contact = on\nfriction model = glue\nend\nend\n";
const std::string slides =
    "begin prescribed displacement\nblock = up\ncomponent = z\nfunction = ramp\nscale factor = -0.02\nend\n"
    "begin prescribed displacement\nblock = up\ncomponent = x\nfunction = ramp\nscale factor = 0.05\nend\n"
    "begin fixed displacement\nblock = up\ncomponent = y\nend\n"
    "begin fixed rotation\nblock = up\ncomponents = x y z\nend\n";
const std::string weight =
    "begin gravity\nblock = up\ncomponent = z\nfunction = ramp\ngravitational constant = -1\nend\n";
const std::string newton_search =
    "begin solver\nbegin cg\nbegin full tangent preconditioner\nend\nend\nend\n";

}  // namespace

TEST_CASE("rigid bodies of load steps have the same bytes for any number of threads", "[app][statics]") {
  const Punch punch;
  punch.write_deck(slides + rough_contact + newton_search);
  REQUIRE(punch.run({"a.i", "--threads", "1"}).exit_code == 0);
  const std::string one = punch.read("a.csv");
  REQUIRE(punch.run({"a.i", "--threads", "2"}).exit_code == 0);
  CHECK(punch.read("a.csv") == one);
  CHECK(punch.last(1) < -1000.0);
  CHECK(punch.last(2) == Approx(-0.02));
  CHECK(std::abs(punch.last(3)) > 1.0);  // friction tilts what conditions hold
}

TEST_CASE("rigid bodies of load steps go on from a stored state with the same bytes", "[app][statics]") {
  const Punch punch;
  const std::string stored = "begin restart data\nat step 0 increment = 2\nend\n";
  const std::string region = GENERATE(slides + rough_contact, weight + tied_contact) + newton_search + stored;
  punch.write_deck(region);
  REQUIRE(punch.run({"a.i"}).exit_code == 0);
  const std::string straight = punch.read("a.csv");
  punch.write_deck(region, "restart time = 0.5\n");
  REQUIRE(punch.run({"a.i"}).exit_code == 0);
  const std::string rest = punch.read("a.csv-s0002");
  const std::string lines = rest.substr(rest.find('\n') + 1);
  CHECK(lines.size() > 40);
  CHECK(straight.substr(straight.size() - lines.size()) == lines);
}

TEST_CASE("a rigid body that nothing else holds hangs on a tie", "[app][statics]") {
  const Punch punch;
  for (const std::string& search : {std::string(), newton_search}) {
    punch.write_deck(weight + tied_contact + search);
    REQUIRE(punch.run({"a.i"}).exit_code == 0);
    CHECK(punch.last(2) < -1e-3);
    CHECK(punch.last(1) == 0.0);
  }
}

TEST_CASE("a rigid body that nothing holds is named", "[app][statics]") {
  const Punch punch;
  for (const std::string& search : {std::string(), newton_search}) {
    punch.write_deck(weight + search);
    const auto [code, out, err] = punch.run({"a.i"});
    CHECK(code == 4);
    CHECK_THAT(err, Contains("no equilibrium is found") && Contains("which nothing else holds, to 'punch'"));
  }
}

TEST_CASE("the log tells the equation solver, and why it is not the one of the deck", "[app][statics]") {
  const Punch punch;
  const auto with = [](const std::string& solver) {
    return "begin solver\nbegin cg\nbegin full tangent preconditioner\nlinear solver = " + solver +
           "\nend\nend\nend\n";
  };
  punch.write_deck(weight + tied_contact + with("amg"));
  const auto free = punch.run({"a.i"});
  REQUIRE(free.exit_code == 0);
  CHECK_THAT(free.out, Contains("equilibrium by Newton's steps, equations by DIRECT") &&
                           Contains("as the deck asks: a rigid body is"));
  CHECK_THAT(free.err, Contains("LINEAR SOLVER = AMG is DIRECT here: a rigid body is not wholly held"));
  punch.write_deck(slides + rough_contact + with("amg"));
  const auto held = punch.run({"a.i"});
  CHECK_THAT(held.out, Contains("equations by AMG, multigrid\n"));
  CHECK_THAT(held.err, !Contains("LINEAR SOLVER"));
  punch.write_deck(slides + rough_contact + with("auto"));
  CHECK_THAT(punch.run({"a.i"}).out, Contains(": there are at most 5000 nodes"));
  punch.write_deck(slides + rough_contact);
  const auto nodal = punch.run({"a.i"});
  CHECK_THAT(nodal.out, Contains("equilibrium by conjugate gradients with nodal blocks"));
  CHECK_THAT(nodal.out, Contains("Contact search") && !Contains("stable time step"));
}
