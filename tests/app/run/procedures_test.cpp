// SPDX-License-Identifier: BSD-3-Clause
// Several procedures in one deck, by the program: what goes from one to the next.
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "support/catch.hpp"
#include "support/csv_column.hpp"
#include "support/exodus_file.hpp"
#include "support/mesh_builder.hpp"
#include "support/program_run.hpp"

using Catch::Matchers::Contains;
using contactsim::test::csv_column;
using contactsim::test::MeshBuilder;
using contactsim::test::ProgramDirectory;

namespace procedures_test {

namespace {

struct Times {
  std::string start, end;
};

/// A directory with a bar of 6 x 2 x 2 elastic-plastic hexahedra, in two blocks, for decks of several
/// procedures.
struct Bar : ProgramDirectory {
  Bar() {
    const auto is_root = [](const Eigen::Vector3d& x) { return x.x() == 0.0; };
    const auto is_tip = [](const Eigen::Vector3d& x) { return x.x() == 6.0; };
    contactsim::test::write_exodus(path("a.g"), MeshBuilder()
                                                    .add_hexes({1, "near", {3, 2, 2}, {0, 0, 0}, {3, 2, 2}})
                                                    .add_hexes({2, "far", {3, 2, 2}, {3, 0, 0}, {3, 2, 2}})
                                                    .add_node_set(1, "clamped", is_root)
                                                    .add_node_set(2, "tip", is_tip)
                                                    .build());
  }
  void write_deck(const std::string& procedures, const std::string& sierra = "") const {
    write("a.i",
          "begin sierra\n" + sierra +
              "begin material m\ndensity = 8000\nbegin parameters for model elastic_plastic\n"
              "youngs modulus = 200e9\npoissons ratio = 0.3\nyield stress = 300e6\nhardening modulus = 1e9\n"
              "end\nend\n"
              "begin function ramp\ntype = piecewise linear\nbegin values\n0 0\n1 1\n2 1\n3 0\nend\nend\n"
              "begin finite element model f\nbegin parameters for block near far\nmaterial = m\nmodel = "
              "elastic_plastic\nend\nend\n" +
              procedures + "end\n");
  }
  contactsim::test::ProgramOutput run_deck(const std::string& procedures) const {
    write_deck(procedures);
    return run({"a.i"});
  }
};

const std::string clamp = "begin fixed displacement\nnode set = clamped\ncomponents = x y z\nend\n";
const std::string pull =
    "begin prescribed force\nnode set = tip\ncomponents = z\nfunction = ramp\nscale factor = 1e6\nend\n";
const std::string take_all = "begin procedural transfer\ninclude all blocks\nend\n";

std::string heartbeat(const std::string& file) {
  return "begin heartbeat output\nstream name = " + file +
         "\nprecision = 17\nat step 0 increment = 1\nglobal kinetic_energy as kinetic\n"
         "global internal_energy as internal\nglobal energy_error as error\n"
         "nodal displacement(z) nearest location 6 0 0 as tip\n"
         "element stress(xx) nearest location 0.5 0.5 0.5 as stress\nend\n";
}

/// A procedure of the kind "adagio" or "presto", with a region of the same name.
std::string procedure(const std::string& kind, const std::string& name, const Times& times,
                      const std::string& transfer, const std::string& region) {
  const bool is_static = kind == "adagio";
  return "begin " + kind + " procedure " + name + "\n" + transfer +
         "begin time control\nbegin time stepping block t\nstart time = " + times.start +
         "\nbegin parameters for " + kind + " region " + name + "\n" +
         (is_static ? "number of time steps = 4\n" : "step interval = 1000\n") +
         "end\nend\ntermination time = " + times.end + "\nend\nbegin " + kind + " region " + name +
         "\nuse finite element model f\n" + clamp +
         (is_static ? "begin solver\nbegin cg\ntarget relative residual = 1e-9\nbegin full tangent "
                      "preconditioner\nend\nend\nend\n"
                    : "") +
         region + "end\nend\n";
}

const std::string preload = procedure("adagio", "load", {"0", "1"}, "", pull + heartbeat("load.csv"));

constexpr std::size_t kinetic = 1, internal = 2, error = 3, tip = 4, stress = 5;

double largest(const std::vector<double>& values) {
  return std::abs(*std::ranges::max_element(values, {}, [](double v) { return std::abs(v); }));
}

}  // namespace

TEST_CASE("an explicit run from a static preload does not ring", "[app][procedures]") {
  const Bar bar;
  const auto [code, out, err] = bar.run_deck(
      preload + procedure("presto", "hold", {"1", "1.02"}, take_all, pull + heartbeat("hold.csv")));
  CHECK(code == 0);
  CHECK(err == "");
  CHECK_THAT(out, Contains("\nProcedure load: quasi-static, region load, time 0 to 1\n") &&
                      Contains("\nProcedure hold: explicit, region hold, time 1 to 1.02\n  takes over the "
                               "state of all blocks from load\n"));
  const std::string loaded = bar.read("load.csv"), held = bar.read("hold.csv");
  REQUIRE(csv_column(held, kinetic).size() > 100);
  CHECK(csv_column(loaded, internal).back() > 1.0);
  CHECK(largest(csv_column(held, kinetic)) < 1e-8 * csv_column(loaded, internal).back());
  CHECK(csv_column(held, internal).front() == Approx(csv_column(loaded, internal).back()).epsilon(1e-12));
  CHECK(csv_column(held, tip).front() == csv_column(loaded, tip).back());
  CHECK(csv_column(held, stress).front() == csv_column(loaded, stress).back());
  CHECK(largest(csv_column(held, error)) < 1e-9 * csv_column(loaded, internal).back());
}

TEST_CASE("procedures have the same bytes for any number of threads", "[app][procedures]") {
  const Bar bar;
  bar.write_deck(preload + procedure("presto", "swing", {"1", "1.01"}, take_all, heartbeat("swing.csv")));
  REQUIRE(bar.run({"a.i", "--threads", "1"}).exit_code == 0);
  const std::string one = bar.read("swing.csv");
  CHECK(largest(csv_column(one, kinetic)) > 0.1 * csv_column(one, internal).front());
  REQUIRE(bar.run({"a.i", "--threads", "2"}).exit_code == 0);
  CHECK(bar.read("swing.csv") == one);
}

TEST_CASE("an explicit procedure goes on with the motion of another", "[app][procedures]") {
  const Bar bar;
  const std::string kick = "begin initial velocity\nblock = far\ncomponent = z\nmagnitude = 5\nend\n";
  const std::string first = procedure("presto", "a", {"0", "0.01"}, "", kick + heartbeat("a.csv"));
  REQUIRE(
      bar.run_deck(procedure("presto", "one", {"0", "0.02"}, "", kick + heartbeat("one.csv"))).exit_code ==
      0);
  REQUIRE(bar.run_deck(first + procedure("presto", "b", {"0.01", "0.02"}, take_all, heartbeat("b.csv")))
              .exit_code == 0);
  CHECK(csv_column(bar.read("a.csv"), 0).back() == Approx(0.01).epsilon(1e-12));
  const std::string one = bar.read("one.csv"), second = bar.read("b.csv");
  CHECK(csv_column(second, kinetic).front() == csv_column(bar.read("a.csv"), kinetic).back());
  CHECK(largest(csv_column(second, error)) < 1e-3 * largest(csv_column(second, kinetic)));
  const double size = largest(csv_column(one, tip));
  CHECK(std::abs(csv_column(second, tip).back() - csv_column(one, tip).back()) < 0.01 * size);
}

TEST_CASE("load steps let go of what inertia bore over their first time stepping block",
          "[app][procedures]") {
  const Bar bar;
  REQUIRE(bar.run_deck(procedure("presto", "kick", {"0", "0.01"}, "",
                                 "begin initial velocity\nblock = far\ncomponent = z\nmagnitude = 5\nend\n" +
                                     heartbeat("kick.csv")) +
                       procedure("adagio", "rest", {"0.01", "1"}, take_all, heartbeat("rest.csv")))
              .exit_code == 0);
  const std::vector<double> place = csv_column(bar.read("rest.csv"), tip);
  CHECK(largest(csv_column(bar.read("rest.csv"), kinetic)) == 0.0);
  REQUIRE(place.size() == 5);
  CHECK(std::abs(place.front()) > 1e-3);
  CHECK(place[2] == Approx(0.5 * place.front()).epsilon(0.02));
  CHECK(std::abs(place.back()) < 1e-4 * std::abs(place.front()));
  CHECK(largest(csv_column(bar.read("rest.csv"), error)) <
        0.01 * largest(csv_column(bar.read("rest.csv"), internal)));
}

TEST_CASE("two procedures of load steps are one", "[app][procedures]") {
  const Bar bar;
  const std::string bend =
      "begin prescribed displacement\nnode set = tip\ncomponent = z\nfunction = ramp\nscale factor = "
      "0.2\nend\n";
  const std::string load = procedure("adagio", "load", {"0", "1"}, "", bend + heartbeat("load.csv"));
  const std::string unload =
      procedure("adagio", "unload", {"2", "3"}, take_all, bend + heartbeat("unload.csv"));
  const std::string idle = procedure("adagio", "idle", {"1", "2"}, take_all, bend + heartbeat("idle.csv"));
  REQUIRE(bar.run_deck(load + idle + unload).exit_code == 0);
  const std::string last = bar.read("unload.csv");
  std::string one = procedure("adagio", "one", {"0", "3"}, "", bend + heartbeat("one.csv"));
  one.replace(one.find("steps = 4"), 9, "steps = 12");
  REQUIRE(bar.run_deck(one).exit_code == 0);
  CHECK(std::abs(csv_column(last, stress).back()) > 1e6);  // what yielding has left
  CHECK(csv_column(last, stress).back() ==
        Approx(csv_column(bar.read("one.csv"), stress).back()).epsilon(1e-5));
  CHECK(csv_column(last, internal).back() ==
        Approx(csv_column(bar.read("one.csv"), internal).back()).epsilon(1e-5));
}

TEST_CASE("blocks that are not named start from the mesh", "[app][procedures]") {
  const Bar bar;
  const auto [code, out, err] = bar.run_deck(
      preload + procedure("presto", "hold", {"1", "1.0001"}, "begin procedural transfer\nblock = far\nend\n",
                          pull + heartbeat("hold.csv")));
  CHECK(code == 0);
  CHECK_THAT(out, Contains("takes over the state of the blocks far from load"));
  CHECK(csv_column(bar.read("hold.csv"), tip).front() == csv_column(bar.read("load.csv"), tip).back());
  CHECK(csv_column(bar.read("hold.csv"), stress).front() == 0.0);
}

TEST_CASE("a procedure that fails is the last, with its exit code", "[app][procedures]") {
  const Bar bar;
  std::string wild = procedure("presto", "wild", {"1", "1.1"}, take_all, heartbeat("wild.csv"));
  wild.replace(wild.find("step interval"), 0, "user time step = 1e-3\n");
  bar.write_deck(preload + wild + procedure("presto", "c", {"1.1", "1.2"}, take_all, heartbeat("c.csv")));
  const auto [code, out, err] = bar.run({"a.i", "--summary", "s.json"});
  CHECK(code == 4);
  CHECK_THAT(out, Contains("\nThe procedure c is not run.\n"));
  CHECK_FALSE(bar.has("c.csv"));
  CHECK(csv_column(bar.read("load.csv"), 0).size() == 5);
  const auto summary = nlohmann::json::parse(bar.read("s.json"));
  CHECK(summary["exit_code"] == 4);
  REQUIRE(summary["earlier_runs"].size() == 1);
  CHECK(summary["earlier_runs"][0]["procedure"] == "load");
  CHECK(summary["earlier_runs"][0]["run"]["steps"] == 4);
}

TEST_CASE("TERMINATE TYPE says whether the procedures behind are run", "[app][procedures]") {
  const Bar bar;
  const auto ended = [&](const std::string& type) {
    const std::string end =
        "begin solution termination\nterminate global internal_energy > 1e-3\n"
        "terminate type = " +
        type + "\nend\n";
    return bar.run_deck(procedure("adagio", "load", {"0", "1"}, "", pull + end) +
                        procedure("presto", "hold", {"1", "1.001"}, take_all, pull));
  };
  CHECK_THAT(ended("procedure").out, Contains("The run ends here") && !Contains("is not run"));
  const auto [code, out, err] = ended("entire_run");
  CHECK(code == 0);
  CHECK_THAT(out, Contains("The run ends here") && Contains("\nThe procedure hold is not run.\n"));
}

}  // namespace procedures_test
