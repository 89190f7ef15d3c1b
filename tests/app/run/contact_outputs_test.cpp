// SPDX-License-Identifier: BSD-3-Clause
// Sets, groups of variables, totals of side sets and units in the files of a run.
#include <sstream>

#include "io/exodus/exodus_reader.hpp"
#include "support/catch.hpp"
#include "support/exodus_file.hpp"
#include "support/mesh_builder.hpp"
#include "support/program_run.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Catch::Matchers::Contains;

namespace {

/// A held plate and the feet of a cube that presses on it; sets with names that results would give.
Mesh pressed_cubes() {
  MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {3, 3, 1}, .origin = {-1, -1, 0}, .size = {3, 3, 1}});
  b.add_hexes({.id = 2, .origin = {0, 0, 0.999}, .share_nodes = false});
  b.add_side_set(7, "contact_block_1",
                 [](const CandidateSide& side) { return side.block_id == 1 && side.normal.z() > 0.5; });
  b.add_side_set(8, "top_of_low",
                 [](const CandidateSide& side) { return side.block_id == 1 && side.normal.z() > 0.5; });
  b.add_node_set(5, "feet", [](const Eigen::Vector3d& x) { return x.z() > 0.9985 && x.z() < 0.9995; });
  b.add_node_set(6, "Contact_Feet", std::vector<std::uint32_t>{0});
  return b.build();
}

struct Run : ProgramDirectory {
  explicit Run(const std::string& variables) {
    write_exodus(path("a.g"), pressed_cubes());
    write("a.i",
          "begin sierra\nbegin material m\ndensity = 1000\nbegin parameters for model elastic\n"
          "youngs modulus = 1e6\npoissons ratio = 0\nend\nend\nbegin finite element model f\n"
          "begin parameters for block block_1 block_2\nmaterial = m\nmodel = elastic\nend\nend\n"
          "begin presto procedure p\nbegin time control\nbegin time stepping block t1\nstart time = 0\nend\n"
          "termination time = 1e-3\nend\nbegin presto region r\nuse finite element model f\n"
          "begin fixed displacement\nblock = block_1\ncomponents = x y z\nend\n"
          "begin results output\ndatabase name = a.e\nat step 0 increment = 1\n" +
              variables +
              "end\nbegin heartbeat output\nstream name = a.csv\nunits line = on\nat step 0 increment = 1\n"
              "global contact_force_top_of_low as on_set\nglobal contact_force_block_1 as on_surface\n"
              "global kinetic_energy\nnodal displacement(z) at node 40\nend\n"
              "begin contact definition\ncontact surface block_1 contains block_1\n"
              "contact node set feet contains feet\nbegin interaction defaults\ngeneral contact = on\n"
              "penalty stiffness = 1e4\nend\nbegin debug\nvisualize contact facets = "
              "on\nend\nend\nend\nend\nend\n");
    done = run({"a.i", "a.g"});
  }
  Mesh mesh_of(const std::string& file) const {
    Diagnostics warnings;
    return read_mesh(path(file), warnings);
  }
  ProgramOutput done;
};

}  // namespace

TEST_CASE("results hold sets of all contact surfaces under names of their own", "[app][contact]") {
  const Run run("nodal variables = displacement\n");
  REQUIRE(run.done.exit_code == 0);
  const Mesh mesh = run.mesh_of("a.e");
  CHECK(mesh.names(EntityKind::side_set) ==
        std::vector<std::string>{"contact_block_1", "top_of_low", "contact_block_1_2"});
  CHECK(mesh.names(EntityKind::node_set) ==
        std::vector<std::string>{"feet", "Contact_Feet", "contact_feet_2"});
  CHECK(mesh.node_sets()[2].nodes.size() == 4);
  CHECK(mesh.node_sets()[2].nodes == mesh.node_sets()[0].nodes);
  const Mesh facets = run.mesh_of("a_contact_facets.exo");
  CHECK(facets.names(EntityKind::block) == std::vector<std::string>{"block_1", "feet", "block_1_edges"});
  CHECK(facets.blocks()[2].shape == Shape::bar2);
  CHECK(facets.blocks()[2].n_elements == 28);
}

TEST_CASE("a group of variables is written as its members; another's name gets ours", "[app][contact]") {
  const Run run("nodal variables = CSTRESS cdisp\nnodal variables = cpress\nnodal variables = cstres\n");
  REQUIRE(run.done.exit_code == 0);
  CHECK_THAT(run.done.out + run.done.err, Contains("here it is called contact_normal_traction_magnitude") &&
                                              Contains("did you mean 'cstress'?"));
  const std::string file = run.read("a.e");
  for (const char* name : {"contact_normal_traction_magnitude", "contact_tangential_traction_magnitude",
                           "contact_normal_gap", "contact_accumulated_slip_vector_x"})
    CHECK(file.find(name) != std::string::npos);
}

TEST_CASE("units stand under the names of a heartbeat, and side sets have totals", "[app][contact]") {
  const Run run("nodal variables = displacement\n");
  std::istringstream text(run.read("a.csv"));
  std::string names, units, line;
  std::getline(text, names);
  std::getline(text, units);
  CHECK(names.starts_with("Time, on_set_x, on_set_y, on_set_z, on_surface_x"));
  CHECK(units == "[time], [force], [force], [force], [force], [force], [force], [energy], [length]");
  std::size_t n_lines = 0;
  while (std::getline(text, line)) {
    std::vector<std::string> words;
    std::istringstream row(line);
    for (std::string word; std::getline(row, word, ',');) words.push_back(word);
    REQUIRE(words.size() == 9);
    CHECK(words[3] == words[6]);
    // At the start all is 0.001 deep under 1e4: 10 pushes the plate down.
    if (n_lines++ == 0) CHECK(std::stod(words[3]) == Approx(-10.0));
  }
  CHECK(n_lines > 1);
}
