// SPDX-License-Identifier: BSD-3-Clause
// Contact in a procedure that takes over the state of another, by the program.
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

constexpr std::size_t pressed_by = 1, pushed_by = 2, moves_by = 3, stored_by = 4, held_by = 5, lost = 6,
                      rubbed = 7;

/// A block on another one of other meshes, pressed down and aside by load steps up to time 1.
struct PressedBlocks : ProgramDirectory {
  PressedBlocks() {
    const auto is_top = [](const Eigen::Vector3d& x) { return x.z() == 1.0; };
    contactsim::test::write_exodus(
        path("a.g"),
        MeshBuilder()
            .add_hexes({1, "low", {3, 3, 2}, {0, 0, 0}, {1, 1, 0.5}})
            .add_hexes({2, "high", {2, 2, 2}, {0, 0, 0.5}, {1, 1, 0.5}, false})
            .add_node_set(1, "bottom", [](const Eigen::Vector3d& x) { return x.z() == 0.0; })
            .add_node_set(2, "top", is_top)
            .add_side_set(1, "above",
                          [=](const contactsim::test::CandidateSide& side) { return is_top(side.centroid); })
            .build());
  }
  /// One of load steps ("adagio"), which lets go aside after time 1, or of explicit dynamics ("presto").
  static std::string procedure(const std::string& kind, const std::string& name, const std::string& start,
                               const std::string& end, const std::string& pair_lines,
                               const std::string& more = "") {
    const bool is_static = kind == "adagio";
    return "begin " + kind + " procedure " + name + "\n" +
           (start == "0" ? "" : "begin procedural transfer\ninclude all blocks\nend\n") +
           "begin time control\nbegin time stepping block t\nstart time = " + start +
           "\nbegin parameters for " + kind + " region " + name + "\n" +
           (is_static ? "number of time steps = 4\n" : "") + "end\nend\ntermination time = " + end +
           "\nend\nbegin " + kind + " region " + name +
           "\nuse finite element model f\n"
           "begin fixed displacement\nnode set = bottom\ncomponents = x y z\nend\n"
           "begin pressure\nsurface = above\nfunction = press\nscale factor = 1e3\nend\n"
           "begin prescribed force\nnode set = top\ncomponent = x\nfunction = " +
           (is_static ? "aside" : "press") +
           "\nscale factor = 20\nend\n"
           "begin contact definition\nskin all blocks = on\nbegin constant friction model rough\n"
           "friction coefficient = 0.5\nend\nbegin interaction defaults\ngeneral contact = on\n"
           "friction model = rough\n" +
           pair_lines + "end\nend\n" +
           (is_static ? "begin solver\nbegin cg\ntarget relative residual = 1e-8\nbegin full tangent "
                        "preconditioner\nend\nend\nbegin control contact\ntarget relative residual = 1e-6\n"
                        "end\nend\n"
                      : "") +
           "begin user output\nblock = low\ncompute global force as sum of nodal force_contact\nend\n"
           "begin heartbeat output\nstream name = " +
           name +
           ".csv\nprecision = 17\nat step 0 increment = 1\nglobal force(z)\nglobal force(x)\n"
           "global kinetic_energy as kinetic\nglobal strain_energy as strain\nglobal contact_energy as held\n"
           "global energy_error as lost\nglobal friction_energy as rubbed\nend\n" +
           more + "end\nend\n";
  }
  ProgramOutput run_deck(const std::string& procedures, const std::string& sierra = "") const {
    write("a.i", "begin sierra\n" + sierra +
                     "begin material m\ndensity = 1000\nbegin parameters for model elastic\n"
                     "youngs modulus = 1e6\npoissons ratio = 0.3\nend\nend\n"
                     "begin function press\ntype = piecewise linear\nbegin values\n0 0\n1 1\n2 1\nend\nend\n"
                     "begin function aside\ntype = piecewise linear\nbegin values\n0 0\n1 1\n2 0\nend\nend\n"
                     "begin finite element model f\nbegin parameters for block low high\nmaterial = m\n"
                     "model = elastic\nend\nend\n" +
                     procedures + "end\n");
    return run({"a.i"});
  }
  std::vector<double> column(const std::string& name, std::size_t i) const {
    return csv_column(read(name + ".csv"), i);
  }
};

}  // namespace

