// SPDX-License-Identifier: BSD-3-Clause
#include <omp.h>

#include <Eigen/Geometry>
#include <cmath>

#include "core/dynamics/integrator.hpp"
#include "core/dynamics/internal_force.hpp"
#include "core/elements/elements.hpp"
#include "core/materials/elastic.hpp"
#include "support/catch.hpp"
#include "support/lone_shell.hpp"
#include "support/mesh_builder.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

class Nothing final : public ForceTerm {
 public:
  ForceReport set_forces(const Motion&, Eigen::Matrix3Xd& forces) override {
    forces.setZero();
    return {};
  }
};

/// A free sheet of shells of edge 1 and thickness 0.1 that turns and bends.
struct SpinningSheet {
  explicit SpinningSheet(int n)
      : mesh(
            MeshBuilder().add_shells({.cells = {n, n}, .u = {1.0 * n, 0, 0}, .v = {0, 1.0 * n, 0}}).build()) {
    model.mesh = &mesh;
    const std::vector<double> thickness(mesh.n_elements(), 0.1);
    model.blocks.push_back(make_shell_block(mesh, 0, shell4_bt_shell, {ElasticLaw{{160e9, 80e9}}, 7800.0},
                                            gauss_layers(), thickness));
    model.mass = lumped_mass(mesh, model.blocks);
    model.inertia = lumped_inertia(mesh, model.blocks);
    state = make_state(mesh.coordinates(), model.blocks, 0.0);
    const Eigen::Vector3d spin(20.0, 10.0, -30.0);
    for (Eigen::Index i = 0; i < state.velocity.cols(); ++i) {
      const Eigen::Vector3d x = mesh.coordinates().col(i);
      state.velocity.col(i) = spin.cross(x);
      state.velocity(2, i) += 30.0 * std::sin(x.x()) * std::cos(2.0 * x.y());
      state.rotations.velocity.col(i) = spin;
    }
  }

  Eigen::Vector3d angular_momentum() const {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (Eigen::Index i = 0; i < state.velocity.cols(); ++i) {
      const Eigen::Vector3d x = state.coordinates.col(i), v = state.velocity.col(i);
      sum += model.mass(i) * x.cross(v) + model.inertia(i) * state.rotations.velocity.col(i);
    }
    return sum;
  }

  void run(int n_steps, int threads = 1) {
    omp_set_num_threads(threads);
    InternalForce internal(model, state);
    Nothing nothing;
    const TimeStepControl control({{"all", 0.0, {}}}, 1e9);
    start(model, {internal, nothing}, control, state);
    for (int step = 0; step < n_steps; ++step) advance(model, {internal, nothing}, control, state);
  }

  Mesh mesh;
  Model model;
  State state;
};

}  // namespace

TEST_CASE("a free sheet of shells keeps its momentum and its energy", "[core][shells]") {
  SpinningSheet sheet(6);
  const Eigen::Vector3d before = sheet.angular_momentum();
  sheet.run(500);
  const Energies& e = sheet.state.energies;
  CHECK(e.internal > 2e-3 * e.kinetic);
  CHECK(std::abs(e.error) < 1e-3 * e.largest);  // steps grow at the start
  CHECK((sheet.angular_momentum() - before).norm() < 1e-10 * before.norm());
  CHECK(sheet.state.rotations.angle.norm() > 1e-3);
}

TEST_CASE("a run of shells gives the same bits with one thread and with two", "[core][shells]") {
  SpinningSheet one(40), two(40);
  one.run(10, 1);
  two.run(10, 2);
  CHECK(one.state.coordinates == two.state.coordinates);
  CHECK(one.state.rotations.velocity == two.state.rotations.velocity);
  CHECK(one.state.energies.internal == two.state.energies.internal);
}

TEST_CASE("a model without shells has no rotations", "[core][shells]") {
  const Mesh mesh = MeshBuilder().add_hexes({}).build();
  std::vector<ModelBlock> blocks;
  blocks.push_back(make_solid_block(mesh, 0, hex8_mean_quadrature, {ElasticLaw{{160e9, 80e9}}, 7800.0}));
  CHECK(lumped_inertia(mesh, blocks).cols() == 0);
  CHECK_FALSE(make_state(mesh.coordinates(), blocks, 0.0).rotations.exist());
}
