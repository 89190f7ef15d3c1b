// SPDX-License-Identifier: BSD-3-Clause
// Elements that die in quasi-static procedures by the program.
#include <cmath>
#include <sstream>

#include "support/catch.hpp"
#include "support/csv_column.hpp"
#include "support/exodus_file.hpp"
#include "support/mesh_builder.hpp"
#include "support/program_run.hpp"

using Catch::Matchers::Contains;
using contactsim::test::csv_column;
using contactsim::test::MeshBuilder;
using contactsim::test::ProgramDirectory;

namespace {

const std::string elastic_material =
    "begin material m\ndensity = 1000\nbegin parameters for model elastic\n"
    "youngs modulus = 1e6\npoissons ratio = 0\nend\nend\n"
    "begin function ramp\ntype = piecewise linear\nbegin values\n0 0\n1 1\nend\nend\n";
std::string steps_of(const std::string& increment) {
  return "begin adagio procedure p\nbegin time control\nbegin time stepping block t\nstart time = 0\n"
         "begin parameters for adagio region r\ntime increment = " +
         increment +
         "\nend\nend\ntermination time = 1\nend\nbegin adagio region r\nuse finite element model f\n";
}

/// A directory with a frame: two bars of 4 x 1 x 1 elements side by side between two walls, a stiff and a
/// soft one, of which parts may die.
struct PulledBars : ProgramDirectory {
  std::string increment = "0.25";  ///< of load steps
  PulledBars() {
    contactsim::test::write_exodus(
        path("a.g"), MeshBuilder()
                         .add_hexes({1, "one", {4, 1, 1}, {0, 0, 0}, {4, 1, 1}})
                         .add_hexes({2, "two", {4, 1, 1}, {0, 2, 0}, {4, 1, 1}, false})
                         .add_node_set(1, "clamped", [](const Eigen::Vector3d& x) { return x.x() == 0.0; })
                         .add_node_set(2, "pulled", [](const Eigen::Vector3d& x) { return x.x() == 4.0; })
                         .build());
  }
  /// Writes the deck a.i: bars that are pulled by 0.04.
  ///   death  lines of the region on deaths
  ///   solver  lines of BEGIN SOLVER
  void write_deck(const std::string& death, const std::string& solver = "", const std::string& region = "",
                  const std::string& sierra = "") const {
    write("a.i",
          "begin sierra\n" + sierra + elastic_material +
              "begin finite element model f\nbegin parameters for block one two\nmaterial = m\nmodel = "
              "elastic\nend\nend\n" +
              steps_of(increment) +
              "begin fixed displacement\nnode set = clamped\ncomponents = x y z\nend\n"
              "begin fixed displacement\nnode set = pulled\ncomponents = y z\nend\n"
              "begin prescribed displacement\nnode set = pulled\ncomponent = x\nfunction = ramp\n"
              "scale factor = 0.04\nend\n" +
              death + "begin solver\n" + solver +
              "end\n"
              "begin user output\nnode set = pulled\ncompute global force as sum of nodal reaction(x)\nend\n"
              "begin heartbeat output\nstream name = a.csv\nprecision = 17\nat step 0 increment = 1\n"
              "global force\nglobal dead_elements as dead\nglobal energy_error as error\n"
              "global internal_energy as internal\nend\n" +
              region + "end\nend\nend\n");
  }
  std::vector<double> column(std::size_t place) const { return csv_column(read("a.csv"), place); }
};

/// A text whose lines are one.
std::string unwrapped(const std::string& text) {
  std::istringstream words(text);
  std::string line, word;
  while (words >> word) line += word + " ";
  return line;
}

// The bars have E = 1e6, an area of 1 and a strain of 0.01 at the end: 1e4 each.
const std::string one_dies =
    "begin element death d\nelement = 2\ncriterion is element value of von_mises > 6e3\nend\n";
const std::string again = "begin control failure\nend\n";
const std::string by_multigrid =
    "begin cg\nbegin full tangent preconditioner\nlinear solver = amg\nend\nend\n";
const std::string by_tangent = "begin cg\nbegin full tangent preconditioner\nend\nend\n";

}  // namespace

TEST_CASE("load steps go on without elements that have died", "[app][statics][death]") {
  const PulledBars bars;
  for (const std::string& search : {std::string(), by_tangent}) {
    for (const std::string& control : {std::string(), again}) {
      CAPTURE(search, control);
      bars.write_deck(one_dies, search + control);
      const auto [code, out, err] = bars.run({"a.i"});
      REQUIRE(code == 0);
      CHECK(err == "");
      CHECK_THAT(out, Contains("Element death at step 3"));
      const auto force = bars.column(1), dead = bars.column(2), error = bars.column(3), work = bars.column(4);
      CHECK(force[2] == Approx(1e4).epsilon(0.01));
      // The step of the death is balanced without what died under CONTROL FAILURE alone.
      CHECK(force[4] == Approx(1e4).epsilon(0.01));
      if (!control.empty()) CHECK(force[3] == Approx(0.75e4).epsilon(0.01));
      CHECK(dead == std::vector<double>{0, 0, 0, 1, 1});
      for (const double e : error) CHECK(std::abs(e) < 1e-3 * work.back());
      const bool is_anew = unwrapped(out).find("anew after deaths: 1") != std::string::npos;
      CHECK(is_anew == !control.empty());
    }
  }
}

