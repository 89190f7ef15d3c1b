// SPDX-License-Identifier: BSD-3-Clause
// USER OUTPUT over the nodes and elements of a side set, and lengths of vectors, in a run.
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

/// Two unit cubes side by side along x, of density 8, as one block; side set "end" is the face at x = 2. The
/// left half flies at (3, 4, 0), nothing else moves or pulls: cube 2 is a block of its own, with nodes of its
/// own.
struct FlyingCubes : ProgramDirectory {
  explicit FlyingCubes(const std::string& region_lines) {
    MeshBuilder b;
    b.add_hexes({.id = 1, .name = "left", .cells = {2, 1, 1}, .size = {2, 1, 1}});
    b.add_hexes({.id = 2, .name = "right", .origin = {10, 0, 0}, .share_nodes = false});
    b.add_side_set(7, "end", [](const contactsim::test::CandidateSide& side) {
      return side.normal.x() > 0.5 && side.centroid.x() < 2.1 && side.centroid.x() > 1.9;
    });
    contactsim::test::write_exodus(path("a.g"), b.build());
    write(
        "a.i",
        "begin sierra\nbegin material m\ndensity = 8\nbegin parameters for model elastic\n"
        "youngs modulus = 100\npoissons ratio = 0\nend\nend\n"
        "begin finite element model f\nbegin parameters for block left right\nmaterial = m\nmodel = elastic\n"
        "end\nend\nbegin presto procedure p\nbegin time control\nbegin time stepping block t\nstart time = "
        "0\n"
        "begin parameters for presto region r\nend\nend\ntermination time = 4e-3\nend\n"
        "begin presto region r\nuse finite element model f\n"
        "begin initial velocity\nblock = left\ncomponent = x\nmagnitude = 3\nend\n"
        "begin initial velocity\nblock = left\ncomponent = y\nmagnitude = 4\nend\n" +
            region_lines + "end\nend\nend\n");
  }
};

double first(const std::string& text, std::size_t column) { return csv_column(text, column).at(0); }

}  // namespace

TEST_CASE("a user output of a surface has its nodes, and the elements behind it", "[app][output]") {
  const FlyingCubes cubes(
      "begin user output\nsurface = end\ncompute global end_mass as sum of nodal mass\n"
      "compute global end_speed as average of nodal velocity(magnitude)\n"
      "compute global end_x as average of nodal coordinates(x)\n"
      "compute global end_volume as sum of element volume\nend\n"
      "begin heartbeat output\nstream name = a.csv\nat step 0 increment = 1\nglobal end_mass\n"
      "global end_speed\nglobal end_x\nglobal end_volume\nnodal velocity(magnitude) at node 1 as v\nend\n");
  const auto [code, out, err] = cubes.run({"a.i"});
  CHECK(err == "");
  REQUIRE(code == 0);
  const std::string csv = cubes.read("a.csv");
  // Four of twelve nodes: an eighth of the mass of a cube, 8, each.
  CHECK(first(csv, 1) == Approx(4.0));
  CHECK(first(csv, 2) == Approx(5.0));
  CHECK(first(csv, 3) == Approx(2.0));
  CHECK(first(csv, 4) == Approx(1.0));
  CHECK(first(csv, 5) == Approx(5.0));
  // The block flies as a whole, at 3 along x.
  CHECK(csv_column(csv, 3).back() == Approx(2.0 + 3.0 * csv_column(csv, 0).back()).epsilon(1e-5));
}

TEST_CASE("a death criterion tests the length of a vector", "[app][output]") {
  const auto death = [](const std::string& variable, const std::string& test) {
    const FlyingCubes cubes(
        "begin element death d\nblock = left right\ncriterion is average nodal value of " + variable + " " +
        test + "\nend\n");
    const auto [code, out, err] = cubes.run({"a.i"});
    CHECK(err == "");
    CHECK(code == 0);
    return out;
  };
  // No component is 4.5; cube 2 is at rest.
  CHECK_THAT(death("velocity(magnitude)", "> 4.5"), Contains("2 elements of 3 that may die are dead"));
  CHECK_THAT(death("velocity", "> 4.5"), Contains("0 elements of 3 that may die are dead"));
  CHECK_THAT(death("velocity(magnitude)", "< 4.5"), Contains("1 element of 3 that may die are dead"));
}

TEST_CASE("only vectors have a length", "[app][output]") {
  const FlyingCubes cubes(
      "begin heartbeat output\nstream name = a.csv\nglobal kinetic_energy(magnitude)\nend\n");
  CHECK_THAT(cubes.run({"a.i", "--check"}).err, Contains("kinetic_energy has no component 'magnitude'"));
}
