// SPDX-License-Identifier: BSD-3-Clause
#include "core/dynamics/initial_state.hpp"

#include <cmath>

#include "core/elements/element_table.hpp"
#include "core/materials/elastic.hpp"
#include "core/materials/linear_hardening.hpp"
#include "support/catch.hpp"
#include "support/condition_deck.hpp"
#include "support/mesh_builder.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// A plastic block of 9 hexahedra, more than a batch, and an elastic one.
const Mesh& two_rows() {
  static const Mesh mesh = MeshBuilder()
                               .add_hexes({.id = 1, .cells = {9, 1, 1}, .size = {9, 1, 1}})
                               .add_hexes({.id = 2, .origin = {0, 5, 0}})
                               .build();
  return mesh;
}

std::vector<ModelBlock> make_blocks() {
  const ElementFormulation& element = *find_solid_element(Shape::hex8, "mean_quadrature");
  ElementProperties plastic, elastic;
  plastic.law = PlasticLaw<LinearHardening>{};
  elastic.law = ElasticLaw{};
  plastic.density = elastic.density = 1.0;
  std::vector<ModelBlock> blocks;
  blocks.push_back(make_solid_block(two_rows(), 0, element, plastic));
  blocks.push_back(make_solid_block(two_rows(), 1, element, elastic));
  return blocks;
}

/// A file with the times 0, 1, 3: v_x to v_z are 1, 2 and 3 times the time, p is the node's position plus
/// ten times the time; s_xx to s_zx are all the element's position, e has no value at the last element.
StoredVariables stored_results() {
  StoredVariables stored;
  stored.times = {0.0, 1.0, 3.0};
  stored.nodal.names = {"p", "V_X", "v_y", "v_z"};
  stored.nodal.read = [times = stored.times](std::size_t variable, std::size_t time) {
    std::vector<double> values(two_rows().n_nodes(), static_cast<double>(variable) * times[time]);
    for (std::size_t i = 0; variable == 0 && i < values.size(); ++i)
      values[i] = static_cast<double>(i) + 10.0 * times[time];
    return values;
  };
  stored.element.names = {"sxx", "syy", "szz", "sxy", "syz", "szx", "e"};
  stored.element.read = [](std::size_t variable, std::size_t) {
    std::vector<double> values(two_rows().n_elements());
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<double>(i);
    if (variable == 6) values.back() = std::nan("");
    return values;
  };
  return stored;
}

/// What INITIAL CONDITION blocks with these lines make of a state at rest, the run starting at 2.
struct Made {
  explicit Made(const std::vector<std::string>& conditions) {
    std::string lines;
    for (const std::string& condition : conditions)
      lines += "begin initial condition\n" + condition + "\nend\n";
    const StoredVariables stored = stored_results();
    ConditionDeck deck(two_rows(), lines, 2.0, &stored);
    const InitialState initial = make_initial_state(deck.scope(), blocks);
    messages = deck.messages();
    state = make_state(two_rows().coordinates(), blocks, 2.0);
    set_initial_state(initial, blocks, state);
  }

  /// A number of an element of the first or the second block.
  double at(std::size_t block, std::size_t element, std::size_t place) const {
    return state.blocks[block].at(blocks[block].layout, element, place);
  }

  std::vector<ModelBlock> blocks = make_blocks();
  State state;
  std::string messages;
};

std::string nodal(const std::string& variable) {
  return "block = block_1\nvariable type = node\ninitialize variable name = " + variable + "\n";
}

std::string elemental(const std::string& variable, const std::string& block = "block_1") {
  return "block = " + block + "\nvariable type = element\ninitialize variable name = " + variable + "\n";
}

}  // namespace

TEST_CASE("nodes start with the velocity and displacement of initial conditions", "[core][conditions]") {
  const Made made({nodal("velocity") + "magnitude = 1 2 3", nodal("displacement") + "magnitude = 0 0.5 0",
                   nodal("velocity(y)") + "magnitude = 9"});
  CHECK(made.messages == "");
  CHECK(made.state.velocity.col(0) == Eigen::Vector3d(1, 9, 3));
  CHECK(made.state.velocity.col(two_rows().n_nodes() - 1) == Eigen::Vector3d(0, 0, 0));
  CHECK(made.state.coordinates.col(0) == Eigen::Vector3d(0, 0.5, 0));
}