TEST_CASE("contact meets what a preload has moved", "[app][procedures]") {
  ProgramDirectory boxes;
  MeshBuilder b;
  b.add_hexes({.id = 1, .name = "low"});
  b.add_hexes({.id = 2, .name = "high", .origin = {0, 0, 1.5}, .share_nodes = false});
  contactsim::test::write_exodus(boxes.path("a.g"), b.build());
  const auto run = [&](const std::string& depth) {
    const std::string times = "begin time control\nbegin time stepping block t\nstart time = ";
    const std::string region =
        "use finite element model f\nbegin fixed displacement\nblock = low\ncomponents = x y z\nend\n";
    boxes.write(
        "a.i",
        "begin sierra\nbegin material m\ndensity = 8000\nbegin parameters for model elastic\n"
        "youngs modulus = 2e9\npoissons ratio = 0.3\nend\nend\nbegin function ramp\ntype = piecewise linear\n"
        "begin values\n0 0\n1 1\nend\nend\nbegin finite element model f\nbegin parameters for block low "
        "high\n"
        "material = m\nmodel = elastic\nend\nend\nbegin adagio procedure a\n" +
            times +
            "0\nbegin parameters for adagio region r\nnumber of time steps = 1\nend\nend\n"
            "termination time = 1\nend\nbegin adagio region r\n" +
            region +
            "begin prescribed displacement\nblock = high\ncomponent = z\nfunction = ramp\nscale factor = " +
            depth +
            "\nend\nbegin fixed displacement\nblock = high\ncomponents = x y\nend\nend\nend\n"
            "begin presto procedure p\n"
            "begin procedural transfer\ninclude all blocks\nend\n" +
            times +
            "1\nbegin parameters for presto region s\nend\nend\ntermination time = 1.015\nend\n"
            "begin presto region s\n" +
            region +
            "begin initial velocity\nblock = high\ncomponent = z\nmagnitude = -10\nend\n"
            "begin contact definition\nskin all blocks = on\nbegin interaction defaults\ngeneral contact = "
            "on\n"
            "end\nend\nbegin heartbeat output\nstream name = a.csv\nat step 0 increment = 1\n"
            "nodal displacement(z) nearest location 0 0 1.5 as low\nend\nend\nend\nend\n");
    return boxes.run({"a.i"});
  };
  CHECK(run("-0.4").exit_code == 0);
  const std::vector<double> place = csv_column(boxes.read("a.csv"), 1);
  CHECK(place.front() == Approx(-0.4));
  CHECK(*std::ranges::min_element(place) == Approx(-0.5).margin(0.01));  // where the low box is
  CHECK_THAT(run("-0.6").err, Contains("[overlap-at-start]"));
}

TEST_CASE("an explicit run from a contact preload does not ring", "[app][procedures]") {
  const std::string form = GENERATE(std::string(), std::string("constraint formulation = node_face\n"));
  const PressedBlocks blocks;
  const auto run = blocks.run_deck(PressedBlocks::procedure("adagio", "load", "0", "1", form) +
                                   PressedBlocks::procedure("presto", "hold", "1", "1.5", form));
  REQUIRE(run.exit_code == 0);
  CHECK_THAT(run.err, !Contains("[contact-begins-anew]"));
  const std::vector<double> moving = blocks.column("hold", moves_by),
                            loads = blocks.column("load", pressed_by);
  REQUIRE(moving.size() > 100);
  const double stored = blocks.column("load", stored_by).back();
  CHECK(*std::max_element(moving.begin(), moving.begin() + 101) < 1e-4 * stored);
  CHECK(blocks.column("hold", pressed_by).front() == Approx(loads.back()).epsilon(1e-3));
  CHECK(blocks.column("hold", held_by).front() == 0.0);
  CHECK(blocks.column("hold", rubbed).front() == Approx(blocks.column("load", rubbed).back()));
  CHECK_THAT(run.out, Contains("put in by the start, overlaps    0.00000e+00"));
  for (const double energy : blocks.column("hold", lost)) CHECK(std::abs(energy) < 1e-8 * stored);
  CHECK(blocks.column("hold", pushed_by).front() ==
        Approx(blocks.column("load", pushed_by).back()).epsilon(1e-3));
}

