// SPDX-License-Identifier: BSD-3-Clause
// Rigid bodies that go from one procedure to the next, by the program.
#include <algorithm>
#include <cmath>

#include "support/catch.hpp"
#include "support/csv_column.hpp"
#include "support/exodus_file.hpp"
#include "support/mesh_builder.hpp"
#include "support/program_run.hpp"

using Catch::Matchers::Contains;
using contactsim::test::csv_column;
using contactsim::test::MeshBuilder;
using contactsim::test::ProgramDirectory;
using contactsim::test::ProgramOutput;

namespace {

struct ProcedureText {
  std::string kind, name, start, end;
  std::string region;  ///< lines of the region
  std::string transfer = "include all blocks\n";
  std::string model = "f";
};

/// A directory with a block "up", turned about no axis of the mesh's, on a larger elastic one "low".
struct RigidPunch : ProgramDirectory {
  explicit RigidPunch(double gap = 0.0) {
    contactsim::test::write_exodus(
        path("a.g"), MeshBuilder()
                         .add_hexes({1, "low", {3, 3, 2}, {0, 0, 0}, {3, 3, 1}})
                         .add_hexes({2, "up", {2, 2, 2}, {0.7, 0.8, 1.0 + gap}, {1.5, 1.0, 0.5}, false})
                         .add_node_set(1, "bottom", [](const Eigen::Vector3d& x) { return x.z() == 0.0; })
                         .build());
  }

  /// Its heartbeat goes to a file of its name.
  static std::string procedure(const ProcedureText& text, bool is_first) {
    const bool is_static = text.kind == "adagio";
    return "begin " + text.kind + " procedure " + text.name + "\n" +
           (is_first ? "" : "begin procedural transfer\n" + text.transfer + "end\n") +
           "begin time control\nbegin time stepping block t\nstart time = " + text.start +
           "\nbegin parameters for " + text.kind + " region " + text.name + "\n" +
           (is_static ? "number of time steps = 4\n" : "") + "end\nend\ntermination time = " + text.end +
           "\nend\nbegin " + text.kind + " region " + text.name + "\nuse finite element model " + text.model +
           "\nbegin fixed displacement\nnode set = bottom\ncomponents = x y "
           "z\nend\n" +
           (is_static
                ? "begin solver\nbegin cg\ntarget relative residual = 1e-6\nbegin full tangent "
                  "preconditioner\nend\nend\nbegin control contact\ntarget relative residual = 1e-6\nend\n"
                  "end\n"
                : "") +
           "begin heartbeat output\nstream name = " + text.name +
           ".csv\nprecision = 17\nat step 0 increment = 1\nglobal displz_punch as way\n"
           "global rotdy_punch as turn\nglobal reactz_punch as force\nglobal kinetic_energy as kinetic\n"
           "global strain_energy as strain\nglobal energy_error as lost\nglobal momentum(x) as momentum\n"
           "nodal displacement(x) nearest location 0.7 0.8 2 as corner_x\n"
           "nodal displacement(z) nearest location 0.7 0.8 2 as corner_z\nend\n" +
           text.region + "end\nend\n";
  }

  ProgramOutput run_deck(const std::vector<ProcedureText>& procedures, const std::string& sierra = "") const {
    std::string text =
        "begin sierra\n" + sierra +
        "begin material m\ndensity = 1000\nbegin parameters for model elastic\n"
        "youngs modulus = 1e8\npoissons ratio = 0.3\nend\nend\n"
        "begin function ramp\ntype = piecewise linear\nbegin values\n0 0\n1 1\n2 1\nend\nend\n"
        "begin rigid body punch\nend\nbegin solid section rigid\nrigid body = punch\nend\n"
        "begin finite element model f\nbegin parameters for block low\nmaterial = m\nmodel = elastic\n"
        "end\nbegin parameters for block up\nmaterial = m\nmodel = elastic\nsection = rigid\nend\nend\n"
        "begin finite element model elastic\ndatabase name = a.g\nbegin parameters for block low up\n"
        "material = m\nmodel = elastic\nend\nend\n";
    for (const ProcedureText& one : procedures) text += procedure(one, &one == procedures.data());
    write("a.i", text + "end\n");
    return run({"a.i"});
  }
  std::vector<double> column(const std::string& name, std::size_t i) const {
    return csv_column(read(name + ".csv"), i);
  }
};

/// Columns of heartbeats.
struct Of {
  enum : std::size_t { way = 1, turn, force, kinetic, strain, lost, momentum, corner_x, corner_z };
};

const std::string rough_punch =
    "begin contact definition c\nskin all blocks = on\nbegin constant friction model rough\n"
    "friction coefficient = 0.3\nend\nbegin interaction defaults\ngeneral contact = on\n"
    "friction model = rough\nend\nend\n";
const std::string glued_punch =
    "begin contact definition c\nskin all blocks = on\nbegin tied model glue\nend\n"
    "begin interaction defaults\ngeneral contact = on\nfriction model = glue\nend\nend\n";
const std::string punch_weight =
    "begin gravity\nblock = up\ncomponent = z\nfunction = ramp\ngravitational constant = -10\nend\n";
const std::string driven_punch =
    "begin prescribed displacement\nblock = up\ncomponent = z\nfunction = ramp\nscale factor = -0.02\nend\n"
    "begin prescribed displacement\nblock = up\ncomponent = x\nfunction = ramp\nscale factor = 0.01\nend\n"
    "begin fixed displacement\nblock = up\ncomponent = y\nend\n"
    "begin fixed rotation\nblock = up\ncomponents = x y z\nend\n";
const std::string turned_punch =
    "begin prescribed rotation\nblock = up\ncomponent = y\nfunction = ramp\nscale factor = 0.5\nend\n"
    "begin fixed rotation\nblock = up\ncomponents = x z\nend\n"
    "begin fixed displacement\nblock = up\ncomponents = x y\nend\n"
    "begin prescribed displacement\nblock = up\ncomponent = z\nfunction = ramp\nscale factor = 0.3\nend\n";

}  // namespace

