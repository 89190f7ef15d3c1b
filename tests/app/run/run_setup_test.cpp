// SPDX-License-Identifier: BSD-3-Clause
#include "app/run/run_setup.hpp"

#include "core/base/errors.hpp"
#include "support/catch.hpp"
#include "support/deck_dump.hpp"
#include "support/two_cube_input.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Catch::Matchers::Contains;

namespace {

/// Two cubes with lines of the region, of an explicit or a quasi-static procedure.
struct SetUpCubes : TwoCubeInput {
  explicit SetUpCubes(const std::string& region, const std::string& kind = "presto",
                      const std::string& model = "", const MeshBuilder& builder = two_cube_mesh(0.1))
      : TwoCubeInput(builder.build(),
                     two_cube_deck(text_of({.start = 0.25, .end = 0.5, .region = region}, kind), model)) {}
  contactsim::Setup make() { return set_up(input(), diagnostics); }
};

const std::string flies = "begin initial velocity\nblock = high\ncomponent = z\nmagnitude = -3\nend\n";
const std::string holds = "begin fixed displacement\nblock = low\ncomponents = x z\nend\n";

}  // namespace

TEST_CASE("a region is set up with its blocks, masses, conditions, start and times", "[app][run]") {
  SetUpCubes cubes(flies + holds);
  const contactsim::Setup setup = cubes.make();
  CHECK(messages(cubes.diagnostics).empty());
  REQUIRE(setup.model.blocks.size() == 2);
  CHECK(setup.model.mass.row(0).sum() == Approx(2.0));  // two unit cubes of density 1
  CHECK(setup.model.kinematic_constraints.nodes().size() == 27);
  CHECK(setup.model.rotation_constraints.nodes().empty());
  CHECK(setup.control.start_time() == 0.25);
  CHECK(setup.control.termination_time() == 0.5);
  CHECK(setup.initial.velocity.leftCols(27).isZero(0.0));
  CHECK(setup.initial.velocity.rightCols(8).row(2).isConstant(-3.0));
  CHECK_FALSE(setup.load_schedule);
  CHECK_FALSE(setup.transfer);
  CHECK(setup.death_sets.empty());
}

TEST_CASE("load steps have a schedule, and no initial velocity", "[app][run][statics]") {
  SetUpCubes still(holds, "adagio");
  CHECK(still.make().load_schedule);
  CHECK(messages(still.diagnostics) == "");
  SetUpCubes moving(
      "begin initial condition\nblock = high\nvariable type = node\ninitialize variable name = velocity\n"
      "magnitude = 0 0 -3\nend\n",
      "adagio");
  moving.make();
  CHECK_THAT(messages(moving.diagnostics),
             Contains("an initial velocity in a quasi-static procedure is not supported"));
  SetUpCubes at_rest(
      "begin initial condition\nblock = high\nvariable type = node\ninitialize variable name = velocity\n"
      "magnitude = 0 0 0\nend\n",
      "adagio");
  at_rest.make();
  CHECK(messages(at_rest.diagnostics) == "");
}

TEST_CASE("elements without volume end the set-up with their block and id", "[app][run]") {
  MeshParts parts = two_cube_mesh(0.1).parts();
  for (Eigen::Index i = 27; i < 35; ++i) parts.coordinates(2, i) = 1.1;
  TwoCubeInput flat(Mesh(std::move(parts)), two_cube_deck(text_of({})));
  CHECK_THROWS_AS(set_up(flat.input(), flat.diagnostics), FileError);
  CHECK_THROWS_WITH(set_up(flat.input(), flat.diagnostics), Contains("high") && Contains("9"));
}

TEST_CASE("conditions that read the mesh file need all of its blocks", "[app][run]") {
  const std::string reads =
      "begin initial condition\nblock = low\nvariable type = node\ninitialize variable name = velocity\n"
      "read variable = v\nend\n";
  SetUpCubes omits(reads, "presto", "omit block block_9\n");
  CHECK_THROWS_AS(omits.make(), DeckError);
  CHECK_THAT(messages(omits.diagnostics), Contains("blocks are omitted, and a condition has READ VARIABLE"));
  SetUpCubes plain(holds, "presto", "omit block block_9\n");
  CHECK_NOTHROW(plain.make());
}

TEST_CASE("all that is wrong with conditions is found in one go", "[app][run]") {
  SetUpCubes wrong(
      "begin fixed displacement\nblock = lov\ncomponents = x\nend\n"
      "begin initial velocity\nblock = hi\ncomponent = z\nmagnitude = 1\nend\n"
      "begin gravity\ngravitational constant = 1\ndirection = z\nblock = hugh\nend\n");
  try {
    wrong.make();
  } catch (const DeckError&) {
  }
  CHECK_THAT(messages(wrong.diagnostics), Contains("'lov'") && Contains("'hi'"));
}