TEST_CASE("what dies at the start is not there in the first load step", "[app][statics][death]") {
  const PulledBars bars;
  bars.write_deck("begin element death d\nelement = 2\ncriterion is always true\nend\n", by_tangent + again);
  REQUIRE(bars.run({"a.i"}).exit_code == 0);
  CHECK(bars.column(1)[1] == Approx(0.25e4).epsilon(0.01));
  CHECK(bars.column(2).front() == 1.0);
}

TEST_CASE("load steps with deaths have the same bytes for any number of threads and after a restart",
          "[app][statics][death]") {
  for (const std::string& control : {std::string(), again}) {
    const PulledBars bars;
    const std::string stored = "begin restart data\nat step 0 increment = 3\nend\n";
    bars.write_deck(one_dies, by_tangent + control, stored);
    REQUIRE(bars.run({"a.i", "--threads", "1"}).exit_code == 0);
    const std::string straight = bars.read("a.csv");
    REQUIRE(bars.run({"a.i", "--threads", "2"}).exit_code == 0);
    CHECK(bars.read("a.csv") == straight);
    bars.write_deck(one_dies, by_tangent + control, stored, "restart time = 0.75\n");
    REQUIRE(bars.run({"a.i"}).exit_code == 0);
    const std::string rest = bars.read("a.csv-s0002");
    const std::string lines = rest.substr(rest.find('\n') + 1);
    CHECK(lines.size() > 40);
    CHECK(straight.substr(straight.size() - lines.size()) == lines);
  }
}

TEST_CASE("loads on nodes without living elements do not matter", "[app][statics][death]") {
  const PulledBars bars;
  const std::string weight =
      "begin gravity\ninclude all blocks\ncomponent = z\nfunction = ramp\ngravitational constant = "
      "-0.01\nend\n";
  const std::string all_of_one =
      "begin element death d\nblock = one\ncriterion is always true\ndeath start time = 0.4\nend\n";
  for (const std::string& search : {std::string(), by_tangent}) {
    bars.write_deck(all_of_one, search + again, weight);
    REQUIRE(bars.run({"a.i"}).exit_code == 0);
    CHECK(bars.column(1).back() == Approx(1e4).epsilon(0.01));
    CHECK(bars.column(2).back() == 4.0);
  }
}

TEST_CASE("a piece that has come off is left where it is", "[app][statics][death]") {
  const PulledBars bars;
  const std::string cut =
      "begin element death d\nelement = 1 4\ncriterion is global value of time > 0.4\nend\n";
  for (const std::string& search : {std::string(), by_tangent, by_multigrid}) {
    for (const std::string& control : {std::string(), again}) {
      bars.write_deck(cut, search + control);
      const auto [code, out, err] = bars.run({"a.i"});
      CAPTURE(out);
      CHECK(code == 0);
      CHECK(err == "");
      CHECK(bars.column(1).back() == Approx(1e4).epsilon(0.01));
    }
  }
}

TEST_CASE("what is left may not be able to bear the loads", "[app][statics][death]") {
  const PulledBars bars;
  const std::string pull =
      "begin prescribed force\nblock = one\ncomponent = x\nfunction = ramp\nscale factor = 10\nend\n";
  const std::string cut =
      "begin element death d\nelement = 1 4\ncriterion is global value of time > 0.4\nend\n";
  bars.write_deck(cut, again, pull);
  const auto [code, out, err] = bars.run({"a.i"});
  CHECK(code == 4);
  CHECK_THAT(err, Contains("no equilibrium is found with a step of"));
}

namespace {

// One after the other where steps are small, and the bar holds by one end; both at once it is loose, with a
// load.
const std::string ends_die =
    "begin element death d\nelement = 1\ncriterion is element value of von_mises > 6e3\nend\n"
    "begin element death e\nelement = 4\ncriterion is element value of von_mises > 7e3\nend\n"
    "begin prescribed force\nblock = one\ncomponent = x\nfunction = ramp\nend\n";

}  // namespace

