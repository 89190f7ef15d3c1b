// SPDX-License-Identifier: BSD-3-Clause
#include "app/run/simulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "contact/enforcement/contact_force.hpp"
#include "support/catch.hpp"
#include "support/exodus_file.hpp"
#include "support/exodus_times.hpp"
#include "support/flying_cube.hpp"
#include "support/mesh_builder.hpp"
#include "support/program_run.hpp"

using Catch::Matchers::Contains;
using contactsim::RunEvent;
using contactsim::Simulation;
using contactsim::test::FlyingCube;
using contactsim::test::MeshBuilder;
using contactsim::test::ProgramDirectory;
using contactsim::test::read_times;

namespace simulation_test {

namespace {

/// A directory with a unit cube of elastic hexahedra and a deck that pulls it.
struct PulledBar : ProgramDirectory {
  /// more  further lines of the region
  explicit PulledBar(const std::string& more = "", std::array<int, 3> cells = {20, 10, 10}) {
    contactsim::test::write_exodus(path("a.g"),
                                   MeshBuilder()
                                       .add_hexes({1, "bar", cells})
                                       .add_node_set(7, "foot", [](const auto& at) { return at.x() == 0.0; })
                                       .build());
    write("a.i",
          "begin sierra\n"
          "begin material m\ndensity = 8000\nbegin parameters for model elastic\nyoungs modulus = 200e9\n"
          "poissons ratio = 0.3\nend\nend\n"
          "begin finite element model f\nbegin parameters for block bar\nmaterial = m\nmodel = "
          "elastic\nend\nend\n"
          "begin presto procedure p\nbegin time control\nbegin time stepping block t\nstart time = 0\n"
          "begin parameters for presto region r\nstep interval = 10\nend\nend\n"
          "termination time = 2e-4\nend\nbegin presto region r\nuse finite element model f\n"
          "begin initial velocity\nblock = bar\ncomponent = x\nmagnitude = 10\nend\n" +
              more + "end\nend\nend\n");
  }
};

const std::string results =
    "begin results output\ndatabase name = a.e\nat time 0 increment = 5e-5\nnodal displacement\n"
    "nodal velocity\nelement stress\nend\n";
const std::string held = "begin fixed displacement\nnode = 1 2 3\ncomponents = x y z\nend\n";

/// Every step to the last bit.
const std::string probe =
    "begin heartbeat output\nstream name = a.csv\nprecision = 17\nat step 0 increment = 1\n"
    "nodal coordinates at node 1000 as place\nglobal energy_error as error\nend\n";

}  // namespace

TEST_CASE("a deck of solids runs to its termination time and tells how", "[app][transient]") {
  const PulledBar bar(held + results);
  const auto [code, out, err] = bar.run({"a.i"});
  CHECK(err == "");
  CHECK(code == 0);
  CHECK_THAT(
      out, Contains("  bar                            2000  HEX8       mean_quadrature         m (elastic)"));
  CHECK_THAT(out, Contains("mass 8000, 3 nodes held or driven") && Contains("set by element"));
  CHECK_THAT(out, Contains("Wall time") && Contains("million element-steps per second"));
  CHECK(bar.has("a.e"));
  CHECK(bar.has("a.log"));
}

TEST_CASE("a run has the same bits with one thread and with two", "[app][transient]") {
  const PulledBar bar(held + probe + results);
  CHECK(bar.run({"a.i", "--threads", "1"}).exit_code == 0);
  const std::string one = bar.read("a.csv");
  CHECK(one.size() > 1000);
  CHECK(bar.run({"a.i", "--threads", "2"}).exit_code == 0);
  CHECK(bar.read("a.csv") == one);
}

TEST_CASE("asking for output does not change the solution, to the last bit", "[app][transient]") {
  const std::string much =
      results +
      "begin user output\nblock = bar\ncompute at every step\n"
      "compute global top as max of element von_mises\nend\n"
      "begin history output\ndatabase name = a.h\nat step 0 increment = 1\nglobal top\nend\n";
  const PulledBar quiet(held + probe), talking(held + probe + much);
  CHECK(quiet.run({"a.i"}).exit_code == 0);
  CHECK(talking.run({"a.i"}).exit_code == 0);
  CHECK(quiet.read("a.csv").size() > 1000);
  CHECK(quiet.read("a.csv") == talking.read("a.csv"));
}

TEST_CASE("an element that turns inside out ends the run with code 4, its id and a last state",
          "[app][transient]") {
  // The foot of four elements is driven into them: by steps that do not shrink, or that do.
  struct Crush {
    std::string step, cause;
  };
  const auto [step, cause] = GENERATE(values<Crush>({
      {"user time step = 1e-6\n", ": element 1 of bar has turned inside out\n"},
      {"", ": the stable time step has fallen to "},
  }));
  const PulledBar bar(
      "begin prescribed velocity\nnode set = foot\ncomponent = x\n"
      "function = sierra_constant_function_one\nscale factor = 6e4\nend\n" +
          results,
      {4, 1, 1});
  bar.edit("a.i", "step interval", step + "step interval");
  const auto [code, out, err] = bar.run({"a.i"});
  INFO(out);
  CHECK(code == 4);
  CHECK(err.starts_with("error: step "));
  CHECK_THAT(err, Contains(cause) && Contains("element 1"));
  const std::vector<double> times = read_times(contactsim::NetcdfFile(bar.path("a.e")));
  REQUIRE(times.size() == 2);  // the second of the plan is later than the end
  CHECK_THAT(err, Contains(fmt::format(", time {}: ", times.back())));
}

TEST_CASE("what a run does not act on yet is refused at its line", "[app][transient]") {
  const PulledBar contact(
      "begin contact definition\nskin all blocks = on\nbegin surface weld model h\nnormal capacity = 1\n"
      "tangential capacity = 1\nfailed model = tied\nend\nbegin interaction defaults\nself contact = "
      "on\nfriction model = h\nend\nend\n");
  const auto touched = contact.run({"a.i"});
  CHECK(touched.exit_code == 2);
  CHECK_THAT(touched.err, Contains("a.i:") && Contains("the FAILED MODEL 'tied' holds what has just failed"));
  CHECK_THAT(touched.out, Contains("\nContact surfaces\n"));
}

TEST_CASE("observers are notified of the start, of every step and of the end", "[app][simulation]") {
  FlyingCube cubes;
  std::vector<RunEvent> events;
  double momentum_error = 0.0;
  cubes.simulation.observe([&](RunEvent event, const Simulation& run) {
    events.push_back(event);
    if (event == RunEvent::step)
      momentum_error = std::max(momentum_error, std::abs(run.state().momentum[2] + 1.0));
  });
  cubes.run_to_end();
  const auto n_steps = static_cast<std::size_t>(cubes.simulation.state().step);
  REQUIRE(events.size() == n_steps + 4);
  CHECK(events[0] == RunEvent::restart_sought);
  CHECK(events[1] == RunEvent::begun);
  CHECK(std::count(events.begin(), events.end(), RunEvent::step) == static_cast<std::ptrdiff_t>(n_steps) + 1);
  CHECK(events.back() == RunEvent::ended);
  CHECK(momentum_error < 1e-12);  // mass and speed are 1
  CHECK(cubes.simulation.contact_force()->histories().front().deepest >= 0.0);
}

TEST_CASE("a simulation that is stopped is over with the step that it has come to", "[app][simulation]") {
  FlyingCube cubes;
  cubes.run(1);
  cubes.simulation.stop("a caller");
  CHECK(cubes.simulation.is_over());
  cubes.simulation.finish();
  CHECK(cubes.simulation.state().step == 1);
  CHECK(cubes.simulation.stopped_by() == "a caller");
}

TEST_CASE("a simulation of a wrong definition throws all errors", "[app][simulation]") {
  FlyingCube cubes;
  cubes.diagnostics.add_error({}, "an earlier one");
  CHECK_THROWS_AS(
      Simulation({cubes.definition, cubes.definition.procedures.front(), cubes.region(), cubes.mesh}, {},
                 cubes.diagnostics),
      contactsim::DeckError);
}

}  // namespace simulation_test
