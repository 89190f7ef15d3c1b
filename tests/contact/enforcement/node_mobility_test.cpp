// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/node_mobility.hpp"

#include <numbers>

#include "support/catch.hpp"
#include "support/lofted_meshes.hpp"
#include "support/two_cubes.hpp"

using namespace contactsim;
using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

constexpr double step_size = 0.1;

/// Two cubes before a step whose nodes of mass 0.5 change their velocity by 0.2 per force.
struct MobileCubes {
  test::TwoCubes cubes;
  ModelFreeDirections free;
  NodeMobility mobility;
  State state;
  std::vector<CarrierTerm> terms;

  void begin() {
    free.update(cubes.model, 0.0);
    state = cubes.state(step_size);
    begin_again();
  }
  void begin_again() { mobility.begin(cubes.model, free, cubes.parts.kinematics, state); }
  const CarrierTerm& add(std::uint32_t node, double weight, const Vector3d& beside = Vector3d::Zero()) {
    mobility.add_terms({node}, weight, beside, terms);
    return terms.back();
  }
};

}  // namespace

TEST_CASE("free nodes are plain carriers in the order in which points name them",
          "[contact][node_mobility]") {
  MobileCubes cubes;
  cubes.begin();
  NodeMobility& mobility = cubes.mobility;
  CHECK(mobility.plain_carrier({8}) == std::optional<std::uint32_t>(0));
  CHECK(mobility.plain_carrier({4}) == std::optional<std::uint32_t>(1));
  CHECK(mobility.plain_carrier({8}) == std::optional<std::uint32_t>(0));
  CHECK(mobility.n_carriers() == 2);
  CHECK(mobility.mesh_nodes() == std::vector<std::uint32_t>{8, 4});
  CHECK(mobility.translation_bound(0) == Approx(0.2));
  CHECK(mobility.turn_bound(0) == 0.0);
  CHECK(mobility.turn_root(0, Vector3d::UnitX()) == 0.0);
  CHECK_FALSE(mobility.has_bodies());
  CHECK(mobility.mobility(1).translation.isApprox(0.2 * Matrix3d::Identity()));
  cubes.begin_again();
  CHECK(mobility.n_carriers() == 0);
  CHECK(mobility.plain_carrier({4}) == std::optional<std::uint32_t>(0));
}

TEST_CASE("a force acts for the mean of the steps before and behind it", "[contact][node_mobility]") {
  MobileCubes cubes;
  cubes.begin();
  cubes.state.dt = 0.3;
  cubes.begin_again();
  cubes.mobility.plain_carrier({8});
  CHECK(cubes.mobility.translation_bound(0) == Approx(0.2 / 0.5));
  cubes.state.dt = 0.0;  // the first step
  cubes.begin_again();
  cubes.mobility.plain_carrier({8});
  CHECK(cubes.mobility.translation_bound(0) == Approx(0.05 / 0.5));
}

TEST_CASE("forces of before the passes stay in all of them, others are those of one pass",
          "[contact][node_mobility]") {
  MobileCubes cubes;
  cubes.begin();
  NodeMobility& mobility = cubes.mobility;
  mobility.plain_carrier({8});
  mobility.plain_carrier({4});
  mobility.push_plain(0, {1, 2, 3, 0});
  mobility.begin_passes();
  CHECK(mobility.change(0).isApprox(0.2 * NodeVector(1, 2, 3, 0)));
  CHECK(mobility.change(1).isZero(0.0));
  mobility.push_plain(1, {0, 0, 5, 0});
  CHECK(mobility.change(1).isZero(0.0));  // not before the pass ends
  mobility.end_pass();
  CHECK(mobility.change(0).isApprox(0.2 * NodeVector(1, 2, 3, 0)));
  CHECK(mobility.change(1).isApprox(NodeVector(0, 0, 1, 0)));
  mobility.end_pass();
  CHECK(mobility.change(0).isApprox(0.2 * NodeVector(1, 2, 3, 0)));
  CHECK(mobility.change(1).isZero(0.0));
}

