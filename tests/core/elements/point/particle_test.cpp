// SPDX-License-Identifier: BSD-3-Clause
#include "core/elements/elements.hpp"
#include "core/materials/elastic.hpp"
#include "support/catch.hpp"
#include "support/mesh_builder.hpp"

using namespace contactsim;
using namespace contactsim::test;

TEST_CASE("particles are balls that weigh and push nobody", "[core][particles]") {
  std::vector<Eigen::Vector3d> centres;
  std::vector<double> radii;
  for (int i = 0; i < 9; ++i) centres.emplace_back(i, 0, 0), radii.push_back(0.1 * (i + 1));  // two batches
  const Mesh mesh = MeshBuilder().add_spheres(1, "", centres).build();
  const ElementProperties properties{ElasticLaw{{3.0, 2.0}}, 5.0};
  const ModelBlock block = make_line_block(mesh, 0, sphere_particle, properties, {}, radii);
  for (std::size_t i = 0; i < 9; ++i) {
    const double volume = 4.0 / 3.0 * M_PI * std::pow(radii[i], 3);
    CHECK(block.mass[i / n_lanes](static_cast<Eigen::Index>(i % n_lanes)) == Approx(5.0 * volume));
  }
  CHECK(block.inertia.empty());
  ModelBlockState state = make_state(block);
  const Eigen::Matrix3Xd v = Eigen::Matrix3Xd::Constant(3, 9, 7.0);
  const ChunkStep step =
      block.element->advance(block, block.chunks[0], {0.0, 1.0, mesh.coordinates(), v}, state);
  CHECK(step.stable_step == std::numeric_limits<double>::infinity());
  Eigen::Matrix3Xd forces = Eigen::Matrix3Xd::Zero(3, 9);
  block.sums.add(state.forces, forces);
  CHECK(forces.isZero(0.0));
}
