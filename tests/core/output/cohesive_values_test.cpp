// SPDX-License-Identifier: BSD-3-Clause
#include "core/output/cohesive_values.hpp"

#include "core/elements/cohesive/cohesive_pairs.hpp"
#include "core/elements/cohesive_section.hpp"
#include "support/catch.hpp"
#include "support/mesh_builder.hpp"
#include "support/sample_run.hpp"

using namespace contactsim;
using namespace contactsim::test;

TEST_CASE("values of a cohesive element are means over its pairs", "[core][output]") {
  MeshBuilder builder;
  for (const double z : {0.0, 0.1}) {
    for (const Eigen::Vector2d& x : std::vector<Eigen::Vector2d>{{0, 0}, {1, 0}, {1, 2}, {0, 2}})
      builder.add_node({x.x(), x.y(), z});
  }
  builder.add_block(1, "", Shape::cohesive8, {0, 1, 2, 3, 4, 5, 6, 7});
  const Mesh mesh = builder.build();
  // Stiffness 50 against opening; peak from 0.1 to 0.5 of 2.
  const TractionLaw law{10.0, 0.1, 0.5, 2.0, 4.0, 3.0};
  Diagnostics diagnostics;
  Model model;
  model.mesh = &mesh;
  model.blocks.push_back(*make_cohesive_block(mesh, 0, law, 0.0, {}, diagnostics));
  State state = make_state(mesh.coordinates(), model.blocks, 0.0);
  const StateLayout& layout = model.blocks[0].layout;
  const auto set = [&](std::size_t pair, std::initializer_list<double> numbers) {
    std::size_t place = layout.energy() - layout.n_own + pair * cohesive::n_numbers;
    for (const double number : numbers) state.blocks[0].batch(layout, 0)[place++](0) = number;
  };
  // The largest lambda, opening and sliding now, their last changes, tractions.
  set(0, {0.4, 0.8, 0.0, 0.1, 0.1, 10.0, 0.0});
  set(2, {0.05, 0.1, -0.4, 0.1, 0.1, 5.0, -5.0});
  state.blocks[0].batch(layout, 0)[layout.energy()](0) = 9.0;
  const OutputContext context{model, state};
  const EntityRange range{0, 0, 1, {}};
  const CohesiveValues values(ElementView{context, range, 0});
  CHECK(values.separation[0] == Approx(0.9 / 4));
  CHECK(values.separation[1] == Approx(-0.4 / 4));
  CHECK(values.traction[0] == Approx(15.0 / 4));
  CHECK(values.traction[1] == Approx(-5.0 / 4));
  CHECK(values.damage == Approx(0.75 / 4));  // of the first pair a quarter of the stiffness is left
  // A quarter of the area of 2 for each: the energies 4, and 0.25 and 1, come back.
  CHECK(values.dissipation == Approx(9.0 - 0.5 * (4.0 + 0.25 + 1.0)));
}

TEST_CASE("other elements have no cohesive values", "[core][output]") {
  SampleRun run;
  run.set_point_value(0, 3, run.model.blocks[0].layout.energy(), 4.0);
  const OutputContext context = run.context();
  const EntityRange range{0, 3, 1, {}};
  const CohesiveValues values(ElementView{context, range, 0});
  CHECK(values.separation == std::array<double, 2>{});
  CHECK(values.traction == std::array<double, 2>{});
  CHECK(values.damage == 0.0);
  CHECK(values.dissipation == 0.0);
}
