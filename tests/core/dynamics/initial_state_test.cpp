// SPDX-License-Identifier: BSD-3-Clause
#include "core/dynamics/initial_state.hpp"

#include "support/catch.hpp"
#include "support/two_rows.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

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

  std::vector<ModelBlock> blocks = blocks_of_two_rows();
  State state;
  std::string messages;
};

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
