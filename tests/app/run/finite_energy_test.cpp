// SPDX-License-Identifier: BSD-3-Clause
// Energies that are no numbers end a run.
#include "support/catch.hpp"
#include "support/exodus_file.hpp"
#include "support/mesh_builder.hpp"
#include "support/program_run.hpp"

using Catch::Matchers::Contains;
using contactsim::test::MeshBuilder;

TEST_CASE("an energy that overflows though all nodes move at some speed ends the run", "[app][run]") {
  const contactsim::test::ProgramDirectory directory;
  contactsim::test::write_exodus(
      directory.path("a.g"),
      MeshBuilder().add_hexes({}).add_bars({.id = 2, .from = {1, 1, 1}, .to = {2, 1, 1}}).build());
  directory.write(
      "a.i",
      "begin sierra\nbegin material m\ndensity = 1\nbegin parameters for model elastic\n"
      "youngs modulus = 1\npoissons ratio = 0\nend\nend\n"
      "begin function f\ntype = piecewise linear\nbegin values\n-1 -4e3\n0 -1e300\n1 1e3\nend\nend\n"
      "begin spring section s\nforce strain function = f\nmass per unit length = 1\nend\n"
      "begin finite element model m\nbegin parameters for block block_1\nmaterial = m\nmodel = elastic\nend\n"
      "begin parameters for block block_2\nsection = s\nend\nend\n"
      "begin presto procedure p\nbegin time control\nbegin time stepping block t\nstart time = 0\n"
      "begin parameters for presto region r\ntime step scale factor = 0.01\nend\nend\ntermination time = "
      "1\nend\n"
      "begin presto region r\nuse finite element model m\n"
      "end\nend\nend\n");
  const auto [code, out, err] = directory.run({"a.i"});
  CHECK(code == 4);
  CHECK_THAT(err, Contains("the energy is not finite"));
}
