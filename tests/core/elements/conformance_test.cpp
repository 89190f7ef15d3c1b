// SPDX-License-Identifier: BSD-3-Clause
// What every solid element must do with every law. Moduli are near 1e11, edges near 1, steps of size 1, so
// that strain rates are small: stresses do not depend on the rate.
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/dynamics/internal_force.hpp"
#include "core/materials/elastic.hpp"
#include "core/materials/neo_hookean.hpp"
#include "core/materials/orthotropic.hpp"
#include "core/mesh/element_checks.hpp"
#include "support/catch.hpp"
#include "support/lone_element.hpp"
#include "support/mesh_builder.hpp"
#include "support/solid_laws.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Eigen::Matrix3d;
using Eigen::Matrix3Xd;

namespace {

constexpr double size_of_forces = 1e11;  // modulus x area

LoneElement make_element(const ElementFormulation& row, const MaterialLaw& law, double distortion = 0.1,
                         unsigned seed = 1) {
  return {row, undamped(law), distorted(regular_element(row.shape), distortion, seed)};
}

/// A general gradient of a size.
Matrix3d gradient_of(double size) {
  return size * Matrix3d{{0.6, 0.3, -0.2}, {-0.1, -0.5, 0.4}, {0.5, 0.2, 0.3}};
}

Matrix3d hooke(const MaterialLaw& law, const Matrix3d& gradient) {
  const Matrix3d strain = 0.5 * (gradient + gradient.transpose());
  if (const auto* directed = law.get_if<OrthotropicLaw>()) {
    Matrix3d stress;
    for (Eigen::Index i = 0; i < 3; ++i) {
      const auto& row = directed->direct[static_cast<std::size_t>(i)];
      stress(i, i) = row[0] * strain(0, 0) + row[1] * strain(1, 1) + row[2] * strain(2, 2);
    }
    stress(0, 1) = stress(1, 0) = 2.0 * directed->shear[0] * strain(0, 1);
    stress(1, 2) = stress(2, 1) = 2.0 * directed->shear[1] * strain(1, 2);
    stress(2, 0) = stress(0, 2) = 2.0 * directed->shear[2] * strain(2, 0);
    return stress;
  }
  return steel.lambda() * strain.trace() * Matrix3d::Identity() + 2.0 * steel.shear * strain;
}

/// A box of 2 x 2 x 2 cells whose inner nodes are moved at random.
Mesh make_patch(Shape shape) {
  MeshBuilder builder;
  const Box box{.cells = {2, 2, 2}};
  if (shape == Shape::hex8) builder.add_hexes(box);
  if (shape == Shape::tet4) builder.add_tets(box);
  if (shape == Shape::tet10) builder.add_ten_node_tets(box);
  if (shape == Shape::wedge6) builder.add_wedges(box);
  if (shape == Shape::pyramid5) builder.add_pyramids(box);
  MeshParts parts = builder.parts();
  const Matrix3Xd moved = distorted(parts.coordinates, 0.06, 3);
  for (Eigen::Index node = 0; node < moved.cols(); ++node) {
    const auto x = parts.coordinates.col(node);
    if (x.minCoeff() > 0.0 && x.maxCoeff() < 1.0) parts.coordinates.col(node) = moved.col(node);
  }
  return Mesh(std::move(parts));
}

/// The plastic strain at an integration point, nothing for laws without.
std::optional<double> plastic_strain(const LoneElement& element, std::size_t point) {
  for (const StateVariable& variable : element.block.properties.law.kind().variables) {
    const std::size_t place = point * element.block.layout.point_size + 6 + variable.first;
    if (variable.name == "eqps") return element.state.at(element.block.layout, 0, place);
  }
  return std::nullopt;
}

}  // namespace

