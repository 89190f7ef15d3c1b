// SPDX-License-Identifier: BSD-3-Clause
#include "core/elements/cohesive_section.hpp"

#include "core/definition/simulation.hpp"
#include "core/elements/cohesive/cohesive_elements.hpp"
#include "support/catch.hpp"
#include "support/mesh_builder.hpp"
#include "support/steel_definition.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

constexpr TractionLaw section_law{10.0, 0.01, 0.5, 2e-3, 4e-3, 3.0};

/// One cohesive element with the id 40 of these corners.
Mesh cohesive_mesh(Shape shape, const Eigen::Matrix3Xd& x) {
  MeshBuilder builder;
  std::vector<std::uint32_t> nodes;
  for (Eigen::Index i = 0; i < x.cols(); ++i) {
    builder.add_node(x.col(i));
    nodes.push_back(static_cast<std::uint32_t>(i));
  }
  return builder.add_block(1, "", shape, nodes).set_element_ids({40}).build();
}

/// Two faces of a square of edges 1 and 2, so far apart.
Eigen::Matrix3Xd two_faces(double apart) {
  Eigen::Matrix3Xd x(3, 8);
  x << 0, 1, 1, 0, 0, 1, 1, 0, 0, 0, 2, 2, 0, 0, 2, 2, 0, 0, 0, 0, apart, apart, apart, apart;
  return x;
}

/// What making an element says; nothing when it is made.
std::string refusal(Shape shape, const Eigen::Matrix3Xd& x) {
  Diagnostics diagnostics;
  const auto made = make_cohesive_block(cohesive_mesh(shape, x), 0, section_law, 0.0, {}, diagnostics);
  CHECK(made.has_value() == diagnostics.empty());
  return diagnostics.empty() ? "" : diagnostics.all()[0].text + "; " + diagnostics.all()[0].hint;
}

}  // namespace

TEST_CASE("pairs of opposite nodes share the face between them and keep their distance", "[core][cohesive]") {
  Diagnostics diagnostics;
  const auto made = make_cohesive_block(cohesive_mesh(Shape::cohesive8, two_faces(0.1)), 0, section_law, 5.0,
                                        {}, diagnostics);
  REQUIRE(made);
  for (std::size_t pair = 0; pair < 4; ++pair) {
    CHECK(made->cohesive.area[pair](0) == Approx(0.5));
    CHECK(made->cohesive.thickness[pair](0) == Approx(0.1));
    CHECK(made->cohesive.area[pair](7) == Approx(0.5));  // lanes that are filled up
  }
  CHECK(made->element == &cohesive8_pairs);
  Eigen::Matrix3Xd triangle(3, 6);
  triangle << two_faces(0.0).leftCols(3), two_faces(0.0).leftCols(3);
  const auto flat =
      make_cohesive_block(cohesive_mesh(Shape::cohesive6, triangle), 0, section_law, 0.0, {}, diagnostics);
  REQUIRE(flat);
  CHECK(flat->element == &cohesive6_pairs);
  CHECK(flat->cohesive.area[2](0) == Approx(1.0 / 3.0));
  CHECK(flat->cohesive.thickness[2](0) == 0.0);
}

TEST_CASE("cohesive elements whose faces are not opposite are refused", "[core][cohesive]") {
  const std::string text = "block_1: the faces of the cohesive element 40 do not lie opposite each other; ";
  const std::string eight =
      text +
      "its faces are nodes 1 2 3 4 and, in the same order, 5 6 7 8, which look from the "
      "first to the second";
  CHECK(refusal(Shape::cohesive8, two_faces(0.0)) == "");
  CHECK(refusal(Shape::cohesive8, two_faces(0.1)) == "");
  CHECK(refusal(Shape::cohesive8, two_faces(-0.1)) == eight);  // the second lies behind the first
  Eigen::Matrix3Xd x(3, 8);
  x << 0, 0, 0, 0, 1, 1, 1, 1, 0, 1, 1, 0, 0, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0;  // edges for faces
  CHECK(refusal(Shape::cohesive8, x) == eight);
  // The width is the root of the diagonals, 5^(1/2): a thousandth of it may lie beside.
  x = two_faces(0.1);
  x(0, 5) += 2e-3;
  CHECK(refusal(Shape::cohesive8, x) == "");
  x(0, 5) += 1e-3;
  CHECK(refusal(Shape::cohesive8, x) == eight);
  Eigen::Matrix3Xd turned(3, 6);
  turned << 0, 1, 1, 1, 1, 0, 0, 0, 2, 0, 2, 0, 0, 0, 0, 0, 0, 0;  // another first node
  CHECK(
      refusal(Shape::cohesive6, turned) ==
      text +
          "its faces are nodes 1 2 3 and, in the same order, 4 5 6, which look from the first to the second");
}

TEST_CASE("the blocks of a COHESIVE SECTION are cohesive in the mesh, others stay", "[core][cohesive]") {
  SimulationDefinition definition = steel_definition("block_2");
  definition.finite_element_models[0].block_parameters[0].section = deck_name("glue");
  definition.sections = {{deck_name("glue"), {}, CohesiveSection{}}};
  const Mesh mesh = MeshBuilder()
                        .add_hexes({.id = 1})
                        .add_hexes({.id = 2, .origin = {0, 0, 1}})
                        .add_wedges({.id = 3, .origin = {0, 0, 2}})
                        .build();
  const auto shapes = [](const Mesh& of) {
    return std::array{of.blocks()[0].shape, of.blocks()[1].shape, of.blocks()[2].shape};
  };
  CHECK(shapes(with_cohesive_blocks(definition, {}, mesh)) ==
        std::array{Shape::hex8, Shape::cohesive8, Shape::wedge6});
  definition.finite_element_models[0].block_parameters[0].names.push_back(deck_name("block_3"));
  CHECK(shapes(with_cohesive_blocks(definition, {}, mesh)) ==
        std::array{Shape::hex8, Shape::cohesive8, Shape::cohesive6});
  definition.sections = {{deck_name("glue"), {}, SolidSection{}}};
  CHECK(shapes(with_cohesive_blocks(definition, {}, mesh)) == shapes(mesh));
  definition.finite_element_models.clear();
  CHECK(shapes(with_cohesive_blocks(definition, {}, mesh)) == shapes(mesh));
  CHECK(topology(Shape::cohesive8).family == Family::cohesive);
  CHECK(topology(Shape::cohesive6).name == "WEDGE6");
  CHECK(find_shape("HEX8", 8) == Shape::hex8);
}
