// SPDX-License-Identifier: BSD-3-Clause
// Quasi-static procedures by the program: the same bytes for any number of threads and after a restart, and
// what is refused.
#include "support/catch.hpp"
#include "support/exodus_file.hpp"
#include "support/mesh_builder.hpp"
#include "support/program_run.hpp"

using Catch::Matchers::Contains;
using contactsim::test::MeshBuilder;
using contactsim::test::ProgramDirectory;

namespace {

/// A directory with a bar of 6 x 2 x 2 elastic-plastic hexahedra that is bent in load steps.
struct BentBar : ProgramDirectory {
  BentBar() {
    contactsim::test::write_exodus(
        path("a.g"), MeshBuilder()
                         .add_hexes({1, "bar", {6, 2, 2}, Eigen::Vector3d::Zero(), Eigen::Vector3d(6, 2, 2)})
                         .add_node_set(1, "clamped", [](const Eigen::Vector3d& x) { return x.x() == 0.0; })
                         .add_node_set(2, "tip", [](const Eigen::Vector3d& x) { return x.x() == 6.0; })
                         .build());
  }
  /// Writes the deck a.i.
  ///   region  further lines of the region
  ///   sierra  further lines at the top
  ///   steps   lines of its parameters for adagio region
  void write_deck(const std::string& region, const std::string& sierra = "",
                  const std::string& steps = "time increment = 0.25\n") const {
    write("a.i",
          "begin sierra\n" + sierra +
              "begin material m\ndensity = 8000\nbegin parameters for model elastic_plastic\n"
              "youngs modulus = 200e9\npoissons ratio = 0.3\nyield stress = 300e6\nhardening modulus = 1e9\n"
              "end\nend\n"
              "begin function ramp\ntype = piecewise linear\nbegin values\n0 0\n1 1\nend\nend\n"
              "begin finite element model f\nbegin parameters for block bar\nmaterial = m\nmodel = "
              "elastic_plastic\nend\nend\n"
              "begin adagio procedure p\nbegin time control\nbegin time stepping block t\nstart time = 0\n"
              "begin parameters for adagio region r\n" +
              steps +
              "end\nend\ntermination time = 1\nend\nbegin adagio region r\nuse finite element model f\n"
              "begin fixed displacement\nnode set = clamped\ncomponents = x y z\nend\n"
              "begin prescribed displacement\nnode set = tip\ncomponent = z\nfunction = ramp\n"
              "scale factor = 0.1\nend\n"
              "begin heartbeat output\nstream name = a.csv\nprecision = 17\nat step 0 increment = 1\n"
              "nodal coordinates at node 40 as place\nglobal energy_error as error\n"
              "global internal_energy as work\nend\n" +
              region + "end\nend\nend\n");
  }
};

const std::string tight = "begin solver\nbegin cg\ntarget relative residual = 1e-7\nend\nend\n";
const std::string full =
    "begin solver\nbegin cg\ntarget relative residual = 1e-7\nbegin full tangent "
    "preconditioner\nend\nend\nend\n";

}  // namespace

TEST_CASE("load steps have the same bytes for any number of threads", "[app][statics]") {
  const BentBar bar;
  for (const std::string& solver : {tight, full}) {
    bar.write_deck(solver);
    REQUIRE(bar.run({"a.i", "--threads", "1"}).exit_code == 0);
    const std::string one = bar.read("a.csv");
    REQUIRE(bar.run({"a.i", "--threads", "2"}).exit_code == 0);
    CHECK(bar.read("a.csv") == one);
  }
}

TEST_CASE("load steps go on from a stored state with the same bytes", "[app][statics]") {
  for (const std::string& solver : {tight, full}) {
    const BentBar bar;
    const std::string stored = "begin restart data\nat step 0 increment = 2\nend\n";
    bar.write_deck(solver + stored);
    REQUIRE(bar.run({"a.i"}).exit_code == 0);
    const std::string straight = bar.read("a.csv");
    bar.write_deck(solver + stored, "restart time = 0.5\n");
    REQUIRE(bar.run({"a.i"}).exit_code == 0);
    const std::string rest = bar.read("a.csv-s0002");
    const std::string lines = rest.substr(rest.find('\n') + 1);
    CHECK(lines.size() > 100);
    CHECK(straight.substr(straight.size() - lines.size()) == lines);
  }
}