TEST_CASE("held nodes answer along what is free", "[contact][node_mobility]") {
  MobileCubes cubes;
  const bool is_held_in_all = GENERATE(false, true);
  cubes.cubes.hold({{8}}, Components{{is_held_in_all, is_held_in_all, true}});
  cubes.begin();
  NodeMobility& mobility = cubes.mobility;
  CHECK(mobility.plain_carrier({8}).has_value() == is_held_in_all);
  const std::uint32_t carrier = cubes.add(8, 1.0).carrier;
  mobility.push(carrier, {1, 2, 3}, {4, 5, 6});
  mobility.begin_passes();
  const Vector3d expected = is_held_in_all ? Vector3d(0, 0, 0) : Vector3d(0.2, 0.4, 0.0);
  CHECK(mobility.change(carrier).head<3>().isApprox(expected));
  CHECK(mobility.turning(carrier).isZero(0.0));
  CHECK(mobility.translation_bound(carrier) == Approx(is_held_in_all ? 0.0 : 0.2));
}

TEST_CASE("nodes are held or free again only once that is said", "[contact][node_mobility]") {
  MobileCubes cubes;
  cubes.begin();
  CHECK(cubes.mobility.plain_carrier({8}));
  cubes.cubes.hold({{8}}, Components{{false, false, true}});
  cubes.mobility.forget();
  cubes.begin();
  CHECK_FALSE(cubes.mobility.plain_carrier({8}));
}

TEST_CASE("the nodes of a rigid body are one term on each side of a point", "[contact][node_mobility]") {
  MobileCubes cubes;
  cubes.cubes.make_rigid();
  cubes.begin();
  CHECK(cubes.mobility.has_bodies());
  CHECK_FALSE(cubes.mobility.plain_carrier({8}));
  cubes.add(8, 0.25);
  cubes.add(9, 0.75, {0, 0, -1});
  REQUIRE(cubes.terms.size() == 1);
  const CarrierTerm body = cubes.terms[0];
  CHECK(body.weight == 1.0);
  // Nodes 8 and 9 are at (-0.5, -0.5, -0.5) and (0.5, -0.5, -0.5) from the centre.
  CHECK(body.arm.isApprox(Vector3d(0.25, -0.5, -1.25)));
  CHECK(cubes.mobility.is_body(body.carrier));
  cubes.add(11, -0.5);
  REQUIRE(cubes.terms.size() == 2);
  CHECK(cubes.terms[1].carrier == body.carrier);
  CHECK(cubes.terms[1].weight == -0.5);
  CHECK(cubes.terms[1].arm.isApprox(Vector3d(0.5, 0.5, -0.5)));
  cubes.add(4, 1.0, {0, 0, 2});
  CHECK_FALSE(cubes.mobility.is_body(cubes.terms[2].carrier));
  CHECK(cubes.terms[2].arm == Vector3d(0, 0, 2));
  CHECK(cubes.mobility.mesh_nodes() == std::vector<std::uint32_t>{4});  // bodies are none
}

TEST_CASE("a rigid body answers by its mass and the moments of inertia as it is turned",
          "[contact][node_mobility]") {
  MobileCubes cubes;
  cubes.cubes.make_rigid();
  cubes.begin();
  const bool is_turned = GENERATE(false, true);
  if (is_turned) {
    cubes.state.rigid[0].orientation = turn_by(0.5 * std::numbers::pi * Vector3d::UnitX());
    cubes.begin_again();
  }
  NodeMobility& mobility = cubes.mobility;
  const std::uint32_t body = cubes.add(8, 1.0).carrier;
  mobility.push(body, {8, 0, -8}, {4, 4, 4});
  mobility.begin_passes();
  CHECK(mobility.change(body).head<3>().isApprox(Vector3d(0.1, 0, -0.1)));
  // The moment of inertia 2 is about the body's own z, which a quarter turn about x brings to -y.
  const Vector3d turning = is_turned ? Vector3d(0.1, 0.2, 0.1) : Vector3d(0.1, 0.1, 0.2);
  CHECK(mobility.turning(body).isApprox(turning));
  CHECK(mobility.turn_bound(body) == Approx(std::sqrt(0.1 * 0.5)));
  CHECK(mobility.turn_root(body, {0, 3, 0}) == Approx(3.0 * std::sqrt(0.1 * (is_turned ? 0.5 : 0.25))));
  CHECK(mobility.mobility(body).rotation.isApprox(Matrix3d((turning / 4.0).asDiagonal())));
}

