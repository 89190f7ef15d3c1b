// SPDX-License-Identifier: BSD-3-Clause
#include "core/statics/static_unknowns.hpp"

#include "support/catch.hpp"
#include "support/mesh_builder.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// A hexahedron's eight nodes with mass 4 and inertia 1, the last without inertia, and two of a rigid body.
struct TurningNodes {
  TurningNodes() {
    model.mesh = &mesh;
    model.mass = Eigen::RowVectorXd::Constant(8, 4.0);
    model.inertia = Eigen::RowVectorXd::Constant(8, 1.0);
    model.inertia(7) = minimum_nodal_mass;
  }

  Mesh mesh = MeshBuilder().add_hexes({}).build();
  Model model;
};

}  // namespace

TEST_CASE("vectors hold displacements first, then rotations", "[core][statics]") {
  const TurningNodes nodes;
  const StaticUnknowns unknowns(nodes.model, 10, true);
  CHECK(unknowns.n() == 30);
  CHECK(unknowns.n_mesh() == 24);
  CHECK(unknowns.size() == 60);
  CHECK(unknowns.turn());
  const Eigen::Matrix3Xd places = Eigen::Matrix3Xd::Random(3, 8), turns = Eigen::Matrix3Xd::Random(3, 8);
  const Eigen::VectorXd vector = unknowns.vector_of(places, turns);
  CHECK(vector.segment<3>(21) == places.col(7));
  CHECK(vector.segment<6>(24).isZero(0.0));
  CHECK(vector.segment<3>(51) == turns.col(7));
  CHECK(vector.tail<6>().isZero(0.0));
  CHECK(unknowns.places_in(vector) == places);
  CHECK(unknowns.turns_in(vector) == turns);
  CHECK(unknowns.vector_of(Eigen::Matrix3Xd(3, 0), turns).head<30>().isZero(0.0));
  CHECK(StaticUnknowns(nodes.model, 10, false).vector_of(places, turns).size() == 30);
}

TEST_CASE("moments count over the radius of gyration, those without inertia not at all", "[core][statics]") {
  const TurningNodes nodes;
  const StaticUnknowns unknowns(nodes.model, 10, true);
  Eigen::VectorXd residual = Eigen::VectorXd::Zero(60);
  residual(1) = 3.0;
  residual(30) = 2.0;   // over a half
  residual(52) = 99.0;  // of the last node
  CHECK(unknowns.norm(residual) == 5.0);
  CHECK(unknowns.scales_of(0) == (Eigen::VectorXd(6) << 1, 1, 1, 2, 2, 2).finished());
  CHECK(unknowns.scales_of(7).tail<3>().isZero(0.0));
  CHECK(StaticUnknowns(nodes.model, 8, false).scales_of(0) == Eigen::VectorXd::Ones(3));
}

TEST_CASE("the largest force and the longest way are those of nodes", "[core][statics]") {
  const TurningNodes nodes;
  const StaticUnknowns unknowns(nodes.model, 10, true);
  Eigen::VectorXd vector = Eigen::VectorXd::Zero(60);
  vector.segment<3>(6) << 2, 2, 2;
  vector(15) = -3.0;
  vector(40) = 9.0;  // a rotation
  CHECK(unknowns.largest_at(vector) == NodeIndex{2});
  CHECK(unknowns.longest_in(vector) == Approx(std::sqrt(12.0)));
}