TEST_CASE("both preconditioners find the same equilibrium", "[app][statics]") {
  const BentBar bar;
  bar.write_deck(tight);
  REQUIRE(bar.run({"a.i"}).exit_code == 0);
  const std::string nodal = bar.read("a.csv");
  bar.write_deck(full);
  const auto [code, out, err] = bar.run({"a.i"});
  REQUIRE(code == 0);
  CHECK_THAT(out, Contains("iterations"));
  const auto last_number = [](const std::string& text) {
    return std::stod(text.substr(text.rfind(',') + 1));
  };
  CHECK(last_number(nodal) == Approx(last_number(bar.read("a.csv"))).epsilon(1e-5));
}

TEST_CASE("what is let go comes back to rest without loads", "[app][statics]") {
  const BentBar bar;
  bar.write_deck(
      "begin prescribed force\nnode set = tip\ncomponent = x\nfunction = hat\nscale factor = 1e6\nend\n",
      "begin function hat\ntype = piecewise linear\nbegin values\n0 0\n0.5 1\n1 0\nend\nend\n");
  const std::string deck = bar.read("a.i");
  const auto prescribed = deck.find("begin prescribed displacement");
  bar.write("a.i", deck.substr(0, prescribed) + deck.substr(deck.find("begin heartbeat")));
  CHECK(bar.run({"a.i"}).exit_code == 0);
}

TEST_CASE("steps without equilibrium end the run with what is left over", "[app][statics]") {
  const BentBar bar;
  bar.write_deck(
      "begin solver\nbegin cg\ntarget relative residual = 1e-12\nacceptable relative residual = 1e-12\n"
      "maximum iterations = 1\nend\nend\n"
      "begin adaptive time stepping\nmaximum failure cutbacks = 2\nend\n");
  const auto [code, out, err] = bar.run({"a.i"});
  CHECK(code == 4);
  CHECK_THAT(err, Contains("no equilibrium is found with a step of 0.0625") && Contains("most at node"));
}

TEST_CASE("forces left over above the target are reported where the deck puts up with them",
          "[app][statics]") {
  const BentBar bar;
  bar.write_deck(
      "begin solver\nbegin cg\ntarget relative residual = 1e-12\nacceptable relative residual = 1e-2\n"
      "maximum iterations = 20\nend\nend\n");
  const auto [code, out, err] = bar.run({"a.i"});
  CHECK(code == 0);
  CHECK_THAT(out, Contains("acceptable, not below the target"));
  CHECK_THAT(err, Contains("5 load steps ended above the target, the first at step 1, time 0.25: forces left "
                           "over are") &&
                      Contains("where the target is 1e-12"));
  bar.write_deck(tight);
  CHECK_THAT(bar.run({"a.i"}).err, !Contains("above the target"));
}

TEST_CASE("what load steps do not know is refused", "[app][statics]") {
  const BentBar bar;
  const auto refusal = [&](const std::string& region) {
    bar.write_deck(region);
    const auto [code, out, err] = bar.run({"a.i"});
    CHECK(code == 2);
    return err;
  };
  CHECK_THAT(refusal("begin initial velocity\nblock = bar\ncomponent = x\nmagnitude = 1\nend\n"),
             Contains("an initial velocity in a quasi-static procedure is not supported"));
  CHECK_THAT(refusal("begin initial condition\nblock = bar\nvariable type = node\ninitialize variable name = "
                     "velocity\nmagnitude = 1 0 0\nend\n"),
             Contains("an initial velocity in a quasi-static procedure is not supported"));
  CHECK_THAT(refusal("begin prescribed acceleration\nnode set = tip\ncomponent = y\nfunction = ramp\nend\n"),
             Contains("a prescribed acceleration in a quasi-static procedure is not supported"));
  bar.write_deck("", "", "");
  CHECK_THAT(bar.run({"a.i"}).err, Contains("give no steps") && Contains("TIME INCREMENT"));
}
