// SPDX-License-Identifier: BSD-3-Clause
#include "app/run/start_warnings.hpp"

#include <fmt/format.h>

#include "io/exodus/exodus_reader.hpp"
#include "support/catch.hpp"
#include "support/exodus_file.hpp"
#include "support/mesh_builder.hpp"
#include "support/program_run.hpp"

// What a run says of the laws of its pairs before the first step.

using Catch::Matchers::Contains;
using contactsim::Mesh;
using contactsim::test::MeshBuilder;
using contactsim::test::ProgramDirectory;

namespace start_warnings_test {

namespace {

const std::string adhesive = "begin adhesion model sticky\nadhesion function = pull\nend\n",
                  hybrid =
                      "begin constant friction model rough\nfriction coefficient = 0.5\nend\n"
                      "begin hybrid model half\ninitially close = rough\n";

/// A deck of elastic blocks block_1 and block_2.
struct LawDeck : ProgramDirectory {
  ///   contact     lines of the contact definition
  ///   of_region   further lines of the region
  ///   parameters  lines of the time stepping
  LawDeck(const Mesh& mesh, const std::string& contact, const std::string& of_region = "",
          const std::string& parameters = "", double end = 1e-5) {
    contactsim::test::write_exodus(path("a.g"), mesh);
    const auto is_beam = [&](std::size_t i) { return mesh.blocks()[i].shape == contactsim::Shape::beam2; };
    const std::string beam_section =
        "begin beam section rod\nsection = rod\nwidth = 0.2\nheight = 0.2\nt axis = 0 0 1\nend\n";
    std::string blocks;
    for (std::size_t i = 0; i < 2; ++i)
      blocks += fmt::format("begin parameters for block block_{}\nmaterial = m\nmodel = elastic\n{}end\n",
                            i + 1, is_beam(i) ? "section = rod\n" : "");
    write("a.i",
          "begin sierra\nbegin material m\ndensity = 1000\nbegin parameters for model elastic\n"
          "youngs modulus = 1e8\npoissons ratio = 0.3\nend\nend\n"
          "begin function pull\ntype is piecewise linear\nbegin values\n0 0\n0.01 1\n0.02 0\nend\nend\n" +
              (is_beam(0) || is_beam(1) ? beam_section : "") + "begin finite element model f\n" + blocks +
              "end\nbegin presto procedure p\nbegin time control\nbegin time stepping block t\n"
              "start time = 0\nbegin parameters for presto region r\n" +
              parameters + fmt::format("end\nend\ntermination time = {}\nend\n", end) +
              "begin presto region r\nuse finite element model f\n" + of_region +
              "begin contact definition c\n" + contact + "end\nend\nend\nend\n");
  }
};

std::string general(const std::string& model, const std::string& surfaces = "skin all blocks = on\n") {
  return surfaces + "begin interaction defaults\ngeneral contact = on\nfriction model = " + model + "\nend\n";
}

/// The pair of the blocks.
std::string pair(const std::string& lines) {
  return "contact surface low contains block_1\ncontact surface high contains block_2\n"
         "begin interaction\nsurfaces = low high\n" +
         lines + "end\n";
}

Mesh crossed_rods() {
  return MeshBuilder()
      .add_beams({.id = 1, .cells = 3, .from = {-1, 0.05, 0}, .to = {1, 0.05, 0}})
      .add_beams({.id = 2, .cells = 3, .from = {0.1, -1, 0.21}, .to = {0.1, 1, 0.21}})
      .build();
}

Mesh block_on_block() {
  return MeshBuilder()
      .add_hexes({.id = 1, .cells = {2, 2, 2}})
      .add_hexes({.id = 2, .cells = {3, 3, 2}, .origin = {0, 0, 1}, .share_nodes = false})
      .build();
}

Mesh blocks_apart(double gap) {
  return MeshBuilder()
      .add_hexes({.id = 1, .cells = {2, 2, 2}})
      .add_hexes({.id = 2, .cells = {2, 2, 2}, .origin = {0, 0, 1.0 + gap}, .share_nodes = false})
      .build();
}

Mesh rod_on_block() {
  return MeshBuilder()
      .add_hexes({.id = 1, .cells = {2, 2, 2}})
      .add_beams({.id = 2, .cells = 3, .from = {0.1, 0.4, 1.1}, .to = {0.9, 0.6, 1.1}})
      .build();
}

std::string warnings_of(const Mesh& mesh, const std::string& contact) {
  const auto [code, out, err] = LawDeck(mesh, contact).run({"a.i"});
  CHECK(code == 0);
  return err;
}

}  // namespace

TEST_CASE("rods that meet under a law that acts on faces alone are reported", "[app][edges]") {
  CHECK_THAT(
      warnings_of(crossed_rods(), general("tied")),
      Contains("where beams or trusses meet each other the law 'tied' does not act: they are neither tied "
               "nor kept apart") &&
          Contains("[edges-without-law]"));
  CHECK_THAT(
      warnings_of(crossed_rods(), adhesive + general("sticky")),
      Contains("they only push each other apart, with its friction") && Contains("[edges-without-law]"));
}

TEST_CASE("laws that act between rods, and rods without edge contact, are nothing to tell", "[app][edges]") {
  const std::string no_edges = "skin all blocks = on\nbegin surface options\nedge contact = off\nend\n";
  CHECK_THAT(warnings_of(crossed_rods(), general("frictionless")), !Contains("edges-without-law"));
  CHECK_THAT(warnings_of(crossed_rods(), hybrid + "end\n" + general("half")), !Contains("edges-without-law"));
  CHECK_THAT(warnings_of(crossed_rods(), general("tied", no_edges)), !Contains("edges-without-law"));
}

TEST_CASE("a tied hybrid half of rods is reported", "[app][edges]") {
  const std::string half_tied = "begin hybrid model half\ninitially close = tied\nend\n";
  CHECK_THAT(warnings_of(crossed_rods(), half_tied + general("half")), Contains("where it ties"));
}

TEST_CASE("tied solids, and a rod tied to a solid, are nothing to tell", "[app][edges]") {
  CHECK_THAT(warnings_of(block_on_block(), general("tied")), !Contains("edges-without-law"));
  CHECK_THAT(warnings_of(rod_on_block(), general("tied")), !Contains("edges-without-law"));
}

TEST_CASE("lines about gaps that do nothing are reported", "[app][gaps]") {
  CHECK_THAT(warnings_of(blocks_apart(0.0), pair("friction model = tied\ncontact offset = 0.1\n")),
             Contains("[gap-without-effect]"));
  CHECK_THAT(warnings_of(blocks_apart(3.0), pair("initial clearance = 0.1\n")),
             Contains("[clearance-empty]"));
  CHECK_THAT(warnings_of(blocks_apart(1.0), pair("initial clearance = 0.1\nnormal tolerance = 2\n")),
             Contains("[clearance-far]"));
  // Slivers beside faces that match but for round-off are as wide as nothing.
  const double shift = GENERATE(0.0, 1e-9);
  const Mesh near =
      MeshBuilder()
          .add_hexes({.id = 1, .cells = {2, 2, 2}})
          .add_hexes({.id = 2, .cells = {2, 2, 2}, .origin = {shift, 0, 1.01}, .share_nodes = false})
          .build();
  const std::string sound = warnings_of(near, pair("initial clearance = 0.1\n"));
  CHECK_THAT(sound, !Contains("clearance-") && !Contains("gap-without-effect"));
}

TEST_CASE("lines about separation, sides and stiffness that do nothing are reported", "[app][sides]") {
  const auto reported = [](const std::string& lines, const std::string& models = "") {
    return warnings_of(block_on_block(), models + pair(lines));
  };
  CHECK_THAT(reported("sides = top\n"),
             Contains("no shell has the side that it names") && Contains("[sides-without-shells]"));
  CHECK_THAT(reported("friction model = tied\nseparation = off\n"), Contains("[separation-without-effect]"));
  const std::string soft =
      "begin exponential pressure model soft\npressure at zero gap = 1\nclearance at zero pressure = 0.001\n";
  CHECK_THAT(reported("friction model = soft\npenalty stiffness = 1e6\n", soft + "end\n"),
             Contains("PENALTY STIFFNESS has no effect beside the law 'exponential pressure'"));
  CHECK_THAT(reported("friction model = soft\npenalty stiffness = 1e6\n",
                      soft + "friction coefficient = 0.1\nend\n"),
             !Contains("PENALTY STIFFNESS"));
  CHECK_THAT(reported("separation = off\n"), !Contains("without-effect"));
}

TEST_CASE("a tie of side sets that leaves a part of both free is reported", "[app][ties]") {
  using contactsim::test::CandidateSide;
  const auto sides = [](double overhang) {
    return MeshBuilder()
        .add_hexes({.id = 1, .cells = {2, 2, 1}, .size = {2, 2, 1}})
        .add_hexes({.id = 2,
                    .cells = {2, 2, 1},
                    .origin = {overhang, 0, 1},
                    .size = {2, 2, 1},
                    .share_nodes = false})
        .add_side_set(1, "top",
                      [](const CandidateSide& side) { return side.block_id == 1 && side.normal.z() > 0.9; })
        .add_side_set(2, "bottom",
                      [](const CandidateSide& side) { return side.block_id == 2 && side.normal.z() < -0.9; })
        .build();
  };
  const std::string surfaces = "contact surface a contains top\ncontact surface b contains bottom\n";
  CHECK_THAT(warnings_of(sides(1.0), general("tied", surfaces)),
             Contains("2 of the 4 faces of '") && Contains("are not tied") && Contains("[tie-partial]"));
  CHECK_THAT(warnings_of(sides(0.0), general("tied", surfaces)), !Contains("tie-partial"));
}

TEST_CASE("lines about reach that do nothing are reported", "[app][reach]") {
  CHECK_THAT(warnings_of(blocks_apart(0.05), pair("capture tolerance = 0.1\n")),
             Contains("[capture-without-effect]") && Contains("'frictionless' holds nothing"));
  CHECK_THAT(warnings_of(blocks_apart(0.05), pair("capture tolerance = 0.1\nfriction model = tied\n")),
             !Contains("capture-without-effect"));
  CHECK_THAT(warnings_of(blocks_apart(0.5), pair("search distance = 0.4\n")),
             Contains("[search-distance-empty]"));
  CHECK_THAT(warnings_of(blocks_apart(0.5), pair("search distance = 0.6\n")),
             !Contains("search-distance-empty"));
  const auto of_all = [](const std::string& lines) {
    return "skin all blocks = on\nbegin interaction defaults\ngeneral contact = on\n" + lines + "end\n";
  };
  CHECK_THAT(warnings_of(blocks_apart(0.5), of_all("search distance = 0.4\n")),
             Contains("nothing of any pair is within the SEARCH DISTANCE"));
  CHECK_THAT(warnings_of(blocks_apart(0.5), of_all("search distance = 0.6\n")),
             !Contains("search-distance-empty"));
  CHECK_THAT(warnings_of(blocks_apart(0.05), pair("search distance = 0.01\nfriction model = tied\n")),
             Contains("no farther than CAPTURE TOLERANCE and SEARCH DISTANCE say"));
  CHECK_THAT(warnings_of(blocks_apart(0.05), of_all("smoothing = auto\n")),
             Contains("[smoothing-without-effect]"));
  CHECK_THAT(warnings_of(blocks_apart(0.05), of_all("sides = top\n")),
             Contains("no pair of the defaults has a shell"));
  const std::string small = "interaction behavior = infinitesimal_sliding\n";
  CHECK_THAT(warnings_of(blocks_apart(0.5), pair(small)), Contains("[no-start-partner]"));
  CHECK_THAT(warnings_of(blocks_apart(0.5), pair(small + "search distance = 0.6\n")),
             !Contains("no-start-partner"));
}

TEST_CASE("nodes that no tie reaches are listed and make a node set of the results", "[app][ties]") {
  const Mesh flat =
      MeshBuilder()
          .add_hexes({.id = 1, .cells = {10, 1, 1}, .size = {10, 1, 1}})
          .add_hexes(
              {.id = 2, .cells = {10, 1, 1}, .origin = {0, 0, 1}, .size = {10, 1, 1}, .share_nodes = false})
          .build();
  Eigen::Matrix3Xd x = flat.coordinates();
  for (Eigen::Index i = x.cols() / 2; i < x.cols(); ++i) x(2, i) += 0.06 * x(0, i);
  const std::string contact =
      "skin all blocks = on\nbegin interaction defaults\ngeneral contact = on\nfriction model = tied\n"
      "capture tolerance = 0.3\nend\n";
  const LawDeck deck(flat.with_coordinates(x), contact,
                     "begin results output\ndatabase name = a.e\nat time 0 increment = 1e-5\n"
                     "nodal displacement\nend\n");
  const auto [code, out, err] = deck.run({"a.i"});
  CHECK(code == 0);
  CHECK_THAT(err, Contains("[tie-partial]") && Contains("10 nodes are not"));
  CHECK_THAT(out, Contains("10 nodes of block_"));
  contactsim::Diagnostics warnings;
  const Mesh written = contactsim::read_mesh(deck.path("a.e"), warnings);
  REQUIRE(written.node_sets().size() == 1);
  CHECK(written.node_sets()[0].name == "contact_untied");
  CHECK(written.node_sets()[0].nodes.size() == 10);
}

TEST_CASE("a contact surface with the name of a side set of the mesh gets another one in results",
          "[app][output]") {
  const Mesh mesh = MeshBuilder()
                        .add_hexes({.id = 1})
                        .add_hexes({.id = 2, .origin = {0, 0, 1}, .share_nodes = false})
                        .add_side_set(1, "Contact_Block_1", {{{0}, 1}})
                        .build();
  const LawDeck deck(mesh, general("frictionless"),
                     "begin results output\ndatabase name = a.e\nat time 0 increment = 1e-5\n"
                     "nodal displacement\nend\n");
  CHECK(deck.run({"a.i"}).exit_code == 0);
  contactsim::Diagnostics warnings;
  const Mesh written = contactsim::read_mesh(deck.path("a.e"), warnings);
  std::vector<std::string> names;
  for (const contactsim::SideSet& set : written.side_sets()) names.push_back(set.name);
  CHECK(names == std::vector<std::string>{"Contact_Block_1", "contact_block_1_2", "contact_block_2"});
}

TEST_CASE("contact that runs away ends the run with code 4 and results that can be read",
          "[app][transient]") {
  const Mesh mesh = MeshBuilder()
                        .add_hexes({.id = 1})
                        .add_hexes({.id = 2, .origin = {0, 0, 1.005}, .share_nodes = false})
                        .build();
  // The step is stable for the elements but far too large for the springs of contact.
  const LawDeck deck(mesh,
                     "enforcement = penalty\nskin all blocks = on\nbegin interaction defaults\n"
                     "general contact = on\npenalty stiffness = 4e9\nend\n",
                     "begin initial velocity\nblock = block_2\ncomponent = z\nmagnitude = -10\nend\n"
                     "begin results output\ndatabase name = a.e\nat time 0 increment = 1e-2\n"
                     "nodal displacement\nend\n",
                     "user time step = 1e-3\n", 0.1);
  const auto [code, out, err] = deck.run({"a.i"});
  CHECK(code == 4);
  CHECK_THAT(err, Contains("contact between 'block_1' and 'block_2' runs away"));
  contactsim::Diagnostics warnings;
  CHECK(contactsim::read_mesh(deck.path("a.e"), warnings).n_elements() == 2);
  CHECK(warnings.empty());
}

}  // namespace start_warnings_test