TEST_CASE("an explicit run from a preload by a rigid body does not ring", "[app][procedures][rigid]") {
  // Of the kinetic energy over the strain energy. Ties of a rigid body need more passes of momentum balance
  // than the default, and facets that are far from flat press elsewhere in explicit dynamics.
  const auto [loads, most] = GENERATE(table<std::string, double>({{punch_weight + rough_punch, 1e-4},
                                                                  {punch_weight + glued_punch, 4e-3},
                                                                  {driven_punch + rough_punch, 1e-3}}));
  const RigidPunch punch;
  const auto run =
      punch.run_deck({{"adagio", "load", "0", "1", loads}, {"presto", "hold", "1", "1.2", loads}});
  REQUIRE(run.exit_code == 0);
  CHECK_THAT(run.err, !Contains("[contact-begins-anew]"));
  const std::vector<double> moving = punch.column("hold", Of::kinetic);
  const double stored = punch.column("load", Of::strain).back();
  REQUIRE(moving.size() > 100);
  CHECK(*std::max_element(moving.begin(), moving.begin() + 101) < most * stored);
  for (const std::size_t same : {Of::way, Of::turn, Of::corner_x, Of::corner_z}) {
    CHECK(punch.column("hold", same).front() == Approx(punch.column("load", same).back()).epsilon(1e-9));
    CHECK(punch.column("hold", same).back() ==
          Approx(punch.column("load", same).back()).epsilon(0.05).margin(1e-6));
  }
  for (const double energy : punch.column("hold", Of::lost)) CHECK(std::abs(energy) < 1e-4 * stored);
}

TEST_CASE("a rigid body that load steps have turned flies and spins on from there",
          "[app][procedures][rigid]") {
  const RigidPunch punch(0.5);
  const std::string spin = "begin initial velocity\nblock = up\ncomponent = x\nmagnitude = 3\nend\n";
  const auto run =
      punch.run_deck({{"adagio", "lift", "0", "1", turned_punch}, {"presto", "fly", "1", "1.1", spin}});
  REQUIRE(run.exit_code == 0);
  CHECK(punch.column("fly", Of::turn).front() == Approx(0.5));
  CHECK(punch.column("fly", Of::turn).back() == Approx(0.5));
  CHECK(punch.column("fly", Of::way).back() == Approx(0.3));
  const std::vector<double> x = punch.column("fly", Of::corner_x), time = punch.column("fly", 0);
  CHECK(x.back() - x.front() == Approx(3.0 * (time.back() - time.front())));
  CHECK(punch.column("fly", Of::kinetic).back() == Approx(0.5 * 750.0 * 9.0));
  CHECK(punch.column("fly", Of::lost).back() == Approx(0.0).margin(1e-6));
}