TEST_CASE("a distorted patch deforms uniformly and its inner nodes stay in balance", "[core][conformance]") {
  for_each_row(all_laws(), [](const ElementFormulation& row, const MaterialLaw& law) {
    const Mesh mesh = make_patch(row.shape);
    Model model;
    model.mesh = &mesh;
    model.blocks.push_back(make_solid_block(mesh, 0, row, undamped(law)));
    State state = make_state(mesh.coordinates(), model.blocks, 0.0);
    InternalForce internal(model, state);
    Matrix3Xd x = mesh.coordinates(), forces(3, x.cols());
    for (int step = 0; step < 3; ++step) {  // beyond the yield strain
      const Matrix3Xd v = gradient_of(2e-3) * x;
      x += v;
      const ForceReport report = internal.set_forces({0.0, 1.0, x, v}, forces);
      CHECK(std::abs(report.hourglass_work) < 1e-20 * size_of_forces);
    }
    const ModelBlock& block = model.blocks[0];
    const double greatest = std::abs(state.blocks[0].at(block.layout, 0, 0));
    CHECK(greatest > 1e8);
    for (std::size_t element = 0; element < block.n_elements; ++element) {
      for (std::size_t place = 0; place < row.n_points * block.layout.point_size; ++place) {
        const double first = state.blocks[0].at(block.layout, 0, place % block.layout.point_size);
        CHECK(std::abs(state.blocks[0].at(block.layout, element, place) - first) <=
              1e-10 * std::max(greatest, 1.0));
      }
    }
    for (Eigen::Index node = 0; node < x.cols(); ++node) {
      const auto rest = mesh.coordinates().col(node);
      const bool is_inner = rest.minCoeff() > 0.0 && rest.maxCoeff() < 1.0;
      if (is_inner) CHECK(forces.col(node).norm() < 1e-10 * greatest);
    }
  });
}

TEST_CASE("a small strain gives Hooke's stress in an element of any form", "[core][conformance]") {
  for_each_row(all_laws(), [](const ElementFormulation& row, const MaterialLaw& law) {
    LoneElement element = make_element(row, law);
    element.move_to((Matrix3d::Identity() + gradient_of(1e-7)) * element.coordinates);
    const Matrix3d expected = hooke(law, gradient_of(1e-7));
    for (std::size_t point = 0; point < row.n_points; ++point)
      CHECK((element.stress(point) - expected).norm() < 1e-6 * expected.norm());
  });
}

TEST_CASE("a rotation in large steps strains nothing and turns stress and forces", "[core][conformance]") {
  for_each_row(all_laws(), [](const ElementFormulation& row, const MaterialLaw& law) {
    LoneElement element = make_element(row, law);
    const Matrix3Xd x = element.coordinates;
    for (int i = 1; i <= 5; ++i) element.move_to(rotation_of(0.3 * i) * x);
    CHECK(element.stress().norm() < 1e-14 * size_of_forces);
    CHECK(element.forces().norm() < 1e-14 * size_of_forces);

    LoneElement strained = make_element(row, law);
    const Matrix3Xd there = distorted((Matrix3d::Identity() + gradient_of(3e-3)) * x, 1e-3, 2);
    strained.move_to(there);
    const LoneElement before = strained;
    CHECK(before.stress().norm() > 1e8);
    for (int i = 1; i <= 5; ++i) strained.move_to(rotation_of(0.3 * i) * there);
    const Matrix3d turn = rotation_of(1.5);
    for (std::size_t point = 0; point < row.n_points; ++point) {
      const Matrix3d expected = turn * before.stress(point) * turn.transpose();
      CHECK((strained.stress(point) - expected).norm() < 1e-14 * size_of_forces);
    }
    CHECK((strained.forces() - turn * before.forces()).norm() < 1e-13 * size_of_forces);
    CHECK(strained.stress_work() == Approx(before.stress_work()).epsilon(1e-9));
  });
}

TEST_CASE("volume and mass are those of the element's faces, and those of a patch add up to the body",
          "[core][conformance]") {
  for_each_row({ElasticLaw{steel}}, [](const ElementFormulation& row, const MaterialLaw& law) {
    for (unsigned seed = 1; seed <= 5; ++seed) {
      const LoneElement element = make_element(row, law, 0.1, seed);
      std::vector<NodeIndex> nodes;
      for (std::uint32_t node = 0; node < row.n_nodes; ++node) nodes.push_back({node});
      const double expected = solid_volume(element.coordinates, nodes, topology(row.shape));
      CHECK(element.volume() == Approx(expected).epsilon(1e-13));
      CHECK(element.mass() == Approx(7800.0 * expected).epsilon(1e-13));
    }
    const Mesh mesh = make_patch(row.shape);
    const ModelBlock block = make_solid_block(mesh, 0, row, undamped(law));
    CHECK(lumped_mass(mesh, {&block, 1}).sum() == Approx(7800.0).epsilon(1e-13));
  });
}

