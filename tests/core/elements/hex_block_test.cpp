// SPDX-License-Identifier: BSD-3-Clause
#include "core/elements/hex_block.hpp"

#include <omp.h>

#include <random>

#include "support/catch.hpp"
#include "support/mesh_builder.hpp"

using namespace contactsim;
using contactsim::test::MeshBuilder;

namespace {

const ElasticLaw elastic{{160e9, 80e9}};

Eigen::Matrix3Xd random_velocities(Eigen::Index n) {
  std::mt19937 random(9);
  std::uniform_real_distribution<double> speed(-50.0, 50.0);
  return Eigen::Matrix3Xd::NullaryExpr(3, n, [&](Eigen::Index, Eigen::Index) { return speed(random); });
}

struct Advanced {
  BlockStep step;
  Eigen::Matrix3Xd forces;
};

Advanced advance(const Mesh& mesh, const Eigen::Matrix3Xd& v) {
  constexpr double dt = 1e-6;
  HexBlock<ElasticLaw> block(mesh.blocks()[0], elastic, {7800.0}, mesh.coordinates());
  Advanced advanced{{}, Eigen::Matrix3Xd::Zero(3, v.cols())};
  const Eigen::Matrix3Xd x = mesh.coordinates() + dt * v;
  advanced.step = block.advance(x, v, dt, advanced.forces);
  return advanced;
}

}  // namespace

TEST_CASE("a block's forces are those of its elements one by one", "[core][hex8]") {
  const Mesh mesh = MeshBuilder().add_hexes({.cells = {3, 2, 2}}).build();  // 12 elements: a batch and a half
  const Eigen::Matrix3Xd v = random_velocities(mesh.coordinates().cols());
  const Advanced all = advance(mesh, v);
  Eigen::Matrix3Xd expected = Eigen::Matrix3Xd::Zero(3, v.cols());
  double hourglass_work = 0.0;
  for (std::uint32_t element = 0; element < mesh.n_elements(); ++element) {
    ElementBlock one = mesh.blocks()[0];
    const auto nodes = mesh.blocks()[0].element_nodes(element);
    one.nodes.assign(nodes.begin(), nodes.end());
    one.n_elements = 1;
    HexBlock<ElasticLaw> block(one, elastic, {7800.0}, mesh.coordinates());
    CHECK(block.mass(0) == Approx(7800.0 / 12.0));
    const BlockStep step = block.advance(mesh.coordinates() + 1e-6 * v, v, 1e-6, expected);
    hourglass_work += step.hourglass_work;
    CHECK(step.stable_step >= all.step.stable_step);
  }
  CHECK((all.forces - expected).norm() <= 1e-12 * expected.norm());
  CHECK(all.step.hourglass_work == Approx(hourglass_work).epsilon(1e-12));
}

TEST_CASE("a block's forces and sums have the same bits for any number of threads", "[core][hex8]") {
  const Mesh mesh = MeshBuilder().add_hexes({.cells = {20, 20, 21}}).build();
  const Eigen::Matrix3Xd v = random_velocities(mesh.coordinates().cols());
  const int n_threads = omp_get_max_threads();
  omp_set_num_threads(1);
  const Advanced one = advance(mesh, v);
  for (const int n : {2, 3, 8}) {
    omp_set_num_threads(n);
    const Advanced many = advance(mesh, v);
    CHECK(many.forces == one.forces);
    CHECK(many.step.hourglass_work == one.step.hourglass_work);
    CHECK(many.step.viscous_work == one.step.viscous_work);
    CHECK(many.step.stable_step == one.step.stable_step);
  }
  omp_set_num_threads(n_threads);
}