TEST_CASE("a rigid body turns about the axes that conditions leave free", "[contact][node_mobility]") {
  MobileCubes cubes;
  cubes.cubes.make_rigid();
  PrescribedMotion held;
  held.nodes = {{0}};  // the first body
  held.direction = Components{{false, false, true}};
  cubes.cubes.model.rigid.rotation_constraints = KinematicConstraints(cubes.cubes.parts.mesh, {held});
  held.direction = Components{{true, false, false}};
  cubes.cubes.model.rigid.kinematic_constraints = KinematicConstraints(cubes.cubes.parts.mesh, {held});
  cubes.begin();
  const std::uint32_t body = cubes.add(8, 1.0).carrier;
  cubes.mobility.push(body, {8, 8, 8}, {4, 4, 4});
  cubes.mobility.begin_passes();
  CHECK(cubes.mobility.change(body).head<3>().isApprox(Vector3d(0, 0.1, 0.1)));
  CHECK((cubes.mobility.turning(body) - Vector3d(0.1, 0.1, 0)).norm() < 1e-15);
}

TEST_CASE("nodes with rotary inertia turn by it, but about what is held", "[contact][node_mobility]") {
  MobileCubes cubes;
  cubes.cubes.model.inertia = Eigen::RowVectorXd::Zero(16);
  cubes.cubes.model.inertia(8) = 0.02;
  const bool is_held = GENERATE(false, true);
  PrescribedMotion held;
  held.nodes = {{8}};
  held.direction = Components{{true, false, false}};
  if (is_held) cubes.cubes.model.rotation_constraints = KinematicConstraints(cubes.cubes.parts.mesh, {held});
  cubes.begin();
  CHECK_FALSE(cubes.mobility.plain_carrier({8}));
  CHECK(cubes.mobility.plain_carrier({9}));
  const CarrierTerm term = cubes.add(8, -1.0, {0, 0, 0.5});
  CHECK(term.weight == -1.0);
  CHECK(term.arm == Vector3d(0, 0, 0.5));
  cubes.mobility.push(term.carrier, {1, 0, 0}, {1, 2, 3});
  cubes.mobility.begin_passes();
  CHECK(cubes.mobility.change(term.carrier).head<3>().isApprox(Vector3d(0.2, 0, 0)));
  CHECK(cubes.mobility.turning(term.carrier).isApprox(5.0 * Vector3d(is_held ? 0 : 1, 2, 3)));
  CHECK(cubes.mobility.turn_bound(term.carrier) == Approx(std::sqrt(5.0)));
}

