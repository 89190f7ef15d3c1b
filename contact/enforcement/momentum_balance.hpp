// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "contact/enforcement/contact_constraints.hpp"
#include "contact/enforcement/node_mobility.hpp"
#include "contact/enforcement/recovery_energy.hpp"
#include "contact/enforcement/tie_constraints.hpp"

namespace contactsim {

class StateArchive;

/// What balancing a step came to.
struct BalanceReport {
  int n_iterations = 0;
  double residual = 0.0;  ///< change of all forces in the last iteration over their sum [1]
};

/// Forces that let nothing through: at the end of the coming step no contact point penetrates, and tied
/// points are where they belong. Contact points are constraints on the velocities of their carriers, which
/// lumped masses make cheap: A = B M^-1 B^T with one row per point. A pass gives every point the force that
/// would close its gap if all points around had the same pressure, pushing only, with friction returned to
/// the Coulomb cone; so a uniform pressure takes one pass, and waves of the mesh's length a few. Passes are
/// accelerated, begin with half of the forces of the step before, go the same way twice, and end when forces
/// no longer change, or more passes bring nothing. Each force acts on both sides of its point alike. The same
/// bits for any number of threads.
///
/// A point that is apart may close by its gap; one that penetrates comes out slowly, so that nothing is
/// thrown out. What meets loses the energy of the motion of its carriers against each other, once; the
/// elements behind them keep theirs.
///
/// Source: forward increment Lagrange multipliers of Carpenter, Taylor and Katona, IJNME 32 (1991) 103-128;
/// momentum balance iterations of Heinstein, Mello, Attaway and Laursen, CMAME 187 (2000) 621-640;
/// accelerated projected gradients of Mazhar, Heyn, Negrut and Tasora, ACM Trans. Graph. 34 (2015) 32,
/// restarted as by O'Donoghue and Candes, Found. Comput. Math. 15 (2015) 715-732.
class MomentumBalance {
 public:
  MomentumBalance() = default;
  MomentumBalance(const MomentumBalance&) = delete;  // its parts refer to each other
  MomentumBalance& operator=(const MomentumBalance&) = delete;

  /// Begins a step.
  ///   surface  sees the velocities of the coming step without these forces
  void begin(const Model& model, const ModelFreeDirections& free, const ContactKinematics& kinematics,
             const State& state);
  /// Adds a contact point, or a law's force that acts besides.
  ///   rule  of its pair, which must outlive the step
  ///   thickness  of the thinner side [length]
  void add(const ContactPoint& point, const PairRule& rule, double thickness) {
    contacts_.add(point, rule, thickness);
  }
  /// Adds the points of a tie, which must outlive the step.
  void add(Tie& tie) { ties_.add(tie); }
  /// Adds a force at a contact node, and a moment about it, that act besides.
  void push(ContactNodeIndex node, const Eigen::Vector3d& force, const Eigen::Vector3d& moment);
  /// To be called when all points are added, behind load steps: ContactConstraints::spread_pressed().
  void spread_pressed() { contacts_.spread_pressed(); }
  /// The points in the order of add() with the forces that the passes begin with.
  std::vector<ContactPoint> begun_points() const { return contacts_.begun_points(); }
  /// Finds the forces. Throws SolveError where they are not finite.
  ///   recovery  what bringing out penetrations may take; overlaps of pairs that begin are added
  BalanceReport solve(int max_iterations, RecoveryEnergy& recovery);
  /// The points in the order of add(), with force, friction, slip and what is lost.
  std::span<const ContactPoint> points() const { return contacts_.points(); }
  const ContactLoss& loss() const { return loss_; }
  /// The nodes of the mesh that the forces may act on.
  std::span<const std::uint32_t> mesh_nodes() const { return mobility_.mesh_nodes(); }
  /// To be called when conditions on nodes or bodies have changed.
  void forget_mobility() { mobility_.forget(); }
  /// Hands over the points, for others in exchange.
  void swap_points(std::vector<ContactPoint>& points) { contacts_.swap_points(points); }

  /// Goes on where contact of another explicit procedure ended: ContactConstraints::go_on().
  void go_on() { contacts_.go_on(); }
  /// Begins with contact points of load steps before the first step: ContactConstraints::begin_pressed().
  void begin_pressed(std::span<const ContactPoint> points) { contacts_.begin_pressed(points); }
  /// Goes over to other faces and nodes.
  void remap(const ContactRemap& remap);
  void archive(StateArchive& saved);

 private:
  void set_softness();
  double choose_light();
  void move_light();
  ConstraintPass pass(double momentum);
  void push_forces();
  void choose_passes(std::int64_t n_passes, double share, double residual);

  NodeMobility mobility_;
  TieConstraints ties_{mobility_};
  ContactConstraints contacts_{mobility_};
  LeaningAreas areas_;              // scratch
  std::vector<CarrierLoad> loads_;  // scratch
  std::vector<CarrierTerm> terms_;  // scratch
  LightCarriers light_;
  std::vector<double> momenta_;  // of the passes of the first half
  ContactLoss loss_;
  double time_ = 0.0;
  std::int64_t n_passes_ = 1000;  // of the next step at most
};

}  // namespace contactsim
