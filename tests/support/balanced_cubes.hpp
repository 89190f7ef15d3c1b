// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact/enforcement/contact_constraints.hpp"
#include "support/two_cubes.hpp"

namespace contactsim::test {

/// Contact points between two cubes as constraints of a step, found by hand instead of by MomentumBalance: a
/// corner of the upper cube over the middle of the lower one's top. A force of it opens it by 0.025 per step.
struct BalancedCubes {
  static constexpr double dt = 0.1, softness = dt * dt * 2.5;  ///< 1 / 0.5 of the corner, 1 / 2 of the face
  static constexpr double friction = 0.2;

  TwoCubes cubes;
  ModelFreeDirections free;
  NodeMobility mobility;
  ContactConstraints contacts{mobility};
  LightCarriers light;
  RecoveryEnergy recovery{1};
  IndexedVector<PairIndex, PairHistory> histories{PairHistory{}};
  State state;
  double dt_before = dt;

  explicit BalancedCubes(const std::string& more = "") : cubes(more) {}
  static std::string rough() {
    return "friction model = rough\nend\nbegin constant friction model rough\nfriction coefficient = 0.2\n";
  }
  /// Begins a step in which the upper cube goes by a velocity.
  void begin(const Eigen::Vector3d& velocity) {
    cubes.parts.v.rightCols(8).colwise() = velocity;
    cubes.parts.kinematics.move_nodes(cubes.parts.motion(dt));
    free.update(cubes.model, 0.0);
    state = cubes.state(dt);
    mobility.begin(cubes.model, free, cubes.parts.kinematics, state);
    contacts.begin(cubes.parts.kinematics, dt_before, dt);
    recovery.begin_step(cubes.parts.rules, histories);
  }
  /// The corner at a gap, with what it closes by in the coming step.
  ContactPoint point(double gap, double area = 1.0) const {
    ContactPoint point = TwoCubes::corner_over_face();
    point.gap = gap;
    point.area = area;
    point.is_balanced = true;
    point.closing = -dt * cubes.parts.kinematics.v({8}).z();
    return point;
  }
  void add(const ContactPoint& point, double thickness = 1.0) {
    contacts.add(point, cubes.parts.rules.of(point), thickness);
  }
  /// Finds the forces by some passes without momentum.
  ContactLoss solve(int n_passes = 30, bool limits_recovery = false) {
    mobility.begin_passes();
    contacts.list_pushes();
    LeaningAreas areas(mobility.n_carriers(), {0.0, 0.0});
    contacts.add_areas(areas);
    light.begin(mobility.n_carriers());
    contacts.set_softness(areas, light, 0.0);
    if (limits_recovery) contacts.limit_recovery(recovery);
    contacts.begin_passes();
    contacts.push_forces();
    mobility.end_pass();
    for (int i = 0; i < n_passes; ++i) {
      contacts.pass(0.0, light);
      mobility.end_pass();
    }
    return contacts.finish();
  }
  /// A step with one point; it as it ends.
  ContactPoint step(const Eigen::Vector3d& velocity, double gap, double thickness = 1.0) {
    begin(velocity);
    add(point(gap), thickness);
    solve();
    return contacts.points()[0];
  }
};

}  // namespace contactsim::test