TEST_CASE("contact of load steps that follow others goes on with what these remember", "[app][procedures]") {
  const std::string form = GENERATE(std::string(), std::string("constraint formulation = node_face\n"));
  const PressedBlocks blocks;
  const std::string loading = PressedBlocks::procedure("adagio", "load", "0", "1", form);
  const auto run = blocks.run_deck(loading + PressedBlocks::procedure("adagio", "rest", "1", "2", form));
  REQUIRE(run.exit_code == 0);
  CHECK_THAT(run.err, !Contains("[contact-begins-anew]"));
  for (const std::size_t i : {pressed_by, pushed_by}) {
    CHECK(blocks.column("rest", i).front() == Approx(blocks.column("load", i).back()).epsilon(1e-6));
  }
  // As one procedure of two time stepping blocks.
  std::string whole = PressedBlocks::procedure("adagio", "whole", "0", "2", form);
  const auto end = whole.find("termination time");
  whole.insert(end,
               "begin time stepping block u\nstart time = 1\nbegin parameters for adagio region whole\n"
               "number of time steps = 4\nend\nend\n");
  REQUIRE(blocks.run_deck(whole).exit_code == 0);
  CHECK(blocks.column("rest", pushed_by).back() ==
        Approx(blocks.column("whole", pushed_by).back()).margin(1e-3));
  CHECK(blocks.column("rest", stored_by).back() ==
        Approx(blocks.column("whole", stored_by).back()).epsilon(1e-6));
}

namespace {

const std::string tied = "friction model = tied\n";
const std::string corner =
    "begin heartbeat output\nstream name = %.csv\nprecision = 17\nat step 0 increment = 1\n"
    "nodal displacement(x) nearest location 1 1 1 as x\nnodal displacement(z) nearest location 1 1 1 as z\n"
    "end\n";

/// A procedure of the blocks, tied, that also writes c_<name>.csv with the motion of a corner.
///   pair_lines  more of the interaction
std::string tied_procedure(const std::string& kind, const std::string& name, const std::string& start,
                           const std::string& end, const std::string& pair_lines,
                           const std::string& more = "") {
  std::string moving = corner;
  moving.replace(moving.find('%'), 1, "c_" + name);
  std::string text = PressedBlocks::procedure(kind, name, start, end, pair_lines, moving + more);
  const std::string rough = "friction model = rough\n";
  return text.replace(text.find(rough), rough.size(), tied);
}

}  // namespace

TEST_CASE("an explicit run from a preload of tied bodies does not ring", "[app][procedures][ties]") {
  const std::string form = GENERATE(std::string(), std::string("constraint formulation = node_face\n"));
  const std::string law = GENERATE(std::string(), std::string("enforcement = penalty\n"));
  const PressedBlocks blocks;
  const auto run = blocks.run_deck(tied_procedure("adagio", "load", "0", "1", form) +
                                   tied_procedure("presto", "hold", "1", "1.5", form + law));
  CAPTURE(form, law, run.err);
  REQUIRE(run.exit_code == 0);
  // What balanced ties find in other places than load steps is held.
  if (!run.err.empty()) CHECK_THAT(run.err, Contains("[contact-held]") && !Contains("error"));
  const std::vector<double> moving = blocks.column("hold", moves_by);
  REQUIRE(moving.size() > 100);
  const double stored = blocks.column("load", stored_by).back();
  CHECK(*std::max_element(moving.begin(), moving.begin() + 101) < 1e-4 * stored);
  for (const std::size_t i : {pressed_by, pushed_by}) {
    const double at_end = blocks.column("load", i).back();
    const std::vector<double> forces = blocks.column("hold", i);
    for (std::size_t step = 0; step <= 100; ++step) CHECK(forces[step] == Approx(at_end).epsilon(0.01));
  }
  // The tie keeps the places of the start: the preload moves the corner by 5e-3.
  for (const std::size_t i : {1u, 2u}) {
    const double at_end = blocks.column("c_load", i).back();
    const std::vector<double> places = blocks.column("c_hold", i);
    CHECK(std::abs(at_end) > 5e-4);
    for (std::size_t step = 0; step <= 100; ++step) CHECK(std::abs(places[step] - at_end) < 1e-5);
  }
}

TEST_CASE("what is held of a preload is reported by a run that ends before contact has found its forces, too",
          "[app][procedures][ties]") {
  const std::string form = "constraint formulation = node_face\n";
  const PressedBlocks blocks;
  const auto run = blocks.run_deck(tied_procedure("adagio", "load", "0", "1", form) +
                                   tied_procedure("presto", "hold", "1", "1.004", form));
  REQUIRE(run.exit_code == 0);
  CHECK(blocks.column("hold", moves_by).size() < 4);
  CHECK_THAT(run.err, Contains("[contact-held]"));
}