TEST_CASE("the forces are the derivatives of the work", "[core][conformance]") {
  for_each_row(elastic_laws(), [](const ElementFormulation& row, const MaterialLaw& law) {
    LoneElement element = make_element(row, law);
    const Matrix3Xd x = element.coordinates;
    for (int i = 1; i <= 4; ++i)
      element.move_to(distorted((Matrix3d::Identity() + gradient_of(0.05 * i)) * x, 0.01, 7));
    constexpr double h = 1e-6;
    const Matrix3Xd forces = element.forces();
    REQUIRE(forces.norm() > 1e-2 * size_of_forces);
    for (Eigen::Index i = 0; i < x.size(); ++i) {
      double work[2];
      for (const int side : {0, 1}) {
        LoneElement moved = element;
        Matrix3Xd there = element.coordinates;
        there(i) += side == 0 ? -h : h;
        work[side] = moved.move_to(there).hourglass_work + moved.stress_work();
      }
      CHECK(-(work[1] - work[0]) / (2.0 * h) == Approx(forces(i)).margin(1e-7 * size_of_forces));
    }
  });
}

TEST_CASE("asking for the forces where an element stands changes nothing", "[core][conformance]") {
  for_each_row(all_laws(), [](const ElementFormulation& row, const MaterialLaw& law) {
    LoneElement element = make_element(row, law);
    element.stay();
    CHECK(element.forces() == Matrix3Xd::Zero(3, element.coordinates.cols()));
    element.move_to(distorted(element.coordinates, 0.01, 2), 1e-5);  // fast
    const LoneElement before = element;
    element.stay();
    CHECK((element.forces() - before.forces()).norm() <= 1e-12 * before.forces().norm());
    CHECK(plastic_strain(element, 0) == plastic_strain(before, 0));
  });
}

TEST_CASE("the work on a neo-Hookean element is its strain energy", "[core][conformance]") {
  for_each_row({NeoHookeanLaw{steel}}, [](const ElementFormulation& row, const MaterialLaw& law) {
    LoneElement element = make_element(row, law);
    const Matrix3Xd x = element.coordinates;
    const double volume = element.volume();
    constexpr int n_steps = 200;
    const Matrix3d f = Matrix3d::Identity() + gradient_of(0.3);
    for (int i = 1; i <= n_steps; ++i)
      element.move_to((Matrix3d::Identity() + gradient_of(0.3 * i / n_steps)) * x);
    const double j = f.determinant();
    const double energy = steel.bulk / 4.0 * (j * j - 1.0) - steel.bulk / 2.0 * std::log(j) +
                          steel.shear / 2.0 * (std::pow(j, -2.0 / 3.0) * f.squaredNorm() - 3.0);
    CHECK(element.stress_work() == Approx(energy * volume).epsilon(1e-4));  // of second order in the step
  });
}

TEST_CASE("internal forces balance in force and moment", "[core][conformance]") {
  for_each_row(all_laws(), [](const ElementFormulation& row, const MaterialLaw& law) {
    LoneElement element(row, {law, 7800.0, 0.05, 0.03}, distorted(regular_element(row.shape), 0.1, 1));
    element.move_to(distorted(element.coordinates, 0.02, 2), 1e-4);
    const Matrix3Xd force = element.forces();
    REQUIRE(force.norm() > 1e7);
    CHECK(force.rowwise().sum().norm() < 1e-12 * force.norm());
    Eigen::Vector3d moment = Eigen::Vector3d::Zero();
    for (Eigen::Index node = 0; node < force.cols(); ++node)
      moment += Eigen::Vector3d(element.coordinates.col(node)).cross(Eigen::Vector3d(force.col(node)));
    CHECK(moment.norm() < 1e-12 * force.norm());
  });
}

