// SPDX-License-Identifier: BSD-3-Clause
// Free bodies that spin. What their stresses and hourglass forces do wrong while they turn is work out of
// nothing, and grows exponentially.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/dynamics/integrator.hpp"
#include "core/dynamics/internal_force.hpp"
#include "support/mesh_builder.hpp"
#include "support/solid_laws.hpp"

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

/// A steel cube of edge 0.4 that begins to turn about an axis through its centre that is none of its own. It
/// breathes: the stress that holds it together, some 1e8, comes and goes, and is enough to yield.
struct SpinningCube {
  Mesh mesh;
  Model model;
  State state;

  SpinningCube(const ElementFormulation& row, const MaterialLaw& law, int cells)
      : mesh(make_mesh(row.shape, cells)) {
    model.mesh = &mesh;
    model.blocks.push_back(make_solid_block(mesh, 0, row, undamped(law)));
    model.mass = lumped_mass(mesh, model.blocks);
    state = make_state(mesh.coordinates(), model.blocks, 0.0);
    for (Eigen::Index i = 0; i < state.velocity.cols(); ++i)
      state.velocity.col(i) = speed * Eigen::Vector3d(1, 2, 3).normalized().cross(mesh.coordinates().col(i));
  }

  static constexpr double speed = 1000.0;  // [1/time]

  static Mesh make_mesh(Shape shape, int cells) {
    const Box box{.cells = {cells, cells, cells},
                  .origin = Eigen::Vector3d::Constant(-0.2),
                  .size = Eigen::Vector3d::Constant(0.4)};
    MeshBuilder builder;
    if (shape == Shape::hex8) builder.add_hexes(box);
    if (shape == Shape::tet4) builder.add_tets(box);
    if (shape == Shape::tet10) builder.add_ten_node_tets(box);
    if (shape == Shape::wedge6) builder.add_wedges(box);
    if (shape == Shape::pyramid5) builder.add_pyramids(box);
    return builder.build();
  }

  /// Turns so many times and checks the energies.
  void turn(double turns) {
    constexpr double pi = 3.14159265358979323846;
    InternalForce internal(model, state);
    Nothing nothing;
    const TimeStepControl control({{"all", 0.0, {}}}, turns * 2.0 * pi / speed);
    start(model, {internal, nothing}, control, state);
    const double whole = state.energies.kinetic;
    double least = 0.0, greatest = 0.0, min_internal = 0.0, max_internal = 0.0;
    while (!control.is_over(state.time, state.dt)) {
      advance(model, {internal, nothing}, control, state);
      const Energies& e = state.energies;
      least = std::min(least, e.kinetic + e.internal - whole);
      greatest = std::max(greatest, e.kinetic + e.internal - whole);
      min_internal = std::min(min_internal, e.internal);
      max_internal = std::max(max_internal, e.internal);
    }
    CHECK(least > -1e-3 * whole);
    CHECK(greatest < 1e-3 * whole);
    CHECK(min_internal > -1e-3 * whole);
    CHECK(max_internal > 1e-4 * whole);  // there is something that could grow
    CHECK(max_internal < 0.03 * whole);
  }
};

}  // namespace

TEST_CASE("spinning solids of every row and law keep their energy", "[core][conformance][spin]") {
  for_each_row(all_laws(), [](const ElementFormulation& row, const MaterialLaw& law) {
    SpinningCube(row, law, row.shape == Shape::tet10 ? 1 : 2).turn(12.0);
  });
}

TEST_CASE("spinning solids of fine meshes keep their energy", "[.][long][spin]") {
  for_each_row(all_laws(), [](const ElementFormulation& row, const MaterialLaw& law) {
    SpinningCube(row, law, 8).turn(20.0);
  });
}
