// SPDX-License-Identifier: BSD-3-Clause
#include "core/dynamics/internal_force.hpp"

#include <omp.h>

#include <random>

#include "core/base/errors.hpp"
#include "core/materials/elastic.hpp"
#include "support/catch.hpp"
#include "support/lone_element.hpp"
#include "support/mesh_builder.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

constexpr double dt = 1e-6;

Eigen::Matrix3Xd random_velocities(Eigen::Index n) {
  std::mt19937 random(9);
  std::uniform_real_distribution<double> speed(-50.0, 50.0);
  return Eigen::Matrix3Xd::NullaryExpr(3, n, [&](Eigen::Index, Eigen::Index) { return speed(random); });
}

ElementProperties damped_elastic() { return {ElasticLaw{{160e9, 80e9}}, 7800.0}; }

Model model_of(const Mesh& mesh) {
  Model model;
  model.mesh = &mesh;
  for (std::uint32_t i = 0; i < mesh.blocks().size(); ++i) {
    const ElementFormulation& row = *find_solid_element(mesh.blocks()[i].shape, "mean_quadrature");
    model.blocks.push_back(make_solid_block(mesh, i, row, damped_elastic()));
  }
  return model;
}

struct Advanced {
  ForceReport report;
  Eigen::Matrix3Xd forces;
};

Advanced advance(const Mesh& mesh, const Eigen::Matrix3Xd& v) {
  const Model model = model_of(mesh);
  State state = make_state(mesh.coordinates(), model.blocks, 0.0);
  InternalForce internal(model, state);
  const Eigen::Matrix3Xd x = mesh.coordinates() + dt * v;
  Advanced advanced{{}, Eigen::Matrix3Xd::Constant(3, v.cols(), 1.0)};
  advanced.report = internal.set_forces({0.0, dt, x, v}, advanced.forces);
  return advanced;
}

/// The columns of an element's nodes.
Eigen::Matrix3Xd at_nodes(const Eigen::Matrix3Xd& values, std::span<const NodeIndex> nodes) {
  Eigen::Matrix3Xd columns(3, static_cast<Eigen::Index>(nodes.size()));
  for (std::size_t i = 0; i < nodes.size(); ++i)
    columns.col(static_cast<Eigen::Index>(i)) = values.col(nodes[i].value);
  return columns;
}

}  // namespace

TEST_CASE("forces of blocks are those of their elements one by one", "[core][elements]") {
  // 12 elements are a batch and a half; the second block shares nodes with the first, one node has no
  // element.
  MeshBuilder builder;
  builder.add_hexes({.cells = {3, 2, 2}})
      .add_hexes({.id = 2, .cells = {1, 2, 2}, .origin = {1.0, 0.0, 0.0}})
      .add_node({5, 5, 5});
  const Mesh mesh = builder.build();
  const Eigen::Matrix3Xd v = random_velocities(mesh.coordinates().cols());
  const Advanced all = advance(mesh, v);
  Eigen::Matrix3Xd expected = Eigen::Matrix3Xd::Zero(3, v.cols());
  double hourglass_work = 0.0, viscous_work = 0.0, stable_step = 1.0;
  ElementIndex critical;
  for (std::uint32_t element = 0; element < mesh.n_elements(); ++element) {
    const auto nodes = mesh.element_nodes({element});
    const Eigen::Matrix3Xd x = at_nodes(mesh.coordinates(), nodes);
    LoneElement one(*find_solid_element(Shape::hex8, "mean_quadrature"), damped_elastic(), x);
    CHECK(one.mass() == Approx(element < 12 ? 7800.0 / 12.0 : 7800.0 / 4.0));
    const ChunkStep step = one.move_to(x + dt * at_nodes(v, nodes), dt);
    for (std::size_t i = 0; i < nodes.size(); ++i)
      expected.col(nodes[i].value) += one.forces().col(static_cast<Eigen::Index>(i));
    hourglass_work += step.hourglass_work;
    viscous_work += step.viscous_work;
    if (step.stable_step < stable_step) critical = {element};
    stable_step = std::min(stable_step, step.stable_step);
  }
  CHECK((all.forces - expected).norm() <=
        1e-11 * expected.norm());  // a velocity has the digits of x / (dt v)
  CHECK(all.report.hourglass_work == Approx(hourglass_work).epsilon(1e-12));
  CHECK(all.report.viscous_work == Approx(viscous_work).epsilon(1e-12));
  CHECK(all.report.stable_step == Approx(stable_step).epsilon(1e-12));
  CHECK(all.report.critical_element == critical);
}

TEST_CASE("forces and sums have the same bits for any number of threads", "[core][elements]") {
  const Mesh mesh = MeshBuilder().add_hexes({.cells = {20, 20, 21}}).build();
  const Eigen::Matrix3Xd v = random_velocities(mesh.coordinates().cols());
  const int n_threads = omp_get_max_threads();
  omp_set_num_threads(1);
  const Advanced one = advance(mesh, v);
  for (const int n : {2, 3, 8}) {
    omp_set_num_threads(n);
    const Advanced many = advance(mesh, v);
    CHECK(many.forces == one.forces);
    CHECK(many.report.hourglass_work == one.report.hourglass_work);
    CHECK(many.report.viscous_work == one.report.viscous_work);
    CHECK(many.report.stable_step == one.report.stable_step);
    CHECK(many.report.critical_element == one.report.critical_element);
  }
  omp_set_num_threads(n_threads);
}

TEST_CASE("an element that turns inside out is named", "[core][elements]") {
  const Mesh mesh = MeshBuilder().add_hexes({.cells = {9, 1, 1}, .size = {9.0, 1.0, 1.0}}).build();
  const Model model = model_of(mesh);
  State state = make_state(mesh.coordinates(), model.blocks, 0.0);
  InternalForce internal(model, state);
  Eigen::Matrix3Xd x = mesh.coordinates(), v = Eigen::Matrix3Xd::Zero(3, x.cols()), forces(3, x.cols());
  for (Eigen::Index i = 0; i < x.cols(); ++i) {
    if (x(0, i) == 9.0) v(0, i) = -3.0;
  }
  x += v;
  CHECK_THROWS_WITH(internal.set_forces({0.5, 1.0, x, v}, forces),
                    "time 0.5: element 9 of block_1 has turned inside out");
}