TEST_CASE("an initial spin behind load steps is about the axis of the mesh, wherever these have put the body",
          "[app][procedures][rigid]") {
  const RigidPunch punch(0.5);
  const std::string spin =
      "begin initial velocity\nblock = up\ncylindrical axis = across\nangular velocity = 4\nend\n";
  const auto run =
      punch.run_deck({{"adagio", "lift", "0", "1", turned_punch}, {"presto", "fly", "1", "1.1", spin}},
                     "define point a with coordinates 1.45 0 1.75\n"
                     "define point b with coordinates 1.45 1 1.75\n"
                     "define axis across with point a point b\n");
  REQUIRE(run.exit_code == 0);
  const std::vector<double> turns = punch.column("fly", Of::turn), times = punch.column("fly", 0);
  CHECK(turns.back() == Approx(0.5 + 4.0 * (times.back() - times.front())).epsilon(1e-6));
  CHECK(punch.column("fly", Of::way).back() == Approx(0.3));
  // A box of 1.5 x 1 x 0.5 m and 750 kg, with the masses of its elements.
  CHECK(punch.column("fly", Of::kinetic).back() ==
        Approx(0.5 * 16.0 * 750.0 * (1.5 * 1.5 + 0.5 * 0.5) / 12.0).epsilon(0.6));
  CHECK(punch.column("fly", Of::kinetic).back() ==
        Approx(punch.column("fly", Of::kinetic).front()).epsilon(1e-9));
}

TEST_CASE("a rigid body goes on with its motion in an explicit procedure that follows",
          "[app][procedures][rigid]") {
  const RigidPunch punch(0.5);
  const std::string axes =
      "define point a with coordinates 1.4 1.3 1.7\ndefine point b with coordinates 1.5 1.9 2.4\n"
      "define axis about with point a point b\n";
  const std::string spun =
      "begin initial velocity\nblock = up\ncylindrical axis = about\nangular velocity = 5\nend\n";
  REQUIRE(punch.run_deck({{"presto", "whole", "0", "0.205", spun}}, axes).exit_code == 0);
  const auto run =
      punch.run_deck({{"presto", "first", "0", "0.1", spun}, {"presto", "second", "0.1", "0.2", ""}}, axes);
  REQUIRE(run.exit_code == 0);
  const std::vector<double> ends = punch.column("second", 0), times = punch.column("whole", 0);
  const auto after = static_cast<std::size_t>(std::ranges::lower_bound(times, ends.back()) - times.begin());
  REQUIRE((after > 0 && after < times.size()));
  const double share = (ends.back() - times[after - 1]) / (times[after] - times[after - 1]);
  for (const std::size_t same : {Of::way, Of::turn, Of::kinetic, Of::momentum, Of::corner_x, Of::corner_z}) {
    const std::vector<double> whole = punch.column("whole", same);
    CHECK(punch.column("second", same).back() ==
          Approx(whole[after - 1] + share * (whole[after] - whole[after - 1])).epsilon(1e-4));
  }
  CHECK(std::abs(punch.column("second", Of::corner_x).back()) > 0.05);
}

TEST_CASE("load steps hold a rigid body where an explicit procedure has left it",
          "[app][procedures][rigid]") {
  const RigidPunch punch(0.5);
  const auto run = punch.run_deck(
      {{"presto", "turn", "0", "1", turned_punch}, {"adagio", "stay", "1", "2", turned_punch}});
  REQUIRE(run.exit_code == 0);
  for (const std::size_t same : {Of::way, Of::turn, Of::corner_x, Of::corner_z}) {
    CHECK(punch.column("stay", same).front() == punch.column("turn", same).back());
    CHECK(punch.column("stay", same).back() == Approx(punch.column("turn", same).back()).epsilon(1e-6));
  }
  CHECK(punch.column("stay", Of::kinetic).front() == 0.0);
}

TEST_CASE("a rigid body takes over with all of its blocks or none", "[app][procedures][rigid]") {
  const RigidPunch punch(0.5);
  const auto run = punch.run_deck(
      {{"adagio", "lift", "0", "1", turned_punch}, {"presto", "fly", "1", "1.1", "", "block = low\n"}});
  REQUIRE(run.exit_code == 0);
  CHECK(punch.column("fly", Of::way).front() == 0.0);
  CHECK(punch.column("fly", Of::turn).back() == 0.0);
}

TEST_CASE("a rigid body does not turn elastic between procedures, nor the other way round",
          "[app][procedures][rigid]") {
  const RigidPunch punch(0.5);
  const ProcedureText lift{"adagio", "lift", "0", "1", turned_punch}, fly{"presto", "fly", "1", "1.1", ""};
  ProcedureText soft = fly;
  soft.model = "elastic";
  const auto first = punch.run_deck({lift, soft});
  CHECK(first.exit_code == 2);
  CHECK_THAT(first.err,
             Contains("the block 'up' cannot take over its state: it is rigid before and not now"));
  soft.kind = "adagio";
  soft.name = "rest";
  soft.start = "0";
  soft.end = "1";
  const auto second = punch.run_deck({soft, fly});
  CHECK_THAT(second.err,
             Contains("the block 'up' cannot take over its state: it is rigid now and not before"));
}
