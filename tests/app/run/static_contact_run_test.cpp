// SPDX-License-Identifier: BSD-3-Clause
// Contact in quasi-static procedures by the program.
#include <cstdio>

#include "support/catch.hpp"
#include "support/exodus_file.hpp"
#include "support/mesh_builder.hpp"
#include "support/program_run.hpp"

using Catch::Matchers::Contains;
using contactsim::test::MeshBuilder;
using contactsim::test::ProgramDirectory;

namespace static_contact_run_test {

namespace {

/// A directory with a small block on a larger one that is pressed down and pushed along.
struct PressedBlock : ProgramDirectory {
  explicit PressedBlock(double gap = 0.0) {
    const auto is_top = [=](const Eigen::Vector3d& x) { return x.z() > 1.9; };
    contactsim::test::write_exodus(
        path("a.g"),
        MeshBuilder()
            .add_hexes({1, "low", {3, 3, 2}, {0, 0, 0}, {3, 3, 1}})
            .add_hexes({2, "up", {2, 2, 2}, {0.7, 0.8, 1.0 + gap}, {1.5, 1.5, 1}, false})
            .add_node_set(1, "bottom", [](const Eigen::Vector3d& x) { return x.z() == 0.0; })
            .add_node_set(2, "top", is_top)
            .add_side_set(1, "above",
                          [=](const contactsim::test::CandidateSide& side) { return is_top(side.centroid); })
            .build());
  }
  void write_deck(const std::string& region, const std::string& contact = "") const {
    write("a.i",
          "begin sierra\nbegin material m\ndensity = 8000\nbegin parameters for model elastic\n"
          "youngs modulus = 1e6\npoissons ratio = 0.3\nend\nend\n"
          "begin function ramp\ntype = piecewise linear\nbegin values\n0 0\n1 1\nend\nend\n"
          "begin finite element model f\nbegin parameters for block low up\nmaterial = m\nmodel = "
          "elastic\nend\nend\n"
          "begin adagio procedure p\nbegin time control\nbegin time stepping block t\nstart time = 0\n"
          "begin parameters for adagio region r\ntime increment = 0.25\nend\nend\ntermination time = 1\nend\n"
          "begin adagio region r\nuse finite element model f\n"
          "begin fixed displacement\nnode set = bottom\ncomponents = x y z\nend\n"
          "begin contact definition c\nskin all blocks = on\nbegin constant friction model rough\n"
          "friction coefficient = 0.3\nend\nbegin interaction defaults\ngeneral contact = on\n" +
              contact +
              "end\nend\nbegin user output\nblock = low\ncompute global force as sum of nodal "
              "force_contact(z)\nend\n"
              "begin heartbeat output\nstream name = a.csv\nprecision = 17\nat step 0 increment = 1\n"
              "global force\nglobal internal_energy as work\nend\n" +
              region + "end\nend\nend\n");
  }
  double last_force() const {
    const std::string text = read("a.csv");
    const std::string line = text.substr(text.rfind('\n', text.size() - 2) + 1);
    return std::stod(line.substr(line.find(',') + 1));
  }
};

const std::string sliding =
    "begin prescribed displacement\nnode set = top\ncomponent = z\nfunction = ramp\nscale factor = "
    "-0.02\nend\n"
    "begin prescribed displacement\nnode set = top\ncomponent = x\nfunction = ramp\nscale factor = "
    "0.05\nend\n"
    "begin fixed displacement\nnode set = top\ncomponent = y\nend\n";
const std::string pressed =
    "begin fixed displacement\nnode set = top\ncomponents = x y\nend\n"
    "begin pressure\nsurface = above\nfunction = ramp\nscale factor = 1e4\nend\n";
const std::string full = "begin solver\nbegin cg\nbegin full tangent preconditioner\nend\nend\nend\n";
const std::string rough = "friction model = rough\n";

}  // namespace

TEST_CASE("contact of load steps has the same bytes for any number of threads", "[app][statics]") {
  const PressedBlock block;
  for (const std::string& solver : {std::string(), full}) {
    block.write_deck(sliding + solver, rough);
    REQUIRE(block.run({"a.i", "--threads", "1"}).exit_code == 0);
    const std::string one = block.read("a.csv");
    REQUIRE(block.run({"a.i", "--threads", "2"}).exit_code == 0);
    CHECK(block.read("a.csv") == one);
    CHECK(block.last_force() < -1000.0);
  }
}

TEST_CASE("contact of load steps goes on from a stored state with the same bytes", "[app][statics]") {
  const PressedBlock block;
  const std::string stored = "begin restart data\nat step 0 increment = 2\nend\n";
  SECTION("under the same conditions") { block.write_deck(sliding + full + stored, rough); }
  SECTION("where others come, by which the stiffness behind faces is limited anew") {
    block.write_deck(sliding + full + stored +
                         "begin fixed displacement\nblock = low\ncomponent = y\nactive periods = u\nend\n",
                     rough + "enforcement = penalty\n");
    std::string deck = block.read("a.i");
    const std::string end = "termination time";
    deck.insert(deck.find(end),
                "begin time stepping block u\nstart time = 0.75\nbegin parameters for adagio region r\n"
                "time increment = 0.25\nend\nend\n");
    block.write("a.i", deck);
  }
  REQUIRE(block.run({"a.i"}).exit_code == 0);
  const std::string straight = block.read("a.csv");
  const std::string deck = block.read("a.i");
  block.write("a.i", "begin sierra\nrestart time = 0.5\n" + deck.substr(deck.find('\n') + 1));
  REQUIRE(block.run({"a.i"}).exit_code == 0);
  const std::string rest = block.read("a.csv-s0002");
  const std::string lines = rest.substr(rest.find('\n') + 1);
  CHECK(lines.size() > 40);
  CHECK(straight.substr(straight.size() - lines.size()) == lines);
}

TEST_CASE("a body that only contact holds drifts until it touches", "[app][statics]") {
  const double gap = GENERATE(0.0, 0.03);
  const PressedBlock block(gap);
  for (const std::string& solver : {std::string(), full}) {
    block.write_deck(pressed + solver);
    REQUIRE(block.run({"a.i"}).exit_code == 0);
    CHECK(block.last_force() == Approx(-1e4 * 1.5 * 1.5).epsilon(0.02));
  }
}

TEST_CASE("stabilization is gone as a time stepping block ends, and reported where it is not",
          "[app][statics]") {
  const PressedBlock block(0.05);
  const std::string free =
      "begin pressure\nsurface = above\nfunction = ramp\nscale factor = 1e4\nend\n" + full;
  const std::string stored = "begin restart data\nat step 0 increment = 2\nend\n";
  block.write_deck(free + stored, "contact stabilization = on\n");
  const auto [code, out, err] = block.run({"a.i", "--threads", "1"});
  REQUIRE(code == 0);
  CHECK(block.last_force() == Approx(-1e4 * 1.5 * 1.5).epsilon(0.02));
  CHECK_THAT(out, Contains("stabilization bears") && Contains("lost to stabilization"));
  CHECK_THAT(err, !Contains("[stabilization-remains]"));
  const std::string straight = block.read("a.csv");
  block.write_deck(free, "contact stabilization = on\n");
  REQUIRE(block.run({"a.i", "--threads", "2"}).exit_code == 0);
  CHECK(block.read("a.csv") == straight);
  block.write_deck(free + stored, "contact stabilization = on\n");
  const std::string deck = block.read("a.i");
  block.write("a.i", "begin sierra\nrestart time = 0.5\n" + deck.substr(deck.find('\n') + 1));
  REQUIRE(block.run({"a.i"}).exit_code == 0);
  const std::string rest = block.read("a.csv-s0002");
  const std::string lines = rest.substr(rest.find('\n') + 1);
  CHECK(lines.size() > 40);
  CHECK(straight.substr(straight.size() - lines.size()) == lines);
  block.write_deck(free, "contact stabilization = on\nstabilization remaining fraction = 1\n");
  const auto remains = block.run({"a.i"});
  CHECK(remains.exit_code == 0);
  CHECK_THAT(remains.err, Contains("[stabilization-remains]"));
}

TEST_CASE("a load step that finds no equilibrium does not tell of what its trials went into",
          "[app][statics]") {
  const PressedBlock block;
  block.write_deck(
      "begin prescribed displacement\nnode set = top\ncomponent = z\nfunction = ramp\nscale factor = "
      "-1.6\nend\n"
      "begin fixed displacement\nnode set = top\ncomponents = x y\nend\n"
      "begin solver\nbegin cg\ntarget relative residual = 1e-12\nacceptable relative residual = 1e-12\n"
      "maximum iterations = 1\nend\nend\n"
      "begin adaptive time stepping\nmaximum failure cutbacks = 0\nend\n");
  const auto [code, out, err] = block.run({"a.i"});
  CHECK(code == 4);
  CHECK_THAT(err, Contains("no equilibrium") && !Contains("interpenetration"));
}

TEST_CASE("enforcement of load steps is reported, and that of explicit steps has no effect",
          "[app][statics]") {
  const PressedBlock block;
  block.write_deck(sliding);
  const auto [code, out, err] = block.run({"a.i"});
  CHECK(code == 0);
  CHECK_THAT(out, Contains("augmented_lagrange") && Contains("updates"));
  block.write_deck(sliding, "enforcement = momentum_balance\n");
  CHECK_THAT(block.run({"a.i"}).err, Contains("ENFORCEMENT = MOMENTUM_BALANCE has no effect"));
  block.write_deck(sliding, "enforcement = penalty\n");
  const auto penalty = block.run({"a.i"});
  CHECK(penalty.exit_code == 0);
  CHECK_THAT(penalty.out, !Contains("augmented_lagrange"));
}

TEST_CASE("multipliers that end above their target are reported with change and target", "[app][statics]") {
  const PressedBlock block;
  const auto control = [](const std::string& lines) {
    return "begin solver\nbegin control contact\n" + lines + "end\nend\n";
  };
  block.write_deck(sliding + control("target relative residual = 1e-12\nacceptable relative residual = 1\n"
                                     "maximum iterations = 2\n"));
  const auto [code, out, err] = block.run({"a.i"});
  CHECK(code == 0);
  CHECK_THAT(out, Contains("multipliers change contact forces by") && Contains("not below the target 1e-12"));
  CHECK_THAT(err, Contains("4 load steps ended above the target, the first at step 1, time 0.25: multipliers "
                           "would still change contact forces by") &&
                      Contains("where the target is 1e-12") && !Contains("forces left over are"));
  // The penalty alone, and multipliers that reach their target, are what the deck asks for.
  for (const char* lines : {"maximum iterations = 0\n", "target relative residual = 1e-2\n"}) {
    block.write_deck(sliding + control(lines));
    const auto asked_for = block.run({"a.i"});
    CHECK(asked_for.exit_code == 0);
    CHECK_THAT(asked_for.out + asked_for.err,
               !Contains("multipliers change contact") && !Contains("above the"));
  }
}

TEST_CASE("the work of an overlap that comes in over load steps is external", "[app][statics]") {
  const PressedBlock block(-0.02);
  const auto last_line = [](const std::string& text) {
    return text.substr(text.rfind('\n', text.size() - 2) + 1);
  };
  for (const char* formulation : {"face_face", "node_face"}) {
    block.write_deck("begin fixed displacement\nnode set = top\ncomponents = x y z\nend\n" + full +
                         "begin heartbeat output\nstream name = b.csv\nat step 0 increment = 1\n"
                         "global internal_energy as i\nglobal external_energy as e\n"
                         "global contact_energy as c\nend\n",
                     std::string("overlap ramp time = 1\nconstraint formulation = ") + formulation + "\n");
    REQUIRE(block.run({"a.i"}).exit_code == 0);
    double time = 0.0, internal = 0.0, external = 0.0, contact = 1.0;
    const std::string line = last_line(block.read("b.csv"));
    REQUIRE(std::sscanf(line.c_str(), "%lf,%lf,%lf,%lf", &time, &internal, &external, &contact) == 4);
    CHECK(internal > 10.0);
    CHECK(external == Approx(internal).epsilon(0.02));
    CHECK(contact == Approx(0.0).margin(0.02 * internal));
  }
}

TEST_CASE("a step that is cut back has all updates of multipliers again", "[app][statics]") {
  const PressedBlock block;
  // Steps like the first one go on; those of the second block have to come nearer, which half of one does.
  block.write_deck(sliding +
                   "begin solver\nbegin control contact\ntarget relative residual = 1e-9\n"
                   "acceptable relative residual = 1\nacceptable relative residual = 3e-3 during u\n"
                   "maximum iterations = 1\nend\nend\n");
  const std::string deck = block.read("a.i");
  const auto end = deck.find("termination time");
  block.write("a.i", deck.substr(0, end) +
                         "begin time stepping block u\nstart time = 0.25\nbegin parameters for adagio region "
                         "r\ntime increment = 0.25\nend\nend\n" +
                         deck.substr(end));
  const auto [code, out, err] = block.run({"a.i"});
  CHECK(code == 0);
  CHECK_THAT(out, Contains(" 1        1"));  // cutbacks and updates
}

}  // namespace static_contact_run_test
