// SPDX-License-Identifier: BSD-3-Clause
// Contact in load steps: trials leave no trace, springs are derivatives of forces, multipliers let nothing
// through.
#include <cmath>

#include "contact/enforcement/contact_force.hpp"
#include "support/catch.hpp"
#include "support/contact_bodies.hpp"
#include "support/random_faces.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Eigen::Matrix3Xd;

namespace contact_force_trial_test {

namespace {

/// Two plates that have just touched, of a quasi-static procedure, and trials from where they are.
class StaticPlates {
 public:
  explicit StaticPlates(const std::string& lines) : bodies(plates(), static_region(lines)) {
    bodies.ask();
    start_ = bodies.x;
    Random random(5);
    noise_.resize(3, start_.cols());
    for (Eigen::Index i = 0; i < start_.cols(); ++i) noise_.col(i) = random_vector(random, 1.0);
  }

  void begin() {
    start_ = bodies.x;
    bodies.time += step;
    bodies.dt = step;
    bodies.v.setZero();
    bodies.contact.begin_trials(bodies.motion());
  }
  /// The forces after the upper plate has moved and all nodes a bit at random.
  Matrix3Xd try_motion(const Eigen::Vector3d& upper, double noise) {
    move(upper, noise);
    Matrix3Xd forces = Matrix3Xd::Zero(3, bodies.x.cols());
    bodies.contact.try_forces(bodies.motion(), forces, nullptr);
    return forces;
  }
  Matrix3Xd accept(const Eigen::Vector3d& upper, double noise) {
    move(upper, noise);
    bodies.contact.accept_trial(bodies.motion(), bodies.forces);
    return bodies.forces;
  }
  void move(const Eigen::Vector3d& upper, double noise) {
    bodies.x = start_ + noise * noise_;
    bodies.shift(1, upper);
    bodies.v = (bodies.x - start_) / step;
  }

  static constexpr double step = 0.5;
  ContactBodies bodies;

 private:
  static MeshBuilder plates() {
    return MeshBuilder()
        .add_hexes({.id = 1, .cells = {3, 3, 1}, .size = {3, 3, 1}})
        .add_hexes({.id = 2,
                    .cells = {2, 2, 1},
                    .origin = {0.4, 0.3, 1.0},
                    .size = {2, 2, 1},
                    .share_nodes = false});
  }
  static Region static_region(const std::string& lines) {
    Region region;
    region.contact = parse_contact("begin constant friction model rough\nfriction coefficient = 0.4\nend\n" +
                                   general_contact(lines));
    region.contact->enforcement.is_static = true;
    region.contact->enforcement.enforcement = Enforcement::augmented_lagrange;
    return region;
  }