TEST_CASE("a push on a point of a loft gives the nodes around its momentum and moment of momentum",
          "[contact][node_mobility]") {
  test::MeshBuilder b;
  test::add_plate(b, {.id = 1, .cells = {3, 2}, .u = {3, 0, 0.9}, .v = {0, 2, 0.1}}, 0.2);
  test::add_plate(b, {.id = 2, .cells = {2, 2}, .origin = {3, 0, 0.9}, .u = {2, 0, -1.4}, .v = {0, 2, 0.1}},
                  0.2);
  test::ContactParts parts(b, test::general_contact());
  Model model;
  model.mesh = &parts.mesh;
  model.mass = Eigen::RowVectorXd::Constant(parts.x.cols(), 1.5);
  const ContactMesh& contact_mesh = parts.contact_mesh;
  const LoftSpins spins(contact_mesh.loft, static_cast<std::size_t>(parts.x.cols()), RigidNodes{});
  parts.kinematics.turn_by(spins);
  parts.move();
  State state = make_state(parts.x, {}, 0.0);
  state.dt = state.next_dt = step_size;
  const auto n_mesh_points = static_cast<std::uint32_t>(contact_mesh.n_mesh_points());
  const Vector3d force(1, -2, 3);
  REQUIRE(contact_mesh.n_nodes() > n_mesh_points);
  for (std::uint32_t point = n_mesh_points; point < contact_mesh.n_nodes(); ++point) {
    NodeMobility mobility;
    mobility.begin(model, {}, parts.kinematics, state);
    std::vector<CarrierTerm> terms;
    mobility.add_terms({point}, 1.0, Vector3d::Zero(), terms);
    REQUIRE(terms.size() == 1);
    const CarrierTerm term = terms[0];
    mobility.push(term.carrier, force, term.arm.cross(force));
    mobility.begin_passes();
    Vector3d momentum = Vector3d::Zero(), moment = Vector3d::Zero();
    for (std::uint32_t i = 0; i < mobility.n_carriers(); ++i) {
      const Vector3d own = 1.5 * mobility.change(i).head<3>();
      momentum += own;
      moment += Vector3d(parts.x.col(mobility.mesh_nodes()[i])).cross(own);
    }
    CHECK((momentum - step_size * force).norm() < 1e-12);
    const Vector3d place = parts.kinematics.x({point});
    CHECK((moment - step_size * place.cross(force)).norm() < 1e-12);
    // The point itself goes where it is pushed.
    const Vector3d moved =
        mobility.change(term.carrier).head<3>() + mobility.turning(term.carrier).cross(term.arm);
    CHECK(moved.dot(force) > 0.0);
  }
}

TEST_CASE("areas that turn a node of a loft lean on the nodes around", "[contact][node_mobility]") {
  test::MeshBuilder b;
  test::add_plate(b, {.id = 1, .cells = {2, 2}, .u = {2, 0, 0}, .v = {0, 2, 0}}, 0.2);
  test::ContactParts parts(b, test::general_contact());
  Model model;
  model.mesh = &parts.mesh;
  model.mass = Eigen::RowVectorXd::Constant(9, 1.5);
  const ContactMesh& contact_mesh = parts.contact_mesh;
  const LoftSpins spins(contact_mesh.loft, 9, RigidNodes{});
  parts.kinematics.turn_by(spins);
  parts.move();
  State state = make_state(parts.x, {}, 0.0);
  state.dt = state.next_dt = step_size;
  NodeMobility mobility;
  mobility.begin(model, {}, parts.kinematics, state);
  std::vector<CarrierTerm> terms;
  auto point = static_cast<std::uint32_t>(contact_mesh.n_mesh_points());
  while (contact_mesh.mesh_nodes[{point}] != NodeIndex{4}) ++point;  // above or below the middle node
  mobility.add_terms({point}, 1.0, Vector3d::Zero(), terms);
  REQUIRE(mobility.n_carriers() == 9);
  const std::uint32_t carrier = terms[0].carrier;
  CHECK(mobility.turn_bound(carrier) == 1.0);
  CHECK(mobility.turn_root(carrier, {3, 0, 4}) == 5.0);
  LeaningAreas areas(9, {0.0, 0.0});
  areas[carrier] = {2.0, 0.3};
  mobility.spread_areas(areas);
  const std::size_t spin = *parts.kinematics.spins().find({4});
  const auto around = parts.kinematics.spins().neighbours(spin);
  double turns = 0.0;
  for (std::size_t k = 0; k < around.size(); ++k) {
    const double bound = parts.kinematics.spins().bound(spin, k);
    std::uint32_t other = 0;
    while (mobility.mesh_nodes()[other] != around[k].value) ++other;
    CHECK(areas[other][0] == Approx(0.3 * bound));
    turns += bound * (step_size / 1.5) * areas[other][0];
  }
  const double own = parts.kinematics.spins().own_bound(spin);
  CHECK(areas[carrier][0] == Approx(2.0 + 0.3 * own));
  CHECK(areas[carrier][1] == Approx(turns + own * (step_size / 1.5) * areas[carrier][0]));
}
