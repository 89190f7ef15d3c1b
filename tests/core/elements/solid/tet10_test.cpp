// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Eigenvalues>
#include <numeric>

#include "core/dynamics/model.hpp"
#include "core/elements/elements.hpp"
#include "core/elements/solid/tet10_geometry.hpp"
#include "core/materials/elastic.hpp"
#include "support/catch.hpp"
#include "support/lone_element.hpp"
#include "support/mesh_builder.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Eigen::Matrix3Xd;

namespace {

LoneElement regular_tet(double bulk) {
  return {tet10_composite, undamped(ElasticLaw{{bulk, 80e9}}), regular_element(Shape::tet10)};
}

NodeVectors<10> in_all_lanes(const Matrix3Xd& x) {
  NodeVectors<10> lanes;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t a = 0; a < 10; ++a)
      lanes[i][a].setConstant(x(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(a)));
  }
  return lanes;
}

/// The displacements of pure bending about y with curvature 1 and Poisson's ratio nu, about the middle.
Matrix3Xd bending(const Matrix3Xd& x, double nu) {
  const Matrix3Xd r = x.colwise() - x.leftCols(4).rowwise().mean().eval();
  Matrix3Xd u(3, x.cols());
  u.row(0) = -r.row(0).cwiseProduct(r.row(2));
  u.row(1) = nu * r.row(1).cwiseProduct(r.row(2));
  u.row(2) = 0.5 * (r.row(0).cwiseAbs2() + nu * (r.row(2).cwiseAbs2() - r.row(1).cwiseAbs2()));
  return u;
}

double energy_of(const LoneElement& element, const Matrix3Xd& u) {
  return 0.5 * u.reshaped().dot(stiffness_of(element) * u.reshaped());
}

/// Of the stiffness, ascending.
Eigen::VectorXd eigenvalues_of(const LoneElement& element) {
  const Eigen::MatrixXd stiffness = stiffness_of(element);
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(0.5 * (stiffness + stiffness.transpose()),
                                                        Eigen::EigenvaluesOnly)
      .eigenvalues();
}

}  // namespace

TEST_CASE("the twelve tetrahedra fill the ten-node one, a quarter for each point", "[core][tet10]") {
  const tet10::Projection projection(in_all_lanes(regular_element(Shape::tet10)));
  const double volume = 8.0 / (6.0 * std::sqrt(2.0));  // of a regular tetrahedron of edge 2
  CHECK(projection.whole_volume(0) == Approx(volume).epsilon(1e-14));
  CHECK(projection.min_volume(7) == Approx(volume / 16.0).epsilon(1e-12));
  for (const Lanes& share : projection.volume) CHECK(share(3) == Approx(volume / 4.0).epsilon(1e-12));
}

TEST_CASE("every node of a ten-node tetrahedron has a positive mass", "[core][tet10]") {
  CHECK(std::accumulate(tet10::mass_shares.begin(), tet10::mass_shares.end(), 0.0) == Approx(1.0));
  // Nodes inside a box of equal cells have nearly equal masses, be they corners or in the middle of edges.
  const Mesh mesh = MeshBuilder().add_ten_node_tets({.cells = {4, 4, 4}}).build();
  const ModelBlock block = make_solid_block(mesh, 0, tet10_composite, undamped_elastic());
  const Eigen::RowVectorXd mass = lumped_mass(mesh, {&block, 1});
  double least = 1e300, greatest = 0.0;
  for (Eigen::Index node = 0; node < mass.cols(); ++node) {
    const auto x = mesh.coordinates().col(node);
    if (x.minCoeff() < 0.2 || x.maxCoeff() > 0.8) continue;
    least = std::min(least, mass(node));
    greatest = std::max(greatest, mass(node));
  }
  CHECK(greatest < 1.6 * least);
}

TEST_CASE("the lumped mass of a ten-node tetrahedron has the element's centre", "[core][tet10]") {
  const Matrix3Xd x = regular_element(Shape::tet10);
  Eigen::Vector3d first = Eigen::Vector3d::Zero();
  for (Eigen::Index a = 0; a < 10; ++a) first += tet10::mass_shares[static_cast<std::size_t>(a)] * x.col(a);
  CHECK((first - x.leftCols(4).rowwise().mean()).norm() < 1e-14);
}

TEST_CASE("a ten-node tetrahedron that bends alone is softer than a beam, never stiffer", "[core][tet10]") {
  // 1/2 E (curvature)^2 times the integral of z^2, V / 20 sum of z^2 of the corners: the twelve tetrahedra
  // take the curve by chords.
  const Matrix3Xd x = regular_element(Shape::tet10);
  const double bulk = 160e9, shear = 80e9, nu = (3 * bulk - 2 * shear) / (2 * (3 * bulk + shear));
  const double youngs = 9 * bulk * shear / (3 * bulk + shear);
  for (const double angle : {0.0, 0.7, 1.2, 1.9, 2.5}) {
    const Matrix3Xd turned = rotation_of(angle) * x;
    const LoneElement element(tet10_composite, undamped(ElasticLaw{{bulk, shear}}), turned);
    const Matrix3Xd r = turned.colwise() - turned.leftCols(4).rowwise().mean().eval();
    const double exact = 0.5 * youngs * element.volume() / 20.0 * r.row(2).head(4).squaredNorm();
    const double share = energy_of(element, bending(turned, nu)) / exact;
    CHECK(share > 0.4);
    CHECK(share < 0.8);
  }
}

TEST_CASE("a ten-node tetrahedron has one constraint when its material is incompressible", "[core][tet10]") {
  const Eigen::VectorXd soft = eigenvalues_of(regular_tet(160e9)),
                        stiff = eigenvalues_of(regular_tet(160e12));
  CHECK(stiff(29) > 100.0 * soft(29));
  CHECK(stiff(28) < 1.1 * soft(29));
}

TEST_CASE("dilatation that differs within an element meets hourglass stiffness alone", "[core][tet10]") {
  // v = (c . r) r - |r|^2 c / 2 has the strain (c . r) 1: three motions without deviator and mean dilatation.
  const Eigen::VectorXd ascending = eigenvalues_of(regular_tet(160e9));
  CHECK(ascending(6) > 5e8);
  CHECK(ascending(8) < 1.01 * ascending(6));
  CHECK(ascending(8) < 0.25 * ascending(9));
}

TEST_CASE("the bound of the stable step is within a sixth of the limit of regular elements",
          "[core][tet10]") {
  LoneElement element = regular_tet(160e9);
  const double limit = stable_limit(element);
  CHECK(element.stay().stable_step > limit / 1.17);
  CHECK(element.stay().stable_step < limit);
}

TEST_CASE("a ten-node tetrahedron with a crossed midside node has no volume", "[core][tet10]") {
  LoneElement element = regular_tet(160e9);
  Matrix3Xd there = element.coordinates;
  there.col(4) = there.col(0) + 1.2 * (there.col(1) - there.col(0));
  CHECK(element.move_to(there).min_volume <= 0.0);
}
