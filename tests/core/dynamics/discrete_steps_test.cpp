// SPDX-License-Identifier: BSD-3-Clause
#include "core/dynamics/discrete_steps.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <limits>

#include "core/elements/elements.hpp"
#include "support/catch.hpp"
#include "support/mesh_builder.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// A row of springs, or dampers, between nodes of given masses.
struct Chain {
  Mesh mesh;
  Model model;

  Chain(const ElementFormulation& element, const std::vector<double>& masses, double stiffness)
      : mesh(MeshBuilder().add_bars({.cells = static_cast<int>(masses.size()) - 1}).build()) {
    model.mesh = &mesh;
    const std::vector<double> areas(mesh.n_elements(), 1.0);
    ModelBlock block = make_discrete_block(mesh, 0, element, 0.0, areas);
    block.discrete.stiffness.assign(block.n_batches(), Lanes::Constant(stiffness));
    block.discrete.stable_step.assign(block.n_batches(), Lanes::Constant(infinity));
    model.blocks.push_back(block);
    model.mass.resize(static_cast<Eigen::Index>(masses.size()));
    for (std::size_t i = 0; i < masses.size(); ++i)
      model.mass.col(static_cast<Eigen::Index>(i)).setConstant(masses[i]);
    set_discrete_steps(model);
  }
  double step() const { return model.blocks[0].discrete.stable_step[0].head(mesh.n_elements()).minCoeff(); }
};

}  // namespace

TEST_CASE("the step of a lone spring is that of its frequency", "[core][springs]") {
  CHECK(Chain(bar2_spring, {2.0, 3.0}, 10.0).step() ==
        Approx(2.0 / std::sqrt(10.0 * (1.0 / 2.0 + 1.0 / 3.0))));
  CHECK(Chain(bar2_spring, {minimum_nodal_mass, 4.0}, 100.0).step() == Approx(2.0 / 5.0));  // on a support
  CHECK(Chain(bar2_damper, {2.0, 2.0}, 10.0).step() == Approx(2.0 / 10.0));
}

TEST_CASE("the step of springs at one another is below that of their highest frequency", "[core][springs]") {
  const std::vector<double> masses{1.0, 0.2, 5.0, 0.1, 1.0};
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(5, 5);
  for (Eigen::Index i = 0; i < 4; ++i) stiffness.block<2, 2>(i, i) += 7.0 * Eigen::Matrix2d{{1, -1}, {-1, 1}};
  for (Eigen::Index i = 0; i < 5; ++i) {
    stiffness.row(i) /= std::sqrt(masses[static_cast<std::size_t>(i)]);
    stiffness.col(i) /= std::sqrt(masses[static_cast<std::size_t>(i)]);
  }
  const double limit =
      2.0 / std::sqrt(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(stiffness).eigenvalues()[4]);
  const double bound = Chain(bar2_spring, masses, 7.0).step();
  CHECK(bound <= limit * (1.0 + 1e-12));
  CHECK(bound > 0.6 * limit);
}

TEST_CASE("steps of elements, springs and dampers combine such that all are stable together",
          "[core][springs]") {
  CHECK(combined_step(3.0, infinity, infinity) == 3.0);
  CHECK(combined_step(3.0, 4.0, infinity) == Approx(2.4));
  CHECK(combined_step(infinity, 4.0, infinity) == Approx(4.0));
  CHECK(combined_step(infinity, infinity, 5.0) == Approx(5.0));
  // A damped oscillator of the frequency 2 / 3 and the damping rate 2 / 5, by the textbook's form.
  const double omega = 2.0 / 3.0, z = 2.0 / 5.0 / (2.0 * omega);
  CHECK(combined_step(infinity, 3.0, 5.0) == Approx(2.0 / omega * (std::sqrt(1.0 + z * z) - z)));
  CHECK(std::isinf(combined_step(infinity, infinity, infinity)));
}