TEST_CASE("what load steps have glued stays glued in explicit dynamics", "[app][procedures][ties]") {
  const std::string law = GENERATE(std::string(), std::string("enforcement = penalty\n"));
  const PressedBlocks blocks;
  const auto glued = [](std::string text) {
    const std::string rough = "begin constant friction model rough\nfriction coefficient = 0.5\n",
                      aside = "scale factor = 20\n";
    text.replace(text.find(rough), rough.size(), "begin glued model rough\n");
    return text.replace(text.find(aside), aside.size(), "scale factor = 0\n");
  };
  const auto run = blocks.run_deck(glued(PressedBlocks::procedure("adagio", "load", "0", "1", "")) +
                                   glued(PressedBlocks::procedure("presto", "hold", "1", "1.5", law)));
  CAPTURE(law, run.err);
  REQUIRE(run.exit_code == 0);
  CHECK(run.err == "");
  const std::vector<double> moving = blocks.column("hold", moves_by);
  REQUIRE(moving.size() > 100);
  CHECK(*std::max_element(moving.begin(), moving.begin() + 101) <
        1e-4 * blocks.column("load", stored_by).back());
  CHECK(blocks.column("hold", pressed_by).front() ==
        Approx(blocks.column("load", pressed_by).back()).epsilon(1e-3));
}

TEST_CASE("ties of load steps go on in those that follow", "[app][procedures][ties]") {
  const std::string form = GENERATE(std::string(), std::string("constraint formulation = node_face\n"));
  const PressedBlocks blocks;
  const auto run = blocks.run_deck(tied_procedure("adagio", "load", "0", "1", form) +
                                   tied_procedure("adagio", "rest", "1", "2", form));
  REQUIRE(run.exit_code == 0);
  CHECK(run.err == "");
  std::string whole = tied_procedure("adagio", "whole", "0", "2", form);
  whole.insert(whole.find("termination time"),
               "begin time stepping block u\nstart time = 1\nbegin parameters for adagio region whole\n"
               "number of time steps = 4\nend\nend\n");
  REQUIRE(blocks.run_deck(whole).exit_code == 0);
  for (const std::size_t i : {1u, 2u})
    CHECK(blocks.column("c_rest", i).back() == Approx(blocks.column("c_whole", i).back()).margin(1e-9));
}

namespace {

/// Blocks that explicit contact presses by each formulation and enforcement, with friction or tied.
struct BlocksPressedFast : PressedBlocks {
  std::string part(const std::string& kind, const std::string& name, const std::string& start,
                   const std::string& end) const {
    return (is_tied ? tied_procedure : PressedBlocks::procedure)(kind, name, start, end, lines, "");
  }
  /// Runs two procedures, the second of which takes contact over.
  void run_both(const std::string& first, const std::string& second) const {
    const auto run = run_deck(first + second);
    CAPTURE(lines, is_tied, run.err);
    REQUIRE(run.exit_code == 0);
    CHECK_THAT(run.err, !Contains("[contact-begins-anew]"));
  }

  std::string lines = GENERATE(std::string(), std::string("constraint formulation = node_face\n"),
                               std::string("enforcement = penalty\n"));
  bool is_tied = GENERATE(false, true);
};

}  // namespace

TEST_CASE("explicit contact goes on in explicit dynamics as if there were one procedure",
          "[app][procedures]") {
  const BlocksPressedFast blocks;
  blocks.run_both(blocks.part("presto", "load", "0", "0.5"), blocks.part("presto", "rest", "0.5", "1"));
  const double stored = blocks.column("rest", stored_by).back();
  for (const double energy : blocks.column("rest", lost)) CHECK(std::abs(energy) < 1e-4 * stored);
  REQUIRE(blocks.run_deck(blocks.part("presto", "whole", "0", "1")).exit_code == 0);
  CAPTURE(blocks.lines, blocks.is_tied);
  for (const std::size_t i : {pressed_by, pushed_by, stored_by}) {
    CHECK(blocks.column("rest", i).back() == Approx(blocks.column("whole", i).back()).epsilon(0.01));
    CHECK(blocks.column("rest", i).front() == Approx(blocks.column("load", i).back()).epsilon(5e-3));
  }
  CHECK(blocks.column("rest", rubbed).back() ==
        Approx(blocks.column("whole", rubbed).back()).margin(2e-4 * stored));
}

TEST_CASE("load steps behind explicit contact come to rest as load steps alone do", "[app][procedures]") {
  const BlocksPressedFast blocks;
  blocks.run_both(blocks.part("presto", "load", "0", "1"), blocks.part("adagio", "rest", "1", "2"));
  const double pressed = blocks.column("rest", pressed_by).back(),
               stored = blocks.column("rest", stored_by).back();
  blocks.run_both(blocks.part("adagio", "load", "0", "1"), blocks.part("adagio", "still", "1", "2"));
  CAPTURE(blocks.lines, blocks.is_tied);
  CHECK(pressed == Approx(blocks.column("still", pressed_by).back()).epsilon(1e-4));
  CHECK(stored == Approx(blocks.column("still", stored_by).back()).epsilon(0.01));
}