TEST_CASE("what has died in a load step that is cut back lives again", "[app][statics][death]") {
  PulledBars bars;
  for (const std::string& search : {std::string(), by_tangent}) {
    bars.increment = "0.0625";
    bars.write_deck(ends_die, search + again);
    const auto small = bars.run({"a.i"});
    REQUIRE(small.exit_code == 0);
    CHECK_THAT(small.out, Contains("Element death at step 10"));
    const double force = bars.column(1).back();
    CHECK(bars.column(2).back() == 1.0);
    bars.increment = "1";
    bars.write_deck(ends_die, search + again);
    const auto large = bars.run({"a.i"});
    CAPTURE(large.out);
    REQUIRE(large.exit_code == 0);
    CHECK(large.err == "");
    CHECK(bars.column(0)[1] == 0.5);
    CHECK(bars.column(2) == std::vector<double>{0, 0, 1, 1, 1});
    CHECK(bars.column(1).back() == Approx(force).epsilon(1e-4));  // steps keep the turns of stress to that
    CHECK_THAT(large.out, Contains("1 element died, 1 dead"));
  }
}

TEST_CASE("deaths that no iteration of CONTROL FAILURE has balanced are reported", "[app][statics][death]") {
  const PulledBars bars;
  const std::string fading =
      "begin element death d\nelement = 2\ncriterion is element value of von_mises > 6e3\ndeath steps = "
      "3\nend\n";
  bars.write_deck(fading, "begin control failure\nmaximum iterations = 1\nend\n");
  const auto few = bars.run({"a.i"});
  CHECK(few.exit_code == 0);
  CHECK_THAT(few.err, Contains("elements still died in the last iteration of CONTROL FAILURE"));
  // One third at a time.
  bars.write_deck(fading, again);
  const auto enough = bars.run({"a.i"});
  CHECK(enough.exit_code == 0);
  CHECK(enough.err == "");
  CHECK_THAT(unwrapped(enough.out), Contains("anew after deaths: 3"));
  CHECK(bars.column(1)[3] == Approx(0.75e4).epsilon(0.01));
}

TEST_CASE("what deaths in load steps cannot do is refused, what has no effect is reported",
          "[app][statics][death]") {
  const PulledBars bars;
  const std::string begin = "begin element death d\nblock = one\ncriterion is always true\n";
  bars.write_deck(begin + "death on inversion = on\nend\n");
  const auto inverted = bars.run({"a.i"});
  CHECK(inverted.exit_code == 2);
  CHECK_THAT(inverted.err, Contains("DEATH ON INVERSION in a quasi-static procedure is not supported"));
  bars.write_deck(begin + "nodal erosion = off\nend\n", "",
                  "begin contact definition c\nskin all blocks = on\nend\n");
  const auto free = bars.run({"a.i"});
  CHECK(free.exit_code == 2);
  CHECK_THAT(free.err, Contains("NODAL EROSION = OFF in a quasi-static procedure is not supported"));
  bars.write_deck("", again);
  const auto idle = bars.run({"a.i"});
  CHECK(idle.exit_code == 0);
  CHECK_THAT(idle.err, Contains("CONTROL FAILURE has no effect: the region has no ELEMENT DEATH"));
}

namespace {

/// A directory with a block that is pressed on another by 0.1, whose topmost layer of 0.06 may be there and
/// die.
struct Layered : ProgramDirectory {
  explicit Layered(bool has_layer) {
    MeshBuilder mesh;
    mesh.add_hexes({1, "low", {3, 3, 2}, {0, 0, 0}, {3, 3, 1}});
    mesh.add_hexes({2, "up", {2, 2, 2}, {0.7, 0.8, 1.06}, {1.5, 1.5, 1}, false});
    if (has_layer) mesh.add_hexes({3, "layer", {3, 3, 1}, {0, 0, 1}, {3, 3, 0.06}});
    mesh.add_node_set(1, "bottom", [](const Eigen::Vector3d& x) { return x.z() == 0.0; });
    mesh.add_node_set(2, "top", [](const Eigen::Vector3d& x) { return x.z() > 2.0; });
    contactsim::test::write_exodus(path("a.g"), mesh.build());
  }
};

}  // namespace