TEST_CASE("elements start with the stress and plastic strain of initial conditions", "[core][conditions]") {
  const Made made({elemental("stress") + "magnitude = 1 2 3 4 5 6", elemental("EQPS") + "magnitude = 0.1",
                   elemental("stress(zz)", "block_2") + "magnitude = -7"});
  CHECK(made.messages == "");
  for (std::size_t place = 0; place < 6; ++place) CHECK(made.at(0, 8, place) == place + 1.0);
  CHECK(made.at(0, 0, 6 + 6) == 0.1);  // after the stress and the back stress
  CHECK(made.at(0, 0, 6) == 0.0);
  CHECK(made.at(1, 0, 2) == -7.0);
  CHECK(made.at(1, 0, 0) == 0.0);
}

TEST_CASE("initial conditions are read from the mesh file at the time asked for", "[core][conditions]") {
  const auto velocity = [](const std::string& lines) {
    return Made({nodal("velocity") + "read variable = v\n" + lines}).state.velocity.col(0).eval();
  };
  CHECK(velocity("") == Eigen::Vector3d(2, 4, 6));  // at the start of the run
  CHECK(velocity("time = first") == Eigen::Vector3d(0, 0, 0));
  CHECK(velocity("time = last\nscale factor = 2") == Eigen::Vector3d(6, 12, 18));
  CHECK(velocity("time = 0.5") == Eigen::Vector3d(0.5, 1, 1.5));
  CHECK(velocity("time = 99") == Eigen::Vector3d(3, 6, 9));
  const Made made(
      {nodal("velocity(x)") + "read variable = P\ntime = 1", elemental("stress") + "read variable = s"});
  CHECK(made.state.velocity.col(3) == Eigen::Vector3d(13, 0, 0));
  CHECK(made.at(0, 8, 4) == 8.0);
}

TEST_CASE("initial conditions that cannot be met are errors", "[core][conditions]") {
  const auto messages = [](const std::string& lines) { return Made({lines}).messages; };
  CHECK(messages(nodal("velocity") + "magnitude = 1") ==
        "c.i:4:28: error: 'velocity' needs 3 numbers for MAGNITUDE, found 1\n");
  CHECK(messages(nodal("velocity(w)") + "magnitude = 1") ==
        "c.i:4:28: error: 'velocity' has no component 'w'\n");
  CHECK(messages(nodal("pressure") + "magnitude = 1") ==
        "c.i:4:28: error: nodes have no 'pressure' that could be set at the start; velocity and displacement "
        "can\n");
  CHECK(messages(elemental("eqp") + "magnitude = 1") ==
        "c.i:4:28: error: elements have no 'eqp' that could be set at the start; they have stress, eqps, "
        "back_stress\n");
  CHECK(messages(elemental("eqps", "block_2") + "magnitude = 1") ==
        "c.i:4:28: error: the material of 'block_2' has no 'eqps'\n");
  CHECK(messages(elemental("stress(xx)", "block_2") + "read variable = e") ==
        "c.i:4:28: error: the initial 'stress(xx)' is not finite, or missing, at element 10\n");
  CHECK(messages(nodal("velocity") + "read variable = speed") ==
        "c.i:5:17: error: the mesh file has no nodal variable 'speed' with 3 components\n");
  CHECK(messages("variable type = global\ninitialize variable name = x\nmagnitude = 1") ==
        "c.i:1:1: error: the initial condition is not of a node or element variable, which it must be; write "
        "VARIABLE TYPE = NODE or ELEMENT\n");
  CHECK(messages(nodal("temperature") + "magnitude = 1") ==
        "c.i:4:28: warning: the initial temperature has no effect: nothing depends on it "
        "[condition-ignored]\n");
  CHECK(messages("surface = surface_1\nvariable type = element\ninitialize variable name = stress(xx)\n"
                 "magnitude = 1") == "c.i:2:11: error: the mesh has no side set 'surface_1'\n");
}
