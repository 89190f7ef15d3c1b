// SPDX-License-Identifier: BSD-3-Clause
#include "core/output/element_view.hpp"

#include "support/catch.hpp"
#include "support/sample_run.hpp"

using namespace contactsim;
using namespace contactsim::test;

TEST_CASE("an element is seen by its place in the range, across batches", "[core][output]") {
  SampleRun run;
  run.set_point_value(0, 8, run.model.blocks[0].layout.energy(), 4.0);
  const OutputContext context = run.context();
  const EntityRange range{0, 7, 2, {}};
  const ElementView last{context, range, 1};
  CHECK(last.element() == 8);
  CHECK(last.mass() == 2.0);
  CHECK(last.volume() == Approx(1.0));
  CHECK(last.strain_energy() == 4.0);
  CHECK(ElementView{context, range, 0}.strain_energy() == 0.0);
  CHECK(last.gathered(run.mesh.coordinates()).row(0).minCoeff() == Approx(8.0));
}

TEST_CASE("a dying element has what is left of its stress", "[core][output]") {
  SampleRun run;
  run.set_point_value(1, 1, 0, 8.0);
  run.state.blocks[1].life.assign(1, Lanes::Constant(1.0));
  const OutputContext context = run.context();
  const EntityRange range{1, 1, 1, {}};
  const ElementView view{context, range, 0};
  CHECK(view.stress()(0, 0) == 8.0);
  run.state.blocks[1].life[0](1) = 0.25;
  CHECK(view.life() == 0.25);
  CHECK(view.stress()(0, 0) == 2.0);
  run.state.blocks[1].life[0](1) = 0.0;
  CHECK(view.stress().isZero(0.0));
}

TEST_CASE("the mean motion of a solid is that of its nodes", "[core][output]") {
  SampleRun run;
  Eigen::Matrix3d f, l;
  f << 1.2, 0.3, 0, 0, 0.9, 0, 0.1, 0, 1.1;
  l << 0, 2, 0, 0, 1, 0, 0, 0, 0;
  run.deform(f, l);
  const OutputContext context = run.context();
  const EntityRange range{0, 3, 1, {}};
  const ElementView view{context, range, 0};
  CHECK(view.deformation_gradient().isApprox(f, 1e-12));
  CHECK(view.rate_of_deformation().isApprox(0.5 * (l + l.transpose()), 1e-12));
  CHECK(view.volume() == Approx(f.determinant()));
}
