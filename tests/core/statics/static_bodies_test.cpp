// SPDX-License-Identifier: BSD-3-Clause
#include "core/statics/static_bodies.hpp"

#include "core/dynamics/rigid_motion.hpp"
#include "core/statics/full_tangent.hpp"
#include "core/statics/multigrid_tangent.hpp"
#include "core/statics/newton.hpp"
#include "core/statics/nodal_blocks.hpp"
#include "support/catch.hpp"
#include "support/static_cube.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// A force on the first node of the top that keeps its direction.
class DeadLoad final : public ForceTerm {
 public:
  ForceReport set_forces(const Motion& motion, Eigen::Matrix3Xd& forces) override {
    forces = Eigen::Matrix3Xd::Zero(3, motion.coordinates.cols());
    forces.col(node) = force;
    return {};
  }
  Eigen::Index node = 0;
  Eigen::Vector3d force = Eigen::Vector3d::Zero();
};

/// An elastic cube of edge 2 on held nodes, whose nodes at z = 2 are those of a rigid body.
struct CappedCube {
  Mesh mesh = MeshBuilder().add_hexes({.cells = {2, 2, 2}, .size = {2, 2, 2}}).build();
  Model model;
  State state;
  DeadLoad load;
  std::optional<InternalForce> internal;
  std::optional<StaticProblem> problem;

  explicit CappedCube(bool drives = false) {
    model.mesh = &mesh;
    ElementProperties properties{ElasticLaw{{160e9, 80e9}}, 7800.0};
    properties.linear_bulk_viscosity = properties.quadratic_bulk_viscosity = 0.0;
    model.blocks.push_back(make_solid_block(mesh, 0, hex8_selective_deviatoric, properties));
    model.mass = lumped_mass(mesh, model.blocks);
    PrescribedMotion fixed;
    fixed.direction = Components{{true, true, true}};
    for (std::uint32_t i = 0; i < mesh.n_nodes(); ++i) {
      if (mesh.coordinates()(2, i) == 0.0) fixed.nodes.push_back({i});
    }
    model.kinematic_constraints = KinematicConstraints(mesh, {fixed});
    add_cap();
    if (drives) drive();
    state = make_state(mesh.coordinates(), model.blocks, 0.0);
    start_rigid_bodies(model, state);
    internal.emplace(model, state);
    problem.emplace(model, ForceTerms{*internal, load}, nullptr, ResidualReference::internal, state);
    problem->begin_step(1.0);
  }

  void add_cap() {
    RigidBody cap;
    cap.name = "cap";
    cap.mass = 1.0;
    cap.inertia.setIdentity();
    cap.centre = {0.8, 1.1, 2.5};
    model.rigid.nodes.body_of.assign(mesh.n_nodes(), RigidNodes::free);
    for (std::uint32_t i = 0; i < mesh.n_nodes(); ++i) {
      if (mesh.coordinates()(2, i) != 2.0) continue;
      cap.nodes.push_back({i});
      model.rigid.nodes.body_of[i] = 0;
    }
    cap.arms.resize(3, static_cast<Eigen::Index>(cap.nodes.size()));
    for (std::size_t k = 0; k < cap.nodes.size(); ++k)
      cap.arms.col(static_cast<Eigen::Index>(k)) = mesh.coordinates().col(cap.nodes[k].value) - cap.centre;
    load.node = cap.nodes.front().value;
    model.rigid.bodies.push_back(cap);
    MeshParts centres;
    centres.coordinates = cap.centre;
    model.rigid.nodes.references = std::make_shared<const Mesh>(std::move(centres));
  }

  /// Fixes the cap but for x, along which it goes with a velocity of 1e-4.
  void drive() {
    const Mesh& centres = *model.rigid.nodes.references;
    PrescribedMotion fixed, moved;
    fixed.direction = Components{{false, true, true}};
    moved.direction = Components{{true, false, false}};
    moved.type = MotionType::velocity;
    moved.value = ConditionFunction{1e-4};
    fixed.nodes = moved.nodes = {NodeIndex{0}};
    model.rigid.kinematic_constraints = KinematicConstraints(centres, {fixed, moved});
    fixed.direction = Components{{true, true, true}};
    model.rigid.rotation_constraints = KinematicConstraints(centres, {fixed});
  }

  Eigen::Index centre() const { return 3 * Eigen::Index{problem->bodies().centre_node(0)}; }
  Eigen::VectorXd still() const { return Eigen::VectorXd::Zero(problem->size()); }
  /// The cap turned by an angle and moved, all other nodes at rest.
  Eigen::VectorXd turned(double angle) const {
    Eigen::VectorXd increment = still();
    increment.segment<6>(centre()) << 0.01, -0.02, 0.03, 0.5 * angle, -0.3 * angle, 0.8 * angle;
    return increment;
  }
  NodeGraph graph() const { return {mesh.n_nodes(), mesh, model.blocks, 1}; }
};

}  // namespace

TEST_CASE("forces on a rigid body do the work of those on its nodes", "[core][statics]") {
  CappedCube cube;
  cube.load.force = {3e9, -2e9, 5e9};
  for (const double angle : {0.0, 1e-4, 0.2}) {
    const Eigen::VectorXd at = cube.turned(angle);
    Eigen::VectorXd residual, forces, moved;
    REQUIRE(cube.problem->evaluate_nodes(at, forces));
    for (Eigen::Index i = 0; i < 6; ++i) {
      constexpr double h = 1e-6;
      Eigen::VectorXd change = cube.still();
      change(cube.centre() + i) = h;
      REQUIRE(cube.problem->evaluate(at - change, moved));
      const Eigen::Matrix3Xd before = cube.state.coordinates;
      REQUIRE(cube.problem->evaluate(at + change, moved));
      const Eigen::Matrix3Xd way = (cube.state.coordinates - before) / (2.0 * h);
      REQUIRE(cube.problem->evaluate(at, residual));
      const double work = forces.head(way.size()).dot(way.reshaped());
      CHECK(residual(cube.centre() + i) == Approx(work).epsilon(1e-6).margin(1e-6 * forces.norm()));
    }
    for (const NodeIndex node : cube.model.rigid.bodies[0].nodes)
      CHECK(residual.segment<3>(3 * Eigen::Index{node.value}).isZero(0.0));
  }
}

