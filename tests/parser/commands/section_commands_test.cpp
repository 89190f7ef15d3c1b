// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/section_commands.hpp"

#include "support/catch.hpp"
#include "support/parsed_deck.hpp"

using namespace contactsim;

namespace {

/// The properties of the first section of a deck without mistakes.
template <class Section>
Section section_of(const std::string& lines) {
  const ParsedDeck deck = parsed_sierra(lines);
  REQUIRE(deck.messages == "");
  REQUIRE(deck.simulation.sections.size() == 1);
  return std::get<Section>(deck.simulation.sections[0].properties);
}

/// What is said of a section that a block uses. Its lines begin at line 3.
std::string said_of_used(const std::string& type, const std::string& lines) {
  return parsed_sierra("begin " + type + " section s\n" + lines +
                       "end\n"
                       "begin finite element model fem\n"
                       "  begin parameters for block b\n"
                       "    section = S\n"
                       "  end\n"
                       "end\n"
                       "begin presto procedure p\n"
                       "  begin presto region r\n"
                       "    use finite element model fem\n"
                       "  end\n"
                       "end\n")
      .messages;
}

}  // namespace

TEST_CASE("a solid section has the defaults of the guide", "[parser][section]") {
  const auto solid = section_of<SolidSection>("begin solid section s\nend\n");
  CHECK(solid.formulation.text == "mean_quadrature");
  CHECK(solid.strain_incrementation.text == "midpoint_increment");
  CHECK_FALSE(solid.deviatoric_parameter);
  CHECK_FALSE(solid.is_hourglass_total);
  CHECK_FALSE(solid.is_hourglass_rotation_scaled);
}

TEST_CASE("a solid section is bound", "[parser][section]") {
  const auto solid = section_of<SolidSection>(
      "begin solid section s\n  formulation = selective_deviatoric\n  strain incrementation is "
      "strongly_objective\n  deviatoric parameter = 0.25\n  hourglass formulation = total\n  hourglass "
      "rotation = "
      "scaled\nend\n");
  CHECK(solid.formulation.text == "selective_deviatoric");
  CHECK(solid.strain_incrementation.text == "strongly_objective");
  CHECK(solid.deviatoric_parameter == 0.25);
  CHECK(solid.is_hourglass_total);
  CHECK(solid.is_hourglass_rotation_scaled);
}

TEST_CASE("shells and membranes are bound with what lofting needs", "[parser][section]") {
  const auto shell = section_of<ShellSection>(
      "begin shell section s\n  thickness = 0.02\n  thickness scale factor = 2\n  lofting factor = 0\n  "
      "number of integration points = 3\n  formulation = bt_shell\n  orientation = c\nend\n");
  CHECK(shell.thickness == 0.02);
  CHECK(shell.thickness_scale_factor == 2.0);
  CHECK(shell.lofting_factor == 0.0);
  CHECK(shell.n_integration_points == 3);
  CHECK(shell.orientation->text == "c");
  CHECK(section_of<ShellSection>("begin shell section s\nend\n").lofting_factor == 0.5);
  const auto membrane = section_of<MembraneSection>(
      "begin membrane section s\n  thickness mesh variable = th\n  deviatoric parameter = 1\nend\n");
  CHECK_FALSE(membrane.thickness);
  CHECK(membrane.thickness_mesh_variable->text == "th");
}

TEST_CASE("beams are bound with shape and size", "[parser][section]") {
  const auto beam = section_of<BeamSection>(
      "begin beam section s\n  section = box\n  width = 0.1\n  height = 0.2\n  wall thickness = 0.01\n  t "
      "axis = 0 "
      "0 2\n  axis offset = 0.1, -0.2\nend\n");
  CHECK(beam.shape == BeamShape::box);
  CHECK(beam.width == 0.1);
  CHECK(beam.height == 0.2);
  CHECK(beam.wall_thickness == 0.01);
  CHECK(beam.t_axis == Eigen::Vector3d(0, 0, 2));
  CHECK(beam.axis_offset == std::array{0.1, -0.2});
  CHECK(section_of<BeamSection>("begin beam section s\n  section = I\nend\n").shape == BeamShape::i);
}

