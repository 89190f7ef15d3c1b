// SPDX-License-Identifier: BSD-3-Clause
#include "core/statics/no_equilibrium.hpp"

#include "support/capped_cube.hpp"
#include "support/catch.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

CgReport failed_search(double residual, double reference) {
  CgReport search;
  search.n_iterations = 100;
  search.residual = residual;
  search.reference = reference;
  return search;
}

}  // namespace

TEST_CASE("an imbalance is reported with its size and place", "[core][statics]") {
  const CappedCube cube;
  const auto describe = [&](Eigen::Index at, double residual, double reference) {
    Eigen::VectorXd forces = Eigen::VectorXd::Zero(cube.problem->size());
    if (at >= 0) forces(at) = 1.0;
    return describe_imbalance(*cube.problem, cube.mesh, failed_search(residual, reference),
                              at < 0 ? Eigen::VectorXd() : forces);
  };
  CHECK(describe(-1, 3.0, 150.0) ==
        "after 100 iterations 3 of forces are left over, 0.02 of their reference 150");
  CHECK(describe(4, 3.0, 150.0) ==
        "after 100 iterations 3 of forces are left over, 0.02 of their reference 150, most at node 2");
  const std::string body = "the rigid body '" + cube.model.rigid.bodies[0].name + "'";
  CHECK(describe(cube.centre(), 3.0, 150.0).ends_with(", most at the force on " + body));
  CHECK(describe(cube.centre() + 3, 3.0, 150.0).ends_with(", most at the moment on " + body));
  CHECK(describe(-1, 3e6, 150.0)
            .ends_with("; are all bodies held, by conditions or by what they are joined to?"));
  CHECK(describe(-1, 3.0, 0.0) == "elements turn inside out from the first guess on");
}

TEST_CASE("rigid bodies that conditions do not hold are named", "[core][statics]") {
  const CappedCube cube;
  CHECK(name_free_bodies(*cube.problem, {}).empty());
  const std::vector<std::uint32_t> free = {0};
  CHECK(name_free_bodies(*cube.problem, free) ==
        "; conditions leave rigid motions, which nothing else holds, to '" + cube.model.rigid.bodies[0].name +
            "'");
}