TEST_CASE("ties are refused where no contact is taken over", "[app][procedures][ties]") {
  const PressedBlocks blocks;
  const auto run =
      blocks.run_deck(tied_procedure("adagio", "load", "0", "1", "") +
                      tied_procedure("presto", "hold", "1", "1.1", "constraint formulation = node_face\n"));
  CHECK(run.exit_code == 2);
  CHECK_THAT(run.err, Contains("where a PROCEDURAL TRANSFER takes over no contact"));
}

TEST_CASE("contact of other pairs begins anew after a transfer, which is reported", "[app][procedures]") {
  const PressedBlocks blocks;
  const std::string loading = PressedBlocks::procedure("adagio", "load", "0", "1", "");
  const auto other = blocks.run_deck(
      loading + PressedBlocks::procedure("presto", "hold", "1", "1.001", "separation = off\n"));
  CHECK(other.exit_code == 0);
  CHECK_THAT(other.err, Contains("[contact-begins-anew]"));
}

TEST_CASE("penalty contact holds what a preload has pressed with, and lets it go evenly",
          "[app][procedures]") {
  const std::string form = GENERATE(std::string(), std::string("constraint formulation = node_face\n"));
  const PressedBlocks blocks;
  const auto run = blocks.run_deck(
      PressedBlocks::procedure("adagio", "load", "0", "1", form) +
      PressedBlocks::procedure("presto", "hold", "1", "1.5", form + "enforcement = penalty\n"));
  REQUIRE(run.exit_code == 0);
  CHECK_THAT(run.err, Contains("[contact-held]"));
  CHECK_THAT(run.err, Contains("held and let go evenly until t = 1.5"));
  const std::vector<double> moving = blocks.column("hold", moves_by);
  REQUIRE(moving.size() > 100);
  const double stored = blocks.column("load", stored_by).back();
  CHECK(moving.front() < 1e-12 * stored);
  CHECK(*std::ranges::max_element(moving) < 5e-3 * stored);  // of sinking in
  for (const double energy : blocks.column("hold", lost)) CHECK(std::abs(energy) < 1e-5 * stored);
  const double at_end = blocks.column("load", pressed_by).back();
  CHECK(blocks.column("hold", pressed_by).front() == Approx(at_end).epsilon(1e-6));
  CHECK(blocks.column("hold", pressed_by).back() == Approx(at_end).epsilon(0.05));
}

TEST_CASE("a deck of several procedures goes on from a stored state with the same bytes",
          "[app][procedures]") {
  const std::string second = GENERATE(std::string("presto"), std::string("adagio"));
  const bool is_tied = GENERATE(false, true);
  const std::string law = GENERATE(std::string(), std::string("enforcement = penalty\n"));
  if (second == "adagio" && !law.empty()) return;
  const auto make = is_tied ? tied_procedure : PressedBlocks::procedure;
  const PressedBlocks blocks;
  const auto data = [](const std::string& name) {
    return "begin restart data\noutput database name = " + name + ".rsout\ninput database name = " + name +
           ".rsout\nat step 0 increment = 2\nend\n";
  };
  const std::string procedures = make("adagio", "load", "0", "1", "", data("load")) +
                                 make(second, "rest", "1", "1.02", law, data("rest"));
  const auto straight = blocks.run_deck(procedures);
  CAPTURE(straight.err);
  REQUIRE(straight.exit_code == 0);
  const std::string loaded = blocks.read("load.csv"), rest = blocks.read("rest.csv");
  const auto ends_with = [](const std::string& text, const std::string& resumed) {
    const std::string lines = resumed.substr(resumed.find('\n') + 1);
    return lines.size() > 40 && text.ends_with(lines);
  };
  // In the middle of the first, at the border, in the second.
  const auto in_first = blocks.run_deck(procedures, "restart time = 0.5\n");
  REQUIRE(in_first.exit_code == 0);
  CHECK(ends_with(loaded, blocks.read("load.csv-s0002")));
  CHECK(blocks.read("rest.csv") == rest);
  const auto at_border = blocks.run_deck(procedures, "restart time = 1\n");
  REQUIRE(at_border.exit_code == 0);
  CHECK(blocks.read("rest.csv") == rest);
  const auto in_second = blocks.run_deck(procedures, "restart time = 1.01\n");
  REQUIRE(in_second.exit_code == 0);
  CHECK_THAT(in_second.out, Contains("The procedure load is not run: rest goes on from its stored state."));
  CHECK(ends_with(rest, blocks.read("rest.csv-s0002")));
}
