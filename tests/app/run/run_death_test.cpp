// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <sstream>

#include "app/run/simulation.hpp"
#include "support/catch.hpp"
#include "support/csv_column.hpp"
#include "support/exodus_file.hpp"
#include "support/mesh_builder.hpp"
#include "support/program_run.hpp"

using Catch::Matchers::Contains;
using contactsim::test::MeshBuilder;
using contactsim::test::ProgramDirectory;

namespace {

/// A cube that flies into a bar of 8 x 2 x 2 cells, whose elements may die.
struct HitBar : ProgramDirectory {
  ///   lines  of the ELEMENT DEATH block
  ///   gap    between cube and bar
  explicit HitBar(const std::string& lines, double gap = 0.01) {
    contactsim::test::write_exodus(
        path("a.g"), MeshBuilder()
                         .add_hexes({1, "bar", {8, 2, 2}, {0, 0, 0}, {8, 2, 2}})
                         .add_hexes({2, "cube", {1, 1, 1}, {3.5, 0.5, 2 + gap}, {1, 1, 1}, false})
                         .build());
    write("a.i",
          "begin sierra\nbegin material m\ndensity = 1\nbegin parameters for model elastic\n"
          "youngs modulus = 100\npoissons ratio = 0.3\nend\nend\n"
          "begin finite element model f\nbegin parameters for block bar cube\nmaterial = m\n"
          "model = elastic\nend\nend\n"
          "begin presto procedure p\nbegin time control\nbegin time stepping block t\nstart time = 0\n"
          "end\ntermination time = 3\nend\nbegin presto region r\nuse finite element model f\n"
          "begin initial velocity\nblock = cube\ncomponent = z\nmagnitude = -1\nend\n"
          "begin element death d\n" +
              lines +
              "end\nbegin contact definition\nskin all blocks = on\nbegin interaction defaults\n"
              "general contact = on\nself contact = on\nend\nend\n"
              "begin heartbeat output\nstream name = a.csv\nprecision = 17\nat step 0 increment = 1\n"
              "global energy_error as error\nglobal kinetic_energy as kinetic\nglobal momentum as p\n"
              "element death_status at element 14 as status\nglobal dead_elements as "
              "dead\nend\nend\nend\nend\n");
  }

  /// A column of the heartbeat, by its place.
  std::vector<double> column(std::size_t place) const {
    return contactsim::test::csv_column(read("a.csv"), place);
  }
};

const std::string by_strain = "block = bar\ncriterion is element value of von_mises > 2\ndeath steps = 3\n";

}  // namespace

TEST_CASE("deaths keep momentum and close the energy balance", "[app][transient][death]") {
  const HitBar bar(by_strain);
  const auto [code, out, err] = bar.run({"a.i"});
  CHECK(err == "");
  CHECK(code == 0);
  CHECK_THAT(out, Contains("Element death at step") && Contains("contact gains"));
  const auto dead = bar.column(7);
  CHECK(dead.front() == 0);
  CHECK(std::is_sorted(dead.begin(), dead.end()));
  CHECK_THAT(
      out, Contains(std::to_string(static_cast<int>(dead.back())) + " elements of 32 that may die are dead"));
  const auto error = bar.column(1), momentum = bar.column(5);
  const double kinetic = bar.column(2).front();
  for (std::size_t i = 0; i < error.size(); ++i) {
    CHECK(std::abs(error[i]) < 0.01 * kinetic);
    CHECK(momentum[i] == Approx(-1.0));
  }
}

TEST_CASE("a run with deaths has the same bits with one thread and with two", "[app][transient][death]") {
  const HitBar bar(by_strain);
  CHECK(bar.run({"a.i", "--threads", "1"}).exit_code == 0);
  const std::string one = bar.read("a.csv");
  CHECK(one.size() > 1000);
  CHECK(bar.run({"a.i", "--threads", "2"}).exit_code == 0);
  CHECK(bar.read("a.csv") == one);
}

