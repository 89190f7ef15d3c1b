// SPDX-License-Identifier: BSD-3-Clause
// Contact in a procedure that takes over the state of another, by the program.
#include <algorithm>

#include "support/catch.hpp"
#include "support/csv_column.hpp"
#include "support/exodus_file.hpp"
#include "support/mesh_builder.hpp"
#include "support/program_run.hpp"

using Catch::Matchers::Contains;
using contactsim::test::csv_column;
using contactsim::test::MeshBuilder;
using contactsim::test::ProgramDirectory;

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