namespace {

/// The bars, held from below, and a block that is pressed on the one that breaks.
struct PressedBars : PulledBars {
  PressedBars() {
    contactsim::test::write_exodus(
        path("a.g"), MeshBuilder()
                         .add_hexes({1, "one", {4, 1, 1}, {0, 0, 0}, {4, 1, 1}})
                         .add_hexes({2, "two", {4, 1, 1}, {0, 2, 0}, {4, 1, 1}, false})
                         .add_hexes({3, "up", {3, 1, 1}, {0.5, 0.1, 1}, {3, 0.8, 1}, false})
                         .add_node_set(1, "clamped", [](const Eigen::Vector3d& x) { return x.x() == 0.0; })
                         .add_node_set(2, "pulled", [](const Eigen::Vector3d& x) { return x.x() == 4.0; })
                         .add_node_set(3, "bottom", [](const Eigen::Vector3d& x) { return x.z() == 0.0; })
                         .add_node_set(4, "top", [](const Eigen::Vector3d& x) { return x.z() == 2.0; })
                         .build());
  }
  void write_deck(const std::string& lines = "", const std::string& sierra = "") const {
    PulledBars::write_deck(
        ends_die, by_tangent + again,
        "begin fixed displacement\nnode set = bottom\ncomponent = z\nend\n"
        "begin fixed displacement\nnode set = top\ncomponents = x y\nend\n"
        "begin prescribed displacement\nnode set = top\ncomponent = z\nfunction = ramp\n"
        "scale factor = -0.0004\nend\n"
        "begin contact definition c\nskin all blocks = on\nbegin interaction defaults\n"
        "general contact = on\nend\nend\n"
        "begin user output\nblock = up\ncompute global push as sum of nodal force_contact(z)\nend\n"
        "begin heartbeat output\nstream name = b.csv\nprecision = 17\nat step 0 increment = 1\n"
        "global push\nglobal dead_elements as dead\nend\n" +
            lines,
        sierra);
    edit("a.i", "block one two", "block one two up");
  }
};

}  // namespace

TEST_CASE("contact with what lives again is as it was", "[app][statics][death]") {
  PressedBars bars;
  bars.increment = "0.0625";
  bars.write_deck();
  REQUIRE(bars.run({"a.i"}).exit_code == 0);
  const double push = csv_column(bars.read("b.csv"), 1).back();
  CHECK(push > 400.0);
  bars.increment = "1";
  const std::string stored = "begin restart data\nat step 0 increment = 1\nend\n";
  bars.write_deck(stored);
  const auto large = bars.run({"a.i"});
  CAPTURE(large.out);
  REQUIRE(large.exit_code == 0);
  CHECK(large.err == "");
  const std::string straight = bars.read("b.csv");
  CHECK(csv_column(straight, 2) == std::vector<double>{0, 0, 1, 1, 1});
  CHECK(csv_column(straight, 1).back() == Approx(push).epsilon(1e-5));
  CHECK_THAT(large.out, Contains("contact gains 1 face, loses 5 faces"));
  CHECK_THAT(large.out, Contains("46 contact faces"));
  // Before the second step that is cut back, and behind it.
  for (const auto& [time, file] : {std::pair("0.5", "b.csv-s0002"), std::pair("0.6875", "b.csv-s0003")}) {
    bars.write_deck(stored, "restart time = " + std::string(time) + "\n");
    REQUIRE(bars.run({"a.i"}).exit_code == 0);
    const std::string rest = bars.read(file), lines = rest.substr(rest.find('\n') + 1);
    CHECK(lines.size() > 40);
    CHECK(straight.ends_with(lines));
  }
}

TEST_CASE("contact of load steps is with what is left of the bodies", "[app][statics][death]") {
  const auto last_force = [](bool has_layer, const std::string& solver) {
    const Layered blocks(has_layer);
    const std::string name = has_layer ? "layer" : "";
    const std::string death =
        "begin element death d\nblock = layer\ncriterion is global value of time > 0.4\nend\n";
    blocks.write("a.i",
                 "begin sierra\n" + elastic_material +
                     "begin finite element model f\nbegin parameters for block low up " + name +
                     "\nmaterial = m\nmodel = elastic\nend\nend\n" + steps_of("0.25") +
                     "begin fixed displacement\nnode set = bottom\ncomponents = x y z\nend\n"
                     "begin fixed displacement\nnode set = top\ncomponents = x y\nend\n"
                     "begin prescribed displacement\nnode set = top\ncomponent = z\nfunction = ramp\n"
                     "scale factor = -0.1\nend\n"
                     "begin contact definition c\nskin all blocks = on\nbegin interaction defaults\n"
                     "general contact = on\nend\nend\n" +
                     (has_layer ? death : "") + "begin solver\n" + solver +
                     "end\nbegin user output\nblock = low\ncompute global force as sum of nodal "
                     "force_contact(z)\nend\n"
                     "begin heartbeat output\nstream name = a.csv\nat step 0 increment = 1\nglobal force\n"
                     "end\nend\nend\nend\n");
    const auto [code, out, err] = blocks.run({"a.i"});
    CAPTURE(out, err);
    REQUIRE(code == 0);
    return csv_column(blocks.read("a.csv"), 1).back();
  };
  const double without = last_force(false, by_tangent);
  CHECK(without < -1e4);
  for (const std::string& control : {std::string(), again})
    CHECK(last_force(true, by_tangent + control) == Approx(without).epsilon(0.01));
}