TEST_CASE("a run that goes on from a step with deaths leaves no force where contact was",
          "[app][restart][death]") {
  // The lower half of a cube is dead from the first step on; the upper half is pressed on a plate with the
  // node that was in the middle, and dies.
  const ProgramDirectory bar;
  contactsim::test::write_exodus(
      bar.path("a.g"), MeshBuilder()
                           .add_hexes({1, "plate", {1, 1, 1}, {0, 0, 0}, {2, 2, 1}})
                           .add_hexes({2, "cube", {2, 2, 2}, {0.5, 0.5, 1.1}, {1, 1, 1}, false})
                           .add_node_set(1, "top", [](const Eigen::Vector3d& x) { return x.z() > 2.0; })
                           .build());
  const auto deck = [](const std::string& more) {
    return "begin sierra\nbegin material m\ndensity = 1\nbegin parameters for model elastic\n"
           "youngs modulus = 100\npoissons ratio = 0.3\nend\nend\n"
           "begin function down\ntype is analytic\nevaluate expression is \"-x\"\nend\n"
           "begin finite element model f\nbegin parameters for block plate cube\nmaterial = m\n"
           "model = elastic\nend\nend\n"
           "begin presto procedure p\nbegin time control\nbegin time stepping block t\nstart time = 0\n"
           "end\ntermination time = 1\nend\nbegin presto region r\nuse finite element model f\n"
           "begin fixed displacement\nblock = plate\ncomponents = x y z\nend\n"
           "begin prescribed displacement\nnode set = top\ncomponent = z\nfunction = down\nend\n"
           "begin element death lower\nelement = 2 3 4 5\ncriterion is always true\nend\n"
           "begin element death upper\nelement = 6 7 8 9\ncriterion is global value of time > 0.7\nend\n"
           "begin contact definition\nskin all blocks = on\nbegin interaction defaults\n"
           "general contact = on\nend\nend\n"
           "begin heartbeat output\nstream name = a.csv\nprecision = 17\nat step 0 increment = 1\n"
           "global kinetic_energy as kinetic\nglobal dead_elements as dead\nend\n"
           "begin restart data\nat step 0 increment = 1\noverwrite = off\n" +
           more + "end\nend\nend\nend\n";
  };
  bar.write("a.i", deck(""));
  REQUIRE(bar.run({"a.i"}).exit_code == 0);
  const std::string straight = bar.read("a.csv");
  const auto times = contactsim::test::csv_column(straight, 0),
             dead = contactsim::test::csv_column(straight, 2);
  const auto at = std::ranges::find(dead, 8.0) - dead.begin();
  REQUIRE(at < static_cast<std::ptrdiff_t>(dead.size()) - 3);
  std::ostringstream time;
  time.precision(17);
  time << "restart time = " << times[static_cast<std::size_t>(at)] << "\n";
  bar.write("a.i", deck(time.str()));
  REQUIRE(bar.run({"a.i"}).exit_code == 0);
  const std::string part = bar.read("a.csv-s0002"), rest = part.substr(part.find('\n') + 1);
  CHECK(rest.size() > 100);
  CHECK(rest == straight.substr(straight.size() - rest.size()));
}

TEST_CASE("death_status falls from 1 to 0 as an element dies", "[app][transient][death]") {
  const HitBar bar("element = 14\ncriterion is global value of time > 1\ndeath steps = 4\n");
  CHECK(bar.run({"a.i"}).exit_code == 0);
  const auto status = bar.column(6);
  CHECK(status.front() == 1.0);
  CHECK(status.back() == 0.0);
  CHECK(std::count(status.begin(), status.end(), 0.5) == 1);
}

TEST_CASE("the log tells of deaths as much as LOGFILE OUTPUT says", "[app][transient][death]") {
  const std::string lines = "element = 29 30\ncriterion is global value of time > 1\n";
  const auto out_of = [&](const std::string& detail) {
    return HitBar(lines + "logfile output = " + detail + "\n").run({"a.i"}).out;
  };
  const std::string minimal = out_of("minimal"), some = out_of("some"), full = out_of("full");
  CHECK_THAT(minimal, Contains("2 elements died, 2 dead; contact gains 6 faces, loses 4 faces"));
  CHECK_THAT(some, Contains("bar                                  6         4"));
  CHECK(full.size() > some.size());
  CHECK(some.size() > minimal.size());
}

TEST_CASE("a body flies through what has died; NODAL EROSION = OFF leaves free nodes in its way",
          "[app][transient][death]") {
  const std::string lines = "block = bar\ncriterion is always true\n";
  const HitBar eroding(lines, 0.3), staying(lines + "nodal erosion = off\n", 0.3);
  CHECK(eroding.run({"a.i"}).exit_code == 0);
  CHECK(staying.run({"a.i"}).exit_code == 0);
  const double cube = 0.5;  // 1/2 m v^2 with mass and speed 1
  CHECK(eroding.column(2).back() == Approx(cube).epsilon(1e-12));
  CHECK(eroding.column(5).back() == Approx(-1.0).epsilon(1e-12));
  // The node (4, 1, 2) of mass 0.5 is hit.
  CHECK(staying.column(2).back() < 0.9 * cube);
  CHECK(staying.column(5).back() == Approx(-1.0).epsilon(1e-12));
}

TEST_CASE("a run goes on when all its elements are dead", "[app][transient][death]") {
  const HitBar bar("include all blocks\ncriterion is always true\ndeath start time = 0.5\n");
  const auto [code, out, err] = bar.run({"a.i"});
  CHECK(code == 0);
  CHECK_THAT(out, Contains("33 elements of 33 that may die are dead"));
}

TEST_CASE("a bad material of elements that may die is an error", "[app][transient][death]") {
  const std::string criterion =
      GENERATE(as<std::string>(), by_strain, "block = bar\nmaterial criterion = on\n",
               "block = bar\ndeath on inversion = on\n");
  const HitBar bar(criterion);
  std::string deck = bar.read("a.i");
  const std::string elastic =
                        "begin parameters for model elastic\nyoungs modulus = 100\npoissons ratio = 0.3\n",
                    chosen = "model = elastic\n";
  deck.replace(deck.find(elastic), elastic.size(),
               "begin parameters for model johnson_cook\nyoungs modulus = 100\npoissons ratio = 0.3\n"
               "yield stress = 1\nhardening constant = 1\nhardening exponent = 0.5\nd1 = -0.5\n");
  deck.replace(deck.find(chosen), chosen.size(), "model = johnson_cook\n");
  bar.write("a.i", deck);
  const auto [code, out, err] = bar.run({"a.i"});
  CHECK(code == 2);
  CHECK_THAT(err, Contains("d1 + d2") && Contains("2 errors"));
}