TEST_CASE("a factor with a rigid body undoes its stiffness", "[core][statics]") {
  CappedCube cube;
  cube.load.force = {3e9, -2e9, 5e9};
  const NodeGraph graph = cube.graph();
  const FullTangentSettings settings;
  FullTangent tangent(*cube.problem, graph, settings);
  tangent.set_free(std::vector<double>(graph.n_nodes(), 0.0));
  tangent.renew(cube.still());
  REQUIRE(tangent.exists());
  Eigen::VectorXd increment = 1e-6 * cube.turned(1.0), residual, base, found;
  increment(3 * 13) = 1e-6;  // of the node in the middle
  REQUIRE(cube.problem->evaluate(cube.still(), base));
  REQUIRE(cube.problem->evaluate(increment, residual));
  tangent.apply(base - residual, found);
  CHECK((found - increment).norm() < 1e-4 * increment.norm());
}

TEST_CASE("what forces do as a rigid body turns is in its stiffness", "[core][statics]") {
  CappedCube cube;
  cube.load.force = {3e9, -2e9, 5e9};
  Eigen::VectorXd base, there, back;
  REQUIRE(cube.problem->evaluate(cube.still(), base));
  const Eigen::Matrix3d stiffness = cube.problem->bodies().turning_stiffness(0);
  for (Eigen::Index i = 0; i < 3; ++i) {
    constexpr double h = 1e-5;
    Eigen::VectorXd change = cube.still();
    change(cube.centre() + 3 + i) = h;
    REQUIRE(cube.problem->evaluate(change, there));
    REQUIRE(cube.problem->evaluate(-change, back));
    const Eigen::Vector3d column = (back - there).segment<3>(cube.centre() + 3) / (2.0 * h);
    // Elements resist, too.
    cube.load.force.setZero();
    REQUIRE(cube.problem->evaluate(change, there));
    REQUIRE(cube.problem->evaluate(-change, back));
    const Eigen::Vector3d of_elements = (back - there).segment<3>(cube.centre() + 3) / (2.0 * h);
    cube.load.force = {3e9, -2e9, 5e9};
    CHECK((column - of_elements - stiffness.col(i)).norm() < 1e-4 * stiffness.norm());
  }
}

TEST_CASE("trials of rigid bodies leave no trace", "[core][statics]") {
  CappedCube cube;
  Eigen::VectorXd residual;
  REQUIRE(cube.problem->evaluate(cube.turned(0.3), residual));
  CHECK(cube.state.rigid[0].angle.norm() > 0.05);
  cube.problem->restore();
  CHECK(cube.state.coordinates == cube.mesh.coordinates());
  CHECK(cube.state.rigid[0].position == cube.model.rigid.bodies[0].centre);
  CHECK(cube.state.rigid[0].angle.isZero(0.0));
}

TEST_CASE("conditions move rigid bodies, which then take part in multigrid, too", "[core][statics]") {
  CappedCube cube(true);
  const Eigen::VectorXd prescribed = cube.problem->prescribed();
  CHECK(prescribed(cube.centre()) == Approx(1e-4));
  CHECK(prescribed.norm() == Approx(1e-4));
  CHECK_FALSE(cube.problem->bodies().are_free());
  CHECK(CappedCube().problem->bodies().are_free());
  Eigen::VectorXd residual, by_factor, by_multigrid;
  REQUIRE(cube.problem->evaluate(prescribed, residual));
  const NodeGraph graph = cube.graph();
  const FullTangentSettings settings;
  FullTangent factor(*cube.problem, graph, settings);
  MultigridTangent multigrid(*cube.problem, graph, settings);
  factor.renew(cube.still());
  multigrid.renew(cube.still());
  factor.apply(residual, by_factor);
  LinearisedEquilibrium linearised(*cube.problem, multigrid, [](const Eigen::VectorXd&, bool) {});
  CgReport report;
  linearised.solve(prescribed, residual, residual, report, by_multigrid);
  CHECK(by_factor.norm() > 1e-6);
  CHECK((by_factor - by_multigrid).norm() < 2e-3 * by_factor.norm());
  CHECK(by_factor.segment<6>(cube.centre()).isZero(0.0));
}

TEST_CASE("nodal blocks have those of rigid bodies", "[core][statics]") {
  CappedCube cube;
  const NodeGraph graph = cube.graph();
  NodalBlocks blocks(*cube.problem, graph);
  CHECK(blocks.renew(cube.still()) == 1 + 3 * 8);
  Eigen::VectorXd residual, z;
  REQUIRE(cube.problem->evaluate(1e-6 * cube.turned(1.0), residual));
  blocks.apply(residual, z);
  CHECK(z.dot(residual) > 0.0);
  CHECK(z.segment<6>(cube.centre()).norm() > 1e-8);
  for (const NodeIndex node : cube.model.rigid.bodies[0].nodes)
    CHECK(z.segment<3>(3 * Eigen::Index{node.value}).isZero(0.0));
}
