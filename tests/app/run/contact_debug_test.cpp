// SPDX-License-Identifier: BSD-3-Clause
#include "app/run/contact_debug.hpp"

#include "app/reports/csv.hpp"
#include "core/definition/contact.hpp"
#include "support/catch.hpp"
#include "support/flying_cube.hpp"
#include "support/report_region.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

constexpr const char* places_head =
    "first,second,first_element,first_side,first_node,second_element,second_side,gap,area,normal_force,"
    "tangential_x,tangential_y,tangential_z\n";

/// The lines of contact points while the cubes press, by their fields.
std::vector<CsvLine> places_of(FlyingCube& cube) {
  cube.simulation.begin();
  while (!cube.simulation.is_over() && cube.simulation.contact_force()->points().empty())
    cube.simulation.step();
  const std::string text =
      format_places_csv(*cube.simulation.contact_force(), *cube.simulation.contact_model(), cube.mesh);
  CHECK(text.starts_with(places_head));
  std::vector<CsvLine> lines = split_csv(text);
  REQUIRE(lines.size() > 1);
  lines.erase(lines.begin());
  return lines;
}

}  // namespace

TEST_CASE("files that contact is debugged by are those that are asked for", "[app][contact]") {
  const SimulationDefinition definition = deck_of_region("");
  ContactDebug debug;
  CHECK(contact_debug_files(definition, debug).paths().empty());
  debug.writes_constraints = true;
  CHECK(contact_debug_files(definition, debug).paths() == std::vector<std::string>{"d_contact_places.csv"});
  debug.visualizes_facets = true;
  const ContactDebugFiles files = contact_debug_files(definition, debug);
  CHECK(files.facets == "d_contact_facets.exo");
  CHECK(files.paths() == std::vector<std::string>{"d_contact_facets.exo", "d_contact_places.csv"});
}

TEST_CASE("contact points of faces have both faces, the area of both is that of the cube", "[app][contact]") {
  FlyingCube cube;
  double area = 0.0;
  for (const CsvLine& line : places_of(cube)) {
    REQUIRE(line.fields.size() == 13);
    CHECK(line.fields[0] != line.fields[1]);
    CHECK(line.fields[4] == "");
    // The upper cube is element 9, of which side 5 looks down; of the lower ones side 6 looks up.
    const std::size_t upper = line.fields[0] == "upper" ? 2 : 5, lower = upper == 2 ? 5 : 2;
    CHECK(line.fields[upper] == "9");
    CHECK(line.fields[upper + 1] == "5");
    CHECK(std::stoi(line.fields[lower]) >= 5);
    CHECK(line.fields[lower + 1] == "6");
    area += std::stod(line.fields[8]);
  }
  CHECK(area == Approx(1.0));
}

TEST_CASE("contact points of nodes have the node in place of a face", "[app][contact]") {
  FlyingCube cube({.contact = "begin interaction\nside a = lower\nside b = upper\nconstraint formulation = "
                              "node_face\nend\n"});
  for (const CsvLine& line : places_of(cube)) {
    CHECK(line.fields[2] == "");
    CHECK(line.fields[3] == "");
    const std::int64_t node = std::stoll(line.fields[4]);
    CHECK(node > 27);  // of the upper cube
    CHECK(node <= 35);
    CHECK(line.fields[6] == "6");
  }
}

TEST_CASE("names with commas are one field", "[app][contact]") {
  FlyingCube cube({.contact = "contact surface 'lid, old' contains upper\nbegin interaction defaults\n"
                              "general contact = on\nend\n"});
  for (const CsvLine& line : places_of(cube)) {
    CHECK(line.fields.size() == 13);
    CHECK((line.fields[0] == "lid, old" || line.fields[1] == "lid, old"));
  }
}