TEST_CASE("only rigid motions are free of resistance", "[core][conformance]") {
  for_each_row({ElasticLaw{steel}}, [](const ElementFormulation& row, const MaterialLaw& law) {
    for (const double distortion : {0.0, 0.1}) {
      const Eigen::MatrixXd stiffness = stiffness_of(make_element(row, law, distortion));
      CHECK((stiffness - stiffness.transpose()).norm() < 1e-5 * stiffness.norm());
      const Eigen::MatrixXd symmetric = 0.5 * (stiffness + stiffness.transpose());
      const Eigen::VectorXd ascending =
          Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(symmetric, Eigen::EigenvaluesOnly).eigenvalues();
      CHECK(ascending.head(6).cwiseAbs().maxCoeff() < 1e-5 * size_of_forces);
      CHECK(ascending(6) > 1e-3 * size_of_forces);
    }
  });
}

TEST_CASE("the stable step is below that of the highest frequency", "[core][conformance]") {
  for_each_row(elastic_laws(), [](const ElementFormulation& row, const MaterialLaw& law) {
    for (unsigned seed = 1; seed <= 6; ++seed) {
      LoneElement element = make_element(row, law, 0.03 * seed, seed);
      CHECK(element.stay().stable_step <= (1.0 + 1e-6) * stable_limit(element));
      if (law.get_if<NeoHookeanLaw>() == nullptr) continue;
      const Matrix3d f = Matrix3d::Identity() + gradient_of(seed % 2 == 0 ? 0.5 : -0.5);
      element.move_to(f * element.coordinates);
      CHECK(element.stay().stable_step <= (1.0 + 1e-6) * stable_limit(element));
    }
  });
}

TEST_CASE("the stable step of flat and warped elements is below that of the highest frequency",
          "[core][conformance]") {
  for_each_row({ElasticLaw{steel}}, [](const ElementFormulation& row, const MaterialLaw& law) {
    ElementProperties properties = undamped(law);
    for (unsigned seed = 1; seed <= 12; ++seed) {
      properties.deviatoric_parameter = seed % 2 == 0 ? 0.0 : 0.5;
      LoneElement element(row, properties, flat_and_warped(row.shape, seed));
      const ChunkStep step = element.stay();
      REQUIRE(step.min_volume > 0.0);
      CHECK(step.stable_step <= (1.0 + 1e-6) * stable_limit(element));
    }
  });
}

TEST_CASE("bulk viscosity pushes against closing and shortens the stable step", "[core][conformance]") {
  for_each_row({ElasticLaw{steel}}, [](const ElementFormulation& row, const MaterialLaw& law) {
    const Matrix3Xd x = distorted(regular_element(row.shape), 0.1, 1);
    LoneElement damped(row, {law, 7800.0}, x), free(row, undamped(law), x);
    const ChunkStep slow = damped.move_to(0.999 * x, 1e-6), fast = free.move_to(0.999 * x, 1e-6);
    CHECK(slow.stable_step < fast.stable_step);
    CHECK(slow.viscous_work > 0.0);
    CHECK(fast.viscous_work == 0.0);
    CHECK((damped.forces() - free.forces()).cwiseProduct(x.colwise() - x.rowwise().mean()).sum() > 0.0);
  });
}

TEST_CASE("plastic strain only grows, whatever an element suffers", "[core][conformance]") {
  for_each_row(plastic_laws(), [](const ElementFormulation& row, const MaterialLaw& law) {
    LoneElement element = make_element(row, law);
    const Matrix3Xd x = element.coordinates;
    std::vector<double> before(row.n_points, 0.0);
    for (unsigned step = 1; step <= 30; ++step) {
      element.move_to(distorted(x, 0.01, step));
      for (std::size_t point = 0; point < row.n_points; ++point) {
        const std::optional<double> now = plastic_strain(element, point);
        REQUIRE(now);
        CHECK(*now >= before[point]);
        before[point] = *now;
      }
    }
    CHECK(before[0] > 0.01);
  });
}