  Matrix3Xd start_, noise_;
};

const std::string node_face = "constraint formulation = node_face\n", rough = "friction model = rough\n";

}  // namespace

TEST_CASE("trials of contact leave no trace", "[contact][contact_force][statics]") {
  const std::string form = GENERATE(std::string(), node_face) + GENERATE(std::string(), rough);
  StaticPlates quiet(form), tried(form);
  const Eigen::Vector3d down(0.02, 0.01, -0.03), further(0.05, 0.0, -0.06);
  for (StaticPlates* plates : {&quiet, &tried}) plates->begin();
  const Matrix3Xd first = tried.try_motion(down, 0.001);
  tried.try_motion({0.7, 0.9, 0.4}, 0.01);  // far enough for other candidates
  tried.try_motion({0, 0, -0.4}, 0.05);
  CHECK(tried.try_motion(down, 0.001) == first);
  CHECK(first.norm() > 0.0);
  tried.bodies.contact.give_up_trials();
  tried.move({0, 0, 0}, 0.0);
  tried.bodies.time -= StaticPlates::step;
  tried.begin();
  CHECK(tried.accept(down, 0.001) == quiet.accept(down, 0.001));
  CHECK(tried.bodies.forces == first);
  for (StaticPlates* plates : {&quiet, &tried}) plates->begin();
  tried.try_motion({0.9, 0, 0}, 0.0);
  CHECK(tried.accept(further, 0.002) == quiet.accept(further, 0.002));
}

TEST_CASE("springs of contact are the derivatives of its forces", "[contact][contact_force][statics]") {
  const std::string form = GENERATE(std::string(), node_face);
  StaticPlates plates(form);
  plates.begin();
  const Eigen::Vector3d down(0, 0, -0.03);
  plates.try_motion(down, 0.0);
  const Eigen::Index n = plates.bodies.x.cols();
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(3 * n, 3 * n);
  plates.bodies.contact.visit_springs([&](const ContactSpring& spring) {
    spring.visit_blocks([&](const SpringEnd& a, const SpringEnd& b, const Eigen::Matrix3d& block) {
      stiffness.block<3, 3>(3 * a.node, 3 * b.node) += block;
    });
  });
  CHECK((stiffness - stiffness.transpose()).norm() < 1e-12 * stiffness.norm());
  // Along the normal, which these plates keep.
  constexpr double size = 1e-6;
  const Matrix3Xd base = plates.try_motion(down, 0.0);
  double error = 0.0, largest = 0.0;
  for (Eigen::Index node = 0; node < n; ++node) {
    plates.move(down, 0.0);
    plates.bodies.x(2, node) += size;
    Matrix3Xd moved = Matrix3Xd::Zero(3, n);
    plates.bodies.contact.try_forces(plates.bodies.motion(), moved, nullptr);
    const Matrix3Xd slope = (base - moved) / size;
    for (Eigen::Index other = 0; other < n; ++other) {
      error = std::max(error, std::abs(slope(2, other) - stiffness(3 * other + 2, 3 * node + 2)));
      largest = std::max(largest, std::abs(slope(2, other)));
    }
  }
  CHECK(largest > 0.0);
  CHECK(error < 0.02 * largest);
}

TEST_CASE("what sticks and what slides resist by the derivatives of their forces",
          "[contact][contact_force][statics]") {
  const std::string form = GENERATE(std::string(), node_face);
  const bool slides = GENERATE(false, true);
  CAPTURE(form, slides);
  StaticPlates plates(form + rough);
  plates.begin();
  const Eigen::Vector3d motion(slides ? 0.25 : 0.002, slides ? 0.1 : 0.001, -0.02);
  const Matrix3Xd base = plates.try_motion(motion, 0.0);
  const Eigen::Index n = base.cols();
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(3 * n, 3 * n);
  double unsymmetric = 0.0;
  plates.bodies.contact.visit_springs([&](const ContactSpring& spring) {
    unsymmetric += spring.unsymmetric.norm();
    for (Eigen::Index column = 0; column < 3 * n; ++column) {
      const Eigen::VectorXd unit = Eigen::VectorXd::Unit(3 * n, column);
      spring.multiply([&](const SpringEnd& end) { return unit.segment<3>(3 * end.node); },
                      [&](const SpringEnd& end, const Eigen::Vector3d& felt) {
                        stiffness.col(column).segment<3>(3 * end.node) += felt;
                      });
    }
  });
  CHECK((unsymmetric > 0.0) == slides);
  constexpr double size = 1e-7;
  double error = 0.0;
  for (Eigen::Index column = 0; column < 3 * n; ++column) {
    plates.move(motion, 0.0);
    plates.bodies.x.reshaped()(column) += size;
    plates.bodies.v.reshaped()(column) += size / StaticPlates::step;
    Matrix3Xd moved = Matrix3Xd::Zero(3, n);
    plates.bodies.contact.try_forces(plates.bodies.motion(), moved, nullptr);
    const Eigen::VectorXd slope = (base - moved).reshaped() / size;
    error = std::max(error, (slope - stiffness.col(column)).norm());
  }
  CHECK(error < 0.05 * stiffness.colwise().norm().maxCoeff());
}

TEST_CASE("nodes slide at the limits that are held, until these follow what presses",
          "[contact][contact_force][statics]") {
  StaticPlates plates(rough), smooth("");
  const auto dragged = [&](double down) {
    const Matrix3Xd forces = plates.try_motion({0.25, 0.1, down}, 0.0);
    double sum = 0.0;
    for (Eigen::Index i = 0; i < forces.cols(); ++i) sum += std::abs(forces(0, i));
    return sum;
  };
  for (StaticPlates* some : {&plates, &smooth}) some->begin();
  const double shallow = dragged(-0.02);
  CHECK(plates.bodies.contact.hold_slip_limits(true));
  CHECK(dragged(-0.03) == Approx(shallow).epsilon(0.01));
  CHECK_FALSE(plates.bodies.contact.hold_slip_limits(false));
  CHECK(dragged(-0.03) == Approx(1.5 * shallow).epsilon(0.01));
  CHECK_FALSE(smooth.bodies.contact.hold_slip_limits(true));
}

TEST_CASE("springs of faces that are bent and open in places are the derivatives of their forces",
          "[contact][contact_force][statics]") {
  StaticPlates plates("");
  plates.begin();
  const Eigen::Vector3d down(0, 0, -0.01);
  constexpr double noise = 0.02, size = 1e-7;
  const Matrix3Xd base = plates.try_motion(down, noise);
  const Eigen::Index n = base.cols();
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(3 * n, 3 * n);
  plates.bodies.contact.visit_springs([&](const ContactSpring& spring) {
    spring.visit_blocks([&](const SpringEnd& a, const SpringEnd& b, const Eigen::Matrix3d& block) {
      stiffness.block<3, 3>(3 * a.node, 3 * b.node) += block;
    });
  });
  double error = 0.0, largest = 0.0;
  std::size_t n_open = 0;
  for (Eigen::Index node = 0; node < n; ++node) {
    if (base(2, node) == 0.0) ++n_open;
    plates.move(down, noise);
    plates.bodies.x(2, node) += size;
    Matrix3Xd moved = Matrix3Xd::Zero(3, n);
    plates.bodies.contact.try_forces(plates.bodies.motion(), moved, nullptr);
    const Eigen::VectorXd slope = (base - moved).row(2).transpose() / size;
    for (Eigen::Index other = 0; other < n; ++other)
      error = std::max(error, std::abs(slope(other) - stiffness(3 * other + 2, 3 * node + 2)));
    largest = std::max(largest, slope.cwiseAbs().maxCoeff());
  }
  CHECK(n_open > 0);
  CHECK(largest > 0.0);
  CHECK(error < 0.05 * largest);
}

TEST_CASE("forces of faces do not jump where lines of two meshes lie on each other",
          "[contact][contact_force][statics]") {
  StaticPlates plates("");
  plates.begin();
  // Lines of both plates come to lie on each other but for a tilt, which has them cross anywhere.
  const auto forces_beside = [&](double beside) {
    const Eigen::Vector3d onto(-0.4 + beside, -0.3, -0.03);
    plates.move(onto, 0.0);
    for (Eigen::Index i = 0; i < plates.bodies.x.cols(); ++i)
      plates.bodies.x(0, i) += 1e-9 * plates.bodies.x(1, i);
    plates.bodies.x(2, 0) -= 0.01;  // pressures differ from place to place
    Matrix3Xd forces = Matrix3Xd::Zero(3, plates.bodies.x.cols());
    plates.bodies.contact.try_forces(plates.bodies.motion(), forces, nullptr);
    return forces;
  };
  const Matrix3Xd left = forces_beside(-1e-8), right = forces_beside(1e-8);
  CHECK(left.norm() > 0.0);
  CHECK((left - right).norm() < 1e-6 * left.norm());
}

TEST_CASE("a node that only a sliver lies before has no multiplier", "[contact][contact_force][statics]") {
  StaticPlates plates("");
  plates.begin();
  // The upper plate begins at x = 1.98, the lower one ends at 3: a fiftieth of its last faces lies before it.
  plates.try_motion({1.58, 0, -0.03}, 0.0);
  ContactForce& contact = plates.bodies.contact;
  contact.update_multipliers(0.0);
  double beyond = 0.0, before = 0.0;
  for (const SurfaceNodeIndex row : indices(contact.contact_mesh().surface_nodes)) {
    const double x = contact.position(contact.contact_mesh().surface_nodes[row].node).x();
    double& largest = x > 3.5 ? beyond : before;
    for (const PairIndex pair : indices(contact.rules().rules()))
      largest = std::max(largest, contact.multipliers().value_or(pair, row, 0.0));
  }
  CHECK(beyond == 0.0);
  CHECK(before == Approx(0.03).epsilon(0.1));
}

TEST_CASE("multipliers grow by what penetrates and go on where contact was",
          "[contact][contact_force][statics]") {
  const std::string form = GENERATE(std::string(), node_face);
  StaticPlates plates(form);
  plates.begin();
  const Eigen::Vector3d down(0, 0, -0.01);
  const double once = plates.try_motion(down, 0.0).norm();
  MultiplierChange change = plates.bodies.contact.update_multipliers(1e-3);
  CHECK(change.change == Approx(change.reference).epsilon(1e-6));
  const double twice = plates.try_motion(down, 0.0).norm();
  // Of nodes those of one side have multipliers; the others press by the penalty alone.
  const double bar = form.empty() ? 1e-6 : 0.2;
  CHECK(twice == Approx(2.0 * once).epsilon(bar));
  // Where nothing penetrates any more they alone press as much as before.
  CHECK(plates.try_motion({0, 0, 0}, 0.0).norm() == Approx(once).epsilon(bar));
  change = plates.bodies.contact.update_multipliers(1e-3);
  CHECK(change.change < 1e-9 * change.reference);
  // Sides that part by more than the multipliers let go.
  CHECK(plates.try_motion({0, 0, 0.02}, 0.0).norm() == 0.0);
  plates.bodies.contact.give_up_trials();
  CHECK(plates.bodies.contact.multipliers().empty());
}

}  // namespace contact_force_trial_test