TEST_CASE("the other element types are bound", "[parser][section]") {
  CHECK(
      section_of<TrussSection>("begin truss section s\n  area = 3\n  initial load = -4\n  period = 5\nend\n")
          .initial_load == -4.0);
  CHECK(section_of<ParticleSection>("begin particle section s\n  radius = 0.5\nend\n").radius == 0.5);
  CHECK(section_of<PointMassSection>("begin point mass section s\n  mass = 2\n  ixy = -1\nend\n").ixy ==
        -1.0);
  CHECK(
      section_of<SpringSection>("begin spring section s\n  default stiffness = 9\nend\n").default_stiffness ==
      9.0);
  CHECK(section_of<DamperSection>("begin damper section s\n  area = 1\nend\n").area == 1.0);
  CHECK(section_of<TotalLagrangeSection>("begin total lagrange section s\n  volume average j = on\nend\n")
            .has_volume_average_j);
}

TEST_CASE("a cohesive section takes its pairs of nodes, a material of tractions no density",
          "[parser][section]") {
  CHECK(section_of<CohesiveSection>("begin cohesive section s\n  number of integration points = 3\nend\n")
            .n_integration_points == 3);
  const std::string begin =
      "begin material glue\n  begin parameters for model tvergaard_hutchinson\n    peak traction = 2\n"
      "    lambda_1 = 0.1\n    lambda_2 = 0.5\n    normal length scale = 3\n";
  const std::string end =
      "  end\nend\nbegin finite element model m\n  database name = a.g\n  begin parameters for block 1\n"
      "    material = glue\n    model = tvergaard_hutchinson\n  end\nend\n";
  const ParsedDeck deck = parsed_sierra(begin + "    tangential length scale = 4\n" + end);
  CHECK(deck.messages == "");
  const ParameterValues& values = deck.simulation.materials.at(0).models.at(0).values;
  CHECK(values.real("peak traction") == 2.0);
  CHECK(values.real("penetration stiffness multiplier") == 1.0);
  // What a material lacks is reported where a region uses it.
  const std::string region =
      "begin presto procedure p\n  begin time control\n    begin time stepping block t\n"
      "      start time = 0\n    end\n    termination time = 1\n  end\n"
      "  begin presto region r\n    use finite element model m\n  end\nend\n";
  CHECK_THAT(parsed_sierra(begin + end + region).messages, Catch::Contains("TANGENTIAL LENGTH SCALE"));
}

TEST_CASE("a section type that is not supported is kept by name", "[parser][section]") {
  for (const std::string type :
       {"superelement", "dem", "bolt", "cylindrical joint", "linear beam", "spring support", "usermount"}) {
    INFO(type);
    CHECK(section_of<UnsupportedSection>("begin " + type + " section s\n  any line = 3\nend\n").type ==
          type + " section");
  }
}

TEST_CASE("a section may make its blocks a rigid body", "[parser][section]") {
  const ParsedDeck deck =
      parsed_sierra("begin solid section s\n  rigid body = rb\nend\nbegin rigid body rb\nend\n");
  CHECK(deck.messages == "");
  CHECK(deck.simulation.sections.at(0).rigid_body->text == "rb");
}

TEST_CASE("what is wrong in a used section is reported", "[parser][section]") {
  CHECK(said_of_used("shell", "  thickness = 0\n  lofting factor = 1.5\n") ==
        "a.i:3:15: error: 'thickness' must be greater than 0, found '0'\n"
        "a.i:4:20: error: 'lofting factor' must be from 0 to 1, found '1.5'\n");
  CHECK(said_of_used("beam", "  section = tub\n") ==
        "a.i:3:13: error: expected one of rod, tube, bar, box, i for 'section', found 'tub'; did you mean "
        "'tube'?\n");
  CHECK(said_of_used("solid", "  rigid body = rb\n") ==
        "a.i:3:16: error: unknown rigid body 'rb'; the deck has no rigid body\n");
  CHECK(said_of_used("shell", "  orientation = c\n") ==
        "a.i:3:17: error: unknown coordinate system 'c'; the deck has no coordinate system\n");
  CHECK(said_of_used("spring", "  force strain function = f\n") ==
        "a.i:3:27: error: unknown function 'f'; the deck has no function\n");
}
